// SPDX-License-Identifier: GPL-3.0-or-later
// What one axisymmetric cross-section stores when it stretches, twists and widens (MODEL.md
// sections 1 to 3). Lengths mm, stresses MPa, angles rad; energies are per mm of reference length,
// so they are in N.
#pragma once

#include <optional>
#include <vector>

#include "model/dual.h"
#include "spec/design.h"
#include "spec/unsupported_design.h"

namespace latticast {

/// A uniform state of a section, written as its distance from rest: stretch - 1, twist in rad per
/// mm of reference length (positive: right-handed about +z), current inner radius - R_i in mm. The
/// rest state is exactly (0, 0, 0), and small states keep their full relative accuracy.
struct Deformation {
  double elongation = 0;
  double twist = 0;
  double inner_growth = 0;
};

/// All strands of one family together. A = cosine e_theta + sine e_z is the strands' rest
/// direction.
struct StrandFamily {
  double cosine = 0;
  double sine = 1;
  double stretch_modulus_mpa = 0;  ///< E times the fraction of the layer that the strands fill
  double joint_modulus_mpa = 0;    ///< sum over strands of fraction times k_t / V (paper (4))
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
  Law liner_law;                   ///< NeoHookean, Yeoh or Gent
  double shear_modulus_mpa = 0;    ///< of the liner at rest
  double ring_modulus_mpa = 0;     ///< E times the fraction of the layer that the rings fill
  std::vector<StrandFamily> families;
};

/// Radii and weights of an integral over the wall, 2 pi R dR included in the weight.
struct QuadraturePoint {
  double radius_mm = 0;
  double weight_mm2 = 0;
};

/// Gauss-Legendre points of a section's two integrals. `lattice` is empty without a lattice.
struct Quadrature {
  std::vector<QuadraturePoint> liner;
  std::vector<QuadraturePoint> lattice;
};

/// An energy with its exact gradient and Hessian in (elongation, twist, inner_growth).
using SectionEnergy = Dual<3>;

/// Reads a segment into a section.
///   layered:  rubber over R_i..R_m, lattice over R_m..R_o, fractions counted from widths and pitch
///             (MODEL.md section 3)
///   mixture:  c1 rubber + c2 lattice over R_i..R_o, c1 = 0.91, c2 = 0.09, no strip fractions
///             (paper (1), (5)); without a lattice there is nothing to mix and c1 = 1
/// Rings that do not exist (none given, or none fits on the segment) leave k_t = 0, whatever the
/// joint. Throws UnsupportedDesign for horseshoe strands, for strands of unequal width in one
/// family (the section would bend), for a linear liner, for a lattice material that is not linear,
/// for strands of one family that overlap at mid radius, and for a clear-span joint between rings
/// that touch. Precondition: the segment is valid in the sense of spec/read_design.h.
Section prepare_section(const Segment& segment, const ModelChoice& model);

/// Points for a section's integrals, `liner_points` >= 1 and `lattice_points` >= 1 of them in R.
Quadrature make_quadrature(const Section& section, int liner_points, int lattice_points);

/// Stored energy per reference length, N, at a deformation:
///     integral W_liner(F) 2 pi R dR
///   + integral [ ring/2 (r/R - 1)^2 + sum over families ( E/2 (s - 1)^2 + k/2 theta_t^2 ) ] 2 pi R
///   dR
/// with r(R)^2 = a^2 + (R^2 - R_i^2)/lambda, s = |F A|, theta_t the signed angle from A to F A.
/// Written without differences of nearly equal numbers: relative accuracy holds down to the rest
/// state, where the energy and its gradient are exactly zero.
/// Empty where the state cannot exist: lambda <= 0, a <= 0, or a Gent rubber stretched to its
/// limit.
std::optional<SectionEnergy> stored_energy(const Section& section, const Quadrature& quadrature,
                                           const Deformation& at);

/// Growth of the cavity per reference length, pi (a^2 lambda - R_i^2) in mm^2, with derivatives:
/// what the pressure works on.
SectionEnergy cavity_growth(const Section& section, const Deformation& at);

/// How much of its stretch limit a Gent liner uses, (I1 - 3)/Jm at the face where it is larger;
/// below 1 for every state that can exist. 0 for other laws.
double stretch_limit_used(const Section& section, const Deformation& at);

/// Current radius in mm of the material at reference radius R >= R_i:
/// r^2 = a^2 + (R^2 - R_i^2)/lambda.
double current_radius_mm(double inner_radius_mm, double reference_radius_mm, const Deformation& at);

}  // namespace latticast
