// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/horseshoe/horseshoe_fibre.h"

#include <algorithm>
#include <cmath>

#include "model/horseshoe/arc_equilibrium.h"

namespace latticast {

std::optional<double> largest_fibre_strain(const HorseshoeShape& shape, double strain) {
  const double slenderness = shape.width_mm / shape.radius_mm;
  const Arc arc{shape.arc_rad / 2, slenderness * slenderness / 12};
  const ArcSolver solver(arc);
  const auto bent = solver.advance(solver.rest(), strain);
  if (!bent) return std::nullopt;
  const double pull = bent->bent.force;
  const double axial = arc.compliance * pull;
  // cos - 1 and cos^2 - 1 at the end, without cancellation.
  const double lag = -2 * end_sine_squared(arc, bent->bent);
  const double squared = 1 + 2 * pull * lag + pull * axial * lag * (2 + lag);
  const double turning = std::sqrt(std::max(0.0, squared));
  return axial + 0.5 * slenderness * std::abs(1 - turning);
}

}  // namespace latticast
