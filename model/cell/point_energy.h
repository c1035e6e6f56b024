// SPDX-License-Identifier: GPL-3.0-or-later
// Isochoric hyperelasticity at a point: energy density, first Piola-Kirchhoff stress and its
// tangent at a deformation gradient F, for every law; [Holzapfel 2000] 6.4-6.6.
#pragma once

#include <array>
#include <optional>

#include "design/material/law.h"

namespace latticast {

/// A 3 x 3 tensor, entry (i, J) at 3 i + J, and what is linear in two of them.
using Tensor = std::array<double, 9>;
using TensorPair = std::array<double, 81>;  ///< entry (iJ, kL) at 9 (3 i + J) + 3 k + L

/// Volume ratio det F with its derivatives: the cofactor, and
/// d2 det F/dF_iJ dF_kL = sum over m, N of eps_ikm eps_JLN F_mN.
struct VolumeRatio {
  double value = 1;
  Tensor cofactor{};
};
VolumeRatio volume_ratio(const Tensor& f);

/// Adds `factor` times the second derivative of det F.
void add_volume_curvature(const Tensor& f, double factor, TensorPair& tangent);

/// Of an energy per reference volume: MPa.
struct PointEnergy {
  double energy = 0;
  Tensor stress{};       ///< dW/dF
  TensorPair tangent{};  ///< d2W/dF2, symmetric
};

/// W of the law at the stretches of F / (det F)^(1/3): what a change of shape stores. Exact also
/// where principal stretches coincide. Empty where det F <= 0 or the law's limit is reached.
std::optional<PointEnergy> isochoric_energy(const Law& law, const Tensor& f);

}  // namespace latticast
