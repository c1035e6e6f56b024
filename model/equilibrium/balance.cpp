// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/equilibrium/balance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "model/numerics/small_matrix.h"
#include "model/section/section_energy.h"

namespace latticast {
namespace {

constexpr int most_points = 64;
constexpr int first_around = 8;
constexpr int points_in_panel = 14;

/// The next rule in line: what a rule is refined to, and what its error is measured with.
int more_points(int points) {
  return points + std::max(4, points / 2);
}

/// Gauss points for about 1e-12. Everything depends on R through r/R, which has its nearest pole at
/// R = 0; the rule converges like rho^(-2n), rho belonging to the ellipse through that pole.
int points_for(double from, double to) {
  if (!(to > from)) return 1;
  const double pole = (to + from) / (to - from);
  const double rho = pole + std::sqrt(pole * pole - 1);
  const int points = static_cast<int>(std::ceil(0.5 * std::log(1e12) / std::log(rho)));
  return std::clamp(points, 3, most_points / 2);
}

std::array<double, coordinate_count> coordinates(const Deformation& q) {
  return {q.elongation, q.twist, q.inner_growth, q.bend_1, q.bend_2};
}

/// A function that is known to second order about one deformation, at another.
SectionEnergy moved(const SectionEnergy& function, const Deformation& from, const Deformation& to) {
  const auto start = coordinates(from);
  const auto end = coordinates(to);
  SectionEnergy result = function;
  for (std::size_t i = 0; i < coordinate_count; ++i) {
    double slope = 0;
    for (std::size_t j = 0; j < coordinate_count; ++j) {
      slope += function.second(i, j) * (end[j] - start[j]);
    }
    result.gradient[i] += slope;
    result.value += (function.gradient[i] + 0.5 * slope) * (end[i] - start[i]);
  }
  return result;
}

double largest_difference(const BalanceAt::Vector& a, const BalanceAt::Vector& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace

void Balance::sort_coordinates(Held held, bool all_unknowns) {
  // The bore comes last: the branch looks for its closure there.
  constexpr std::array<int, coordinate_count> order = {coordinate::elongation, coordinate::twist,
                                                       coordinate::bend_1, coordinate::bend_2,
                                                       coordinate::inner_growth};
  const std::array<bool, coordinate_count> solved = {true, all_unknowns || section_.twists, true,
                                                     all_unknowns || section_.bending_axes >= 1,
                                                     all_unknowns || section_.bending_axes == 2};
  const std::array<bool, coordinate_count> fixed = {held.stretch, held.twist, false, held.bend,
                                                    held.bend};
  for (const int i : order) {
    if (solved[i]) active_.push_back(i);
    if (solved[i] && !fixed[i]) free_.push_back(i);
    if (!solved[i] && !fixed[i]) suppressed_.push_back(i);
  }
}

Balance::Balance(const Section& section, Held held, const SolverOptions& options,
                 EnergySource source)
    : section_(section), source_(std::move(source)) {
  sort_coordinates(held, options.all_unknowns);
  const double outer = section.outer_radius_mm;
  scale_ = {1, 1 / outer, section.inner_radius_mm, 1 / outer, 1 / outer};
  const double rubber_area = std::numbers::pi *
                             (section.isotropic_to_mm - section.isotropic_from_mm) *
                             (section.isotropic_to_mm + section.isotropic_from_mm);
  energy_ = section.shear_modulus_mpa * rubber_area;

  points_fixed_ = options.fixed_quadrature > 0 || has_source();
  if (options.fixed_quadrature > 0) {
    const int points = options.fixed_quadrature;
    set_points(points, points, std::max(points, 4));
  } else {
    set_points(points_for(section.isotropic_from_mm, section.isotropic_to_mm),
               points_for(section.anisotropic_from_mm, section.anisotropic_to_mm), first_around);
  }

  const int n = free_count();
  if (!anchor_at(BranchPoint{})) throw std::runtime_error("a segment cannot be solved at rest");
  BalanceAt rest = *at(BranchPoint{});
  const std::span<double> speed = std::span(rest.load_vector).first(n);
  solve_in_place(std::span(rest.tangent_stiffness).first(entry_count(n)), speed);
  pressure_mpa_ = 1 / norm(speed);
}

std::optional<BalanceAt> Balance::at(std::span<const double> x) const {
  if (has_source()) return balanced(x, corrected_energy(deformation(x)));
  return evaluate(x, quadrature_);
}

std::optional<BalanceAt> Balance::finer_at(std::span<const double> x) const {
  if (!has_source()) return evaluate(x, finer_);
  const Deformation q = deformation(x);
  auto energy = corrected_energy(q);
  if (energy) *energy += moved(anchor_->doubt, anchor_->at, q);
  return balanced(x, energy);
}

std::optional<SectionEnergy> Balance::corrected_energy(const Deformation& q) const {
  auto energy = stored_energy(section_, quadrature_, q, active_);
  if (energy) *energy += moved(anchor_->missing, anchor_->at, q);
  return energy;
}

bool Balance::anchor_at(std::span<const double> x) {
  if (!has_source()) return true;
  const Deformation q = deformation(x);
  const auto source = source_(q);
  const auto own = stored_energy(section_, quadrature_, q, active_);
  if (!source || !own) return false;
  SectionEnergy missing = source->energy;
  missing -= *own;
  anchor_ = std::make_shared<const EnergyAnchor>(EnergyAnchor{q, missing, source->doubt});
  return true;
}

double Balance::distance_from(const EnergyAnchor& anchor, std::span<const double> x) const {
  const auto from = coordinates(anchor.at);
  const auto to = coordinates(deformation(x));
  double sum = 0;
  for (std::size_t i = 0; i < coordinate_count; ++i) sum += square((to[i] - from[i]) / scale_[i]);
  return std::sqrt(sum);
}

bool Balance::refine(std::span<const double> x) {
  const int panels = points_fixed_ ? 1 : bore_panels_for(section_, deformation(x));
  if (panels > panels_) {
    // One more, so that the next steps of a closing bore find theirs.
    panels_ = panels + 1;
    set_points(points_in_panel, std::max(points_in_panel, lattice_points_), around_);
    return true;
  }
  if (points_fixed_ || std::max({liner_points_, lattice_points_, around_}) >= most_points) {
    return false;
  }
  const auto more = [](int points) { return std::min(more_points(points), most_points); };
  const auto now = at(x);
  const auto radial = evaluate(x, quadrature(more(liner_points_), more(lattice_points_), around_));
  const auto angular = evaluate(x, quadrature(liner_points_, lattice_points_, more(around_)));
  double in_radius = 1;
  double around = 1;
  if (now && radial && angular) {
    in_radius = largest_difference(now->residual, radial->residual);
    around = largest_difference(now->residual, angular->residual);
  }
  // Work goes with the product of both counts: what contributes little stays as it is.
  const bool refine_radius = in_radius >= 0.1 * around;
  const bool refine_around = around >= 0.1 * in_radius;
  set_points(refine_radius ? more(liner_points_) : liner_points_,
             refine_radius ? more(lattice_points_) : lattice_points_,
             refine_around ? more(around_) : around_);
  return true;
}

Quadrature Balance::quadrature(int liner, int lattice, int around) const {
  const bool bends_any_way =
      std::find(active_.begin(), active_.end(), coordinate::bend_2) != active_.end();
  // As fine on a whole turn as `around` intervals on its half.
  Quadrature result =
      make_quadrature(section_, liner, lattice, bends_any_way ? 2 * around : 1, panels_);
  if (!bends_any_way) result.around = half_turn(around);
  return result;
}

void Balance::set_points(int liner, int lattice, int around) {
  liner_points_ = liner;
  lattice_points_ = lattice;
  around_ = around;
  quadrature_ = quadrature(liner, lattice, around);
  finer_ = quadrature(more_points(liner), more_points(lattice), more_points(around));
  for_suppressed_ = quadrature_;
  if (section_.bending_axes > 0) return;
  // Around a straight section second derivatives go with cos^2, whose mean one direction at 45
  // degrees already has; two lesser ones keep directions apart where they differ.
  if (section_.isotropic) {
    for_suppressed_.around = {{std::sqrt(0.5), std::sqrt(0.5), 1}};
    for_suppressed_.average_strands = true;
  } else {
    for_suppressed_.around = half_turn(2);
  }
}

Deformation Balance::deformation(std::span<const double> x) const {
  std::array<double, coordinate_count> q{};
  for (std::size_t i = 0; i < free_.size(); ++i) q[free_[i]] = x[i] * scale_[free_[i]];
  return {q[0], q[1], q[2], q[3], q[4]};
}

std::optional<BalanceAt> Balance::evaluate(std::span<const double> x,
                                           const Quadrature& quadrature) const {
  return balanced(x, stored_energy(section_, quadrature, deformation(x), active_));
}

std::optional<BalanceAt> Balance::balanced(std::span<const double> x,
                                           const std::optional<SectionEnergy>& stored) const {
  if (!stored) return std::nullopt;
  const Deformation q = deformation(x);
  const SectionEnergy cavity = cavity_growth(section_, q);
  const double pressure = pressure_mpa(x);

  BalanceAt result;
  for (int i = 0; i < coordinate_count; ++i) {
    result.reaction[i] = stored->gradient[i] - pressure * cavity.gradient[i];
  }
  const std::size_t n = free_.size();
  for (std::size_t column = 0; column < n; ++column) {
    const int j = free_[column];
    const double scale_j = scale_[j] / energy_;
    result.residual[column] = result.reaction[j] * scale_j;
    result.load_vector[column] = cavity.gradient[j] * scale_j * pressure_mpa_;
    for (std::size_t row = 0; row < n; ++row) {
      const int i = free_[row];
      const double scale = scale_[i] * scale_j;
      const double cavity_second = cavity.second(i, j);
      result.tangent_stiffness[column * n + row] =
          (stored->second(i, j) - pressure * cavity_second) * scale;
      result.load_stiffness[column * n + row] = cavity_second * scale * pressure_mpa_;
    }
  }
  return result;
}

BalanceAt::Vector Balance::doubt(std::span<const double> x, const BalanceAt& at) const {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  const std::size_t n = free_.size();
  double load = 0;
  for (std::size_t i = 0; i < n; ++i) load = std::max(load, std::abs(at.load_vector[i] * x[n]));
  const std::array<double, coordinate_count> law = law_error(section_, quadrature_, deformation(x));
  BalanceAt::Vector doubt{};
  for (std::size_t i = 0; i < n; ++i) {
    doubt[i] = law[free_[i]] * scale_[free_[i]] / energy_ + rounding * load;
  }
  return doubt;
}

SuppressedModes Balance::suppressed_modes(std::span<const double> x) const {
  SuppressedModes result;
  if (suppressed_.empty()) return result;
  std::vector<int> asked = suppressed_;
  // One direction stands for both where they are alike.
  const bool alike =
      section_.isotropic && section_.bending_axes == 0 && asked.back() == coordinate::bend_2;
  if (alike) asked.pop_back();
  const auto stored = stored_energy(section_, for_suppressed_, deformation(x), asked);
  if (!stored) return result;
  const std::size_t n = asked.size();
  BalanceAt::Matrix stiffness{};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      // The cavity does not grow by twisting or bending: pressure has no part in this.
      if (i != j && alike) continue;
      stiffness[j * n + i] =
          stored->second(asked[i], asked[j]) * scale_[asked[i]] * scale_[asked[j]] / energy_;
    }
  }
  if (alike) result.eigenvalues[n] = stiffness[n * n - 1];
  symmetric_eigenvalues(std::span(stiffness).first(n * n), std::span(result.eigenvalues).first(n));
  result.count = static_cast<int>(alike ? n + 1 : n);
  return result;
}

}  // namespace latticast
