// SPDX-License-Identifier: GPL-3.0-or-later
// Strand widths that differ around the tube.
#pragma once

#include <optional>
#include <vector>

#include "design/table_reader.h"

namespace latticast {

enum class WidthProfile { cosine, halves };

/// One width per strand; strand j of `count` sits at phi_j = 2 pi j / count.
/// cosine: w_j = (from + to)/2 + (from - to)/2 cos(phi_j), `from` at strand 0 and `to` opposite it.
/// halves: `from` for the strands with 2 j < count, `to` for the others.
/// One strand has width `from`; none gives an empty list.
std::vector<double> graded_widths_mm(double from_mm, double to_mm, WidthProfile profile, int count);

/// A list of widths. It must agree with the count where one is written.
std::vector<double> read_listed_widths(const Field& field, std::optional<int> count);

/// A table { from, to, profile }.
std::vector<double> read_graded_widths(const Field& field, int count);

}  // namespace latticast
