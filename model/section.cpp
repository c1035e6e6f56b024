// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/section.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>

#include "geometry/pattern/rings.h"
#include "model/gauss.h"

namespace latticast {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double mixture_rubber = 0.91;
constexpr double mixture_lattice = 0.09;

std::string grid_name(std::size_t index) {
  return "grid " + std::to_string(index);
}

double rest_shear_modulus(const Law& law) {
  if (const auto* rubber = std::get_if<NeoHookean>(&law)) return rubber->shear_modulus_mpa;
  if (const auto* rubber = std::get_if<Yeoh>(&law)) return 2 * rubber->c1_mpa;
  if (const auto* rubber = std::get_if<Gent>(&law)) return rubber->shear_modulus_mpa;
  throw UnsupportedDesign(
      "the liner has a linear law, which only the effective-rods model uses; straight grids need a "
      "rubber (neo-hookean, yeoh or gent)");
}

double youngs_modulus(const Lattice& lattice) {
  if (const auto* linear = std::get_if<Linear>(&lattice.material.law)) {
    return linear->youngs_modulus_mpa;
  }
  throw UnsupportedDesign(
      "the lattice material is a rubber; strands need a linear material (E, nu)");
}

/// Rings as they exist on the segment: how much of the layer they fill, and their pitch.
struct RingLayout {
  double fraction = 0;
  double pitch_mm = 0;  ///< 0: no rings
  double width_mm = 0;
};

RingLayout ring_layout(const Segment& segment) {
  const std::optional<Rings>& rings = segment.lattice->rings;
  if (!rings) return {};
  const auto count = static_cast<double>(ring_centres_mm(*rings, segment.length_mm).size());
  if (count == 0) return {};
  return {count * rings->width_mm / segment.length_mm, ring_pitch_mm(*rings, segment.length_mm),
          rings->width_mm};
}

/// k_t / V of one strand: 12 E I / L_t over w h L_t is E (w sin(alpha) / p)^2.
double joint_modulus(double modulus_mpa, double width_mm, double sine, const RingLayout& rings,
                     JointModel joint) {
  if (joint == JointModel::none || rings.pitch_mm == 0) return 0;
  const double slenderness = width_mm * sine / rings.pitch_mm;
  const double paper = modulus_mpa * slenderness * slenderness;
  if (joint == JointModel::paper) return paper;
  const double clear = rings.pitch_mm - rings.width_mm;
  if (!(clear > 0)) {
    throw UnsupportedDesign("the rings touch, so the strands have no clear span to bend in");
  }
  const double shortening = rings.pitch_mm / clear;
  return paper * shortening * shortening * shortening;
}

void refuse_uncovered(const Grid& grid, std::size_t index) {
  if (grid.horseshoe) {
    throw UnsupportedDesign(grid_name(index) +
                            " has horseshoe strands, whose response is not predicted yet");
  }
  const auto [thin, wide] = std::minmax_element(grid.widths_mm.begin(), grid.widths_mm.end());
  if (*thin != *wide) {
    throw UnsupportedDesign(grid_name(index) +
                            " has strands of unequal width; such a section bends, and bending is "
                            "not predicted yet");
  }
}

StrandFamily strand_family(const Segment& segment, std::size_t index, const RingLayout& rings,
                           const ModelChoice& model) {
  const Grid& grid = segment.lattice->grids[index];
  refuse_uncovered(grid, index);
  const double modulus = youngs_modulus(*segment.lattice);
  // Measured from the axis, mirrored angles have exactly mirrored directions: a symmetric lattice
  // is symmetric to the last bit, and does not twist.
  const double from_axis = (90 - grid.angle_deg) * pi / 180;
  StrandFamily family{std::sin(from_axis), std::cos(from_axis), 0, 0};
  const bool layered = model.wall == WallKind::layered;
  const double around = 2 * pi * segment.lattice_mid_radius_mm() * family.sine;
  double filled = 0;
  for (const double width : grid.widths_mm) {
    // The mixture counts no strips: a family as a whole carries c2, whatever its number of strands.
    const double fraction = layered ? width / around : mixture_lattice / grid.count();
    filled += fraction;
    family.stretch_modulus_mpa += fraction * modulus;
    family.joint_modulus_mpa +=
        fraction * joint_modulus(modulus, width, family.sine, rings, model.joint);
  }
  if (layered && filled > 1) {
    throw UnsupportedDesign("the strands of " + grid_name(index) + " overlap: they would fill " +
                            std::to_string(filled) + " times the layer at mid radius");
  }
  return family;
}

void add_lattice(const Segment& segment, const ModelChoice& model, Section& section) {
  const bool mixture = model.wall == WallKind::mixture;
  if (mixture) {
    section.isotropic_fraction = mixture_rubber;
    section.isotropic_to_mm = section.outer_radius_mm;
  }
  section.anisotropic_from_mm = mixture ? section.inner_radius_mm : section.liner_outer_radius_mm;
  section.anisotropic_to_mm = section.outer_radius_mm;
  const RingLayout rings = ring_layout(segment);
  const double share = mixture && rings.pitch_mm > 0 ? mixture_lattice : rings.fraction;
  section.ring_modulus_mpa = share * youngs_modulus(*segment.lattice);
  for (std::size_t i = 0; i < segment.lattice->grids.size(); ++i) {
    if (segment.lattice->grids[i].count() == 0) continue;
    section.families.push_back(strand_family(segment, i, rings, model));
  }
}

/// Stretch measures that all energies share, free of differences of nearly equal numbers.
template <class Number>
struct Kinematics {
  Number axial;        ///< lambda^2 - 1
  Number axial_ratio;  ///< 1 - 1/lambda
  Number inner;        ///< a^2 - R_i^2
  Number elongation;
  Number twist;
  double inner_radius;

