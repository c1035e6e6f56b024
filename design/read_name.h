// SPDX-License-Identifier: GPL-3.0-or-later
// Names that a design gives to itself and to its parts.
#pragma once

#include <string>
#include <vector>

#include "design/table_reader.h"

namespace latticast {

/// The name of the design, which begins the names of files: it must be a file's name on every
/// system and look like what it is.
std::string read_design_name(const Field& field);

/// The name of an entry of a list, by which paths find it (design/setting/setting.h); empty without
/// one. It must be a word, and unlike `others`, to which it is added.
std::string read_entry_name(const Field& field, std::vector<std::string>& others);

}  // namespace latticast
