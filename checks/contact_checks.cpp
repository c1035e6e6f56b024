// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/contact_checks.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "checks/strand_stations.h"
#include "design/text/written_number.h"
#include "design/units.h"
#include "design/unsupported_design.h"
#include "geometry/pattern/rings.h"
#include "geometry/pattern/strand_path.h"
#include "model/shape/inflated_wall.h"

namespace latticast {
namespace {

// A free rubber surface creases where compression along it, over the stretch square to it, falls
// to 0.65^2, whatever the stretch along the crease: docs/checks.md.
constexpr double creasing = 0.65 * 0.65;

double shortened_side_rad(const State& state) {
  return lengthened_side_rad(state) + pi;
}

double ring_gap_mm(const Segment& segment, const State& state) {
  const Rings& rings = *segment.lattice->rings;
  const double side = shortened_side_rad(state);
  const double axial = wall_stretch(segment, state, segment.outer_radius_mm(), side).axial;
  return axial * ring_pitch_mm(rings, segment.length_mm) - rings.width_mm;
}

double width_of_pair_mm(const Grid& grid, int strand) {
  return 0.5 * (grid.widths_mm[strand] + grid.widths_mm[(strand + 1) % grid.count()]);
}

/// Between neighbouring strands, and within one, whichever is less.
double strand_gap_mm(const Segment& segment, const Grid& grid, const State& state) {
  const double angle = grid.angle_rad();
  double least = HUGE_VAL;
  for (const StrandStation& station : strand_stations(segment, grid, state)) {
    const WallStretch at =
        wall_stretch(segment, state, segment.lattice_mid_radius_mm(), station.theta_rad);
    PlacedStrand strand = placed_strand(segment, grid, station.strand);
    strand.shape = stretched(strand, at.along(angle));
    strand.angle_deg = degrees(at.turned_rad(angle));
    strand.length_mm = at.axial * segment.length_mm;
    const double spacing = 2 * pi * at.radius_mm / grid.count();
    const double between = grid.count() < 2 ? HUGE_VAL
                                            : centre_distance_mm(strand, spacing) -
                                                  width_of_pair_mm(grid, station.strand);
    least = std::min({least, between, gap_within_mm(strand)});
  }
  return least;
}

void check_gap(const LoadedSegment& loaded, const std::string& part,
               const std::function<double(const State&)>& gap, CheckFindings& findings) {
  const Measure measure{"strands-touch-inflated", part, "mm", 0, false, gap};
  State rest;
  rest.inner_radius_mm = loaded.segment->inner_radius_mm();
  if (gap(rest) < 0) return;  // then it cannot even be drawn
  const auto beyond = excess(loaded, measure);
  if (!beyond) return;
  CheckFinding finding = finding_of(loaded, measure, *beyond);
  finding.message = fmt::format(
      "touch each other from {} kPa on; at {} kPa {} mm are missing between them, and "
      "contact is not modelled",
      written(beyond->from_kpa, 3), written(beyond->worst_kpa, 4), written(-beyond->worst, 3));
  finding.remedy = pressure_remedy(beyond->safe_kpa) + ", fewer of them, or narrower ones";
  findings.push_back(std::move(finding));
}

void check_gaps(const LoadedSegment& loaded, CheckFindings& findings) {
  const Segment& segment = *loaded.segment;
  const Lattice& lattice = *segment.lattice;
  if (lattice.rings && ring_centres_mm(*lattice.rings, segment.length_mm).size() > 1) {
    check_gap(
        loaded, "rings", [&](const State& state) { return ring_gap_mm(segment, state); }, findings);
  }
  for (std::size_t i = 0; i < lattice.grids.size(); ++i) {
    const Grid& grid = lattice.grids[i];
    if (grid.count() < 2 && !is_curved(grid.path)) continue;
    check_gap(
        loaded, grid_name(i),
        [&](const State& state) { return strand_gap_mm(segment, grid, state); }, findings);
  }
}

/// Least stretch in the wall over the stretch across it, at either face of the liner.
double crease_ratio(const Segment& segment, const State& state) {
  const double side = shortened_side_rad(state);
  double least = HUGE_VAL;
  for (const double radius : {segment.inner_radius_mm(), segment.liner_outer_radius_mm()}) {
    const WallStretch at = wall_stretch(segment, state, radius, side);
    least = std::min(least, at.least_in_wall() / at.across());
  }
  return least;
}

void check_folds(const LoadedSegment& loaded, CheckFindings& findings) {
  const Segment& segment = *loaded.segment;
  const Measure measure{"folds", "liner",
                        "",      creasing,
                        false,   [&](const State& state) { return crease_ratio(segment, state); }};
  const auto beyond = excess(loaded, measure);
  if (!beyond) return;
  CheckFinding finding = finding_of(loaded, measure, *beyond);
  finding.message = fmt::format(
      "its shortened side folds into creases from {} kPa on: its stretch over that across the "
      "wall is {} at {} kPa, and rubber creases below {}",
      written(beyond->from_kpa, 3), written(beyond->worst, 3), written(beyond->worst_kpa, 4),
      written(creasing, 3));
  finding.remedy = pressure_remedy(beyond->safe_kpa);
  findings.push_back(std::move(finding));
}

}  // namespace

void check_contact(const LoadedSegment& loaded, CheckFindings& findings) {
  check_folds(loaded, findings);
  if (loaded.segment->lattice) check_gaps(loaded, findings);
}

}  // namespace latticast
