// SPDX-License-Identifier: GPL-3.0-or-later
// Deformation of a cross-section: stretch, twist, growth of the bore and bending, of an
// incompressible wall (docs/model.md#coordinates).
#pragma once

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

/// Current radius in mm of the material at reference radius R >= R_i, r^2 = a^2 + (R^2 -
/// R_i^2)/lambda.
double current_radius_mm(double inner_radius_mm, double reference_radius_mm, const Deformation& at);

}  // namespace latticast
