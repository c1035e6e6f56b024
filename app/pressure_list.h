// SPDX-License-Identifier: GPL-3.0-or-later
// Pressures as the command line takes them.
#pragma once

#include <string_view>
#include <vector>

namespace latticast {

/// Pressures from the command line: "30", "10,20,30" or "FROM:TO:STEP", in kPa.
/// Throws std::invalid_argument saying what is wrong and how to write it.
std::vector<double> parse_pressures_kpa(std::string_view text);

}  // namespace latticast
