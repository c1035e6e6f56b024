// SPDX-License-Identifier: GPL-3.0-or-later
// The balance of forces of one section, in scaled form, for whoever solves it (MODEL.md section 1).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "model/response.h"
#include "model/section.h"

namespace latticast {

/// A point of the (state, pressure) space: the n free coordinates in scaled form, then the scaled
/// pressure; entries past n + 1 are unused.
using BranchPoint = std::array<double, 4>;

/// The balance at one point; n free coordinates, n x n matrices column after column.
struct BalanceAt {
  std::array<double, 3> imbalance{};  ///< scaled dPi/dq over the free coordinates; 0 in equilibrium
  std::array<double, 9> stiffness{};  ///< scaled d2Pi/dq2
  std::array<double, 3> push{};       ///< scaled dV/dq: what one unit of pressure adds
  std::array<double, 9> push_slope{};  ///< its derivative
  std::array<double, 3> reaction{};    ///< dPi/dq of all three coordinates: N, N mm, N/mm
};

/// Scaled coordinates are (lambda - 1, k R_o, a/R_i - 1); energies are in units of G A (liner shear
/// modulus at rest times rubber cross-section). The pressure unit is the one that moves the rest
/// state at unit speed in these coordinates, so that pressure and state weigh alike along the
/// branch.
class Balance {
 public:
  /// `quadrature_points` per integral; 0: enough for the rest geometry's nearest singularity.
  Balance(const Section& section, Held held, int quadrature_points);

  int free_count() const { return static_cast<int>(free_.size()); }

  /// Empty where the state cannot exist. `x` holds n + 1 numbers.
  std::optional<BalanceAt> at(std::span<const double> x) const;

  /// The same under the finer quadrature that errors are measured with.
  std::optional<BalanceAt> finer_at(std::span<const double> x) const;

  /// Takes more quadrature points; false when there are as many as there may be.
  bool refine();

  Deformation deformation(std::span<const double> x) const;
  double pressure_mpa(std::span<const double> x) const { return x[free_.size()] * pressure_mpa_; }
  double scaled_pressure(double pressure_mpa) const { return pressure_mpa / pressure_mpa_; }

  /// G A in N, the unit of scaled energies.
  double energy_unit() const { return energy_; }
  const Section& section() const { return section_; }

 private:
  std::optional<BalanceAt> evaluate(std::span<const double> x, const Quadrature& quadrature) const;
  void set_points(int liner, int lattice);

  Section section_;
  std::vector<int> free_;  // indices of the free coordinates among (elongation, twist, growth)
  std::array<double, 3> scale_;  // of all three coordinates
  double energy_ = 1;
  double pressure_mpa_ = 1;
  bool points_fixed_ = false;
  int liner_points_ = 0;
  int lattice_points_ = 0;
  Quadrature quadrature_;
  Quadrature finer_;
};

}  // namespace latticast
