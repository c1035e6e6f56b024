// SPDX-License-Identifier: GPL-3.0-or-later
// A material as the model needs it: a constitutive law, and how far and how well it is known.
#pragma once

#include <optional>
#include <string>
#include <variant>

namespace latticast {

/// Linear elasticity, for lattice strands. Young's modulus E in MPa; 0 <= nu <= 0.5.
struct Linear {
  double youngs_modulus_mpa = 0;
  double poisson_ratio = 0.5;
};

/// Incompressible neo-Hookean rubber, W = mu/2 (I1 - 3); paper equation (2).
struct NeoHookean {
  double shear_modulus_mpa = 0;
};

/// Incompressible Yeoh rubber, W = c1 (I1 - 3) + c2 (I1 - 3)^2 + c3 (I1 - 3)^3
/// (O. H. Yeoh, Rubber Chem. Technol. 66, 1993). Small-strain shear modulus 2 c1.
struct Yeoh {
  double c1_mpa = 0;
  double c2_mpa = 0;
  double c3_mpa = 0;
};

/// Incompressible Gent rubber, W = -mu Jm/2 ln(1 - (I1 - 3)/Jm); defined for I1 - 3 < Jm only
/// (A. N. Gent, Rubber Chem. Technol. 69, 1996).
struct Gent {
  double shear_modulus_mpa = 0;
  double limit_jm = 0;
};

using Law = std::variant<Linear, NeoHookean, Yeoh, Gent>;

/// The same law with all moduli times `factor`: every stress is multiplied by it, every law here
/// being proportional to its moduli. Poisson's ratio and Gent's limit stay.
Law scaled(Law law, double factor);

/// A named or inline material. Fields that a source does not give are empty, never guessed.
struct Material {
  std::string name;  ///< library name, or "inline"
  Law law;
  std::optional<double> max_strain;           ///< engineering strain up to which the law was fitted
  std::optional<double> elongation_at_break;  ///< engineering strain
  std::optional<double> density_g_per_cm3;
  std::optional<double> shrinkage;  ///< linear, of the mold's size: casting = mold (1 - shrinkage)
  std::optional<double> modulus_low_factor;  ///< known modulus band: low = factor * stated modulus
  std::optional<double> modulus_high_factor;
  std::string source;  ///< where the constants come from
  std::string note;    ///< what a user should know before relying on them
};

}  // namespace latticast
