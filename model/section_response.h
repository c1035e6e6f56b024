// SPDX-License-Identifier: GPL-3.0-or-later
// Response of one cross-section: its branch of equilibria followed through the pressures asked for,
// under the section's own energy or a unit cell's.
#pragma once

#include <span>

#include "model/cell/unit_cell.h"
#include "model/equilibrium/response.h"
#include "model/section/section.h"

namespace latticast {

struct SectionPath {
  const Section& section;
  const UnitCell* cell = nullptr;  ///< whose energy takes the place of the section's; may be null
  double length_mm = 0;            ///< for the angles that messages name
};

/// Precondition: pressures are finite.
Response section_response(const SectionPath& path, std::span<const double> pressures_kpa, Held held,
                          const SolverOptions& options);

}  // namespace latticast
