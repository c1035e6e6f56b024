// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/validity_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/core.h>

#include "design/text/written_number.h"
#include "design/units.h"
#include "design/unsupported_design.h"
#include "geometry/pattern/rings.h"
#include "geometry/pattern/strand_path.h"
#include "model/segment_response.h"

namespace latticast {
namespace {

constexpr double least_angle_deg = 10;
constexpr double largest_difference = 0.2;
// Of rings along the waves, in waves.
constexpr double least_drift = 0.02;         // from one to the next
constexpr double least_drift_in_all = 0.25;  // from the first to the last

void check_angles(const LoadedSegment& loaded, CheckFindings& findings) {
  if (!loaded.segment->lattice) return;
  const auto& grids = loaded.segment->lattice->grids;
  for (std::size_t i = 0; i < grids.size(); ++i) {
    const double from_circumference = std::min(grids[i].angle_deg, 180 - grids[i].angle_deg);
    if (!clearly_below(from_circumference, least_angle_deg)) continue;
    CheckFinding finding = check_finding("angle-out-of-range");
    finding.segment = loaded.number;
    finding.part = grid_name(i);
    finding.value = grids[i].angle_deg;
    finding.limit = grids[i].angle_deg < 90 ? least_angle_deg : 180 - least_angle_deg;
    finding.unit = "degrees";
    finding.message = fmt::format(
        "at {} degrees its strands are almost rings, and wind far around the tube between two "
        "rings: the model, which takes that span as straight, is not valid",
        written(grids[i].angle_deg, 4));
    finding.remedy = fmt::format("angle = {}, or rings", written(*finding.limit, 4));
    findings.push_back(std::move(finding));
  }
}

/// Where rings cross a family's waves. Half waves are each other's mirror images, so that places
/// half a wave apart are one.
struct RingsOnWaves {
  double half_wave_mm = 0;      ///< along the tube
  double half_waves_apart = 0;  ///< from one ring to the next, whole
  double drift = 0;             ///< what they are further apart than that, in waves
  double first = 0;             ///< place of the first ring, in waves from where half waves meet
  double last = 0;              ///< and of the last, counted on from there
};

RingsOnWaves rings_on_waves(const Segment& segment, const Grid& grid,
                            const std::vector<double>& centres_mm) {
  const double pitch = ring_pitch_mm(*segment.lattice->rings, segment.length_mm);
  RingsOnWaves rings;
  rings.half_wave_mm =
      link_chord_mm(closed(placed_strand(segment, grid))) * std::sin(grid.angle_rad());
  rings.half_waves_apart = std::round(pitch / rings.half_wave_mm);
  rings.drift = 0.5 * (pitch / rings.half_wave_mm - rings.half_waves_apart);
  const double first = centres_mm.front() / rings.half_wave_mm;
  rings.first = 0.5 * std::max(0.0, first - std::floor(first + 1e-9));
  rings.last = rings.first + static_cast<double>(centres_mm.size() - 1) * rings.drift;
  return rings;
}

bool in_step(const RingsOnWaves& rings) {
  return rings.half_waves_apart >= 1 && clearly_below(std::abs(rings.drift), least_drift) &&
         std::abs(rings.last - rings.first) < least_drift_in_all;
}

CheckFinding ring_finding(const RingsOnWaves& rings) {
  CheckFinding finding = check_finding("rings-in-step");
  finding.value = std::abs(rings.drift);
  finding.limit = least_drift;
  finding.unit = "waves";
  finding.message = fmt::format(
      "rings cross its waves at nearly the same place, the first at {:.2f} of a wave and the last "
      "at {:.2f} (0 and 0.5: where half waves meet, 0.25: on the bulges), which kind = \"layered\" "
      "does not see: in finite elements the paper's elongating lattice (2:2), with rings one wave "
      "apart, lengthens at 30 kPa by 9.5 % with rings on the bulges, 7.5 % where half waves meet "
      "and 7.8 % between, and off the bulges it twists by 0.004 to 0.005 rad/mm",
      rings.first, rings.last);
  const double spread = (rings.half_waves_apart + 0.25) * rings.half_wave_mm;
  const double kept = rings.half_waves_apart * rings.half_wave_mm;
  finding.remedy = fmt::format(
      "rings.pitch = {} spreads them over the waves; rings.pitch = {}, phase = {} puts "
      "them on the bulges",
      written(spread, 4), written(kept, 6), written(0.5 / rings.half_waves_apart, 4));
  return finding;
}

void check_ring_places(const LoadedSegment& loaded, CheckFindings& findings) {
  const Segment& segment = *loaded.segment;
  if (!segment.lattice || !segment.lattice->rings) return;
  const std::vector<double> centres = ring_centres_mm(*segment.lattice->rings, segment.length_mm);
  if (centres.size() < 2) return;
  for (std::size_t i = 0; i < segment.lattice->grids.size(); ++i) {
    const Grid& grid = segment.lattice->grids[i];
    if (!is_curved(grid.path)) continue;
    const RingsOnWaves rings = rings_on_waves(segment, grid, centres);
    if (!in_step(rings)) continue;
    CheckFinding finding = ring_finding(rings);
    finding.segment = loaded.number;
    finding.part = grid_name(i);
    findings.push_back(std::move(finding));
  }
}

/// One angle or stretch of a state that a user looks at.
struct Quantity {
  const char* name;
  const char* unit;
  double value;
};

std::array<Quantity, 3> quantities(const Segment& segment, const State& state) {
  return {Quantity{"elongation", "%", 100 * (state.stretch - 1)},
          Quantity{"twist", "degrees", degrees(state.twist_rad_per_mm * segment.length_mm)},
          Quantity{"bending", "degrees",
                   degrees(state.bend_magnitude_rad_per_mm() * segment.length_mm)}};
}

struct Band {
  std::string part;
  double factor = 1;
};

void add_band(const LoadedSegment& loaded, const Band& band, CheckFindings& findings) {
  const State& stated = *loaded.states().back();
  const ModulusFactors factors =
      band.part == "liner" ? ModulusFactors{band.factor, 1} : ModulusFactors{1, band.factor};
  const Response& response = loaded.response_at({stated.pressure_kpa}, factors);
  CheckFinding finding = check_finding("modulus-band");
  finding.segment = loaded.number;
  finding.part = band.part;
  finding.pressure_kpa = stated.pressure_kpa;
  finding.limit = largest_difference;
  std::string change;
  if (!response.states[0]) {
    change = response.message;
  } else {
    const auto before = quantities(*loaded.segment, stated);
    const auto after = quantities(*loaded.segment, *response.states[0]);
    double largest = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (std::abs(before[i].value) < 0.1) continue;  // nothing that one would see
      const double difference = std::abs(after[i].value / before[i].value - 1);
      largest = std::max(largest, difference);
      change +=
          fmt::format("{}{} {} instead of {} {}", change.empty() ? "" : ", ", before[i].name,
                      written(after[i].value, 3), written(before[i].value, 3), before[i].unit);
    }
    if (!clearly_above(largest, largest_difference)) return;
    finding.value = largest;
  }
  finding.message =
      fmt::format("its modulus may be {} times the stated one; at {} kPa that makes: {}",
                  written(band.factor, 3), written(stated.pressure_kpa, 4), change);
  finding.remedy = "measure the material that will be used, and give it inline";
  findings.push_back(std::move(finding));
}

void check_bands(const LoadedSegment& loaded, CheckFindings& findings) {
  const std::vector<const State*> states = loaded.states();
  if (states.empty() || states.back()->pressure_kpa == 0) return;
  const auto check = [&](const std::string& part, const std::optional<double>& factor) {
    // A change that small can hardly move anything by a fifth.
    if (factor && std::abs(*factor - 1) > 0.05) add_band(loaded, {part, *factor}, findings);
  };
  const Material& liner = loaded.segment->liner.material;
  check("liner", liner.modulus_low_factor);
  check("liner", liner.modulus_high_factor);
  if (!loaded.segment->lattice) return;
  const Material& lattice = loaded.segment->lattice->material;
  check("lattice", lattice.modulus_low_factor);
  check("lattice", lattice.modulus_high_factor);
}

}  // namespace

void check_validity(const LoadedSegment& loaded, CheckFindings& findings) {
  check_angles(loaded, findings);
  check_ring_places(loaded, findings);
  check_bands(loaded, findings);
}

}  // namespace latticast
