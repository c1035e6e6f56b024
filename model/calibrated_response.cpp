// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/calibrated_response.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "design/units.h"
#include "model/equilibrium/branch_text.h"
#include "model/section/calibration.h"
#include "model/section_response.h"

namespace latticast {
namespace {

/// Cavity over the cavity at rest beyond which no section is asked.
constexpr double most_volume_ratio = 3;

double volume_ratio(const Section& section, const State& state) {
  return state.stretch * square(state.inner_radius_mm / section.inner_radius_mm);
}

/// Numbers of the pressures whose state a section cannot be trusted with.
std::vector<std::size_t> beyond_section(const Section& section, const Response& response) {
  std::vector<std::size_t> beyond;
  for (std::size_t i = 0; i < response.states.size(); ++i) {
    const std::optional<State>& state = response.states[i];
    if (!state || !state->stable || volume_ratio(section, *state) > most_volume_ratio) {
      beyond.push_back(i);
    }
  }
  return beyond;
}

Deformation deformation_of(const Section& section, const State& state) {
  return state.deformation(section.inner_radius_mm, section.axis_rad);
}

/// Of the cell's energy: pressure and what holds the held coordinates.
std::array<double, coordinate_count> energy_gradient(const Section& section, const State& state) {
  std::array<double, coordinate_count> gradient =
      cavity_growth(section, deformation_of(section, state)).gradient;
  for (double& part : gradient) part *= mpa_from_kpa(state.pressure_kpa);
  gradient[coordinate::elongation] += state.force_n;
  gradient[coordinate::twist] += state.torque_nmm;
  const double cosine = std::cos(section.axis_rad);
  const double sine = std::sin(section.axis_rad);
  const auto& moment = state.moment_nmm;
  gradient[coordinate::bend_1] += cosine * moment[0] + sine * moment[1];
  gradient[coordinate::bend_2] += cosine * moment[1] - sine * moment[0];
  return gradient;
}

double percent_off(double value, double truth) {
  return truth == 0 ? 0 : 100 * (value / truth - 1);
}

std::string drift_text(const State& section, const State& cell) {
  std::string text = "calibrated by the unit cell at rest and at " +
                     pressure_text(cell.pressure_kpa) + ", where rest alone is off by ";
  const auto percent = [](const char* name, double value, double truth) {
    std::array<char, 60> number{};
    std::snprintf(number.data(), number.size(), "%.1f %% in %s", percent_off(value, truth), name);
    return std::string(number.data());
  };
  text += percent("stretch - 1", section.stretch - 1, cell.stretch - 1);
  if (cell.twist_rad_per_mm != 0) {
    text += " and " + percent("twist", section.twist_rad_per_mm, cell.twist_rad_per_mm);
  }
  if (cell.bend_magnitude_rad_per_mm() != 0) {
    text += " and " + percent("bending", section.bend_magnitude_rad_per_mm(),
                              cell.bend_magnitude_rad_per_mm());
  }
  return text;
}

class CalibratedSolver {
 public:
  CalibratedSolver(const PreparedSegment& segment, Held held, const SolverOptions& options)
      : segment_(segment),
        section_(std::get<Section>(segment.section)),
        held_(held),
        options_(options) {}

  Response by_section(std::span<const double> pressures_kpa) const {
    return section_response({section_, nullptr, segment_.length_mm}, pressures_kpa, held_,
                            options_);
  }

  Response by_cell(std::span<const double> pressures_kpa) const {
    return section_response({section_, segment_.cell.get(), segment_.length_mm}, pressures_kpa,
                            held_, options_);
  }

  /// Corrects the section to the cell's state at this pressure; what that moved, or nothing where
  /// either has no such state.
  std::string calibrate_at(double pressure_kpa) {
    const std::array pressures = {pressure_kpa};
    const auto before = by_section(pressures).states.front();
    const auto cell = by_cell(pressures).states.front();
    if (!before || !cell) return {};
    const auto calibration =
        calibrated_at(section_, deformation_of(section_, *cell), energy_gradient(section_, *cell));
    if (!calibration) return {};
    section_.calibration = std::make_shared<const Calibration>(*calibration);
    return drift_text(*before, *cell);
  }

  const Section& section() const { return section_; }

 private:
  const PreparedSegment& segment_;
  Section section_;
  Held held_;
  const SolverOptions& options_;
};

/// Replaces states beyond the section, and all that is said of the branch there, by the cell's.
void hand_over(const CalibratedSolver& solver, std::span<const double> pressures_kpa,
               const std::vector<std::size_t>& beyond, Response& response) {
  std::vector<double> asked;
  asked.reserve(beyond.size());
  for (const std::size_t i : beyond) asked.push_back(pressures_kpa[i]);
  Response cell = solver.by_cell(asked);
  for (std::size_t i = 0; i < beyond.size(); ++i) response.states[beyond[i]] = cell.states[i];

  // A section that fails further on is not believed beyond the last pressure where it has a state.
  double lowest = 0;
  double highest = 0;
  for (std::size_t i = 0; i < pressures_kpa.size(); ++i) {
    if (std::binary_search(beyond.begin(), beyond.end(), i)) continue;
    lowest = std::min(lowest, pressures_kpa[i]);
    highest = std::max(highest, pressures_kpa[i]);
  }
  const auto is_beyond = [lowest, highest](const AngleExtremum& point) {
    return point.pressure_kpa < lowest || point.pressure_kpa > highest;
  };
  std::erase_if(response.angle_extrema, is_beyond);
  std::copy_if(cell.angle_extrema.begin(), cell.angle_extrema.end(),
               std::back_inserter(response.angle_extrema), is_beyond);
  const double from = *std::min_element(
      asked.begin(), asked.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  response.critical_points = std::move(cell.critical_points);
  response.status = cell.status;
  response.message = std::move(cell.message);
  add_sentence(response.message, "states from " + pressure_text(from) +
                                     " on are the unit cell's: the cavity more than trebles there, "
                                     "or the section's branch ends");
}

}  // namespace

Response calibrated_response(const PreparedSegment& segment, std::span<const double> pressures_kpa,
                             Held held, const SolverOptions& options) {
  CalibratedSolver solver(segment, held, options);
  const auto highest = std::max_element(pressures_kpa.begin(), pressures_kpa.end());
  std::string drift;
  if (segment.calibrate == Calibrate::state && highest != pressures_kpa.end() && *highest > 0) {
    drift = solver.calibrate_at(*highest);
  }
  Response response = solver.by_section(pressures_kpa);
  const std::vector<std::size_t> beyond = beyond_section(solver.section(), response);
  if (!beyond.empty()) hand_over(solver, pressures_kpa, beyond, response);
  if (!drift.empty()) {
    add_sentence(response.message, drift);
  } else if (!segment.calibration_doubt.empty()) {
    add_sentence(response.message, segment.calibration_doubt);
  }
  return response;
}

}  // namespace latticast
