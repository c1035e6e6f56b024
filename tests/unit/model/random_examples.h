// SPDX-License-Identifier: GPL-3.0-or-later
// Random designs with pressures, for tests that hold over all that can be asked for.
#pragma once

#include <vector>

#include "model/equilibrium/state.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {

struct RandomExample {
  Segment segment;
  ModelChoice model;
  Held held;
  std::vector<double> pressures_kpa;
};

/// Straight strands, evenly spaced. Wall ratios 0.05 to 0.999, E/mu 1e-3 to 1e7, angles 0.5 to
/// 179.5 degrees; pressures up to several times what the liner alone can take, or up to strains of
/// order 0.1 of the lattice.
RandomExample random_straight_example(Random& random);

/// Liner and lattice of any size and stiffness; one uneven family and up to two even ones, of
/// straight strips or horseshoes, axial or tilted; any coordinates held.
RandomExample random_bending_example(Random& random);

}  // namespace latticast::testing
