// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/strip_wedges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "design/units.h"
#include "model/cell/strip_grid.h"

namespace latticast {
namespace {

/// Element ends, and whether each element is a strip's or a ring's.
struct Steps {
  std::vector<double> ends;
  std::vector<char> solid;

  void mark(bool is_solid) { solid.resize(ends.size() - 1, is_solid ? 1 : 0); }
};

constexpr double same_place_mm = 1e-9;

/// t of one sector: a strip, then its gap, rad.
Steps around(const StripTube& tube, const StripDivision& division) {
  const double radius = 0.5 * (tube.liner_outer_radius_mm + tube.outer_radius_mm);
  const double strip = 0.5 * tube.strip_width_mm / (std::sin(tube.angle_rad) * radius);
  Steps steps{{-strip}, {}};
  append_steps(steps.ends, strip, division.strip, 1);
  steps.mark(true);
  append_graded(steps.ends, 2 * pi / tube.strips - strip, division.gap, division.grading);
  steps.mark(false);
  return steps;
}

/// z from the base to the tip: rings, and what is between, divided as finely as a whole span.
Steps along(const StripTube& tube, double length_mm, const std::vector<double>& ring_centres_mm,
            const StripDivision& division) {
  const double half = 0.5 * tube.ring_width_mm;
  const double span = tube.pitch_mm - tube.ring_width_mm;
  Steps steps{{0}, {}};
  const auto go_free = [&](double to) {
    const double length = to - steps.ends.back();
    if (length < same_place_mm) return;
    const int count = static_cast<int>(std::ceil(2 * division.span * length / span - 1e-6));
    append_graded(steps.ends, to, std::max(count, 1), division.grading);
    steps.mark(false);
  };
  for (const double centre : ring_centres_mm) {
    go_free(centre - half);
    append_steps(steps.ends, std::min(centre + half, length_mm), 2 * division.ring, 1);
    steps.mark(true);
  }
  go_free(length_mm);
  return steps;
}

Steps through(const StripTube& tube, const StripDivision& division) {
  Steps steps{{tube.inner_radius_mm}, {}};
  append_steps(steps.ends, tube.liner_outer_radius_mm, division.liner, 1 / division.grading);
  steps.mark(false);
  append_steps(steps.ends, tube.outer_radius_mm, division.lattice, 1);
  steps.mark(true);
  return steps;
}

class WedgeBuilder {
 public:
  WedgeBuilder(const StripTube& tube, Steps t, Steps z, Steps r, bool whole)
      : sector_steps_(t.solid.size()),
        sectors_(whole ? tube.strips : 1),
        whole_(whole),
        t_(std::move(t)),
        z_(std::move(z)),
        r_(std::move(r)),
        t_rad_(with_middles(t_.ends)),
        z_mm_(with_middles(z_.ends)),
        r_mm_(with_middles(r_.ends)) {
    const double radius = 0.5 * (tube.liner_outer_radius_mm + tube.outer_radius_mm);
    const bool axial = std::abs(tube.angle_rad - 0.5 * pi) < 1e-12;
    turn_rad_per_mm_ = axial ? 0 : 1 / (std::tan(tube.angle_rad) * radius);
    sector_rad_ = 2 * pi / tube.strips;
    mesh_.sectors = whole ? 1 : tube.strips;
    mesh_.length_mm = z_.ends.back();
    mesh_.inner_radius_mm = tube.inner_radius_mm;
  }

  WedgeMesh build() {
    for (std::size_t k = 0; k < r_.solid.size(); ++k) {
      for (std::size_t j = 0; j < z_.solid.size(); ++j) {
        for (std::size_t i = 0; i < sector_steps_ * sectors_; ++i) add_block(i, j, k);
      }
    }
    if (!whole_) add_ties();
    return std::move(mesh_);
  }

 private:
  using Place = std::array<std::size_t, 3>;  // in steps of half an element: t, z, r

  bool is_solid(std::size_t i, std::size_t j, std::size_t k) const {
    return r_.solid[k] == 0 || t_.solid[i % sector_steps_] != 0 || z_.solid[j] != 0;
  }

