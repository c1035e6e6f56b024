// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/plain_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

#include <Eigen/Dense>

#include "model/section/section_energy.h"

namespace latticast {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most_steps = 20000;
constexpr double shortest = 1e-7;  // step of pressure, against the pressure asked for

double size(const ScaledState& x) {
  double largest = 0;
  for (const double value : x) largest = std::max(largest, std::abs(value));
  return largest;
}

/// Imbalance and stiffness by the given coordinates, scaled.
struct Local {
  VectorXd imbalance;
  MatrixXd stiffness;
  VectorXd push;
};

std::optional<Local> local(const Section& section, const Quadrature& quadrature,
                           const Deformation& at, double pressure_mpa, std::span<const int> free,
                           const ScaledState& scale, double energy) {
  const auto stored = stored_energy(section, quadrature, at, free);
  if (!stored) return std::nullopt;
  const SectionEnergy cavity = cavity_growth(section, at);
  const auto n = static_cast<Eigen::Index>(free.size());
  Local result{VectorXd(n), MatrixXd(n, n), VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const int a = free[i];
    result.push[i] = cavity.gradient[a] * scale[a] / energy;
    result.imbalance[i] = stored->gradient[a] * scale[a] / energy - pressure_mpa * result.push[i];
    for (Eigen::Index j = 0; j < n; ++j) {
      const int b = free[j];
      result.stiffness(i, j) = (stored->second(a, b) - pressure_mpa * cavity.second(a, b)) *
                               scale[a] * scale[b] / energy;
    }
  }
  return result;
}

}  // namespace

const PlainPath::Points PlainPath::finest{80, 48, 288};
const PlainPath::Points PlainPath::middling{24, 12, 24};

PlainPath::PlainPath(const Section& section, Held held) : section_(section) {
  const std::array<bool, coordinate_count> fixed = {held.stretch, held.twist, false, held.bend,
                                                    held.bend};
  const std::array<bool, coordinate_count> moves = {
      true, section.twists, true, section.bending_axes > 0, section.bending_axes > 1};
  for (int i = 0; i < coordinate_count; ++i) {
    if (fixed[i]) continue;
    free_.push_back(i);
    if (moves[i]) stepped_.push_back(i);
  }
  const double outer = section.outer_radius_mm;
  scale_ = {1, 1 / outer, section.inner_radius_mm, 1 / outer, 1 / outer};
  energy_ = section.shear_modulus_mpa * std::numbers::pi *
            (section.isotropic_to_mm - section.isotropic_from_mm) *
            (section.isotropic_to_mm + section.isotropic_from_mm);
}

Deformation PlainPath::deformation(const ScaledState& x) const {
  return {x[0] * scale_[0], x[1] * scale_[1], x[2] * scale_[2], x[3] * scale_[3], x[4] * scale_[4]};
}

ScaledState PlainPath::scaled(const State& state) const {
  const Deformation q = state.deformation(section_.inner_radius_mm, section_.axis_rad);
  return {q.elongation / scale_[0], q.twist / scale_[1], q.inner_growth / scale_[2],
          q.bend_1 / scale_[3], q.bend_2 / scale_[4]};
}

/// Where the wall's energy may come close to a singularity at the bore: it closes, or a Gent rubber
/// is stretched to its limit.
bool PlainPath::is_singular(double pressure_mpa) const {
  return pressure_mpa < 0 || std::isfinite(first_invariant_limit(section_.liner_law));
}

Quadrature PlainPath::points(const Points& count, double pressure_mpa) const {
  const bool panels = is_singular(pressure_mpa);
  return make_quadrature(section_, panels ? std::max(10, count.radial / 4) : count.radial,
                         count.lattice, count.around, panels ? 12 : 1);
}

std::optional<ScaledState> PlainPath::newton_step(const ScaledState& x, double pressure_mpa,
                                                  const Points& count) const {
  const auto at = local(section_, points(count, pressure_mpa), deformation(x), pressure_mpa,
                        stepped_, scale_, energy_);
  if (!at) return std::nullopt;
  const VectorXd step = -at->stiffness.fullPivLu().solve(at->imbalance);
  ScaledState result{};
  for (std::size_t i = 0; i < stepped_.size(); ++i) {
    result[stepped_[i]] = step[static_cast<Eigen::Index>(i)];
  }
  return result;
}

