// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibria of a section by plain load stepping: pressure up a little, Newton's method, again.
// Slow and simple, a second opinion on the branch that `predict` follows.
#pragma once

#include <array>
#include <optional>

#include "model/equilibrium/state.h"
#include "model/section/quadrature.h"

namespace latticast {

/// Coordinates scaled as in State: elongation, twist R_o, growth/R_i, bending R_o.
using ScaledState = std::array<double, coordinate_count>;

class PlainPath {
 public:
  /// Stepped in the coordinates that the section's symmetry leaves; that the others are not pushed
  /// is for missing_step to see.
  PlainPath(const Section& section, Held held);

  struct End {
    bool arrived = false;
    double pressure_mpa = 0;  ///< asked for, or the last before the steps became too short
    ScaledState x{};
  };

  /// From rest to a pressure; `thorough`: where a coarse quadrature does not arrive, a finer one
  /// tries.
  End follow_to(double pressure_mpa, bool thorough = true) const;

  /// Newton step that a state lacks under a quadrature finer than any that `predict` takes, in the
  /// stepped coordinates; the gradient of a coordinate that is not stepped must be zero and counts
  /// with its own stiffness. Empty where the state cannot exist.
  std::optional<double> missing_step(const ScaledState& x, double pressure_mpa) const;

  /// Of the stiffness of all five coordinates but held ones, over G A.
  struct Stiffness {
    double smallest = 0;
    double norm = 0;
    ScaledState nearest{};  ///< direction of the eigenvalue nearest to zero, of the stepped ones
    double nearest_value = 0;
    double push = 0;  ///< of the pressure along that direction
  };
  std::optional<Stiffness> stiffness(const ScaledState& x, double pressure_mpa) const;

  /// v.H v in the stepped coordinates, the quadrature as in `stiffness`.
  std::optional<double> curvature(const ScaledState& x, double pressure_mpa,
                                  const ScaledState& v) const;

  ScaledState scaled(const State& state) const;

 private:
  struct Points {
    int radial;
    int lattice;
    int around;
  };
  struct Step {
    ScaledState x{};
    bool done = false;
  };
  Deformation deformation(const ScaledState& x) const;
  std::optional<ScaledState> newton_step(const ScaledState& x, double pressure_mpa,
                                         const Points& count) const;
  struct Rate {
    ScaledState by_pressure{};
    int negative = 0;  ///< eigenvalues of the stepped stiffness
  };
  std::optional<Rate> rate(const ScaledState& x, double pressure_mpa, const Points& count) const;
  Step corrected(const ScaledState& start, double pressure_mpa, double allowed,
                 const Points& count) const;

  Section section_;
  std::vector<int> free_;     // of all five, those not held
  std::vector<int> stepped_;  // of these, those followed
  ScaledState scale_{};
  double energy_ = 1;
  static const Points finest;
  static const Points middling;
  bool is_singular(double pressure_mpa) const;
  End polished(End end) const;
  Quadrature points(const Points& count, double pressure_mpa) const;
  End follow_to(double pressure_mpa, const Points& count) const;
};

}  // namespace latticast
