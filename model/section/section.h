// SPDX-License-Identifier: GPL-3.0-or-later
// What one cross-section stores when it stretches, twists, widens and bends (MODEL.md sections 1
// to 6). Lengths mm, stresses MPa, angles rad; energies are per mm of reference length, so they
// are in N.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "design/design.h"
#include "design/unsupported_design.h"
#include "model/horseshoe/horseshoe_law.h"
#include "model/numerics/dual.h"

namespace latticast {

/// A uniform state of a section, written as its distance from rest: stretch - 1, twist in rad per
/// mm of reference length (positive: right-handed about +z), current inner radius - R_i in mm, and
/// the bending kappa in rad per mm of reference length along the section's two axes. Fibres on the
/// side of +kappa lengthen; the tube bends toward -kappa. The rest state is exactly zero, and
/// small states keep their full relative accuracy.
struct Deformation {
  double elongation = 0;
  double twist = 0;
  double inner_growth = 0;
  double bend_1 = 0;
  double bend_2 = 0;
};

/// Numbers of the coordinates in derivatives by a Deformation.
namespace coordinate {
inline constexpr int elongation = 0;
inline constexpr int twist = 1;
inline constexpr int inner_growth = 2;
inline constexpr int bend_1 = 3;
inline constexpr int bend_2 = 4;
}  // namespace coordinate
inline constexpr int coordinate_count = 5;

/// One strand at its angular place, cosine and sine of the angle from the section's first axis.
struct StrandPlace {
  double cosine = 1;
  double sine = 0;
  double stretch_modulus_mpa = 0;           ///< E times the fraction of the layer that it fills
  double joint_modulus_mpa = 0;             ///< fraction times k_t / V (paper (4))
  std::shared_ptr<const HorseshoeLaw> law;  ///< of a horseshoe strand; empty: straight
};

/// All strands of one family. A = cosine e_theta + sine e_z is the strands' rest direction.
struct StrandFamily {
  double cosine = 0;
  double sine = 1;
  double stretch_modulus_mpa = 0;  ///< summed over the strands
  double joint_modulus_mpa = 0;    ///< summed over the strands
  double arcs_per_mm = 0;  ///< horseshoe arcs of one strand per mm of tube, 1/(chord sine); else 0
  bool averaged = false;   ///< averaged around the tube: turns against the section's frame, counts
                           ///< no strips (mixture), or has so many equal strands that their sum
                           ///< over places is that average
  std::vector<StrandPlace> strands;
};

/// A segment's cross-section as the model sees it, prepared once.
/// Invariant of prepare_section: 0 < inner < liner_outer <= outer radius, and every modulus >= 0.
struct Section {
  double inner_radius_mm = 0;        ///< R_i
  double liner_outer_radius_mm = 0;  ///< R_m
  double outer_radius_mm = 0;        ///< R_o
  double isotropic_from_mm = 0;      ///< the rubber energy is integrated over these radii ...
  double isotropic_to_mm = 0;
  double anisotropic_from_mm = 0;  ///< ... and the ring and strand energies over these;
  double anisotropic_to_mm = 0;    ///< equal bounds: no lattice
  double isotropic_fraction = 1;   ///< 1, or c1 of the mixture wall
  Law liner_law;                   ///< of a rubber, never Linear
  double shear_modulus_mpa = 0;    ///< of the liner at rest
  double ring_modulus_mpa = 0;     ///< E times the fraction of the layer that the rings fill
  std::vector<StrandFamily> families;

