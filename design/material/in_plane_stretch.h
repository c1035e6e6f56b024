// SPDX-License-Identifier: GPL-3.0-or-later
// Strain measures of an incompressible sheet, and energy densities with their derivatives by them:
// Evans and Skalak's area and shear measures [Evans 1980], the second times 2 lambda_1 lambda_2.
#pragma once

namespace latticast {

/// Principal stretches lambda_1 and lambda_2 in a plane, the third being 1/(lambda_1 lambda_2).
/// Both numbers are 0 at rest and analytic in the deformation, also where the stretches coincide:
/// with C the plane's right Cauchy-Green tensor, area = sqrt(det C) - 1 and
/// distortion = tr C - 2 sqrt(det C). Every isotropic energy is a function of them, and in
/// which of its three principal planes they are taken is a matter of choice.
struct InPlaneStretch {
  double area = 0;        ///< lambda_1 lambda_2 - 1 > -1
  double distortion = 0;  ///< (lambda_1 - lambda_2)^2 >= 0
};

/// An energy per reference volume in MPa with its exact derivatives by an InPlaneStretch.
struct EnergyDensity {
  double value = 0;
  double by_area = 0;
  double by_distortion = 0;
  double by_area_area = 0;
  double by_area_distortion = 0;
  double by_distortion_distortion = 0;
};

constexpr EnergyDensity operator+(const EnergyDensity& a, const EnergyDensity& b) {
  return {.value = a.value + b.value,
          .by_area = a.by_area + b.by_area,
          .by_distortion = a.by_distortion + b.by_distortion,
          .by_area_area = a.by_area_area + b.by_area_area,
          .by_area_distortion = a.by_area_distortion + b.by_area_distortion,
          .by_distortion_distortion = a.by_distortion_distortion + b.by_distortion_distortion};
}

constexpr EnergyDensity operator*(double factor, const EnergyDensity& w) {
  return {.value = factor * w.value,
          .by_area = factor * w.by_area,
          .by_distortion = factor * w.by_distortion,
          .by_area_area = factor * w.by_area_area,
          .by_area_distortion = factor * w.by_area_distortion,
          .by_distortion_distortion = factor * w.by_distortion_distortion};
}

/// I1 - 3 with its derivatives. Free of differences of nearly equal numbers: full relative accuracy
/// down to rest.
constexpr EnergyDensity first_invariant_minus_3(const InPlaneStretch& at) {
  const double u = at.area;
  const double s = 1 + u;
  return {.value = at.distortion + u * u * (3 + 2 * u) / (s * s),
          .by_area = 2 * u * (3 + u * (3 + u)) / (s * s * s),
          .by_distortion = 1,
          .by_area_area = 6 / (s * s * s * s),
          .by_area_distortion = 0,
          .by_distortion_distortion = 0};
}

/// An energy f(I1 - 3) given f, f' and f'' at first_invariant_minus_3(at).value.
constexpr EnergyDensity of_first_invariant(const EnergyDensity& j, double f, double f1, double f2) {
  return {.value = f,
          .by_area = f1 * j.by_area,
          .by_distortion = f1,
          .by_area_area = f2 * j.by_area * j.by_area + f1 * j.by_area_area,
          .by_area_distortion = f2 * j.by_area,
          .by_distortion_distortion = f2};
}

}  // namespace latticast
