// SPDX-License-Identifier: GPL-3.0-or-later
// Materials as they are written: a library's entry, a name, or an inline table.
#pragma once

#include "design/material_library.h"
#include "design/table_reader.h"

namespace latticast {

/// An entry of a library: a law with its constants, and `source`, which must say where they are
/// from. Empty when the law could not be read.
std::optional<Material> read_library_entry(const std::string& name, const Field& field);

/// A design's material: the name of a library entry, or an inline table of the same form as an
/// entry with `source` optional (its name is then "inline"). Empty when absent, refused, or of
/// unknown law.
std::optional<Material> read_material(const Field& field, const MaterialLibrary& library);

}  // namespace latticast
