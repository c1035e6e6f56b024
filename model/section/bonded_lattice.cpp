// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/section/bonded_lattice.h"

#include <algorithm>
#include <cmath>

#include "design/units.h"

namespace latticast {
namespace {

struct Wall {
  WallEnergy hoop;
  WallEnergy elongation;
  WallEnergy twist;

  explicit Wall(const WallStrains& at)
      : hoop(WallEnergy::variable(0, at.hoop)),
        elongation(WallEnergy::variable(1, at.elongation)),
        twist(WallEnergy::variable(2, at.twist)) {}
};

StrandStretch<WallEnergy> stretch_in(const Wall& wall, double cosine, double sine,
                                     double radius_mm) {
  return {.cosine = cosine,
          .sine = sine,
          .hoop = wall.hoop * (wall.hoop + 2.0),
          .hoop_strain = wall.hoop,
          .shear = wall.twist * (radius_mm * sine),
          .elongation = wall.elongation,
          .axial = wall.elongation * (wall.elongation + 2.0)};
}

/// 1 - sqrt(R/r): by how much a ring narrows that widens to r.
WallEnergy narrowing(const WallEnergy& hoop) {
  const WallEnergy stretch = hoop + 1.0;
  return hoop / (stretch + sqrt(stretch));
}

}  // namespace

StrandStretch<WallEnergy> strand_stretch(double cosine, double sine, const WallStrains& at) {
  return stretch_in(Wall(at), cosine, sine, at.radius_mm);
}

WallEnergy bonded_strand_energy(const StrandFamily& family, double stretch_modulus_mpa,
                                double joint_modulus_mpa, double ring_share,
                                const WallStrains& at) {
  const double free = 1 - ring_share;
  Wall wall(at);
  wall.elongation += narrowing(wall.hoop) * ring_share;
  wall.elongation *= 1 / free;
  wall.twist *= 1 / free;
  const auto strand = stretch_in(wall, family.cosine, family.sine, at.radius_mm);
  WallEnergy energy = square(strand.strain()) * (0.5 * free * stretch_modulus_mpa);
  if (joint_modulus_mpa > 0) energy += square(strand.turn()) * (0.5 * joint_modulus_mpa);
  return energy;
}

WallEnergy ring_pad_energy(double pad_mm, const WallStrains& at) {
  const Wall wall(at);
  const WallEnergy shear = wall.twist * (wall.hoop + 1.0) * at.radius_mm;
  return (square(shear) + square(wall.elongation) * 2.0) * (0.5 * pad_mm);
}

WallEnergy strip_pad_energy(const StrandFamily& family, double pad_mm, const WallStrains& at) {
  const Wall wall(at);
  const auto strand = stretch_in(wall, family.cosine, family.sine, at.radius_mm);
  // n is turned by F to across F A by det F/|F A|, and along it by (F n).(F A)/|F A|.
  const WallEnergy inverse = reciprocal(strand.strain() + 1.0);
  const WallEnergy area = wall.hoop + wall.elongation + wall.hoop * wall.elongation;
  const WallEnergy gap = (area - strand.strain()) * inverse;
  const WallEnergy hoop_stretch = wall.hoop + 1.0;
  const WallEnergy shear = wall.twist * hoop_stretch * at.radius_mm;
  const double c = family.cosine;
  const double s = family.sine;
  const WallEnergy slip = ((strand.axial - strand.hoop + square(shear)) * (c * s) +
                           shear * hoop_stretch * (c * c - s * s)) *
                          inverse;
  return (square(slip) + square(gap) * 2.0) * (0.5 * pad_mm);
}

double pad_thickness_mm(double period_mm, double covered, double liner_thickness_mm) {
  const double half_space = -period_mm / pi * std::log(std::cos(0.5 * pi * covered));
  return std::min(half_space, liner_thickness_mm * covered / (1 - covered));
}

double clear_shear_joint_mpa(const Linear& material, double width_mm, double sine, double pitch_mm,
                             double ring_width_mm) {
  if (pitch_mm == 0) return 0;
  const double clear = (pitch_mm - ring_width_mm) / sine;
  const double slenderness = width_mm / clear;
  const double shear = 2.4 * (1 + material.poisson_ratio) * slenderness * slenderness;
  return material.youngs_modulus_mpa * width_mm * width_mm / (clear * pitch_mm / sine) /
         (1 + shear);
}

}  // namespace latticast
