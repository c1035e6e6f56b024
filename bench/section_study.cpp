// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibrium of one section: error of the scaled coordinates against processor time.
//   section_cost    for the page: what a state of the program's own settings costs, and its error
//   section_starts  for the page: Newton's method from rest at the asked pressure, over 200
//                   pressures, beside continuation, under the program's first quadrature (with 24
//                   points in R far fewer roots lie beyond the branch's end)
//   section         every point of the plot: quadrature order, Newton's tolerance, error goal
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "bench/section_reference.h"
#include "bench/study.h"
#include "model/numerics/newton.h"
#include "model/segment_response.h"
#include "tests/unit/model/segments.h"

namespace {

using namespace latticast;

constexpr double paper_seconds = 30;  // of the paper's programs for "a single calculation"

struct Case {
  std::string name;
  Segment segment;
  double pressure_kpa = 0;
};

double ballooning_kpa(const Segment& segment) {
  return predict(segment, {}, std::vector<double>{1000}).critical_points.at(0).pressure_kpa;
}

std::vector<Case> cases() {
  const Segment twisting = testing::paper_segment({36});
  const Segment bending = testing::columns(testing::halves(16, 3.5, 2));
  const Segment irregular = testing::columns({2, 3.5, 3, 2.5, 2, 3.5, 2.5, 2.5}, 60);
  Segment stiff = twisting;
  stiff.lattice->material.law = Linear{0.08e6, 0.5};
  const Segment bare = testing::tube(12, 16, NeoHookean{0.08});
  return {{"twisting 36° at 40 kPa", twisting, 40},
          {"bending 2:3.5 at 30 kPa", bending, 30},
          {"superimposed irregular at 30 kPa", irregular, 30},
          {"stiff (E/mu = 1e6) at 40 kPa", stiff, 40},
          {"bare tube at 0.9999 of its limit", bare, 0.9999 * ballooning_kpa(bare)}};
}

/// One way to a state: where it ended, and what it took.
struct Trial {
  std::string method;
  double setting = 0;
  double error = 0;
  double estimate = 0;
  double seconds = 0;
};

class Comparison {
 public:
  explicit Comparison(const Case& what)
      : what_(what),
        prepared_(prepare_segment(what.segment, {})),
        balance_(std::get<Section>(prepared_.section), {}, fixed(24)) {
    const State near = state_at(what.pressure_kpa, {});
    reference_ = section_reference(balance_, scaled(balance_, near));
    size_ = largest_error(balance_, reference_.x, BranchPoint{});
  }

  std::vector<Trial> trials() const {
    std::vector<Trial> all;
    for (const int points : {2, 3, 4, 6, 8, 12, 16, 24, 32, 48}) {
      all.push_back(predicted("quadrature points", points, fixed(points)));
    }
    for (int digits = 3; digits <= 12; ++digits) {
      SolverOptions options;
      options.error_goal = std::pow(10, -digits);
      all.push_back(predicted("error goal", options.error_goal, options));
    }
    const BranchPoint start = scaled(balance_, state_at(0.9 * what_.pressure_kpa, {}));
    for (int digits = 1; digits <= 14; ++digits) {
      all.push_back(newton(start, std::pow(10, -digits)));
    }
    return all;
  }

  /// A row of section_cost: one state from rest, and one of a sweep of 13 pressures.
  void add_cost(StudyTable& table) const {
    const Trial rest = predicted("", 0, {});
    std::vector<double> sweep;
    for (int i = 1; i <= 13; ++i) sweep.push_back(what_.pressure_kpa * i / 13);
    const double seconds = processor_seconds([&] { predict(prepared_, sweep); }) / 13;
    table.add({what_.name, static_cast<double>(balance_.free_count()), reference_.last_step,
               rest.error * size_, rest.estimate * size_, rest.error, rest.seconds * 1e6,
               seconds * 1e6, paper_seconds / rest.seconds, paper_seconds / (13 * seconds)});
  }

  /// A row of section_starts.
  void add_starts(StudyTable& table) const;

  const Case& what() const { return what_; }

 private:
  static SolverOptions fixed(int points) {
    SolverOptions options;
    options.fixed_quadrature = points;
    return options;
  }

  State state_at(double pressure_kpa, const SolverOptions& options) const {
    return predict(prepared_, std::vector<double>{pressure_kpa}, {}, options).states[0].value();
  }

  Trial predicted(const std::string& method, double setting, const SolverOptions& options) const {
    const std::vector<double> pressure = {what_.pressure_kpa};
    Trial trial{method, setting, INFINITY, INFINITY, 0};
    const Response response = predict(prepared_, pressure, {}, options);
    if (response.states[0]) {
      trial.error = error_of(scaled(balance_, *response.states[0]));
      trial.estimate = response.states[0]->error_estimate / size_;
    }
    trial.seconds = processor_seconds([&] { predict(prepared_, pressure, {}, options); });
    return trial;
  }

