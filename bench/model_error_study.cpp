// SPDX-License-Identifier: GPL-3.0-or-later
// Error of the model beside the error of the numbers: every variant against what the paper
// publishes and against a finite-element cell (tests/golden/fe_alpha36.csv).
//   model_error_twist, model_error_bend  for the page: percent by which each variant is off
//   model_error_and_time                 for the page: both errors and the time, in words
//   model_error                          every value
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "bench/study.h"
#include "model/segment_response.h"
#include "tests/golden/finite_element_cell.h"
#include "tests/unit/model/segments.h"

namespace {

using namespace latticast;
using testing::degree;

/// What is compared, and the scaled coordinate that its numerical error is measured against.
struct Quantity {
  std::string name;
  std::string source;
  double reference = 0;
  Segment segment;
  double pressure_kpa = 0;
  Held held;
  std::function<double(const State&)> value;
  std::function<double(const State&)> coordinate;
};

struct Variant {
  std::string name;
  ModelChoice model;
};

std::vector<Variant> twisting_variants() {
  ModelChoice mixture = testing::with_joint(JointModel::paper);
  mixture.wall = WallKind::mixture;
  return {{"joint none", testing::with_joint(JointModel::none)},
          {"joint paper", testing::with_joint(JointModel::paper)},
          {"joint clear-span", testing::with_joint(JointModel::clear_span)},
          {"mixture", mixture}};
}

std::vector<Variant> bending_variants() {
  ModelChoice rods;
  rods.columns = ColumnModel::rods;
  return {{"rods (fitted)", rods}, {"distributed", {}}};
}

double turned(const State& state) {
  return std::abs(state.twist_rad_per_mm);
}

double lengthened(const State& state) {
  return state.stretch - 1;
}

double bent(const State& state) {
  return state.bend_magnitude_rad_per_mm();
}

double times_radius(double curvature) {
  return curvature * 18;  // R_o in mm, of all segments here
}

void add_finite_elements(std::vector<Quantity>& all) {
  Segment segment = testing::paper_segment({36});
  segment.length_mm = 80;  // whole periods of the cell
  segment.lattice->rings = Rings{std::nullopt, 10.0, 2};
  for (const testing::CellState& at : testing::finite_element_cell()) {
    const double pressure = at.pressure_kpa;
    if (std::fmod(pressure, 20) != 0) continue;
    all.push_back({fmt::format("stretch - 1 at {:g} kPa", pressure),
                   "finite elements",
                   at.stretch - 1,
                   segment,
                   pressure,
                   {},
                   lengthened,
                   lengthened});
    all.push_back({fmt::format("twist in deg/100 mm at {:g} kPa", pressure),
                   "finite elements",
                   at.twist_rad_per_mm * 100 / degree,
                   segment,
                   pressure,
                   {},
                   [](const State& s) { return turned(s) * 100 / degree; },
                   [](const State& s) { return times_radius(turned(s)); }});
  }
}

std::vector<Quantity> twisting_quantities() {
  std::vector<Quantity> all;
  add_finite_elements(all);
  const Segment segment = testing::paper_segment({36});
  all.push_back({"end rotation in deg/100 mm at 60 kPa",
                 "paper",
                 185,
                 segment,
                 60,
                 {},
                 [](const State& s) { return turned(s) * 100 / degree; },
                 [](const State& s) { return times_radius(turned(s)); }});
  all.push_back({"blocked torque in N m at 60 kPa",
                 "paper",
                 0.82,
                 segment,
                 60,
                 {.twist = true},
                 [](const State& s) { return std::abs(s.torque_nmm) / 1000; },
                 lengthened});
  return all;
}

/// Columns 2 mm thin and `thick`; the fitted arc belongs to the rods, the drawn one to the others.
Segment bending_segment(double thick_mm, const ModelChoice& model) {
  if (model.columns == ColumnModel::distributed) {
    return testing::columns(testing::halves(16, thick_mm, 2));
  }
  Segment segment = testing::columns(testing::halves(16, thick_mm, 2), 90, {3.5, 170, true});
  segment.liner.material.law = Linear{0.082, 0.5};
  return segment;
}

struct BendingAngle {
  double thick_mm;
  double pressure_kpa;
  double published_deg;
};

// The paper's plots end at 10 mm, where the angle has levelled off.
constexpr BendingAngle bending_angles[] = {
    {4, 20, 14}, {4, 100, 43}, {10, 40, 30}, {10, 60, 42}, {10, 80, 51}};

struct Finding {
  double value;
  double error_percent;
  double numerical_percent;
  double seconds;
};

Finding found(const Quantity& quantity, const ModelChoice& model) {
  const PreparedSegment prepared = prepare_segment(quantity.segment, model);
  const std::vector<double> pressure = {quantity.pressure_kpa};
  const Response response = predict(prepared, pressure, quantity.held);
  if (!response.states[0]) return {NAN, NAN, NAN, NAN};
  const State& state = *response.states[0];
  double numerical = state.error_estimate / quantity.coordinate(state);
  for (const auto& law : response.laws) {
    numerical = std::max(numerical, law->accuracy().force_error);
  }
  const double value = quantity.value(state);
  return {value, 100 * (value / quantity.reference - 1), 100 * numerical,
          processor_seconds([&] { predict(prepared, pressure, quantity.held); }, 0.005)};
}

/// What all rows together say.
class Summary {
 public:
  void add(const Finding& finding) {
    if (std::isnan(finding.value)) return;
    model_.push_back(std::abs(finding.error_percent));
    numerical_ = std::max(numerical_, finding.numerical_percent);
    seconds_ = std::max(seconds_, finding.seconds);
  }

