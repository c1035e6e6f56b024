// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/mesh_size.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "geometry/pattern/pattern.h"
#include "geometry/pattern/rings.h"
#include "geometry/solid/cutting.h"
#include "geometry/solid/relief.h"

namespace latticast {
namespace {

constexpr double coarse_share = 0.001;  // of the layer's radius: a flatness that costs nothing
constexpr double within_factor = 1.5;   // what estimates are good to
constexpr double bytes_a_triangle = 600;

// Rings alone, then each grid alone.
std::vector<Lattice> families_alone(const Lattice& lattice) {
  std::vector<Lattice> families;
  Lattice bare = lattice;
  bare.grids.clear();
  bare.rings.reset();
  bare.fillet_mm = 0;
  if (lattice.rings) {
    families.push_back(bare);
    families.back().rings = lattice.rings;
  }
  for (const Grid& grid : lattice.grids) {
    families.push_back(bare);
    families.back().grids = {grid};
  }
  return families;
}

bool is_on_curve(const Strand& strand, std::size_t edge) {
  if (strand.traces.empty() || strand.traces[edge].curve == own_line) return false;
  const auto& curve = strand.curves[strand.traces[edge].curve];
  return !std::holds_alternative<StraightLine>(curve.shape);
}

// Twice the signed area.
double turn(const PlanePoint& a, const PlanePoint& b) {
  return a.u * b.z - b.u * a.z;
}

// Places where strands of two families cross: all rings cross all strands of a grid once.
double crossings(const Segment& segment) {
  const Lattice& lattice = *segment.lattice;
  const double around = segment.lattice_circumference_mm();
  const std::size_t rings =
      lattice.rings ? ring_centres_mm(*lattice.rings, segment.length_mm).size() : 0;
  double count = 0;
  for (std::size_t i = 0; i < lattice.grids.size(); ++i) {
    const Grid& grid = lattice.grids[i];
    count += static_cast<double>(rings) * grid.count();
    for (std::size_t j = 0; j < i; ++j) {
      const Grid& other = lattice.grids[j];
      const double apart =
          std::abs(1 / std::tan(grid.angle_rad()) - 1 / std::tan(other.angle_rad()));
      count += grid.count() * other.count() * segment.length_mm * apart / around;
    }
  }
  return count;
}

// Of the fillets at a crossing's four corners, taken as square.
double chords_a_crossing(double fillet_mm, double flatness_mm) {
  if (fillet_mm == 0) return 0;
  return 4 * std::ceil(0.5 * std::numbers::pi / std::sqrt(8 * flatness_mm / fillet_mm));
}

// Layers of walls, and floor and ceiling: each vertex of the outline brings two triangles to either
// of the latter and four to each of the former.
double triangles_a_vertex(double floor_mm, double ceiling_mm, int sectors, double steepness,
                          double walls_mm) {
  const double angle = 2 * std::numbers::pi / sectors;
  const double off = wall_error_mm(ceiling_mm - floor_mm, angle, steepness);
  return 2 + 4 * std::max(1.0, std::ceil(off / walls_mm));
}

}  // namespace

LatticeSize::LatticeSize(const Segment& segment)
    : segment_(segment), flatness_mm_(coarse_share * segment.lattice_mid_radius_mm()) {
  for (const Lattice& alone : families_alone(*segment.lattice)) {
    families_.push_back(family_of(alone));
  }
}

LatticeSize::Family LatticeSize::family_of(const Lattice& alone) const {
  Segment segment = segment_;
  segment.lattice = alone;
  const Pattern pattern = draw_lattice(segment, flatness_mm_);
  Family family;
  double doubled_area = 0;
  for (const Strand& strand : pattern.strands) {
    for (std::size_t i = 0; i < strand.outline.size(); ++i) {
      const PlanePoint& from = strand.outline[i];
      const PlanePoint& to = strand.outline[(i + 1) % strand.outline.size()];
      (is_on_curve(strand, i) ? family.chords : family.corners) += 1;
      family.around_mm += std::abs(to.u - from.u);
      family.along_mm += std::abs(to.z - from.z);
      doubled_area += turn(from, to);
    }
  }
  const double plane = pattern.circumference_mm * pattern.length_mm;
  family.covered = std::min(0.95, 0.5 * std::abs(doubled_area) / plane);
  return family;
}

double LatticeSize::triangles(const SolidOptions& options) const {
  const LatticeCutting cutting = lattice_cutting(segment_, options);
  const ToleranceBudget& budget = cutting.budget;
  const int sectors = sectors_of(segment_, options, budget.facets_mm);
  const double sector_mm = segment_.lattice_circumference_mm() / sectors;
  const double band_mm = segment_.length_mm / std::max(1.0, bands_of(segment_, options, sectors));
  // Chords become shorter with the square root of their sagitta.
  const double finer = std::sqrt(std::max(1.0, flatness_mm_ / budget.drawing_mm));
  double vertices =
      crossings(segment_) * (4 + chords_a_crossing(segment_.lattice->fillet_mm, budget.drawing_mm));
  for (const Family& family : families_) {
    double seen = 1;
    for (const Family& other : families_) {
      if (&other != &family) seen *= 1 - other.covered;
    }
    const double cuts = family.around_mm / sector_mm +
                        (band_mm < segment_.length_mm ? family.along_mm / band_mm : 0);
    vertices += seen * (family.corners + finer * family.chords + cuts);
  }
  return vertices * triangles_a_vertex(segment_.liner_outer_radius_mm(), segment_.outer_radius_mm(),
                                       sectors, cutting.steepness, budget.walls_mm);
}

double liner_triangles(const Segment& segment, const SolidOptions& options) {
  const int sectors = sectors_of(segment, options, options.tolerance_mm);
  return 4.0 * sectors * (1 + std::max(1.0, bands_of(segment, options, sectors)));
}

double fitting_tolerance_mm(const std::function<double(double tolerance_mm)>& triangles) {
  double digits = 10;
  double unit = 1e-6;
  while (within_factor * triangles(digits * unit) > most_triangles && unit < 1) {
    if (++digits == 100) {
      digits = 10;
      unit *= 10;
    }
  }
  return digits * unit;
}

bool is_surely_too_large(double triangles) {
  return triangles > within_factor * most_triangles;
}

double memory_of_mesh(double triangles) {
  return bytes_a_triangle * triangles;
}

}  // namespace latticast
