// SPDX-License-Identifier: GPL-3.0-or-later
// Effective rods, the bending model of [Wang] III.B: each half's axial columns act as one rod
// (docs/bending.md#effective-rods). mm, N, MPa, rad.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "design/design.h"
#include "design/unsupported_design.h"
#include "model/law/strand_law.h"

namespace latticast {

/// The columns of one half, pulled together.
struct EffectiveRod {
  struct Column {
    std::shared_ptr<const StrandLaw> law;
    int count = 0;
  };
  std::vector<Column> columns;      ///< curved ones, by law
  double straight_stiffness_n = 0;  ///< sum of E w h over straight columns
};

/// A section with a linear liner of constant bore and two effective rods.
struct Rods {
  double inner_radius_mm = 0;          ///< R_i
  double liner_outer_radius_mm = 0;    ///< R_m, where the rods' strain is taken
  double outer_radius_mm = 0;          ///< R_o
  double youngs_modulus_mpa = 0;       ///< E_s of the liner
  double arm_mm = 0;                   ///< mean arm of the rods' forces
  std::array<EffectiveRod, 2> halves;  ///< at Theta = +90 and -90 degrees

  double axial_stiffness_n() const;       ///< E_s pi (R_m^2 - R_i^2)
  double bending_stiffness_nmm2() const;  ///< E_s pi (R_m^4 - R_i^4)/4
  double bore_area_mm2() const;           ///< pi R_i^2, what the pressure pushes on
};

/// Loads on a rods section. A held coordinate is zero and its equation is left out.
struct RodsLoad {
  double pressure_mpa = 0;
  double force_n = 0;     ///< further pull along the axis
  double moment_nmm = 0;  ///< along +kappa
  bool hold_stretch = false;
  bool hold_bend = false;
};

/// Why there is no equilibrium.
enum class RodsRefusal { law_range, no_length };

/// One equilibrium.
struct RodsState {
  double elongation = 0;               ///< e0
  double bend_rad_per_mm = 0;          ///< kappa: positive lengthens the +90 degree half
  double force_n = 0;                  ///< that the mounting applies
  double moment_nmm = 0;               ///< that the mounting applies
  double residual = 0;                 ///< of the axial balance, over the liner's stiffness
  double error = 0;                    ///< of e0 and kappa R_m: last Newton step, interpolated
                                       ///< laws, rounding
  double smallest_eigenvalue = 0;      ///< of the scaled stiffness, over the liner's
  double elongation_per_mpa = 0;       ///< d e0/dP
  double bend_rad_per_mm_per_mpa = 0;  ///< d kappa/dP
  int iterations = 0;
};

/// Reads a segment's axial columns. Strands with 2 j < n form the half at +90 degrees. A rubber
/// liner enters with E_s = 3 G, G its shear modulus at rest. Throws UnsupportedDesign for a grid
/// that is not axial, for a lattice material that is not linear and for links outside of
/// their law's scope.
Rods prepare_rods(const Segment& segment, const StrandLaws& known = {});

StrandLaws laws_of(const Rods& rods);

/// The equilibrium of
///     P pi R_i^2 + N = E_s e0 pi (R_m^2 - R_i^2) + f_+ + f_-
///     M              = E_s kappa pi (R_m^4 - R_i^4)/4 + (f_+ - f_-) arm,   f at e0 +- kappa R_m
/// With the second one times R_m/arm, they are the gradient of a convex function, the laws'
/// slopes being positive: there is one solution at most, and damped Newton steps find it. Empty
/// where a link would leave its law's range, or where a side of the wall would be left without
/// length (1 + e0 - |kappa| R_o <= 0, which a linear liner does not know of); `why` then says
/// which.
std::optional<RodsState> rods_equilibrium(const Rods& rods, const RodsLoad& load,
                                          RodsRefusal* why = nullptr);

}  // namespace latticast
