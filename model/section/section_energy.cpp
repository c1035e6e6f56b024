// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/section/section_energy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "design/units.h"
#include "model/section/bonded_lattice.h"
#include "model/section/calibration.h"
#include "model/section/strand_stretch.h"

namespace latticast {
namespace {

/// Stretch measures that all energies share, free of differences of nearly equal numbers.
template <class Number>
struct Kinematics {
  Number axial;        ///< lambda^2 - 1
  Number axial_ratio;  ///< 1 - 1/lambda
  Number inner;        ///< a^2 - R_i^2
  Number elongation;
  Number twist;
  Number bend_1;
  Number bend_2;
  double inner_radius;

  /// (r/R)^2 - 1 at reference radius R.
  Number hoop(double radius) const {
    const double outside = (radius - inner_radius) * (radius + inner_radius);
    return (inner - outside * axial_ratio) * (1 / (radius * radius));
  }
};

/// What is the same all around the tube at one reference radius. A straight tube is written apart
/// by `bent`: it is by far the most frequent, and needs half of the work.
template <bool bent, class Number>
struct AtRadius {
  double radius;
  Number hoop;                            ///< (r/R)^2 - 1
  Number hoop_strain;                     ///< r/R - 1
  std::array<Number, bent ? 2 : 0> lift;  ///< r kappa: what Lambda gains along either axis

  AtRadius(const Kinematics<Number>& q, double reference_radius)
      : radius(reference_radius),
        hoop(q.hoop(reference_radius)),
        hoop_strain(stretch_minus_1(hoop)) {
    if constexpr (bent) {
      const Number current = (hoop_strain + 1.0) * radius;
      lift = {current * q.bend_1, current * q.bend_2};
    }
  }

  /// Lambda - 1 in a direction of the section.
  Number elongation(const Kinematics<Number>& q, double cosine, double sine) const {
    if constexpr (bent) return q.elongation + lift[0] * cosine + lift[1] * sine;
    return q.elongation;
  }
};

template <class Number>
Kinematics<Number> kinematics(const Section& section, const std::array<Number, 5>& q) {
  return {q[0] * (q[0] + 2.0),
          q[0] / (q[0] + 1.0),
          q[2] * (q[2] + 2 * section.inner_radius_mm),
          q[0],
          q[1],
          q[3],
          q[4],
          section.inner_radius_mm};
}

/// How the wall is stretched within its own plane: area = (r/R) Lambda - 1, distortion =
/// (r/R - Lambda)^2 + (k r)^2.
template <class Number>
struct WallPlane {
  Number area;
  Number distortion;

