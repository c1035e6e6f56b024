// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/section_response.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>

#include "design/text/written_number.h"
#include "design/units.h"
#include "model/cell/unit_cell.h"
#include "model/equilibrium/branch.h"
#include "model/equilibrium/branch_text.h"
#include "model/section/section_energy.h"
#include "model/section/section_reading.h"

namespace latticast {
namespace {

/// What a point of the branch says, without its error, effort and stability.
State state_at(const Balance& balance, const BranchPoint& x, const BalanceAt& at, Held held) {
  const Section& section = balance.section();
  const Deformation q = balance.deformation(x);
  State state;
  const double pressure = balance.pressure_mpa(x);
  state.pressure_kpa = kpa_from_mpa(pressure);
  state.stretch = 1 + q.elongation;
  state.twist_rad_per_mm = q.twist;
  state.inner_radius_mm = section.inner_radius_mm + q.inner_growth;
  state.outer_radius_mm = current_radius_mm(section.inner_radius_mm, section.outer_radius_mm, q);
  const auto in_material = [&](double along_1, double along_2) {
    const double cosine = std::cos(section.axis_rad);
    const double sine = std::sin(section.axis_rad);
    return std::array{cosine * along_1 - sine * along_2, sine * along_1 + cosine * along_2};
  };
  state.bend_rad_per_mm = in_material(q.bend_1, q.bend_2);
  state.frame_turn_rad_per_mm = section.frame_turn_rad_per_mm;
  if (held.stretch) state.force_n = at.reaction[coordinate::elongation];
  if (held.twist) state.torque_nmm = at.reaction[coordinate::twist];
  if (held.bend) {
    state.moment_nmm =
        in_material(at.reaction[coordinate::bend_1], at.reaction[coordinate::bend_2]);
  }
  const double bore = std::numbers::pi * section.inner_radius_mm * section.inner_radius_mm;
  const double unit = 1 + std::abs(pressure) * bore / balance.energy_unit();
  for (const double residual : at.residual) {
    state.residual = std::max(state.residual, std::abs(residual) / unit);
  }
  return state;
}

std::string limit_name(const CriticalState& point, double pressure_kpa) {
  const std::string at = " at " + pressure_text(pressure_kpa);
  const bool inflating = pressure_kpa > 0;
  if (point.kind == CriticalKind::bifurcation) {
    return "bifurcation" + at + ": states " + (inflating ? "above" : "below") +
           " it on this branch are unstable";
  }
  if (point.kind == CriticalKind::closure) {
    return "the bore closes" + at + ": no open state below it";
  }
  const std::string beyond =
      std::string(": no equilibrium ") + (inflating ? "above" : "below") + " it on this branch";
  if (point.kind == CriticalKind::asymptote) return "growth without end" + at + beyond;
  return std::string("limit point (") + (inflating ? "ballooning)" : "collapse)") + at + beyond;
}

/// Why a path could not be followed further, where the model itself gives the reason.
std::string reason_of_loss(const Balance& balance, const BranchState& here) {
  const auto beyond_a_hundred = [](double x) { return std::abs(x) > 100; };
  const int n = balance.free_count();
  if (std::any_of(here.x.begin(), here.x.begin() + n, beyond_a_hundred)) {
    return ": the tube has grown more than a hundredfold there, which no material stands";
  }
  const Section& section = balance.section();
  const Deformation q = balance.deformation(here.x);
  if (stretch_limit_used(section, q) > 0.99) {
    return ": the liner's rubber has come to its stretch limit (Gent), where its stress is "
           "unbounded";
  }
  const auto link = most_strained_link(section, q);
  if (link &&
      (link->strain > 0.95 * link->range.highest || link->strain < 0.95 * link->range.lowest)) {
    return ": a " + std::string(link->path) + " strand is strained by " + written(link->strain, 3) +
           ", its law ends at " + written(link->range.lowest, 3) + " and " +
           written(link->range.highest, 3);
  }
  const double lift = std::hypot(q.bend_1, q.bend_2) *
                      current_radius_mm(section.inner_radius_mm, section.outer_radius_mm, q);
  if (1 + q.elongation - lift < 0.02) {
    return ": bending has brought the wall's inner side to zero length there";
  }
  if (std::abs(here.nearest_eigenvalue) < 0.01) {
    return ": the section is on the verge of instability there";
  }
  return "";
}

CriticalPoint critical_point(const Balance& balance, const CriticalState& point, Held held) {
  CriticalPoint limit;
  limit.kind = point.kind;
  limit.state = state_at(balance, point.x, point.balance, held);
  limit.state.error_estimate = point.pressure_error;
  limit.state.iterations = point.iterations;
  limit.pressure_kpa = limit.state.pressure_kpa;
  limit.name = limit_name(point, limit.pressure_kpa);
  return limit;
}

/// Requests in the order in which the branch meets them: from rest upwards, or from rest downwards.
std::vector<std::size_t> requests_of_sign(std::span<const double> pressures_kpa, bool suction) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < pressures_kpa.size(); ++i) {
    if ((pressures_kpa[i] < 0) == suction) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(pressures_kpa[a]) < std::abs(pressures_kpa[b]);
  });
  return order;
}