  /// (r/R)^2 - 1 at reference radius R.
  Number hoop(double radius) const {
    const double outside = (radius - inner_radius) * (radius + inner_radius);
    return (inner - outside * axial_ratio) * (1 / (radius * radius));
  }
};

template <class Number>
Kinematics<Number> kinematics(const Section& section, const Number& elongation, const Number& twist,
                              const Number& inner_growth) {
  return {elongation * (elongation + 2.0),
          elongation / (elongation + 1.0),
          inner_growth * (inner_growth + 2 * section.inner_radius_mm),
          elongation,
          twist,
          section.inner_radius_mm};
}

/// I1 - 3 = b + c + 1/(b c) - 3 + (k r)^2 with b = 1 + hoop, c = 1 + axial, brought to a form whose
/// every term is of second order in the strains.
template <class Number>
Number first_invariant_minus_3(const Kinematics<Number>& q, double radius) {
  const Number x = q.hoop(radius);
  const Number& y = q.axial;
  const Number xy = x * y;
  const Number sum = x + y;
  const Number shear = q.twist * radius;
  return (sum * sum - xy + sum * xy) / (sum + xy + 1.0) + shear * shear * (x + 1.0);
}

template <class Number>
Number energy_density(const NeoHookean& law, const Number& j) {
  return j * (0.5 * law.shear_modulus_mpa);
}

template <class Number>
Number energy_density(const Yeoh& law, const Number& j) {
  return j * (j * (j * law.c3_mpa + law.c2_mpa) + law.c1_mpa);
}

template <class Number>
Number energy_density(const Gent& law, const Number& j) {
  return log1p(j * (-1 / law.limit_jm)) * (-0.5 * law.shear_modulus_mpa * law.limit_jm);
}

template <class Number>
Number energy_density(const Linear&, const Number&) {
  return Number(0);  // prepare_section lets no such liner through
}

/// The liner law decides once, outside the loop over points.
template <class Number>
Number liner_energy(const Section& section, const Quadrature& quadrature,
                    const Kinematics<Number>& q) {
  return std::visit(
      [&](const auto& law) {
        Number sum(0);
        for (const auto& [radius, weight] : quadrature.liner) {
          sum += energy_density(law, first_invariant_minus_3(q, radius)) *
                 (weight * section.isotropic_fraction);
        }
        return sum;
      },
      section.liner_law);
}

/// E/2 (s - 1)^2 + k/2 theta_t^2 of one family. With A = (c, s) around and along the tube,
/// F A = (r/R) (c + k R s) e_theta + lambda s e_z.
template <class Number>
Number strand_energy_density(const StrandFamily& family, const Kinematics<Number>& q,
                             const Number& x, const Number& hoop_stretch_minus_1, double radius) {
  const double c = family.cosine;
  const double s = family.sine;
  const Number shear = q.twist * (radius * s);
  const Number around = shear + c;
  const Number square_minus_1 = x * square(around) + shear * (shear + 2 * c) + q.axial * (s * s);
  const Number strain = square_minus_1 / (sqrt(square_minus_1 + 1.0) + 1.0);
  Number energy = square(strain) * (0.5 * family.stretch_modulus_mpa);
  if (family.joint_modulus_mpa > 0) {
    const Number hoop_stretch = hoop_stretch_minus_1 + 1.0;
    const Number cross = ((q.elongation - hoop_stretch_minus_1) * c - hoop_stretch * shear) * s;
    const Number dot = hoop_stretch * around * c + (q.elongation + 1.0) * (s * s);
    energy += square(atan2(cross, dot)) * (0.5 * family.joint_modulus_mpa);
  }
  return energy;
}

template <class Number>
Number lattice_energy(const Section& section, const Quadrature& quadrature,
                      const Kinematics<Number>& q) {
  Number sum(0);
  for (const auto& [radius, weight] : quadrature.lattice) {
    const Number x = q.hoop(radius);
    const Number hoop_stretch_minus_1 = x / (sqrt(x + 1.0) + 1.0);
    Number density = square(hoop_stretch_minus_1) * (0.5 * section.ring_modulus_mpa);
    for (const StrandFamily& family : section.families) {
      density += strand_energy_density(family, q, x, hoop_stretch_minus_1, radius);
    }
    sum += density * weight;
  }
  return sum;
}

bool possible(const Section& section, const Deformation& at) {
  if (!std::isfinite(at.elongation) || !std::isfinite(at.twist) ||
      !std::isfinite(at.inner_growth)) {
    return false;
  }
  if (!(at.elongation > -1) || !(at.inner_growth > -section.inner_radius_mm)) return false;
  return stretch_limit_used(section, at) < 1;
}

std::vector<QuadraturePoint> points_between(double from, double to, int count) {
  if (!(to > from)) return {};
  const GaussRule rule = gauss_legendre(count);
  std::vector<QuadraturePoint> points(rule.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double radius = 0.5 * ((from + to) + (to - from) * rule.points[i]);
    points[i] = {radius, pi * (to - from) * rule.weights[i] * radius};
  }
  return points;
}

}  // namespace

