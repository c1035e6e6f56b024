// SPDX-License-Identifier: GPL-3.0-or-later
// Energy of straight strips and rings as plates bonded to the liner: rings clamp the strips, the
// liner's face follows what is bonded to it (docs/bonded.md). Per mm of reference length; lengths
// mm, moduli MPa, angles rad.
#pragma once

#include "design/design.h"
#include "model/numerics/dual.h"
#include "model/section/section.h"
#include "model/section/strand_stretch.h"

namespace latticast {

/// Strains of the wall at one radius and direction: r/R - 1, Lambda - 1, and the twist k.
struct WallStrains {
  double radius_mm = 0;
  double hoop = 0;
  double elongation = 0;
  double twist = 0;
};

/// A function of hoop, elongation and twist, in this order, with exact derivatives.
using WallEnergy = Dual<3>;

/// Of a strand whose rest direction is (cosine, sine) in (theta, z).
StrandStretch<WallEnergy> strand_stretch(double cosine, double sine, const WallStrains& at);

/// Energy density of strands with the given moduli, each times the fraction of the layer that it
/// fills. Between rings, which neither lengthen nor shear and narrow as they widen, a strip sees
/// lambda_f - 1 = (lambda - 1 + f (1 - sqrt(R/r)))/(1 - f) and k_f = k/(1 - f), f being the rings'
/// share of the length:
///     (1 - f) E/2 (s_f - 1)^2 + K/2 theta_f^2
WallEnergy bonded_strand_energy(const StrandFamily& family, double stretch_modulus_mpa,
                                double joint_modulus_mpa, double ring_share, const WallStrains& at);

/// What holding the liner's outer face under a ring costs, per mm^2 of that face and unit of shear
/// modulus: l/2 (g^2 + 2 (Lambda - 1)^2), g = k r. `pad_mm` is l.
WallEnergy ring_pad_energy(double pad_mm, const WallStrains& at);

/// The same under strips: l/2 (m_along^2 + 2 m_across^2), m = F n - n_turned, n across the strip.
WallEnergy strip_pad_energy(const StrandFamily& family, double pad_mm, const WallStrains& at);

/// Thickness of the liner that a face with strips, `period_mm` apart and covering the share
/// `covered` < 1 of it, puts under its own strain: (d/pi) ln sec(pi c/2), exact for a half-space in
/// antiplane shear; not more than a sheet of `liner_thickness_mm` stores between the strips,
/// t c/(1 - c).
double pad_thickness_mm(double period_mm, double covered, double liner_thickness_mm);

/// k_t of a strip that is clamped between rings `pitch_mm` apart, over its volume, MPa: the clear
/// span bends and shears [Timoshenko 1921], 12 E I/L_c/(1 + 2.4 (1 + nu) w^2/L_c^2)/(w h L_t).
/// 0 without rings. Precondition: ring_width_mm < pitch_mm.
double clear_shear_joint_mpa(const Linear& material, double width_mm, double sine, double pitch_mm,
                             double ring_width_mm);

}  // namespace latticast
