// SPDX-License-Identifier: GPL-3.0-or-later
// Material: a constitutive law, and how far and how well it is known.
#pragma once

#include <optional>
#include <string>

#include "design/material/law.h"

namespace latticast {

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

  friend bool operator==(const Material&, const Material&) = default;
};

}  // namespace latticast
