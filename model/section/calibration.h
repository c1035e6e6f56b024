// SPDX-License-Identifier: GPL-3.0-or-later
// Correction of a straight section's energy in the natural strains of its lattice, so that the
// section has the stiffness, and one pressurised state, of a unit cell
// (docs/bonded.md#calibration).
#pragma once

#include <array>
#include <optional>

#include "model/section/bonded_lattice.h"
#include "model/section/section.h"
#include "model/section/section_energy.h"

namespace latticast {

/// Strains in which the correction is written, all at R_c and zero at rest: a strand's s - 1, the
/// hoop strain r/R - 1, the strand's turn in rad.
inline constexpr std::size_t natural_strain_count = 3;
using NaturalStrains = std::array<WallEnergy, natural_strain_count>;

NaturalStrains natural_strains(double cosine, double sine, const WallStrains& at);

/// 1/2 z . (stiffness z) + 1/2 (along . z)^2 (state . z) in N, z the natural strains.
struct Calibration {
  double radius_mm = 0;  ///< R_c
  double cosine = 1;     ///< of the strand's direction at rest
  double sine = 0;
  std::array<std::array<double, natural_strain_count>, natural_strain_count> stiffness_n{};
  std::array<double, natural_strain_count> along{};
  std::array<double, natural_strain_count> state_n{};
};

WallEnergy calibration_energy(const Calibration& calibration, const WallStrains& at);

/// The correction after which the section's Hessian by (lambda, k, a) at rest is the cell's. Empty
/// where the cell is not stiffer than the bare liner, which no lattice can make softer: its mesh is
/// at fault then. Precondition: the section is bonded, bends nowhere and has one family, of
/// straight strands whose angle is least_calibrated_angle_rad or more.
std::optional<Calibration> calibrated_at_rest(const Section& section,
                                              const SectionEnergy& cell_at_rest);

/// Strains are too nearly dependent below, and small errors of the cell become large.
inline constexpr double least_calibrated_angle_rad = 0.1;

/// Adds to a calibrated section's correction at rest what gives its energy this gradient by
/// (lambda, k, a) at the cell's state; `along` becomes the direction, in natural strains, in which
/// the section leaves rest under pressure. Empty where the state is too near to rest to tell.
std::optional<Calibration> calibrated_at(const Section& section, const Deformation& cell_state,
                                         const std::array<double, 3>& cell_gradient);

}  // namespace latticast
