// SPDX-License-Identifier: GPL-3.0-or-later
// Strain energy of a cross-section with exact gradient and Hessian, and the growth of the cavity
// that pressure works on (docs/model.md#energy). Energies are per mm of reference length, so they
// are in N.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "model/law/strand_law.h"
#include "model/numerics/dual.h"
#include "model/section/quadrature.h"
#include "model/section/section.h"

namespace latticast {

/// An energy with its exact gradient and Hessian by the coordinates of a Deformation.
using SectionEnergy = Dual<coordinate_count>;

/// Stored energy per reference length, N, at a deformation:
///     integral W_liner(F) R dR dphi
///   + integral [ ring/2 (r/R - 1)^2 + sum over strands ( E/2 (s - 1)^2 + k/2 theta_t^2 ) ] 2 pi R
///   dR + sum over curved strands of links_per_mm U(s - 1 at R_c)
/// with r(R)^2 = a^2 + (R^2 - R_i^2)/lambda, Lambda = lambda + r kappa . n, s = |F A|, theta_t the
/// signed angle from A to F A. Written without differences of nearly equal numbers: relative
/// accuracy holds down to the rest state, where the energy and its gradient are exactly zero.
/// Empty where the state cannot exist (a stretch Lambda <= 0, a <= 0, a Gent rubber stretched to
/// its limit) or a link leaves its law's range.
std::optional<SectionEnergy> stored_energy(const Section& section, const Quadrature& quadrature,
                                           const Deformation& at);

/// The same with derivatives by the `active` coordinates only; all other derivatives are left 0.
/// Faster the fewer there are, and much faster when neither bending is among them nor in `at`.
std::optional<SectionEnergy> stored_energy(const Section& section, const Quadrature& quadrature,
                                           const Deformation& at, std::span<const int> active);

/// How far the gradient may be off because the links' laws are interpolated: the sum of their
/// errors over all strands, as if none cancelled another. Zero without curved strands.
/// Precondition: stored_energy is not empty at this deformation.
std::array<double, coordinate_count> law_error(const Section& section, const Quadrature& quadrature,
                                               const Deformation& at);

/// Growth of the cavity per reference length, pi (a^2 lambda - R_i^2) in mm^2, with derivatives:
/// what the pressure works on.
SectionEnergy cavity_growth(const Section& section, const Deformation& at);

/// How much of its law's stretch limit the liner uses, (I1 - 3)/Jm where it is largest; below 1 for
/// every state that can exist. 0 for laws without such a limit.
double stretch_limit_used(const Section& section, const Deformation& at);

/// Strain of the curved strand that is nearest to an end of its law's range, and that range.
struct LinkStrain {
  std::string_view path;  ///< "horseshoe"
  double strain = 0;
  StrainRange range;
};

/// Empty without curved strands, or where the state cannot exist.
std::optional<LinkStrain> most_strained_link(const Section& section, const Deformation& at);

}  // namespace latticast
