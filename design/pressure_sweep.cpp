// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/pressure_sweep.h"

#include <cmath>

namespace latticast {
namespace {

// Enough to reach `to` in spite of rounding (0 to 1 by 0.1), too little to invent a pressure.
constexpr double reach = 1e-9;

}  // namespace

double sweep_size(const PressureSweep& sweep) {
  const bool finite =
      std::isfinite(sweep.from_kpa) && std::isfinite(sweep.to_kpa) && std::isfinite(sweep.step_kpa);
  if (!finite || sweep.step_kpa == 0) return 0;
  const double steps = (sweep.to_kpa - sweep.from_kpa) / sweep.step_kpa;
  return steps >= 0 ? std::floor(steps + reach) + 1 : 0;
}

std::vector<double> sweep_pressures_kpa(const PressureSweep& sweep) {
  std::vector<double> pressures(static_cast<std::size_t>(sweep_size(sweep)));
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    const double pressure = sweep.from_kpa + static_cast<double>(i) * sweep.step_kpa;
    const bool arrived = std::abs(pressure - sweep.to_kpa) <= reach * std::abs(sweep.step_kpa);
    pressures[i] = arrived ? sweep.to_kpa : pressure;
  }
  return pressures;
}

}  // namespace latticast