  std::string sentence() {
    std::sort(model_.begin(), model_.end());
    return fmt::format(
        "Over all {} values the model is off by {:.2g} % at the median and {:.2g} % at most, the "
        "numbers by {:.1g} % at most: {:.0f} orders of magnitude less at the median. No state took "
        "more than {:.2g} ms.",
        model_.size(), model_[model_.size() / 2], model_.back(), numerical_,
        std::floor(std::log10(model_[model_.size() / 2] / numerical_)), seconds_ * 1e3);
  }

 private:
  std::vector<double> model_;
  double numerical_ = 0;
  double seconds_ = 0;
};

class Study {
 public:
  /// A row of a page's table: one quantity under each variant.
  void compare(StudyTable& page, const std::vector<std::pair<Quantity, Variant>>& all) {
    const Quantity& first = all.front().first;
    std::vector<Cell> row = {first.name, first.source, first.reference};
    double numerical = 0;
    double seconds = 0;
    for (const auto& [quantity, variant] : all) {
      const Finding finding = found(quantity, variant.model);
      points_.add({quantity.name, quantity.source, quantity.reference, variant.name, finding.value,
                   finding.error_percent, finding.numerical_percent, finding.seconds});
      summary_.add(finding);
      row.emplace_back(finding.error_percent);
      numerical = std::max(numerical, finding.numerical_percent);
      seconds = std::max(seconds, finding.seconds);
    }
    row.emplace_back(numerical);
    row.emplace_back(seconds * 1e6);
    page.add(std::move(row));
  }

  void write(const std::filesystem::path& folder) {
    points_.write(folder, false);
    write_sentence(folder, "model_error_and_time", summary_.sentence());
  }

 private:
  StudyTable points_{"model_error",
                     {"quantity", "source", "reference", "model", "value", "error_percent",
                      "numerical_percent", "seconds"}};
  Summary summary_;
};

}  // namespace

// What is thrown ends the study with its message.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int count, char** arguments) {
  const std::filesystem::path folder = study_folder(count, arguments);
  Study study;
  StudyTable twist("model_error_twist",
                   {"quantity", "from", "value there", "joint none (%)", "joint paper (%)",
                    "joint clear-span (%)", "mixture (%)", "numerical error (%)", "time (us)"});
  for (const Quantity& quantity : twisting_quantities()) {
    std::vector<std::pair<Quantity, Variant>> row;
    for (const Variant& variant : twisting_variants()) row.emplace_back(quantity, variant);
    study.compare(twist, row);
  }
  twist.write(folder);
  StudyTable bend("model_error_bend",
                  {"quantity", "from", "value there", "rods fitted to these (%)", "distributed (%)",
                   "numerical error (%)", "time (us)"});
  for (const BendingAngle& angle : bending_angles) {
    std::vector<std::pair<Quantity, Variant>> row;
    for (const Variant& variant : bending_variants()) {
      Quantity quantity;
      quantity.name =
          fmt::format("bending in deg of 2:{:g} at {:g} kPa", angle.thick_mm, angle.pressure_kpa);
      quantity.source = "paper";
      quantity.reference = angle.published_deg;
      quantity.segment = bending_segment(angle.thick_mm, variant.model);
      quantity.pressure_kpa = angle.pressure_kpa;
      quantity.value = [](const State& s) { return bent(s) * 85 / degree; };
      quantity.coordinate = [](const State& s) { return times_radius(bent(s)); };
      row.emplace_back(quantity, variant);
    }
    study.compare(bend, row);
  }
  bend.write(folder);
  study.write(folder);
}