std::optional<PlainPath::Rate> PlainPath::rate(const ScaledState& x, double pressure_mpa,
                                               const Points& count) const {
  const auto at = local(section_, points(count, pressure_mpa), deformation(x), pressure_mpa,
                        stepped_, scale_, energy_);
  if (!at) return std::nullopt;
  const VectorXd by_pressure = at->stiffness.fullPivLu().solve(at->push);
  Rate result;
  for (std::size_t i = 0; i < stepped_.size(); ++i) {
    result.by_pressure[stepped_[i]] = by_pressure[static_cast<Eigen::Index>(i)];
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(at->stiffness, Eigen::EigenvaluesOnly);
  result.negative = static_cast<int>((eigen.eigenvalues().array() < 0).count());
  return result;
}

PlainPath::Step PlainPath::corrected(const ScaledState& start, double pressure_mpa, double allowed,
                                     const Points& count) const {
  Step step{start};
  for (int i = 0; i < 8; ++i) {
    const auto newton = newton_step(step.x, pressure_mpa, count);
    if (!newton || !(size(*newton) <= allowed)) return step;
    for (int j = 0; j < coordinate_count; ++j) step.x[j] += (*newton)[j];
    step.done = size(*newton) <= 1e-7 * allowed + 1e-13 * std::max(1.0, size(step.x));
    if (step.done) return step;
  }
  return step;
}

PlainPath::End PlainPath::follow_to(double pressure_mpa, bool thorough) const {
  const bool bends = section_.bending_axes > 0;
  const End quick = follow_to(pressure_mpa, {bends ? 12 : 20, 8, 24});
  if (quick.arrived || !thorough) return quick;
  return follow_to(pressure_mpa, {36, 16, 72});
}

PlainPath::End PlainPath::follow_to(double pressure_mpa, const Points& count) const {
  End here;
  double step = pressure_mpa;
  int distrust = 0;  // steps in a row that change the number of negative eigenvalues
  // A pressure of the right sign: the quadrature goes by it.
  auto now = rate(here.x, std::copysign(1e-300, pressure_mpa), count);
  for (int steps = 0; steps < most_steps && now; ++steps) {
    const double left = pressure_mpa - here.pressure_mpa;
    if (left == 0) return polished(here);
    const double speed = size(now->by_pressure);
    const double longest = 0.05 * std::max(1.0, size(here.x)) / speed;
    if (std::abs(step) > longest) step = std::copysign(longest, step);
    if (!(std::abs(step) >= shortest * std::abs(pressure_mpa))) return here;
    const double next = std::abs(step) >= std::abs(left) ? pressure_mpa : here.pressure_mpa + step;
    const double length = next - here.pressure_mpa;
    ScaledState start = here.x;
    for (int j = 0; j < coordinate_count; ++j) start[j] += length * now->by_pressure[j];
    const Step tried = corrected(start, next, 0.1 * std::abs(length) * speed, count);
    const auto then = tried.done ? rate(tried.x, next, count) : std::nullopt;
    // A number that changes is a step across a gap to another branch, unless it still changes when
    // steps are short.
    if (!then || (then->negative != now->negative && ++distrust < 10)) {
      step = 0.4 * length;
      continue;
    }
    distrust = 0;
    here.x = tried.x;
    here.pressure_mpa = next;
    now = then;
    step = 1.6 * length;
  }
  return here;
}

/// Moved to the section's own equilibrium, away from a coarse quadrature's.
PlainPath::End PlainPath::polished(End end) const {
  for (int i = 0; i < 6; ++i) {
    const auto newton = newton_step(end.x, end.pressure_mpa, finest);
    if (!newton || size(*newton) > 0.01 * std::max(1.0, size(end.x))) return end;
    for (int j = 0; j < coordinate_count; ++j) end.x[j] += (*newton)[j];
    if (size(*newton) < 1e-12) break;
  }
  end.arrived = true;
  return end;
}

std::optional<double> PlainPath::missing_step(const ScaledState& x, double pressure_mpa) const {
  const auto step = newton_step(x, pressure_mpa, finest);
  if (!step) return std::nullopt;
  double largest = size(*step);
  // What symmetry leaves out must not be pushed at all.
  const auto all = local(section_, points(middling, pressure_mpa), deformation(x), pressure_mpa,
                         free_, scale_, energy_);
  if (!all) return std::nullopt;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const bool stepped = std::find(stepped_.begin(), stepped_.end(), free_[i]) != stepped_.end();
    const auto row = static_cast<Eigen::Index>(i);
    if (!stepped) {
      largest = std::max(largest, std::abs(all->imbalance[row]) /
                                      std::max(1.0, std::abs(all->stiffness(row, row))));
    }
  }
  return largest;
}

std::optional<PlainPath::Stiffness> PlainPath::stiffness(const ScaledState& x,
                                                         double pressure_mpa) const {
  const auto all = local(section_, points(middling, pressure_mpa), deformation(x), pressure_mpa,
                         free_, scale_, energy_);
  const auto some = local(section_, points(finest, pressure_mpa), deformation(x), pressure_mpa,
                          stepped_, scale_, energy_);
  if (!all || !some) return std::nullopt;
  Stiffness result;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(all->stiffness);
  result.smallest = eigen.eigenvalues()[0];
  result.norm = eigen.eigenvalues().cwiseAbs().maxCoeff();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> followed(some->stiffness);
  Eigen::Index nearest = 0;
  followed.eigenvalues().cwiseAbs().minCoeff(&nearest);
  result.nearest_value = followed.eigenvalues()[nearest];
  for (std::size_t i = 0; i < stepped_.size(); ++i) {
    result.push += followed.eigenvectors()(static_cast<Eigen::Index>(i), nearest) *
                   some->push[static_cast<Eigen::Index>(i)];
    result.nearest[stepped_[i]] = followed.eigenvectors()(static_cast<Eigen::Index>(i), nearest);
  }
  return result;
}

std::optional<double> PlainPath::curvature(const ScaledState& x, double pressure_mpa,
                                           const ScaledState& v) const {
  const auto at = local(section_, points(middling, pressure_mpa), deformation(x), pressure_mpa,
                        stepped_, scale_, energy_);
  if (!at) return std::nullopt;
  double sum = 0;
  for (std::size_t i = 0; i < stepped_.size(); ++i) {
    for (std::size_t j = 0; j < stepped_.size(); ++j) {
      sum += v[stepped_[i]] * v[stepped_[j]] *
             at->stiffness(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }
  }
  return sum;
}

}  // namespace latticast
