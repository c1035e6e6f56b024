// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/bulging_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <variant>

#include <fmt/core.h>

#include "design/text/written_number.h"
#include "design/units.h"
#include "geometry/pattern/rings.h"
#include "model/bulging.h"
#include "model/cell/cell_wall.h"
#include "model/strand/links.h"

namespace latticast {
namespace {

/// Bulges of one segment, found once for every pressure that is looked at.
class Bulges {
 public:
  explicit Bulges(const LoadedSegment& loaded) : loaded_(loaded) {}

  const std::vector<Bulge>& at(const State& state) {
    auto& bulges = found_[state.pressure_kpa];
    if (bulges.empty()) bulges = liner_bulges(*loaded_.segment, loaded_.section(), state);
    return bulges;
  }

  const Bulge& at_kpa(double pressure_kpa, std::size_t kind) const {
    return found_.at(pressure_kpa)[kind];
  }

  const Bulge& highest_at_kpa(double pressure_kpa) const {
    const std::vector<Bulge>& bulges = found_.at(pressure_kpa);
    return *std::max_element(bulges.begin(), bulges.end(), [](const Bulge& a, const Bulge& b) {
      return a.height_mm < b.height_mm;
    });
  }

 private:
  const LoadedSegment& loaded_;
  std::map<double, std::vector<Bulge>> found_;
};

std::string remedy(const Excess& beyond, const std::string& members) {
  return fmt::format("{}, a thicker liner, or more {}", pressure_remedy(beyond.safe_kpa),
                     members == "rings" ? members : "strands");
}

/// Adds a finding where the load of a gap, `margin` times, is more than the wall in it can bear.
bool add_ballooning(const LoadedSegment& loaded, Bulges& bulges, std::size_t kind,
                    std::string_view code, double margin, CheckFindings& findings) {
  Measure measure{code, "", "kPa", 1, true, {}};
  measure.value = [&](const State& state) {
    const Bulge& bulge = bulges.at(state)[kind];
    return bulge.load_mpa > 0 ? margin * bulge.load_mpa / bulge.largest_load_mpa : 0;
  };
  const auto beyond = excess(loaded, measure);
  if (!beyond) return false;
  const Bulge& bulge = bulges.at_kpa(beyond->worst_kpa, kind);
  measure.part = "liner between " + bulge.members;
  CheckFinding finding = finding_of(loaded, measure, *beyond);
  finding.value = kpa_from_mpa(bulge.load_mpa);
  finding.limit = kpa_from_mpa(bulge.largest_load_mpa) / margin;
  finding.message = fmt::format(
      "{} through the gaps from {} kPa on: at {} kPa they are {} mm wide, the lattice "
      "beside them holds {} kPa, and the wall in them balloons at {} kPa",
      margin > 1 ? "is near ballooning" : "balloons", written(beyond->from_kpa, 3),
      written(beyond->worst_kpa, 4), written(bulge.gap_mm, 3), written(*finding.value, 3),
      written(kpa_from_mpa(bulge.largest_load_mpa), 3));
  finding.remedy = remedy(*beyond, bulge.members);
  findings.push_back(std::move(finding));
  return true;
}

/// In mid cell, where the bulges of all gaps meet: beyond the outside of the lattice the liner rubs
/// against whatever the lattice lies on.
void add_bulging(const LoadedSegment& loaded, Bulges& bulges, CheckFindings& findings) {
  const double thickness = loaded.segment->lattice->thickness_mm;
  const Measure measure{"liner-bulges", "liner", "mm", thickness, true, [&](const State& state) {
                          if (const CellWall* wall = loaded.wall(state)) return wall->bulge_mm;
                          double height = 0;
                          for (const Bulge& bulge : bulges.at(state)) height += bulge.height_mm;
                          return height;
                        }};
  const auto beyond = excess(loaded, measure);
  if (!beyond) return;
  CheckFinding finding = finding_of(loaded, measure, *beyond);
  finding.message = fmt::format(
      "stands out beyond the lattice in its gaps from {} kPa on; at {} kPa it bulges by "
      "{} mm, and the lattice is {} mm thick",
      written(beyond->from_kpa, 3), written(beyond->worst_kpa, 4), written(beyond->worst, 3),
      written(thickness, 3));
  const bool rings = loaded.segment->lattice->rings.has_value();
  finding.remedy = remedy(*beyond, loaded.walls ? (rings ? "rings" : "strands")
                                                : bulges.highest_at_kpa(beyond->worst_kpa).members);
  findings.push_back(std::move(finding));
}

/// Farther from a ring than this, over pi/2, a liner at rest hardly feels it: the rate at which a
/// disturbance decays along a tube whose wall bends, shears and resists widening.
double longest_clear_span_mm(const Liner& liner, double shear_modulus_mpa) {
  const double thickness = liner.thickness_mm;
  const double middle = liner.inner_radius_mm + 0.5 * thickness;
  const double widening = 4 * shear_modulus_mpa * thickness / (middle * middle);
  const double bending = shear_modulus_mpa * std::pow(thickness, 3) / 3;
  const double shear = 5.0 / 6 * shear_modulus_mpa * thickness;
  // Roots of bending x^2 - widening bending/shear x + widening = 0, x the square of the rate.
  const double half = 0.5 * widening / shear;
  const double product = widening / bending;
  const double rate = half * half < product ? std::sqrt(0.5 * (std::sqrt(product) + half))
                                            : std::sqrt(half - std::sqrt(half * half - product));
  return pi / rate;
}

/// Strips that wind around the tube hold it, too: E f_t cos^4 alpha h/R_c^2 against the liner's.
bool strands_hold_the_tube(const Segment& segment, double shear_modulus_mpa) {
  const Lattice& lattice = *segment.lattice;
  const double radius = segment.lattice_mid_radius_mm();
  double held = 0;
  for (const Grid& grid : lattice.grids) {
    if (is_curved(grid.path)) continue;
    const double angle = grid.angle_rad();
    double width = 0;
    for (const double w : grid.widths_mm) width += w;
    const double fraction = width / (2 * pi * radius * std::sin(angle));
    held += strand_modulus_mpa(lattice) * fraction * std::pow(std::cos(angle), 4) *
            lattice.thickness_mm;
  }
  return held > 4 * shear_modulus_mpa * segment.liner.thickness_mm;
}

void check_ring_distance(const LoadedSegment& loaded, CheckFindings& findings) {
  const Segment& segment = *loaded.segment;
  if (!segment.lattice || !segment.lattice->rings) return;
  const Rings& rings = *segment.lattice->rings;
  if (ring_centres_mm(rings, segment.length_mm).size() < 2) return;
  const double modulus = rest_shear_modulus_mpa(segment.liner.material.law);
  if (strands_hold_the_tube(segment, modulus)) return;
  const double clear = ring_pitch_mm(rings, segment.length_mm) - rings.width_mm;
  const double limit = longest_clear_span_mm(segment.liner, modulus);
  if (!clearly_above(clear, limit)) return;
  CheckFinding finding = check_finding("rings-too-far");
  finding.segment = loaded.number;
  finding.part = "rings";
  finding.value = clear;
  finding.limit = limit;
  finding.unit = "mm";
  finding.message = fmt::format(
      "are {} mm apart; beyond {} mm this liner does not feel them in between, and the "
      "prediction, which spreads them evenly, is too stiff",
      written(clear, 3), written(limit, 3));
  finding.remedy =
      fmt::format("pitch = {}", written(std::floor(10 * (limit + rings.width_mm)) / 10, 3));
  findings.push_back(std::move(finding));
}

}  // namespace

void check_bulging(const LoadedSegment& loaded, CheckFindings& findings) {
  check_ring_distance(loaded, findings);
  const std::vector<const State*> states = loaded.states();
  if (!loaded.segment->lattice || states.empty()) return;
  Bulges bulges(loaded);
  // In a unit cell the wall balloons by itself: its branch ends there.
  if (loaded.walls) return add_bulging(loaded, bulges, findings);
  bool balloons = false;
  for (std::size_t kind = 0; kind < bulges.at(*states.back()).size(); ++kind) {
    const bool here = add_ballooning(loaded, bulges, kind, "liner-balloons", 1, findings);
    if (!here) {
      add_ballooning(loaded, bulges, kind, "liner-balloons-near", least_limit_margin, findings);
    }
    balloons |= here;
  }
  if (!balloons) add_bulging(loaded, bulges, findings);
}

}  // namespace latticast
