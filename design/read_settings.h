// SPDX-License-Identifier: GPL-3.0-or-later
// The design file's tables about what to do with the segments: load, model, make, export, printer.
#pragma once

#include <vector>

#include "design/design.h"
#include "design/table_reader.h"

namespace latticast {

/// [load]: the sweep first, then the cases. `segments` is 0 when the segments could not be read;
/// each case's length then goes unchecked.
std::vector<LoadCase> read_load(const Field& field, std::size_t segments);

ModelChoice read_model(const Field& field);

/// [make]. A lattice can be made only where some segment has one; molds suit the printer; a deck
/// needs a load.
Make read_make(const Field& field, const std::vector<Segment>& segments, const Printer& printer,
               bool has_load);

/// [export] of the file. The tolerance, written or not, must be finer than the thinnest layer and
/// the narrowest strand, ring or fillet.
Export read_export(TableReader& file, const std::vector<Segment>& segments);

Printer read_printer(const Field& field);

}  // namespace latticast
