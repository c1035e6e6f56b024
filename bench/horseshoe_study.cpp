// SPDX-License-Identifier: GPL-3.0-or-later
// Force of one horseshoe at one strain: error against processor time of four methods, beside a
// reference in extended precision.
//   horseshoe_methods   for the page: each method's best and what it needs for 1e-9
//   horseshoe_law       for the page: the production interpolant over its whole range
//   horseshoe           every point of the plot
#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "bench/arc_method.h"
#include "bench/arc_reference.h"
#include "bench/study.h"
#include "model/horseshoe/horseshoe_law.h"

namespace {

using namespace latticast;

struct Case {
  const char* name;
  double radius_mm;
  double arc_deg;
  double width_mm;
  double strain;  // in parts of the full extension, and ...
  double beyond;  // ... on top of it
};

// The rubber's columns are pulled to about full extension; docs/horseshoe.md#equation says what the
// shapes mean.
constexpr Case cases[] = {
    {"180° w/R 0.753: half extended", 85.0 / 32, 180, 2, 0.5, 0},
    {"180° w/R 0.753: pushed", 85.0 / 32, 180, 2, -0.35, 0},
    {"170° w/R 0.571: 0.9 of full", 3.5, 170, 2, 0.9, 0},
    {"170° w/R 3: half extended", 1, 170, 3, 0.5, 0},
    {"220° w/R 0.1: full extension", 20, 220, 2, 1, 0},
    {"180° w/R 0.01: 0.9 of full", 100, 180, 1, 0.9, 0},
    {"180° w/R 0.01: full extension", 100, 180, 1, 1, 0},
    {"180° w/R 0.01: full + 0.1", 100, 180, 1, 1, 0.1},
};

struct Trial {
  double setting = 0;
  double error = std::numeric_limits<double>::infinity();  // relative; infinite: not solved
  double seconds = 0;
};

using Method = std::function<std::optional<double>()>;

Trial tried(double setting, long double reference, const Method& method) {
  Trial trial;
  trial.setting = setting;
  std::optional<double> force;
  const std::clock_t begin = std::clock();
  force = method();
  trial.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  if (force) trial.error = static_cast<double>(std::abs(*force / reference - 1));
  if (trial.seconds < 0.01) trial.seconds = processor_seconds([&] { method(); }, 0.002);
  return trial;
}

/// "3e-14 in 0.4 ms (32)": the cheapest trial within ten times the least error.
std::string best_of(const std::vector<Trial>& trials) {
  const auto by_error = [](const Trial& a, const Trial& b) { return a.error < b.error; };
  const double least = std::min_element(trials.begin(), trials.end(), by_error)->error;
  if (!(least < 0.1)) return "fails";
  const Trial* cheapest = nullptr;
  for (const Trial& trial : trials) {
    if (trial.error > std::max(10 * least, 1e-15)) continue;
    if (cheapest == nullptr || trial.seconds < cheapest->seconds) cheapest = &trial;
  }
  const double seconds = cheapest->seconds;
  const std::string time = seconds < 1e-6   ? fmt::format("{:.2g} ns", seconds * 1e9)
                           : seconds < 1e-3 ? fmt::format("{:.2g} us", seconds * 1e6)
                                            : fmt::format("{:.2g} ms", seconds * 1e3);
  return fmt::format("{:.0e} in {}", cheapest->error, time);
}

HorseshoeShape shape_of(const Case& what) {
  return {what.radius_mm, what.arc_deg * std::numbers::pi / 180, what.width_mm, 2, 19.46};
}

Arc arc_of(const HorseshoeShape& shape) {
  return {shape.arc_rad / 2, std::pow(shape.width_mm / shape.radius_mm, 2) / 12};
}

class Comparison {
 public:
  explicit Comparison(const Case& what)
      : what_(what),
        shape_(shape_of(what)),
        arc_(arc_of(shape_)),
        strain_(what.strain * full_extension(shape_) + what.beyond),
        solver_(arc_),
        at_(solver_.advance(solver_.rest(), strain_).value()),
        reference_(arc_reference(arc_, at_)) {}

  void add_to(StudyTable& points, StudyTable& page) const {
    std::vector<Cell> row = {what_.name, strain_, exponent(),
                             static_cast<double>(reference_.disagreement)};
    const auto add = [&](const char* method, const std::vector<Trial>& trials) {
      for (const Trial& trial : trials) {
        const bool solved = trial.error < 0.1;
        points.add({what_.name, strain_, exponent(), static_cast<double>(reference_.disagreement),
                    method, trial.setting, solved ? Cell(trial.error) : Cell(""), trial.seconds,
                    solved                       ? "solved"
                    : std::isfinite(trial.error) ? "another branch"
                                                 : "fails"});
      }
      row.emplace_back(best_of(trials));
    };
    add("collocation", collocation());
    add("shooting from the end", shooting(ShootingStart::end));
    add("shooting from the middle", shooting(ShootingStart::middle));
    add("first integral", first_integral());
    add("interpolant", interpolant());
    page.add(std::move(row));
  }

 private:
  // By which power of e shooting along the whole arc amplifies an error.
  double exponent() const {
    const double beta = at_.bent.force;
    const double rate_squared = beta * (1 + arc_.compliance * beta);
    return rate_squared > 0 ? 2 * arc_.half_angle_rad * std::sqrt(rate_squared) : 0;
  }

