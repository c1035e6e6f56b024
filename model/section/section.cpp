// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/section/section.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <unordered_set>
#include <variant>

#include "geometry/pattern/rings.h"
#include "model/horseshoe/horseshoe_strands.h"
#include "model/numerics/gauss.h"
#include "model/section/mirror_places.h"

namespace latticast {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double mixture_rubber = 0.91;
constexpr double mixture_lattice = 0.09;
constexpr int many_strands =
    128;  // as many as there are directions at most, see model/equilibrium/balance.cpp
constexpr double panel_ratio = 4;  // thickness of successive panels
constexpr int most_panels = 24;

std::string grid_name(std::size_t index) {
  return "grid " + std::to_string(index);
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

bool is_even(const Grid& grid) {
  return grid.count() >= 2 &&
         std::equal(grid.widths_mm.begin() + 1, grid.widths_mm.end(), grid.widths_mm.begin());
}

void refuse_in_mixture(const Grid& grid, std::size_t index) {
  if (grid.horseshoe) {
    throw UnsupportedDesign(grid_name(index) +
                            " has horseshoe strands, which the mixture wall cannot tell from "
                            "straight ones; use kind = \"layered\"");
  }
  const auto [thin, wide] = std::minmax_element(grid.widths_mm.begin(), grid.widths_mm.end());
  if (*thin != *wide) {
    throw UnsupportedDesign(grid_name(index) +
                            " has strands of unequal width, so the section bends, but the mixture "
                            "wall counts no strips; use kind = \"layered\"");
  }
}

struct Layer {
  const Segment& segment;
  const ModelChoice& model;
  RingLayout rings;
  LawsByShape laws;
};

StrandFamily strand_family(const Layer& layer, std::size_t index) {
  const Segment& segment = layer.segment;
  const Grid& grid = segment.lattice->grids[index];
  const bool layered = layer.model.wall == WallKind::layered;
  if (!layered) refuse_in_mixture(grid, index);
  const double modulus = strand_modulus_mpa(*segment.lattice);
  // Exactly mirrored for mirrored angles: a symmetric lattice is symmetric to the last bit, and
  // does not twist.
  const StrandDirection direction = grid.direction();
  StrandFamily family;
  family.cosine = direction.cosine;
  family.sine = direction.sine;
  const double around = segment.lattice_circumference_mm() * family.sine;
  double filled = 0;
  for (const double width : grid.widths_mm) {
    StrandPlace strand;
    if (grid.horseshoe) {
      strand.law = layer.laws.at(horseshoe_shape(segment, grid, width));
      family.arcs_per_mm = 1 / (rest_chord_mm(strand.law->shape()) * family.sine);
    } else {
      // The mixture counts no strips: a family as a whole carries c2, whatever its strands.
      const double fraction = layered ? width / around : mixture_lattice / grid.count();
      filled += fraction;
      strand.stretch_modulus_mpa = fraction * modulus;
      strand.joint_modulus_mpa =
          fraction * joint_modulus(modulus, width, family.sine, layer.rings, layer.model.joint);
      family.stretch_modulus_mpa += strand.stretch_modulus_mpa;
      family.joint_modulus_mpa += strand.joint_modulus_mpa;
    }
    family.strands.push_back(std::move(strand));
  }
  if (layered && filled > 1) {
    throw UnsupportedDesign("the strands of " + grid_name(index) + " overlap: they would fill " +
                            std::to_string(filled) + " times the layer at mid radius");
  }
  return family;
}

/// A grid that exists, with what decides on the section's symmetry.
struct Winding {
  std::size_t index = 0;  // among the grids
  const Grid* grid = nullptr;
  bool even = true;
  double turn = 0;  // cot(alpha)/R_c, rad/mm
};

std::vector<Winding> windings(const Segment& segment, const ModelChoice& model,
                              const std::vector<StrandFamily>& families) {
  std::vector<Winding> result;
  for (std::size_t i = 0; i < segment.lattice->grids.size(); ++i) {
    const Grid& grid = segment.lattice->grids[i];
    if (grid.count() == 0) continue;
    const StrandFamily& family = families[result.size()];
    const bool even = model.wall == WallKind::mixture || is_even(grid);
    const double turn = family.cosine / (family.sine * segment.lattice_mid_radius_mm());
    result.push_back({i, &grid, even, turn});
  }
  return result;
}

bool same_turn(double a, double b) {
  return std::abs(a - b) <= 1e-12 * (std::abs(a) + std::abs(b));
}

/// The one turn of all uneven families; without any, that of the first pair of strands, whose
/// stiffness differs between directions.
double frame_turn(const std::vector<Winding>& all) {
  const Winding* first = nullptr;
  for (const Winding& winding : all) {
    if (winding.even) continue;
    if (first == nullptr) first = &winding;
    if (!same_turn(winding.turn, first->turn)) {
      throw UnsupportedDesign(
          grid_name(first->index) + " and " + grid_name(winding.index) +
          " are both uneven around the tube and wind at different rates (" +
          std::to_string(first->turn) + " and " + std::to_string(winding.turn) +
          " rad/mm), so the section changes along the tube; make one of them even");
    }
  }
  if (first != nullptr) return first->turn;
  for (const Winding& winding : all) {
    if (winding.grid->count() == 2) return winding.turn;
  }
  return 0;
}

/// Theta of a plane that mirrors the widths of all uneven families. Planes and their opposites are
/// one, so as many places as the first family has strands suffice.
std::optional<double> mirror_axis(const std::vector<Winding>& all) {
  std::vector<std::vector<bool>> uneven;
  for (const Winding& winding : all) {
    if (!winding.even) uneven.push_back(mirror_places(winding.grid->widths_mm));
  }
  if (uneven.empty()) return std::nullopt;
  const std::size_t n = uneven.front().size();
  for (std::size_t place = 0; place < n; ++place) {
    const auto mirrors = [&](const std::vector<bool>& places) {
      return place * places.size() % n == 0 && places[place * places.size() / n];
    };
    if (std::all_of(uneven.begin(), uneven.end(), mirrors)) {
      return pi * static_cast<double>(place) / static_cast<double>(n);
    }
  }
  return std::nullopt;
}

bool are_supplementary(const StrandFamily& a, const StrandFamily& b) {
  const auto same_strand = [](const StrandPlace& x, const StrandPlace& y) {
    return x.stretch_modulus_mpa == y.stretch_modulus_mpa &&
           x.joint_modulus_mpa == y.joint_modulus_mpa && x.law == y.law;
  };
  return a.cosine == -b.cosine && a.sine == b.sine && a.arcs_per_mm == b.arcs_per_mm &&
         std::equal(a.strands.begin(), a.strands.end(), b.strands.begin(), b.strands.end(),
                    same_strand);
}

/// Whether tilted families do not all come in mirrored pairs.
bool has_handedness(const std::vector<StrandFamily>& families) {
  std::multimap<double, const StrandFamily*> open;  // by how far they lean
  for (const StrandFamily& family : families) {
    if (family.cosine == 0) continue;
    const double lean = std::abs(family.cosine);
    const auto [first, last] = open.equal_range(lean);
    const auto partner = std::find_if(
        first, last, [&](const auto& other) { return are_supplementary(family, *other.second); });
    partner == last ? void(open.emplace(lean, &family)) : void(open.erase(partner));
  }
  return !open.empty();
}

/// Decides on the frame and on the unknowns that symmetry leaves, and puts strands at their places.
void settle_symmetry(const Segment& segment, const ModelChoice& model, Section& section) {
  const std::vector<Winding> all = windings(segment, model, section.families);
  section.frame_turn_rad_per_mm = frame_turn(all);
  const bool bends = std::any_of(all.begin(), all.end(), [](const Winding& w) { return !w.even; });
  bool unpaired = false;
  for (std::size_t i = 0; i < all.size(); ++i) {
    section.families[i].averaged = model.wall == WallKind::mixture ||
                                   !same_turn(all[i].turn, section.frame_turn_rad_per_mm) ||
                                   (all[i].even && all[i].grid->count() >= many_strands);
    if (!all[i].even && section.families[i].cosine != 0) unpaired = true;
  }
  section.twists = unpaired || has_handedness(section.families);
  const std::optional<double> axis = mirror_axis(all);
  // Also where strands are tilted: turned over about that axis, the section is the same again.
  section.bending_axes = !bends ? 0 : (axis ? 1 : 2);
  section.axis_rad = section.bending_axes == 1 ? *axis : 0;
  section.isotropic =
      model.wall == WallKind::mixture || std::none_of(all.begin(), all.end(), [](const Winding& w) {
        return !w.even || w.grid->count() == 2;
      });
  for (StrandFamily& family : section.families) {
    const auto n = static_cast<double>(family.strands.size());
    for (std::size_t j = 0; j < family.strands.size(); ++j) {
      const double angle = 2 * pi * static_cast<double>(j) / n - section.axis_rad;
      family.strands[j].cosine = std::cos(angle);
      family.strands[j].sine = std::sin(angle);
    }
  }
}

void add_lattice(const Segment& segment, const ModelChoice& model, const HorseshoeLaws& known,
                 Section& section) {
  const bool mixture = model.wall == WallKind::mixture;
  if (mixture) {
    section.isotropic_fraction = mixture_rubber;
    section.isotropic_to_mm = section.outer_radius_mm;
  }
  section.anisotropic_from_mm = mixture ? section.inner_radius_mm : section.liner_outer_radius_mm;
  section.anisotropic_to_mm = section.outer_radius_mm;
  const RingLayout rings = ring_layout(segment);
  const double share = mixture && rings.pitch_mm > 0 ? mixture_lattice : rings.fraction;
  section.ring_modulus_mpa = share * strand_modulus_mpa(*segment.lattice);
  const Layer layer{segment, model, rings, mixture ? LawsByShape{} : build_laws(segment, known)};
  for (std::size_t i = 0; i < segment.lattice->grids.size(); ++i) {
    if (segment.lattice->grids[i].count() == 0) continue;
    section.families.push_back(strand_family(layer, i));
  }
  settle_symmetry(segment, model, section);
}

const Law& rubber_law(const Material& liner) {
  if (!std::holds_alternative<Linear>(liner.law)) return liner.law;
  throw UnsupportedDesign(
      "the liner has a linear law, which only axial columns under columns = \"rods\" can use; "
      "other sections need a rubber (" +
      rubber_law_names() + ")");
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

std::vector<Direction> whole_turn(int count) {
  std::vector<Direction> directions(count);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    directions[i] = {std::cos(angle), std::sin(angle), 1.0 / count};
  }
  return directions;
}

}  // namespace

Section prepare_section(const Segment& segment, const ModelChoice& model,
                        const HorseshoeLaws& known) {
  Section section;
  section.inner_radius_mm = segment.inner_radius_mm();
  section.liner_outer_radius_mm = segment.liner_outer_radius_mm();
  section.outer_radius_mm = segment.outer_radius_mm();
  section.isotropic_from_mm = section.inner_radius_mm;
  section.isotropic_to_mm = section.liner_outer_radius_mm;
  section.anisotropic_from_mm = section.anisotropic_to_mm = section.liner_outer_radius_mm;
  section.liner_law = rubber_law(segment.liner.material);
  section.shear_modulus_mpa = rest_shear_modulus_mpa(section.liner_law);
  section.isotropic = true;
  if (segment.lattice) add_lattice(segment, model, known, section);
  return section;
}

HorseshoeLaws laws_of(const Section& section) {
  HorseshoeLaws laws;
  std::unordered_set<const HorseshoeLaw*> met;
  for (const StrandFamily& family : section.families) {
    for (const StrandPlace& strand : family.strands) {
      if (strand.law && met.insert(strand.law.get()).second) laws.push_back(strand.law);
    }
  }
  return laws;
}

Quadrature make_quadrature(const Section& section, int liner_points, int lattice_points, int around,
                           int bore_panels) {
  const auto points = [&](double from, double to, int count) {
    const int panels = from == section.inner_radius_mm ? bore_panels : 1;
    std::vector<QuadraturePoint> all;
    double begin = from;
    for (int i = 1; i <= panels; ++i) {
      const double end = i == panels ? to : from + (to - from) * std::pow(panel_ratio, i - panels);
      const std::vector<QuadraturePoint> panel = points_between(begin, end, count);
      all.insert(all.end(), panel.begin(), panel.end());
      begin = end;
    }
    return all;
  };
  return {points(section.isotropic_from_mm, section.isotropic_to_mm, liner_points),
          points(section.anisotropic_from_mm, section.anisotropic_to_mm, lattice_points),
          whole_turn(around)};
}

int bore_panels_for(const Section& section, const Deformation& at) {
  const double rest = section.inner_radius_mm;
  const double bore = 1 + at.inner_growth / rest;
  // Distance of the singularity from the bore, against the wall.
  double distance = 1;
  const double filled = (1 + at.elongation) * bore * bore;
  if (filled < 1) {
    // R_i - sqrt(R_i^2 - lambda a^2), without the difference of nearly equal numbers.
    distance = rest * filled / (1 + std::sqrt(1 - filled)) / (section.isotropic_to_mm - rest);
  }
  const double used = stretch_limit_used(section, at);
  if (used > 0.8) distance = std::min(distance, 0.25 * (1 - used));
  if (distance > 0.05) return 1;
  return std::min(most_panels,
                  1 + static_cast<int>(std::ceil(std::log(1 / distance) / std::log(panel_ratio))));
}

std::vector<Direction> half_turn(int intervals) {
  std::vector<Direction> directions(intervals + 1);
  for (int i = 0; i <= intervals; ++i) {
    const double angle = pi * i / intervals;
    const bool at_end = i == 0 || i == intervals;
    directions[i] = {std::cos(angle), std::sin(angle), (at_end ? 0.5 : 1.0) / intervals};
  }
  return directions;
}

}  // namespace latticast