  /// The section is the same at every Z in a frame that turns by this, against the material and
  /// per mm of reference length: cot(alpha)/R_c of the family that is uneven around the tube.
  double frame_turn_rad_per_mm = 0;
  double axis_rad = 0;     ///< Theta of the first section axis at Z = 0
  bool twists = false;     ///< false: k = 0 by symmetry
  int bending_axes = 0;    ///< 0: kappa = 0 by symmetry; 1: along the first axis only; 2: any
  bool isotropic = false;  ///< bends equally about all axes: no family of one or two strands
};

/// Radii and weights of an integral over the wall, 2 pi R dR included in the weight.
struct QuadraturePoint {
  double radius_mm = 0;
  double weight_mm2 = 0;
};

/// A direction in the section and its share of the whole turn.
struct Direction {
  double cosine = 1;
  double sine = 0;
  double weight = 1;
};

/// Points of a section's integrals: Gauss-Legendre in R, trapezoidal around the tube. `lattice` is
/// empty without a lattice. `average_strands`: all families are averaged around the tube.
struct Quadrature {
  std::vector<QuadraturePoint> liner;
  std::vector<QuadraturePoint> lattice;
  std::vector<Direction> around;
  bool average_strands = false;
};

/// An energy with its exact gradient and Hessian by the coordinates of a Deformation.
using SectionEnergy = Dual<coordinate_count>;

/// Reads a segment into a section.
///   layered:  rubber over R_i..R_m, lattice over R_m..R_o, fractions counted from widths and pitch
///             (MODEL.md section 3); horseshoe strands by their law at R_c (section 5)
///   mixture:  c1 rubber + c2 lattice over R_i..R_o, c1 = 0.91, c2 = 0.09, no strip fractions
///             (paper (1), (5)); without a lattice there is nothing to mix and c1 = 1
/// Rings that do not exist (none given, or none fits on the segment) leave k_t = 0, whatever the
/// joint. `known` laws are reused where they fit; missing ones are built, side by side.
/// Families that are uneven around the tube (unequal strands, or a single one) fix the section's
/// frame. Throws UnsupportedDesign for two of them that wind at different rates (no frame in which
/// the section stays the same), for horseshoes or uneven families in a mixture wall (which counts
/// no strips), for a horseshoe outside of its law's scope, for a linear liner, for a lattice
/// material that is not linear, for straight strands of one family that overlap at mid radius, and
/// for a clear-span joint between rings that touch. Precondition: the segment is valid in the
/// sense of design/read_design.h.
Section prepare_section(const Segment& segment, const ModelChoice& model,
                        const HorseshoeLaws& known = {});

/// The laws that a section uses.
HorseshoeLaws laws_of(const Section& section);

/// Points for a section's integrals, `liner_points` >= 1 and `lattice_points` >= 1 of them in R,
/// and `around` >= 1 directions evenly spaced around the whole tube. Integrals that begin at the
/// bore are cut into `bore_panels` >= 1 parts, each with that many points and a quarter as thick as
/// the next one outwards: for states whose bore is nearly closed.
Quadrature make_quadrature(const Section& section, int liner_points, int lattice_points,
                           int around = 24, int bore_panels = 1);

/// Panels that a state needs. Gauss points converge slowly when the energy is singular close below
/// R_i: r(R) is zero where R^2 = R_i^2 - lambda a^2, and a Gent rubber that is near its limit at
/// the bore would reach it a little inside. The innermost panel is not thicker than that distance,
/// as far as it is known. 1 where it is more than a twentieth of the wall. Precondition: the state
/// can exist.
int bore_panels_for(const Section& section, const Deformation& at);

/// Directions evenly spaced on half of the tube, from the first axis to its opposite, each
/// standing for its mirror image as well: `intervals` >= 1 of them.
std::vector<Direction> half_turn(int intervals);

/// Stored energy per reference length, N, at a deformation:
///     integral W_liner(F) R dR dphi
///   + integral [ ring/2 (r/R - 1)^2 + sum over strands ( E/2 (s - 1)^2 + k/2 theta_t^2 ) ] 2 pi R
///   dR + sum over horseshoe strands of arcs_per_mm U(s - 1 at R_c)
/// with r(R)^2 = a^2 + (R^2 - R_i^2)/lambda, Lambda = lambda + r kappa . n, s = |F A|, theta_t the
/// signed angle from A to F A. Written without differences of nearly equal numbers: relative
/// accuracy holds down to the rest state, where the energy and its gradient are exactly zero.
/// Empty where the state cannot exist (a stretch Lambda <= 0, a <= 0, a Gent rubber stretched to
/// its limit) or a horseshoe leaves its law's range.
std::optional<SectionEnergy> stored_energy(const Section& section, const Quadrature& quadrature,
                                           const Deformation& at);

/// The same with derivatives by the `active` coordinates only; all other derivatives are left 0.
/// Faster the fewer there are, and much faster when neither bending is among them nor in `at`.
std::optional<SectionEnergy> stored_energy(const Section& section, const Quadrature& quadrature,
                                           const Deformation& at, std::span<const int> active);

/// How far the gradient may be off because the horseshoe laws are interpolated: the sum of their
/// errors over all strands, as if none cancelled another. Zero without horseshoes.
/// Precondition: stored_energy is not empty at this deformation.
std::array<double, coordinate_count> law_error(const Section& section, const Quadrature& quadrature,
                                               const Deformation& at);

/// Growth of the cavity per reference length, pi (a^2 lambda - R_i^2) in mm^2, with derivatives:
/// what the pressure works on.
SectionEnergy cavity_growth(const Section& section, const Deformation& at);

/// How much of its stretch limit a Gent liner uses, (I1 - 3)/Jm where it is largest; below 1 for
/// every state that can exist. 0 for other laws.
double stretch_limit_used(const Section& section, const Deformation& at);

/// Strains of the horseshoe strand that is nearest to an end of its law's range, and that range.
struct HorseshoeStrain {
  double strain = 0;
  StrainRange range;
};

/// Empty without horseshoe strands, or where the state cannot exist.
std::optional<HorseshoeStrain> most_strained_horseshoe(const Section& section,
                                                       const Deformation& at);

/// Current radius in mm of the material at reference radius R >= R_i:
/// r^2 = a^2 + (R^2 - R_i^2)/lambda.
double current_radius_mm(double inner_radius_mm, double reference_radius_mm, const Deformation& at);

}  // namespace latticast
