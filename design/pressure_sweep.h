// SPDX-License-Identifier: GPL-3.0-or-later
// Evenly spaced pressures.
#pragma once

#include <vector>

namespace latticast {

/// from, from + step, ... up to `to`, which is included when it is reached within 1e-9 of a step.
struct PressureSweep {
  double from_kpa = 0;
  double to_kpa = 0;
  double step_kpa = 0;
};

/// How many pressures the sweep holds, as a real number because it may be absurdly large, or even
/// infinite where the step is below every rounding. 0 when it never arrives: a step of zero or away
/// from `to`, or a number that is not finite. Ends that are equal give one pressure, for any step
/// but zero.
double sweep_size(const PressureSweep& sweep);

/// The pressures, in order. Precondition: sweep_size(sweep) is a number worth allocating.
std::vector<double> sweep_pressures_kpa(const PressureSweep& sweep);

}  // namespace latticast
