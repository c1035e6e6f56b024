// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibrium equations of one section in scaled form: residual, tangent stiffness, load vector
// (docs/model.md#how-it-is-solved-and-how-good-a-state-is).
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/equilibrium/response.h"
#include "model/section/quadrature.h"
#include "model/section/section_energy.h"

namespace latticast {

/// A point of the (state, pressure) space: the n free coordinates in scaled form, then the scaled
/// pressure; entries past n + 1 are unused.
using BranchPoint = std::array<double, coordinate_count + 1>;

/// Residual, loads and their derivatives at one point; n free coordinates, n x n matrices column
/// after column.
struct BalanceAt {
  using Vector = std::array<double, coordinate_count>;
  using Matrix = std::array<double, std::size_t{coordinate_count} * coordinate_count>;
  Vector residual{};           ///< scaled dPi/dq over the free coordinates; 0 in equilibrium
  Matrix tangent_stiffness{};  ///< scaled d2Pi/dq2
  Vector load_vector{};        ///< scaled dV/dq: the load of one unit of pressure
  Matrix load_stiffness{};     ///< its derivative
  Vector reaction{};           ///< dPi/dq of all coordinates: N, N mm, N/mm, N mm, N mm
};

/// Eigenvalues of the coordinates that symmetry keeps at zero, see Balance::suppressed_modes.
struct SuppressedModes {
  std::array<double, coordinate_count> eigenvalues{};  ///< of the scaled stiffness
  int count = 0;
};

/// An energy that is dear, such as a unit cell's, and how far it may be off.
struct SourceEnergy {
  SectionEnergy energy;
  SectionEnergy doubt;
};

/// What a section's energy lacks against a source's, known to second order about one deformation.
struct EnergyAnchor {
  Deformation at;
  SectionEnergy missing;
  SectionEnergy doubt;  ///< of the source's energy
};

/// What may take the place of the section's own energy. Empty: nothing.
using EnergySource = std::function<std::optional<SourceEnergy>(const Deformation&)>;

/// Scaled coordinates are (lambda - 1, k R_o, kappa R_o, a/R_i - 1), the bore last; energies are in
/// units of G A (liner shear modulus at rest times rubber cross-section). The pressure unit is the
/// one that moves the rest state at unit speed in these coordinates, so that pressure and state
/// weigh alike along the branch.
/// Coordinates that the section's symmetry keeps at zero are not solved for; their stiffness, which
/// is not coupled to that of the others, is still asked for stability.
class Balance {
 public:
  Balance(const Section& section, Held held, const SolverOptions& options,
          EnergySource source = {});

  /// Whether its energy is not the section's own. It is the section's then, and what that lacks
  /// against the source, to second order from where the source was asked last.
  bool has_source() const { return static_cast<bool>(source_); }

  /// Asks the source for the state at `x`, so that the energy is the source's near it. False where
  /// the source has none; nothing has changed then. Without a source there is nothing to do.
  bool anchor_at(std::span<const double> x);

  /// Where the source was asked last; null without a source.
  const std::shared_ptr<const EnergyAnchor>& anchor() const { return anchor_; }
  void return_to(std::shared_ptr<const EnergyAnchor> anchor) { anchor_ = std::move(anchor); }

  /// Distance from an anchor in scaled coordinates.
  double distance_from(const EnergyAnchor& anchor, std::span<const double> x) const;

  int free_count() const { return static_cast<int>(free_.size()); }

  /// Empty where the state cannot exist. `x` holds n + 1 numbers.
  std::optional<BalanceAt> at(std::span<const double> x) const;

  /// The same under the finer quadrature that errors are measured with.
  std::optional<BalanceAt> finer_at(std::span<const double> x) const;

  /// How far the residual may be off for other reasons than its quadrature: interpolated horseshoe
  /// laws, and rounding of forces as large as the pressure's. Scaled as the residual is.
  BalanceAt::Vector doubt(std::span<const double> x, const BalanceAt& at) const;

  /// Stiffness against the free coordinates that symmetry keeps at zero: buckling in twist and
  /// sideways. Precondition: `at(x)` is not empty.
  SuppressedModes suppressed_modes(std::span<const double> x) const;

  /// Takes more quadrature points, in R or around the tube or both, wherever the residual at `x`
  /// is not yet good, and panels toward a bore that is nearly closed; false when there are as many
  /// as there may be.
  bool refine(std::span<const double> x);

  Deformation deformation(std::span<const double> x) const;
  double pressure_mpa(std::span<const double> x) const { return x[free_.size()] * pressure_mpa_; }
  double scaled_pressure(double pressure_mpa) const { return pressure_mpa / pressure_mpa_; }

  /// Free coordinates by their numbers in `coordinate`, in the order of x.
  const std::vector<int>& free_coordinates() const { return free_; }

  /// G A in N, the unit of scaled energies.
  double energy_unit() const { return energy_; }
  const Section& section() const { return section_; }

 private:
  std::optional<BalanceAt> evaluate(std::span<const double> x, const Quadrature& quadrature) const;
  std::optional<SectionEnergy> corrected_energy(const Deformation& q) const;
  std::optional<BalanceAt> balanced(std::span<const double> x,
                                    const std::optional<SectionEnergy>& stored) const;
  Quadrature quadrature(int liner, int lattice, int around) const;
  void set_points(int liner, int lattice, int around);
  void sort_coordinates(Held held, bool all_unknowns);

  Section section_;
  EnergySource source_;
  std::shared_ptr<const EnergyAnchor> anchor_;
  std::vector<int> active_;  // coordinates with a derivative: free ones, and held ones that react
  std::vector<int> free_;    // solved for
  std::vector<int> suppressed_;  // free, but zero by symmetry
  std::array<double, coordinate_count> scale_{};
  double energy_ = 1;
  double pressure_mpa_ = 1;
  bool points_fixed_ = false;
  int liner_points_ = 0;
  int lattice_points_ = 0;
  int around_ = 0;  // directions, or intervals on half a turn
  int panels_ = 1;  // toward the bore
  Quadrature quadrature_;
  Quadrature finer_;
  Quadrature for_suppressed_;
};

}  // namespace latticast
