// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/section/section_symmetry.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "design/units.h"
#include "design/unsupported_design.h"
#include "model/section/mirror_places.h"

namespace latticast {
namespace {

constexpr int many_strands =
    128;  // as many as there are directions at most, see model/equilibrium/balance.cpp

bool is_even(const Grid& grid) {
  return grid.count() >= 2 &&
         std::equal(grid.widths_mm.begin() + 1, grid.widths_mm.end(), grid.widths_mm.begin());
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
  return a.cosine == -b.cosine && a.sine == b.sine && a.links_per_mm == b.links_per_mm &&
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

}  // namespace

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

void adopt_symmetry(bool twists, bool bends, Section& section) {
  section.twists = twists;
  section.bending_axes = bends ? 2 : 0;
  const double cosine = std::cos(section.axis_rad);
  const double sine = std::sin(section.axis_rad);
  section.axis_rad = 0;
  for (StrandFamily& family : section.families) {
    for (StrandPlace& strand : family.strands) {
      const double along = strand.cosine;
      strand.cosine = cosine * along - sine * strand.sine;
      strand.sine = sine * along + cosine * strand.sine;
    }
  }
}

}  // namespace latticast
