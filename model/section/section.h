// SPDX-License-Identifier: GPL-3.0-or-later
// Cross-section of a segment as the model sees it: radii, rubber, strands and rings, symmetry.
// Lengths mm, stresses MPa, angles rad.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "design/design.h"
#include "model/law/strand_law.h"
#include "model/section/deformation.h"

namespace latticast {

/// One strand at its angular place, cosine and sine of the angle from the section's first axis.
struct StrandPlace {
  double cosine = 1;
  double sine = 0;
  double stretch_modulus_mpa = 0;        ///< E times the fraction of the layer that it fills
  double joint_modulus_mpa = 0;          ///< fraction times k_t / V, [Wang] (4)
  double pad_mm = 0;                     ///< share of its family's pad, docs/bonded.md#pads
  std::shared_ptr<const StrandLaw> law;  ///< of a curved strand's link; empty: straight
};

/// All strands of one family. A = cosine e_theta + sine e_z is the strands' rest direction.
struct StrandFamily {
  double cosine = 0;
  double sine = 1;
  double stretch_modulus_mpa = 0;  ///< summed over the strands
  double joint_modulus_mpa = 0;    ///< summed over the strands
  double pad_mm = 0;               ///< summed over the strands
  double links_per_mm = 0;  ///< links of a curved strand per mm of tube, 1/(chord sine); else 0
  bool averaged = false;    ///< averaged around the tube: turns against the section's frame, counts
                            ///< no strips (mixture), or has so many equal strands that their sum
                            ///< over places is that average
  std::vector<StrandPlace> strands;
};

struct Calibration;

/// What bonding of the lattice to the liner adds, docs/bonded.md.
struct Bond {
  double ring_share = 0;   ///< of the length, f
  double ring_pad_mm = 0;  ///< thickness of liner that takes the rings' strain with them
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
  std::optional<Bond> bond;  ///< empty: strands and rings are lines that lie on the liner
  std::shared_ptr<const Calibration> calibration;  ///< empty: uncorrected

  /// The section is the same at every Z in a frame that turns by this, against the material and
  /// per mm of reference length: cot(alpha)/R_c of the family that is uneven around the tube.
  double frame_turn_rad_per_mm = 0;
  double axis_rad = 0;     ///< Theta of the first section axis at Z = 0
  bool twists = false;     ///< false: k = 0 by symmetry
  int bending_axes = 0;    ///< 0: kappa = 0 by symmetry; 1: along the first axis only; 2: any
  bool isotropic = false;  ///< bends equally about all axes: no family of one or two strands
};

}  // namespace latticast