EnergySource source_of(const std::shared_ptr<UnitCellEnergy>& energy) {
  if (!energy) return {};
  return [energy](const Deformation& at) -> std::optional<SourceEnergy> {
    const auto found = energy->at(at);
    if (!found) return std::nullopt;
    return SourceEnergy{found->energy, found->doubt};
  };
}

class ResponseSolver {
 public:
  ResponseSolver(const SectionPath& path, Held held, const SolverOptions& options)
      : cell_(path.cell != nullptr ? std::make_shared<UnitCellEnergy>(*path.cell) : nullptr),
        branch_(path.section, held, options, source_of(cell_)),
        held_(held),
        length_mm_(path.length_mm) {}

  void report_solved(Response& response) const {
    constexpr std::array names = {"stretch", "twist", "radius", "bend-1", "bend-2"};
    for (const int i : branch_.balance().free_coordinates()) {
      response.solved.emplace_back(names[i]);
    }
  }

  void follow(std::span<const double> pressures_kpa, bool suction, Response& response) {
    branch_.restart();
    for (const std::size_t request : requests_of_sign(pressures_kpa, suction)) {
      const Reached reached = branch_.advance_to(mpa_from_kpa(pressures_kpa[request]));
      if (reached == Reached::target) {
        response.states[request] = finished_state(pressures_kpa[request]);
      } else if (reached == Reached::lost) {
        report_loss(response);
        break;
      } else if (response.status == Status::ok) {
        response.status = Status::no_equilibrium;
      }
    }
    report_critical_points(response);
    report_angle_extrema(response);
  }

 private:
  using Clock = std::chrono::steady_clock;

  State finished_state(double pressure_kpa) {
    const BranchState& here = branch_.here();
    State state = state_at(branch_.balance(), here.x, here.balance, held_);
    state.pressure_kpa = pressure_kpa;
    state.error_estimate = here.error_estimate;
    state.smallest_eigenvalue = here.smallest_eigenvalue;
    state.stable = here.smallest_eigenvalue > 0;
    const Clock::time_point now = Clock::now();
    state.time_us = std::chrono::duration<double, std::micro>(now - since_).count();
    state.iterations = branch_.iterations() - iterations_before_;
    since_ = now;
    iterations_before_ = branch_.iterations();
    return state;
  }

  void report_loss(Response& response) const {
    response.status = Status::not_converged;
    const double pressure = kpa_from_mpa(branch_.balance().pressure_mpa(branch_.here().x));
    std::string reason = reason_of_loss(branch_.balance(), branch_.here());
    if (cell_ && cell_->buckled()) {
      reason = ": the wall buckles between the lattice's strands and rings there";
    }
    if (cell_ && cell_->exhausted()) {
      reason =
          ": the unit cell has been solved as often as one request may; the end of the branch "
          "may be near, ask for lower pressures";
    }
    add_sentence(response.message, "the equilibrium could not be followed beyond " +
                                       pressure_text(pressure) + reason);
  }

  void report_critical_points(Response& response) const {
    for (const CriticalState& point : branch_.critical_points()) {
      response.critical_points.push_back(critical_point(branch_.balance(), point, held_));
      add_sentence(response.message, response.critical_points.back().name);
    }
  }

  void report_angle_extrema(Response& response) const {
    for (const ExtremumState& at : branch_.angle_extrema()) {
      AngleExtremum point;
      point.quantity = at.of_bending ? AngleKind::bend : AngleKind::twist;
      point.largest = at.largest;
      point.state = state_at(branch_.balance(), at.x, at.balance, held_);
      point.state.error_estimate = at.pressure_error;
      point.pressure_kpa = point.state.pressure_kpa;
      point.name = extremum_text(point, length_mm_);
      response.angle_extrema.push_back(std::move(point));
    }
  }

  Clock::time_point since_ = Clock::now();  // first: the first state pays for setting up
  std::shared_ptr<UnitCellEnergy> cell_;
  Branch branch_;
  Held held_;
  double length_mm_;
  int iterations_before_ = 0;
};

}  // namespace

Response section_response(const SectionPath& path, std::span<const double> pressures_kpa, Held held,
                          const SolverOptions& options) {
  Response response;
  response.states.resize(pressures_kpa.size());
  response.laws = laws_of(path.section);
  ResponseSolver solver(path, held, options);
  solver.report_solved(response);
  solver.follow(pressures_kpa, false, response);
  solver.follow(pressures_kpa, true, response);
  return response;
}

}  // namespace latticast
