// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/equilibrium/branch_state.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/numerics/small_matrix.h"

namespace latticast {
namespace {

constexpr int most_corrector_iterations = 12;

/// Room for the free coordinates and the load.
using BorderedMatrix = std::array<double, entry_count(coordinate_count + 1)>;
static_assert(coordinate_count + 1 <= largest_matrix);

/// Derivatives of the residual by coordinates and load, closed by a plane's normal: regular also
/// where the stiffness alone is singular.
void fill_bordered(std::span<double> matrix, const BalanceAt& balance, const BranchPoint& normal,
                   int n) {
  for (int j = 0; j < n; ++j) {
    std::copy_n(&balance.tangent_stiffness[entry_at(0, j, n)], n, &matrix[entry_at(0, j, n + 1)]);
    matrix[entry_at(j, n, n + 1)] = -balance.load_vector[j];
  }
  for (int j = 0; j <= n; ++j) matrix[entry_at(n, j, n + 1)] = normal[j];
}

void solve_bordered(const BalanceAt& balance, const BranchPoint& normal, BranchPoint& right,
                    int n) {
  BorderedMatrix matrix;
  fill_bordered(matrix, balance, normal, n);
  solve_in_place(std::span(matrix).first(entry_count(n + 1)), std::span(right).first(n + 1));
}

/// The direction in which the residual stays zero, on the side of `guide`.
BranchPoint tangent_at(const BalanceAt& balance, const BranchPoint& guide, int n) {
  BranchPoint tangent{};
  tangent[n] = 1;
  solve_bordered(balance, guide, tangent, n);
  const double length = norm(tangent);
  for (double& entry : tangent) entry /= length;
  return tangent;
}

void count_eigenvalue(BranchState& state, double value) {
  state.smallest_eigenvalue = std::min(state.smallest_eigenvalue, value);
  if (std::abs(value) < std::abs(state.nearest_eigenvalue)) state.nearest_eigenvalue = value;
  if (value < 0) ++state.negative_eigenvalues;
}

void examine_stability(const EquilibriumEquations& equations, BranchState& state) {
  const int n = equations.size;
  BalanceAt::Matrix stiffness = state.balance.tangent_stiffness;
  BalanceAt::Vector values{};
  symmetric_eigenvalues(std::span(stiffness).first(entry_count(n)), std::span(values).first(n));
  state.smallest_eigenvalue = state.nearest_eigenvalue = values[0];
  for (int i = 0; i < n; ++i) count_eigenvalue(state, values[i]);
  state.nearest_solved_eigenvalue = state.nearest_eigenvalue;
  const SuppressedModes suppressed = equations.suppressed_modes(state.x);
  for (int i = 0; i < suppressed.count; ++i) count_eigenvalue(state, suppressed.eigenvalues[i]);
}

}  // namespace

EquilibriumEquations equations_of(const Balance& balance) {
  return {.size = balance.free_count(),
          .at = [&balance](std::span<const double> x) { return balance.at(x); },
          .finer_at = [&balance](std::span<const double> x) { return balance.finer_at(x); },
          .suppressed_modes =
              [&balance](std::span<const double> x) { return balance.suppressed_modes(x); }};
}

BranchState examined(const EquilibriumEquations& equations, const BranchPoint& x,
                     const BalanceAt& balance, const BranchPoint& guide) {
  BranchState state;
  state.x = x;
  state.balance = balance;
  examine_stability(equations, state);
  state.tangent = tangent_at(balance, guide, equations.size);
  return state;
}

std::optional<BranchState> corrected(const EquilibriumEquations& equations, NewtonSolver& newton,
                                     const BranchPoint& start, const BranchPoint& normal,
                                     const BranchPoint& guide) {
  const int n = equations.size;
  BalanceAt last;
  const auto system = [&](std::span<const double> x, std::span<double> residual,
                          std::span<double> jacobian) {
    const auto at = equations.at(x);
    if (!at) return false;
    last = *at;
    fill_bordered(jacobian, *at, normal, n);
    std::copy_n(at->residual.begin(), n, residual.begin());
    residual[n] = 0;
    for (int i = 0; i <= n; ++i) residual[n] += normal[i] * (x[i] - start[i]);
    return true;
  };
  BranchPoint x = start;
  if (!newton.solve(std::span(x).first(n + 1), system, most_corrector_iterations)) {
    return std::nullopt;
  }
  return examined(equations, x, last, guide);
}

BranchPoint correction(const BalanceAt& balance, const BalanceAt::Vector& residual,
                       const BranchPoint& normal, int size) {
  BranchPoint change{};
  std::copy_n(residual.begin(), size, change.begin());
  solve_bordered(balance, normal, change, size);
  return change;
}

double dot(const BranchPoint& a, const BranchPoint& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

double distance(const BranchPoint& a, const BranchPoint& b) {
  BranchPoint apart{};
  for (std::size_t i = 0; i < a.size(); ++i) apart[i] = a[i] - b[i];
  return norm(apart);
}

BranchPoint between(const BranchPoint& a, const BranchPoint& b, double fraction) {
  BranchPoint x{};
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = a[i] + fraction * (b[i] - a[i]);
  return x;
}

BranchPoint at_load(BranchPoint x, double load, int size) {
  x[size] = load;
  return x;
}

BranchPoint load_axis(int size) {
  return at_load({}, 1, size);
}

double movement(const BranchPoint& a, const BranchPoint& b, int size) {
  return distance(at_load(a, 0, size), at_load(b, 0, size));
}

double largest_growth(const BranchPoint& x, int size) {
  double growth = 0;
  for (int i = 0; i < size; ++i) growth = std::max(growth, std::abs(x[i]));
  return growth;
}

}  // namespace latticast
