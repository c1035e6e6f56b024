// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in texts for people.
#pragma once

#include <string>

namespace latticast {

/// A number as a person writes it: rounded to `digits` significant ones (1 to 17), without trailing
/// zeros and without exponent: "100", "12300", "0.000008". Only what no person writes out, from
/// 1e15 on and below 1e-9, has one: "1.2e-12". Infinite is "inf", what is no number "nan".
std::string written(double value, int digits);

/// With the fewest digits that give the same double.
std::string written(double value);

}  // namespace latticast