  WallPlane(const Number& hoop_strain, const Number& elongation, const Number& shear_squared)
      : area(hoop_strain * elongation + hoop_strain + elongation),
        distortion(square(hoop_strain - elongation) + shear_squared) {}
};

/// The law is evaluated in plain numbers and chained, so that none of it is compiled for every set
/// of unknowns; but for the most frequent one, of which there is little.
template <bool bent, class Number>
Number liner_energy(const Section& section, const Quadrature& quadrature,
                    const Kinematics<Number>& q) {
  const auto* neo_hookean = std::get_if<NeoHookean>(&section.liner_law);
  Number sum(0);
  for (const auto& [radius, weight] : quadrature.liner) {
    const AtRadius<bent, Number> at(q, radius);
    const Number shear_squared = square((at.hoop_strain + 1.0) * (q.twist * radius));
    const auto add = [&](const Number& elongation, double share) {
      const WallPlane<Number> plane(at.hoop_strain, elongation, shear_squared);
      const InPlaneStretch stretch{plane.area.value, plane.distortion.value};
      const EnergyDensity w = neo_hookean != nullptr ? neo_hookean->energy_density(stretch)
                                                     : energy_density(section.liner_law, stretch);
      sum += chain(plane.area, plane.distortion,
                   {.value = w.value,
                    .by_x = w.by_area,
                    .by_y = w.by_distortion,
                    .by_xx = w.by_area_area,
                    .by_xy = w.by_area_distortion,
                    .by_yy = w.by_distortion_distortion}) *
             share;
    };
    const double share = weight * section.isotropic_fraction;
    if constexpr (bent) {
      for (const Direction& direction : quadrature.around) {
        add(at.elongation(q, direction.cosine, direction.sine), share * direction.weight);
      }
    } else {
      add(q.elongation, share);
    }
  }
  return sum;
}

/// Of a strand of this family where Lambda - 1 is `elongation`.
template <bool bent, class Number>
StrandStretch<Number> strand_stretch(const StrandFamily& family, const Kinematics<Number>& q,
                                     const AtRadius<bent, Number>& at, const Number& elongation,
                                     const Number& axial) {
  const Number shear = q.twist * (at.radius * family.sine);
  return {family.cosine, family.sine, at.hoop, at.hoop_strain, shear, elongation, axial};
}

/// E/2 (s - 1)^2 + k/2 theta_t^2 of straight strands with the given moduli.
template <bool bent, class Number>
Number strand_energy_density(const StrandFamily& family, double stretch_modulus,
                             double joint_modulus, const Kinematics<Number>& q,
                             const AtRadius<bent, Number>& at, const Number& elongation,
                             const Number& axial) {
  const StrandStretch<Number> strand = strand_stretch<bent>(family, q, at, elongation, axial);
  Number energy = square(strand.strain()) * (0.5 * stretch_modulus);
  if (joint_modulus > 0) energy += square(strand.turn()) * (0.5 * joint_modulus);
  return energy;
}

bool is_averaged(const StrandFamily& family, const Quadrature& quadrature) {
  return family.averaged || quadrature.average_strands;
}

/// Strands of a bent section, or directions where they are averaged around the tube.
std::size_t place_count(const StrandFamily& family, const Quadrature& quadrature) {
  return is_averaged(family, quadrature) ? quadrature.around.size() : family.strands.size();
}

struct StraightStrand {
  double cosine, sine, stretch_modulus_mpa, joint_modulus_mpa, pad_mm;
};

StraightStrand straight_strand(const StrandFamily& family, const Quadrature& quadrature,
                               std::size_t place) {
  if (is_averaged(family, quadrature)) {
    const Direction& d = quadrature.around[place];
    return {d.cosine, d.sine, family.stretch_modulus_mpa * d.weight,
            family.joint_modulus_mpa * d.weight, family.pad_mm * d.weight};
  }
  const StrandPlace& strand = family.strands[place];
  return {strand.cosine, strand.sine, strand.stretch_modulus_mpa, strand.joint_modulus_mpa,
          strand.pad_mm};
}

template <bool bent, class Number>
Number family_energy_density(const StrandFamily& family, const Quadrature& quadrature,
                             const Kinematics<Number>& q, const AtRadius<bent, Number>& at) {
  if constexpr (!bent) {
    return strand_energy_density(family, family.stretch_modulus_mpa, family.joint_modulus_mpa, q,
                                 at, q.elongation, q.axial);
  }
  Number sum(0);
  for (std::size_t i = 0; i < place_count(family, quadrature); ++i) {
    const StraightStrand strand = straight_strand(family, quadrature, i);
    const Number e = at.elongation(q, strand.cosine, strand.sine);
    sum += strand_energy_density(family, strand.stretch_modulus_mpa, strand.joint_modulus_mpa, q,
                                 at, e, e * (e + 2.0));
  }
  return sum;
}

template <bool bent, class Number>
Number lattice_energy(const Section& section, const Quadrature& quadrature,
                      const Kinematics<Number>& q) {
  Number sum(0);
  for (const auto& [radius, weight] : quadrature.lattice) {
    const AtRadius<bent, Number> at(q, radius);
    Number density = square(at.hoop_strain) * (0.5 * section.ring_modulus_mpa);
    for (const StrandFamily& family : section.families) {
      if (family.links_per_mm > 0) continue;
      density += family_energy_density(family, quadrature, q, at);
    }
    sum += density * weight;
  }
  return sum;
}

/// An energy of the wall's strains, `energy_at` evaluated in plain numbers and chained.
template <bool bent, class Number, class Energy>
Number of_wall(const Kinematics<Number>& q, const AtRadius<bent, Number>& at,
               const Number& elongation, const Energy& energy_at) {
  const WallEnergy energy =
      energy_at({at.radius, at.hoop_strain.value, elongation.value, q.twist.value});
  return chain(std::array<Number, 3>{at.hoop_strain, elongation, q.twist}, energy);
}

/// Sum over a family's straight strands of an energy of the wall's strains and the strand.
template <bool bent, class Number, class Energy>
Number of_strands(const StrandFamily& family, const Quadrature& quadrature,
                  const Kinematics<Number>& q, const AtRadius<bent, Number>& at,
                  const Energy& energy_at) {
  if constexpr (!bent) {
    const StraightStrand all{1, 0, family.stretch_modulus_mpa, family.joint_modulus_mpa,
                             family.pad_mm};
    return of_wall(q, at, q.elongation,
                   [&](const WallStrains& wall) { return energy_at(all, wall); });
  }
  Number sum(0);
  for (std::size_t i = 0; i < place_count(family, quadrature); ++i) {
    const StraightStrand strand = straight_strand(family, quadrature, i);
    sum += of_wall(q, at, at.elongation(q, strand.cosine, strand.sine),
                   [&](const WallStrains& wall) { return energy_at(strand, wall); });
  }
  return sum;
}

/// Sum over directions of the pad that rings hold.
template <bool bent, class Number>
Number ring_pad(const Bond& bond, const Quadrature& quadrature, const Kinematics<Number>& q,
                const AtRadius<bent, Number>& at) {
  const auto pad = [&](const WallStrains& wall) { return ring_pad_energy(bond.ring_pad_mm, wall); };
  if constexpr (!bent) return of_wall(q, at, q.elongation, pad);
  Number sum(0);
  for (const Direction& direction : quadrature.around) {
    sum +=
        of_wall(q, at, at.elongation(q, direction.cosine, direction.sine), pad) * direction.weight;
  }
  return sum;
}

/// The same lattice as plates that are bonded to the liner; kept out of what most sections need.
template <bool bent, class Number>
[[gnu::noinline]] Number bonded_energy(const Section& section, const Bond& bond,
                                       const Quadrature& quadrature, const Kinematics<Number>& q) {
  Number sum(0);
  for (const auto& [radius, weight] : quadrature.lattice) {
    const AtRadius<bent, Number> at(q, radius);
    Number density = square(at.hoop_strain) * (0.5 * section.ring_modulus_mpa);
    for (const StrandFamily& family : section.families) {
      if (family.links_per_mm > 0) continue;
      density += of_strands(
          family, quadrature, q, at, [&](const StraightStrand& strand, const WallStrains& wall) {
            return bonded_strand_energy(family, strand.stretch_modulus_mpa,
                                        strand.joint_modulus_mpa, bond.ring_share, wall);
          });
    }
    sum += density * weight;
  }
  const AtRadius<bent, Number> face(q, section.liner_outer_radius_mm);
  Number pads = ring_pad(bond, quadrature, q, face);
  for (const StrandFamily& family : section.families) {
    if (family.links_per_mm > 0) continue;
    pads += of_strands(family, quadrature, q, face,
                       [&](const StraightStrand& strand, const WallStrains& wall) {
                         return strip_pad_energy(family, strand.pad_mm, wall);
                       });
  }
  sum += pads * (2 * pi * section.liner_outer_radius_mm * section.shear_modulus_mpa);
  return sum;
}

/// What a unit cell has set.
template <bool bent, class Number>
Number calibrated_energy(const Calibration& calibration, const Kinematics<Number>& q) {
  const AtRadius<bent, Number> middle(q, calibration.radius_mm);
  std::array<Number, most_natural_strains> strains = {middle.hoop_strain, q.elongation, q.twist,
                                                      Number(0), Number(0)};
  if constexpr (bent) std::copy(middle.lift.begin(), middle.lift.end(), strains.begin() + 3);
  MiddleStrains values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = strains[i].value;
  return chain(strains, calibration_energy(calibration, values));
}

/// Visits the places of a family of curved strands: law, direction, and how many strands are there.
template <bool bent, class Visit>
void for_each_place(const StrandFamily& family, const Quadrature& quadrature, const Visit& visit) {
  if constexpr (bent) {
    const bool averaged = is_averaged(family, quadrature);
    const auto count = static_cast<double>(family.strands.size());
    for (std::size_t i = 0; i < place_count(family, quadrature); ++i) {
      const StrandPlace& strand = family.strands[averaged ? 0 : i];
      Direction direction{strand.cosine, strand.sine, 1};
      if (averaged) {
        direction = quadrature.around[i];
        direction.weight *= count;
      }
      visit(*strand.law, direction);
    }
  } else {
    // Direction does not matter: strands of one law, successive ones, are taken together.
    for (auto first = family.strands.begin(); first != family.strands.end();) {
      const auto last = std::find_if(first, family.strands.end(), [&](const StrandPlace& strand) {
        return strand.law != first->law;
      });
      visit(*first->law, Direction{1, 0, static_cast<double>(last - first)});
      first = last;
    }
  }
}

double mid_radius_mm(const Section& section) {
  return 0.5 * (section.liner_outer_radius_mm + section.outer_radius_mm);
}

/// Empty when a link leaves its law's range. The law's force is d energy/d chord.
template <bool bent, class Number>
std::optional<Number> link_energy(const Section& section, const Quadrature& quadrature,
                                  const Kinematics<Number>& q) {
  Number sum(0);
  bool possible = true;
  for (const StrandFamily& family : section.families) {
    if (family.links_per_mm == 0) continue;
    const AtRadius<bent, Number> at(q, mid_radius_mm(section));
    for_each_place<bent>(family, quadrature, [&](const StrandLaw& law, const Direction& place) {
      const Number e = at.elongation(q, place.cosine, place.sine);
      const Number strain = strand_stretch<bent>(family, q, at, e, e * (e + 2.0)).strain();
      const auto arc = law.at(strain.value);
      if (!arc) {
        possible = false;
        return;
      }
      const double chord = law.rest_chord_mm();
      sum += chain(strain, arc->energy_nmm, arc->force_n * chord, arc->slope_n * chord) *
             (family.links_per_mm * place.weight);
    });
  }
  if (!possible) return std::nullopt;
  return sum;
}

bool bends(const Deformation& at) {
  return at.bend_1 != 0 || at.bend_2 != 0;
}

bool possible(const Section& section, const Deformation& at) {
  if (!std::isfinite(at.elongation) || !std::isfinite(at.twist) ||
      !std::isfinite(at.inner_growth) || !std::isfinite(at.bend_1) || !std::isfinite(at.bend_2)) {
    return false;
  }
  if (!(at.elongation > -1) || !(at.inner_growth > -section.inner_radius_mm)) return false;
  if (bends(at)) {
    const double lift = std::hypot(at.bend_1, at.bend_2) *
                        current_radius_mm(section.inner_radius_mm, section.outer_radius_mm, at);
    if (!(1 + at.elongation - lift > 0)) return false;
  }
  return stretch_limit_used(section, at) < 1;
}

std::array<double, 5> numbers(const Deformation& at) {
  return {at.elongation, at.twist, at.inner_growth, at.bend_1, at.bend_2};
}

/// At most N active coordinates.
// Flattened, since the compiler stops inlining when so many versions of one formula stand side by
// side, and then takes 1.6 times as long.
template <bool bent, std::size_t N>
[[gnu::flatten]] std::optional<SectionEnergy> energy_with(const Section& section,
                                                          const Quadrature& quadrature,
                                                          const Deformation& at,
                                                          std::span<const int> active) {
  const std::array<double, 5> values = numbers(at);
  std::array<Dual<N>, 5> variables;
  for (std::size_t i = 0; i < values.size(); ++i) variables[i] = Dual<N>(values[i]);
  for (std::size_t i = 0; i < active.size(); ++i) {
    variables[active[i]] = Dual<N>::variable(i, values[active[i]]);
  }
  const auto q = kinematics(section, variables);
  const auto links = link_energy<bent>(section, quadrature, q);
  if (!links) return std::nullopt;
  const Dual<N> lattice = section.bond ? bonded_energy<bent>(section, *section.bond, quadrature, q)
                                       : lattice_energy<bent>(section, quadrature, q);
  Dual<N> sum = liner_energy<bent>(section, quadrature, q) + lattice + *links;
  if (section.calibration) sum += calibrated_energy<bent>(*section.calibration, q);
  SectionEnergy energy(sum.value);
  for (std::size_t i = 0; i < active.size(); ++i) {
    energy.gradient[active[i]] = sum.gradient[i];
    for (std::size_t j = i; j < active.size(); ++j) {
      energy.set_second(active[i], active[j], sum.second(i, j));
    }
  }
  return energy;
}

}  // namespace

std::optional<SectionEnergy> stored_energy(const Section& section, const Quadrature& quadrature,
                                           const Deformation& at, std::span<const int> active) {
  if (!possible(section, at)) return std::nullopt;
  const bool bent = bends(at) || std::any_of(active.begin(), active.end(),
                                             [](int i) { return i >= coordinate::bend_1; });
  // What coordinates are held for is rare: not worth versions of its own.
  switch (active.size()) {
    case 1:
    case 2:
      if (!bent) return energy_with<false, 2>(section, quadrature, at, active);
      [[fallthrough]];
    case 3:
      return bent ? energy_with<true, 3>(section, quadrature, at, active)
                  : energy_with<false, 3>(section, quadrature, at, active);
    case 4:
      return energy_with<true, 4>(section, quadrature, at, active);
    default:
      return energy_with<true, 5>(section, quadrature, at, active);
  }
}

std::optional<SectionEnergy> stored_energy(const Section& section, const Quadrature& quadrature,
                                           const Deformation& at) {
  constexpr std::array<int, 5> all = {0, 1, 2, 3, 4};
  return stored_energy(section, quadrature, at, all);
}

std::array<double, coordinate_count> law_error(const Section& section, const Quadrature& quadrature,
                                               const Deformation& at) {
  std::array<double, coordinate_count> error{};
  const std::array<double, 5> values = numbers(at);
  std::array<SectionEnergy, 5> variables;
  for (std::size_t i = 0; i < 5; ++i) variables[i] = SectionEnergy::variable(i, values[i]);
  const auto q = kinematics(section, variables);
  for (const StrandFamily& family : section.families) {
    if (family.links_per_mm == 0) continue;
    const AtRadius<true, SectionEnergy> ring(q, mid_radius_mm(section));
    for_each_place<true>(family, quadrature, [&](const StrandLaw& law, const Direction& place) {
      const SectionEnergy e = ring.elongation(q, place.cosine, place.sine);
      const SectionEnergy strain = strand_stretch<true>(family, q, ring, e, e * (e + 2.0)).strain();
      const LinkState arc = law.at(strain.value).value_or(LinkState{});
      const double work = std::abs(arc.force_n) * arc.error * law.rest_chord_mm();
      for (int i = 0; i < coordinate_count; ++i) {
        error[i] += family.links_per_mm * place.weight * work * std::abs(strain.gradient[i]);
      }
    });
  }
  return error;
}

SectionEnergy cavity_growth(const Section& section, const Deformation& at) {
  const double radius = section.inner_radius_mm;
  const double stretch = 1 + at.elongation;
  const double bore = radius + at.inner_growth;
  SectionEnergy growth(
      pi * (at.inner_growth * (bore + radius) * stretch + at.elongation * radius * radius));
  growth.gradient[coordinate::elongation] = pi * bore * bore;
  growth.gradient[coordinate::inner_growth] = 2 * pi * bore * stretch;
  growth.set_second(coordinate::elongation, coordinate::inner_growth, 2 * pi * bore);
  growth.set_second(coordinate::inner_growth, coordinate::inner_growth, 2 * pi * stretch);
  return growth;
}

double stretch_limit_used(const Section& section, const Deformation& at) {
  const double limit = first_invariant_limit(section.liner_law);
  if (std::isinf(limit)) return 0;
  const auto q = kinematics<double>(section, numbers(at));
  const double bend = std::hypot(at.bend_1, at.bend_2);
  double largest = 0;
  for (const double radius : {section.isotropic_from_mm, section.isotropic_to_mm}) {
    const AtRadius<false, double> ring(q, radius);
    const double stretch = 1 + ring.hoop_strain;
    const double shear = stretch * at.twist * radius;
    const double lift = bend * radius * stretch;
    for (const double e : {at.elongation - lift, at.elongation + lift}) {
      const WallPlane<double> plane(ring.hoop_strain, e, shear * shear);
      largest = std::max(largest, first_invariant_minus_3({plane.area, plane.distortion}).value);
    }
  }
  return largest / limit;
}

std::optional<LinkStrain> most_strained_link(const Section& section, const Deformation& at) {
  const bool any = std::any_of(section.families.begin(), section.families.end(),
                               [](const StrandFamily& family) { return family.links_per_mm > 0; });
  if (!any || !possible(section, at)) return std::nullopt;
  const double radius = mid_radius_mm(section);
  const double current = current_radius_mm(section.inner_radius_mm, radius, at);
  std::optional<LinkStrain> worst;
  double least_room = std::numeric_limits<double>::infinity();
  for (const StrandFamily& family : section.families) {
    if (family.links_per_mm == 0) continue;
    for (const StrandPlace& strand : family.strands) {
      const double axial =
          1 + at.elongation + current * (at.bend_1 * strand.cosine + at.bend_2 * strand.sine);
      const double around = current / radius * (family.cosine + at.twist * radius * family.sine);
      const double strain = std::hypot(around, axial * family.sine) - 1;
      const StrainRange& range = strand.law->range();
      const double room = std::min((strain - range.lowest) / -range.lowest,
                                   (range.highest - strain) / range.highest);
      if (room < least_room) {
        least_room = room;
        worst = LinkStrain{path_name(strand.law->shape()), strain, range};
      }
    }
  }
  return worst;
}

}  // namespace latticast
