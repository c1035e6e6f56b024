// SPDX-License-Identifier: GPL-3.0-or-later
// Correction of a section's energy in the natural strains of its lattice, so that the section has
// the stiffness, and one pressurised state, of a unit cell (docs/bonded.md#calibration).
#pragma once

#include <array>
#include <optional>

#include "model/section/bonded_lattice.h"
#include "model/section/section.h"
#include "model/section/section_energy.h"

namespace latticast {

/// Strains in which the correction is written, all at R_c and zero at rest: the first family's
/// strand s - 1, the hoop strain r/R - 1, the strand's turn in rad where the section twists, r
/// kappa along both axes of a section that bends.
inline constexpr std::size_t most_natural_strains = 5;

/// What natural strains are functions of: hoop, elongation and twist at R_c, and r kappa twice.
using MiddleStrains = std::array<double, most_natural_strains>;
using CalibrationEnergy = Dual<most_natural_strains>;
using NaturalStrains = std::array<CalibrationEnergy, most_natural_strains>;

/// 1/2 z . (stiffness z) + 1/2 (along . z)^2 (state . z) in N, z the natural strains.
struct Calibration {
  using Vector = std::array<double, most_natural_strains>;

  double radius_mm = 0;  ///< R_c
  double cosine = 1;     ///< of the strand's direction at rest
  double sine = 0;
  std::array<Vector, most_natural_strains> stiffness_n{};
  Vector along{};
  Vector state_n{};
};

/// With derivatives by the middle's strains.
NaturalStrains natural_strains(const Calibration& calibration, const MiddleStrains& at);
CalibrationEnergy calibration_energy(const Calibration& calibration, const MiddleStrains& at);

/// The correction after which the section's Hessian at rest is the cell's, by lambda and a, and by
/// k and kappa where the section twists and bends. Empty where the cell is not stiffer than the
/// bare liner, which no lattice can make softer: its mesh is at fault then. Precondition: the first
/// family's angle is least_calibrated_angle_rad or more.
std::optional<Calibration> calibrated_at_rest(const Section& section,
                                              const SectionEnergy& cell_at_rest);

/// Strains are too nearly dependent below, and small errors of the cell become large.
inline constexpr double least_calibrated_angle_rad = 0.1;

/// Adds to a calibrated section's correction at rest what gives its energy this gradient at the
/// cell's state; `along` becomes the direction, in natural strains, in which the section leaves
/// rest under pressure. Empty where the state is too near to rest to tell.
std::optional<Calibration> calibrated_at(const Section& section, const Deformation& cell_state,
                                         const std::array<double, coordinate_count>& cell_gradient);

}  // namespace latticast
