// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/strain_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <variant>

#include <fmt/core.h>

#include "checks/strand_stations.h"
#include "design/material/drucker.h"
#include "design/text/written_number.h"
#include "design/units.h"
#include "design/unsupported_design.h"
#include "model/cell/cell_wall.h"
#include "model/shape/inflated_wall.h"
#include "model/strand/links.h"

namespace latticast {
namespace {

constexpr double largest_limit_use =
    0.9;  // from here a Gent rubber's stress grows more than tenfold
constexpr double largest_lock_use = 0.95;

double straight_strain(const Segment& segment, const Grid& grid, const State& state) {
  const double angle = grid.angle_rad();
  double largest = 0;
  for (const StrandStation& station : strand_stations(segment, grid, state)) {
    for (const double radius : {segment.liner_outer_radius_mm(), segment.outer_radius_mm()}) {
      const WallStretch at = wall_stretch(segment, state, radius, station.theta_rad);
      largest = std::max(largest, at.along(angle) - 1);
    }
  }
  return largest;
}

double chord_strain(const Segment& segment, const Grid& grid, const State& state,
                    const StrandStation& station) {
  const double angle = grid.angle_rad();
  return wall_stretch(segment, state, segment.lattice_mid_radius_mm(), station.theta_rad)
             .along(angle) -
         1;
}

/// Of the most stretched fibre of curved strands.
double fibre_strain(const Segment& segment, const Grid& grid, const State& state) {
  double largest = 0;
  for (const StrandStation& station : strand_stations(segment, grid, state)) {
    const auto link = link_shape(segment, grid, station.width_mm);
    const auto fibre = largest_fibre_strain(*link, chord_strain(segment, grid, state, station));
    largest = std::max(largest, fibre.value_or(0));
  }
  return largest;
}

double ring_strain(const Segment& segment, const State& state) {
  return std::max(wall_stretch(segment, state, segment.liner_outer_radius_mm(), 0).hoop,
                  wall_stretch(segment, state, segment.outer_radius_mm(), 0).hoop) -
         1;
}

/// The liner's largest principal stretch - 1; it lies at a face, on the lengthened side.
double liner_strain(const LoadedSegment& loaded, const State& state) {
  if (const CellWall* wall = loaded.wall(state)) return wall->liner_strain;
  const Segment& segment = *loaded.segment;
  const double side = lengthened_side_rad(state);
  double largest = 0;
  for (const double radius : {segment.inner_radius_mm(), segment.liner_outer_radius_mm()}) {
    const WallStretch at = wall_stretch(segment, state, radius, side);
    largest = std::max(largest, at.largest_principal() - 1);
  }
  return largest;
}

/// (I1 - 3) where it is largest, against the law's limit of it.
double limit_use(const Segment& segment, const State& state) {
  const double limit = first_invariant_limit(segment.liner.material.law);
  double largest = 0;
  for (const double side : {lengthened_side_rad(state), lengthened_side_rad(state) + pi}) {
    for (const double radius : {segment.inner_radius_mm(), segment.liner_outer_radius_mm()}) {
      const WallStretch at = wall_stretch(segment, state, radius, side);
      largest = std::max(largest, at.first_invariant_minus_3() / limit);
    }
  }
  return largest;
}

/// Adds a finding when a strain leaves its limit, and says whether it does.
bool add_strain(const LoadedSegment& loaded, const Measure& measure, const std::string& limit_name,
                CheckFindings& findings) {
  const auto beyond = excess(loaded, measure);
  if (!beyond) return false;
  CheckFinding finding = finding_of(loaded, measure, *beyond);
  finding.message =
      fmt::format("is strained by {} at {} kPa, beyond {} {}, which it reaches at {} kPa",
                  written(beyond->worst, 3), written(beyond->worst_kpa, 4), limit_name,
                  written(measure.limit, 3), written(beyond->from_kpa, 3));
  finding.remedy = pressure_remedy(beyond->safe_kpa);
  findings.push_back(std::move(finding));
  return true;
}

/// Both limits of a material for one strain. Where it tears, its law's range does not matter.
void check_material(const LoadedSegment& loaded, const Material& material,
                    std::array<std::string_view, 2> codes, const std::string& part,
                    const std::function<double(const State&)>& strain, CheckFindings& findings) {
  if (material.elongation_at_break) {
    const Measure tears{codes[0], part, "", *material.elongation_at_break, true, strain};
    if (add_strain(loaded, tears, "its elongation at break,", findings)) return;
  }
  if (material.max_strain) {
    const Measure leaves{codes[1], part, "", *material.max_strain, true, strain};
    add_strain(loaded, leaves, "the strain up to which its law was fitted,", findings);
  }
}

/// Beyond the stretch at which the law loses Drucker's stability, its constants say more than the
/// tests that they were fitted to.
void check_law_stability(const LoadedSegment& loaded, CheckFindings& findings) {
  const Segment& segment = *loaded.segment;
  const Law& law = segment.liner.material.law;
  const auto strain = [&](const State& state) { return liner_strain(loaded, state); };
  double largest = 0;
  for (const State* state : loaded.states()) largest = std::max(largest, strain(*state));
  const auto loss = drucker_loss(law, 1 + largest);
  if (!loss) return;
  const Measure measure{"liner-law-unstable", "liner", "", loss->stretch - 1, true, strain};
  const auto beyond = excess(loaded, measure);
  if (!beyond) return;
  CheckFinding finding = finding_of(loaded, measure, *beyond);
  finding.message = fmt::format(
      "is strained by {} at {} kPa; its law ({}) is stable in {} only up to {}, which "
      "is reached at {} kPa: beyond, more strain takes less stress",
      written(beyond->worst, 3), written(beyond->worst_kpa, 4), law_name(law), loss->test,
      written(measure.limit, 3), written(beyond->from_kpa, 3));
  finding.remedy = pressure_remedy(beyond->safe_kpa) +
                   ", or constants that are fitted to uniaxial, planar and equibiaxial tests";
  findings.push_back(std::move(finding));
}

void check_liner(const LoadedSegment& loaded, CheckFindings& findings) {
  const Segment& segment = *loaded.segment;
  const Material& material = segment.liner.material;
  check_material(
      loaded, material, {"liner-overstrained", "liner-law-exceeded"}, "liner",
      [&](const State& state) { return liner_strain(loaded, state); }, findings);
  check_law_stability(loaded, findings);
  if (std::isinf(first_invariant_limit(material.law))) return;
  const Measure use{
      "liner-law-exceeded", "liner", "of Jm",
      largest_limit_use,    true,    [&](const State& state) { return limit_use(segment, state); }};
  const auto beyond = excess(loaded, use);
  if (!beyond) return;
  CheckFinding finding = finding_of(loaded, use, *beyond);
  finding.message = fmt::format(
      "uses {} of its law's stretch limit at {} kPa, where the stress grows without bound",
      written(beyond->worst, 3), written(beyond->worst_kpa, 4));
  finding.remedy = pressure_remedy(beyond->safe_kpa);
  findings.push_back(std::move(finding));
}

void check_strands(const LoadedSegment& loaded, CheckFindings& findings) {
  const Segment& segment = *loaded.segment;
  const Material& material = segment.lattice->material;
  constexpr std::array<std::string_view, 2> codes = {"strand-overstrained", "strand-law-exceeded"};
  if (loaded.walls) {
    check_material(
        loaded, material, codes, "lattice",
        [&](const State& state) {
          const CellWall* wall = loaded.wall(state);
          return wall != nullptr ? wall->lattice_strain : 0;
        },
        findings);
    return;
  }
  if (segment.lattice->rings) {
    check_material(
        loaded, material, codes, "rings",
        [&](const State& state) { return ring_strain(segment, state); }, findings);
  }
  for (std::size_t i = 0; i < segment.lattice->grids.size(); ++i) {
    const Grid& grid = segment.lattice->grids[i];
    check_material(
        loaded, material, codes, grid_name(i),
        [&](const State& state) {
          return is_curved(grid.path) ? fibre_strain(segment, grid, state)
                                      : straight_strain(segment, grid, state);
        },
        findings);
  }
}

/// How much of its free way a grid has used: of the elongation 1/sin(alpha) - 1 at which
/// inextensible strips lie along the tube, or at which curved strands are straight.
std::optional<Measure> lock_use(const Segment& segment, std::size_t index) {
  const Grid& grid = segment.lattice->grids[index];
  Measure measure{"fibre-lock", grid_name(index), "of the way", largest_lock_use, true, {}};
  if (is_curved(grid.path)) {
    measure.value = [&segment, &grid](const State& state) {
      double largest = 0;
      for (const StrandStation& station : strand_stations(segment, grid, state)) {
        const auto link = link_shape(segment, grid, station.width_mm);
        const double strain = chord_strain(segment, grid, state, station);
        largest = std::max(largest, strain / full_extension(*link));
      }
      return largest;
    };
    return measure;
  }
  if (grid.angle_deg == 90) return std::nullopt;  // nothing to lock: never free
  const double free_way = 1 / std::sin(grid.angle_rad()) - 1;
  measure.value = [free_way](const State& state) { return (state.stretch - 1) / free_way; };
  return measure;
}

void check_locks(const LoadedSegment& loaded, CheckFindings& findings) {
  for (std::size_t i = 0; i < loaded.segment->lattice->grids.size(); ++i) {
    const auto measure = lock_use(*loaded.segment, i);
    if (!measure) continue;
    const auto beyond = excess(loaded, *measure);
    if (!beyond) continue;
    CheckFinding finding = finding_of(loaded, *measure, *beyond);
    finding.message = fmt::format(
        "its strands are nearly straight along the tube from {} kPa on ({} of their free "
        "way at {} kPa): more pressure strains them and moves little",
        written(beyond->from_kpa, 3), written(beyond->worst, 3), written(beyond->worst_kpa, 4));
    finding.remedy = fmt::format("{}, or {}", pressure_remedy(beyond->safe_kpa),
                                 describe(loaded.segment->lattice->grids[i].path).more);
    findings.push_back(std::move(finding));
  }
}

}  // namespace

void check_strains(const LoadedSegment& loaded, CheckFindings& findings) {
  check_liner(loaded, findings);
  if (!loaded.segment->lattice) return;
  check_strands(loaded, findings);
  check_locks(loaded, findings);
}

}  // namespace latticast