  std::vector<Trial> collocation() const {
    std::vector<Trial> trials;
    for (const int order : {8, 12, 16, 24, 32, 48, 64, 96, 128}) {
      trials.push_back(
          tried(order, reference_.force, [&] { return collocated_force(arc_, strain_, order); }));
    }
    return trials;
  }

  std::vector<Trial> shooting(ShootingStart start) const {
    std::vector<Trial> trials;
    for (int digits = 1; digits <= 13; digits += 2) {
      const double tolerance = std::pow(10, -digits);
      trials.push_back(tried(tolerance, reference_.force,
                             [&] { return shot_force(arc_, strain_, tolerance, start); }));
    }
    return trials;
  }

  std::vector<Trial> first_integral() const {
    std::vector<Trial> trials;
    for (const int points : {2, 3, 4, 6, 8, 10, 12, 16, 20, 26, 32}) {
      const ArcSolver solver(arc_, points);
      trials.push_back(tried(points, reference_.force, [&]() -> std::optional<double> {
        const auto found = solver.advance(solver.rest(), strain_);
        if (!found) return std::nullopt;
        return found->bent.force;
      }));
    }
    return trials;
  }

  std::vector<Trial> interpolant() const {
    const ForceTable law = arc_table(arc_, widest_range(shape_));
    Trial trial = tried(0, reference_.force, [&] { return std::optional(law.at(strain_)->force); });
    constexpr int calls = 1000;
    double sum = 0;
    const double seconds = processor_seconds([&] {
      for (int i = 0; i < calls; ++i) sum += law.at(strain_ * (1 - 1e-9 * i))->force;
    });
    trial.seconds = std::isfinite(sum) ? seconds / calls : 0;
    return {trial};
  }

  Case what_;
  HorseshoeShape shape_;
  Arc arc_;
  double strain_;
  ArcSolver solver_;
  ArcEquilibrium at_;
  ArcReference reference_;
};

/// Largest relative error of the force over strains all over the range, rest left out.
double worst_error(const StrandLaw& law, const Arc& arc) {
  constexpr int count = 29;
  const ArcSolver solver(arc);
  const StrainRange& range = law.range();
  double worst = 0;
  for (int i = 0; i <= count; ++i) {
    const double t = static_cast<double>(i) / count;
    const double strain = range.lowest * (1 - t) + range.highest * t;
    const auto near = solver.advance(solver.rest(), strain);
    const long double reference = arc_reference_force(arc, near.value());
    const double force = law.table().at(strain)->force;
    worst = std::max(worst, static_cast<double>(std::abs(force / reference - 1)));
  }
  return worst;
}

/// Time of one evaluation, at strains in no order.
double evaluation_seconds(const StrandLaw& law) {
  std::vector<double> strains(4096);
  unsigned number = 1;
  for (double& strain : strains) {
    number = number * 1664525U + 1013904223U;
    const double t = number / 4294967296.0;
    strain = law.range().lowest * (1 - t) + law.range().highest * t;
  }
  double sum = 0;
  const double seconds = processor_seconds([&] {
    for (const double strain : strains) sum += law.at(strain)->force_n;
  });
  return std::isfinite(sum) ? seconds / static_cast<double>(strains.size()) : 0;
}

StudyTable law_table() {
  StudyTable table("horseshoe_law",
                   {"arc (deg)", "w/R", "pieces", "worst error of 30 strains", "its own estimate",
                    "evaluation (ns)", "building (ms)", "evaluations that cost as much"});
  for (const auto& [arc_deg, slenderness] : {std::pair{180.0, 64.0 / 85},
                                             {170.0, 2 / 3.5},
                                             {170.0, 4 / 3.5},
                                             {180.0, 0.1},
                                             {180.0, 0.01},
                                             {20.0, 0.001},
                                             {300.0, 0.001},
                                             {300.0, 100.0}}) {
    const HorseshoeShape shape{1, arc_deg * std::numbers::pi / 180, slenderness, 2, 19.46};
    const StrandLaw law = make_law(shape);
    const double building = processor_seconds([&] { make_law(shape); });
    const double evaluation = evaluation_seconds(law);
    table.add({arc_deg, slenderness, static_cast<double>(law.table().breaks().size() - 1),
               worst_error(law, arc_of(shape)), law.accuracy().force_error, evaluation * 1e9,
               building * 1e3, std::round(building / evaluation)});
  }
  return table;
}

}  // namespace

// What is thrown ends the study with its message.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int count, char** arguments) {
  const std::filesystem::path folder = study_folder(count, arguments);
  StudyTable points("horseshoe", {"case", "strain", "exponent", "references_differ", "method",
                                  "setting", "error", "seconds", "outcome"});
  StudyTable page(
      "horseshoe_methods",
      {"horseshoe", "strain", "exponent of the whole arc", "references differ by", "collocation",
       "shooting from the end", "shooting from the middle", "first integral", "interpolant"});
  for (const Case& what : cases) Comparison(what).add_to(points, page);
  points.write(folder, false);
  page.write(folder);
  law_table().write(folder);
}