Section prepare_section(const Segment& segment, const ModelChoice& model) {
  Section section;
  section.inner_radius_mm = segment.inner_radius_mm();
  section.liner_outer_radius_mm = segment.liner_outer_radius_mm();
  section.outer_radius_mm = segment.outer_radius_mm();
  section.isotropic_from_mm = section.inner_radius_mm;
  section.isotropic_to_mm = section.liner_outer_radius_mm;
  section.anisotropic_from_mm = section.anisotropic_to_mm = section.liner_outer_radius_mm;
  section.liner_law = segment.liner.material.law;
  section.shear_modulus_mpa = rest_shear_modulus(section.liner_law);
  if (segment.lattice) add_lattice(segment, model, section);
  return section;
}

Quadrature make_quadrature(const Section& section, int liner_points, int lattice_points) {
  return {points_between(section.isotropic_from_mm, section.isotropic_to_mm, liner_points),
          points_between(section.anisotropic_from_mm, section.anisotropic_to_mm, lattice_points)};
}

std::optional<SectionEnergy> stored_energy(const Section& section, const Quadrature& quadrature,
                                           const Deformation& at) {
  if (!possible(section, at)) return std::nullopt;
  const auto q =
      kinematics(section, SectionEnergy::variable(0, at.elongation),
                 SectionEnergy::variable(1, at.twist), SectionEnergy::variable(2, at.inner_growth));
  return liner_energy(section, quadrature, q) + lattice_energy(section, quadrature, q);
}

SectionEnergy cavity_growth(const Section& section, const Deformation& at) {
  const auto elongation = SectionEnergy::variable(0, at.elongation);
  const auto growth = SectionEnergy::variable(2, at.inner_growth);
  const double radius = section.inner_radius_mm;
  const SectionEnergy inner = growth * (growth + 2 * radius);
  return (inner * (elongation + 1.0) + elongation * (radius * radius)) * pi;
}

double stretch_limit_used(const Section& section, const Deformation& at) {
  const auto* gent = std::get_if<Gent>(&section.liner_law);
  if (gent == nullptr) return 0;
  const auto q = kinematics<double>(section, at.elongation, at.twist, at.inner_growth);
  return std::max(first_invariant_minus_3(q, section.isotropic_from_mm),
                  first_invariant_minus_3(q, section.isotropic_to_mm)) /
         gent->limit_jm;
}

double current_radius_mm(double inner_radius_mm, double reference_radius_mm,
                         const Deformation& at) {
  const double inner = inner_radius_mm + at.inner_growth;
  const double outside =
      (reference_radius_mm - inner_radius_mm) * (reference_radius_mm + inner_radius_mm);
  return std::sqrt(inner * inner + outside / (1 + at.elongation));
}

}  // namespace latticast