  double error_of(const BranchPoint& x) const {
    return largest_error(balance_, x, reference_.x) / size_;
  }

  /// Newton's method at the asked pressure from the state at 0.9 of it, until a step is small.
  Trial newton(const BranchPoint& start, double tolerance) const {
    const int n = balance_.free_count();
    BranchPoint x{};
    const auto walk = [&] {
      x = start;
      x[n] = balance_.scaled_pressure(what_.pressure_kpa / 1000);
      for (int i = 0; i < 20; ++i) {
        const BalanceAt at = balance_.at(x).value();
        const Eigen::Map<const Eigen::MatrixXd> stiffness(at.tangent_stiffness.data(), n, n);
        const Eigen::Map<const Eigen::VectorXd> imbalance(at.residual.data(), n);
        const Eigen::VectorXd step = stiffness.partialPivLu().solve(imbalance);
        for (int j = 0; j < n; ++j) x[j] -= step[j];
        if (step.cwiseAbs().maxCoeff() < tolerance) break;
      }
    };
    const double seconds = processor_seconds(walk);
    return {"Newton tolerance", tolerance, error_of(x), tolerance / size_, seconds};
  }

  Case what_;
  PreparedSegment prepared_;
  Balance balance_;
  SectionReference reference_;
  double size_ = 1;  // largest scaled coordinate
};

/// Newton's method (KINSOL) at one pressure from rest; false: no convergence.
bool cold_start(const Balance& balance, NewtonSolver& newton, BranchPoint& x) {
  const int n = balance.free_count();
  const auto system = [&](std::span<const double> at, std::span<double> residual,
                          std::span<double> jacobian) {
    BranchPoint point = x;
    std::copy(at.begin(), at.end(), point.begin());
    const auto found = balance.at(point);
    if (!found) return false;
    std::copy_n(found->residual.begin(), n, residual.begin());
    std::copy_n(found->tangent_stiffness.begin(), n * n, jacobian.begin());
    return true;
  };
  return newton.solve(std::span<double>(x).first(n), system, 200);
}

void Comparison::add_starts(StudyTable& table) const {
  constexpr int count = 200;
  const double reach_kpa = 8 * what_.pressure_kpa;
  std::vector<double> pressures;
  for (int i = 1; i <= count; ++i) pressures.push_back(reach_kpa * i / count);
  const Response response = predict(prepared_, pressures);
  const Balance balance(balance_.section(), {}, {});  // points as the program begins with
  const int n = balance.free_count();
  NewtonSolver newton(n);
  int right = 0;
  int wrong = 0;
  int ghosts = 0;
  int failed = 0;
  for (int i = 0; i < count; ++i) {
    BranchPoint x{};
    x[n] = balance.scaled_pressure(pressures[i] / 1000);
    if (!cold_start(balance, newton, x)) {
      ++failed;
    } else if (!response.states[i]) {
      ++ghosts;
    } else {
      const BranchPoint true_x = scaled(balance_, *response.states[i]);
      const bool same = largest_error(balance_, x, true_x) <
                        1e-5 * (1 + largest_error(balance_, true_x, BranchPoint{}));
      ++(same ? right : wrong);
    }
  }
  const double cold = processor_seconds([&] {
    BranchPoint x{};
    x[n] = balance.scaled_pressure(what_.pressure_kpa / 1000);
    cold_start(balance, newton, x);
  });
  const double sweep = processor_seconds([&] { predict(prepared_, pressures); }) / count;
  const double states = static_cast<double>(
      std::count_if(response.states.begin(), response.states.end(),
                    [](const std::optional<State>& state) { return state.has_value(); }));
  table.add({what_.name, reach_kpa, states, static_cast<double>(right), static_cast<double>(wrong),
             static_cast<double>(ghosts), static_cast<double>(failed), cold * 1e6, sweep * 1e6});
}

}  // namespace

// What is thrown ends the study with its message.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int count, char** arguments) {
  const std::filesystem::path folder = study_folder(count, arguments);
  StudyTable points("section", {"case", "method", "setting", "error", "estimate", "seconds"});
  StudyTable cost("section_cost",
                  {"section", "unknowns", "reference's last step", "error of a coordinate",
                   "its own estimate", "error over the largest coordinate", "from rest (us)",
                   "each of 13 in a sweep (us)", "30 s over one state", "30 s over the sweep"});
  StudyTable starts("section_starts",
                    {"section", "pressures up to (kPa)", "states by continuation (of 200)",
                     "the same by cold start", "another root", "a root beyond the branch's end",
                     "no convergence", "cold start (us)", "continuation (us each)"});
  for (const Case& what : cases()) {
    const Comparison comparison(what);
    for (const Trial& trial : comparison.trials()) {
      points.add(
          {what.name, trial.method, trial.setting, trial.error, trial.estimate, trial.seconds});
    }
    comparison.add_cost(cost);
    comparison.add_starts(starts);
  }
  points.write(folder, false);
  cost.write(folder);
  starts.write(folder);
}
