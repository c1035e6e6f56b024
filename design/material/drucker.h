// SPDX-License-Identifier: GPL-3.0-or-later
// Drucker stability of an incompressible law [Drucker 1959]: a change of logarithmic strain needs a
// positive work of the change of Kirchhoff stress, tested in homogeneous plane stress.
#pragma once

#include <optional>
#include <string_view>

#include "design/material/law.h"

namespace latticast {

/// Where a law stops being stable.
struct DruckerLoss {
  std::string_view test;  ///< "uniaxial tension", "equibiaxial tension" or "planar tension"
  double stretch = 1;     ///< the test's principal stretch; stable below
};

/// Whether d2W/(de_i de_j), e the logarithms of two principal stretches in a sheet that is free
/// across, is positive definite. Precondition: I1 - 3 is below the law's limit.
bool is_drucker_stable(const Law& law, double stretch_1, double stretch_2);

/// The test that loses stability at the least stretch, to 1e-9; empty when none does from rest up
/// to `largest_stretch`, or up to the law's limit where that comes before. Losses that are regained
/// within 0.5 % of stretch may be overlooked.
std::optional<DruckerLoss> drucker_loss(const Law& law, double largest_stretch);

}  // namespace latticast