  /// A hexahedron of the grid as two wedges that share the shorter diagonal of its faces.
  void add_block(std::size_t i, std::size_t j, std::size_t k) {
    if (!is_solid(i, j, k)) return;
    // Corners of the block's face, counter-clockwise seen from outside.
    const auto corner = [&](std::size_t a, std::size_t b) {
      return std::array{2 * i + a, 2 * j + b};
    };
    if (turn_rad_per_mm_ > 0) {
      add_wedge({corner(0, 0), corner(2, 0), corner(0, 2)}, k);
      add_wedge({corner(2, 0), corner(2, 2), corner(0, 2)}, k);
    } else {
      add_wedge({corner(0, 0), corner(2, 0), corner(2, 2)}, k);
      add_wedge({corner(0, 0), corner(2, 2), corner(0, 2)}, k);
    }
  }

  void add_wedge(const std::array<std::array<std::size_t, 2>, 3>& corners, std::size_t k) {
    Wedge wedge{.part = r_.solid[k] == 0 ? WedgePart::liner : WedgePart::lattice};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto& here = corners[c];
      const auto& next = corners[(c + 1) % 3];
      const std::size_t t = (here[0] + next[0]) / 2;
      const std::size_t z = (here[1] + next[1]) / 2;
      wedge.nodes[c] = node({here[0], here[1], 2 * k});
      wedge.nodes[3 + c] = node({here[0], here[1], 2 * k + 2});
      wedge.nodes[6 + c] = node({t, z, 2 * k});
      wedge.nodes[9 + c] = node({t, z, 2 * k + 2});
      wedge.nodes[12 + c] = node({here[0], here[1], 2 * k + 1});
    }
    if (k == 0) mesh_.bore.push_back(static_cast<std::int32_t>(mesh_.wedges.size()));
    if (r_.solid[k] != 0 && r_.solid[k - 1] == 0) {
      for (const std::size_t n : {0, 1, 2, 6, 7, 8}) bond(wedge.nodes[n]);
    }
    mesh_.wedges.push_back(wedge);
  }

  void bond(std::int32_t node) {
    if (bonded_.insert(node).second) mesh_.bond.push_back(node);
  }

  std::int32_t node(Place place) {
    const std::size_t steps = 2 * sector_steps_;
    if (whole_) place[0] %= steps * sectors_;
    const auto [found, is_new] =
        numbers_.try_emplace(place, static_cast<std::int32_t>(mesh_.nodes.size()));
    if (!is_new) return found->second;
    const double z = z_mm_[place[1]];
    const std::size_t sector = std::min(place[0] / steps, sectors_ - 1);
    const double angle = t_rad_[place[0] - sector * steps] +
                         static_cast<double>(sector) * sector_rad_ + turn_rad_per_mm_ * z;
    const double r = r_mm_[place[2]];
    mesh_.nodes.push_back({r * std::cos(angle), r * std::sin(angle), z});
    if (place[1] == 0) mesh_.base.push_back(found->second);
    if (place[1] + 1 == z_mm_.size()) mesh_.tip.push_back(found->second);
    return found->second;
  }

  void add_ties() {
    for (const auto& [place, near] : numbers_) {
      if (place[0] != 0) continue;
      const auto far = numbers_.find({2 * sector_steps_, place[1], place[2]});
      if (far != numbers_.end()) mesh_.ties.emplace_back(near, far->second);
    }
  }

  std::size_t sector_steps_;
  std::size_t sectors_;
  bool whole_;
  Steps t_, z_, r_;
  std::vector<double> t_rad_, z_mm_, r_mm_;
  double turn_rad_per_mm_ = 0;
  double sector_rad_ = 0;
  WedgeMesh mesh_;
  std::map<Place, std::int32_t> numbers_;
  std::set<std::int32_t> bonded_;
};

}  // namespace

WedgeMesh strip_wedges(const StripTube& tube, double length_mm,
                       const std::vector<double>& ring_centres_mm, const StripDivision& division,
                       bool whole) {
  return WedgeBuilder(tube, around(tube, division),
                      along(tube, length_mm, ring_centres_mm, division), through(tube, division),
                      whole)
      .build();
}

}  // namespace latticast
