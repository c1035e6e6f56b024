// SPDX-License-Identifier: GPL-3.0-or-later
// Force and energy of a circular arc by its strain as one piecewise polynomial, free of units.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <vector>

#include "model/horseshoe/arc_integrals.h"

namespace latticast {

/// Strains of the ends of an arc: chord / rest chord - 1.
struct StrainRange {
  double lowest = 0;
  double highest = 0;
};

/// How good a law is.
struct ArcLawAccuracy {
  double force_error = 0;  ///< largest relative error of the force at check points between nodes
  double slope_error = 0;  ///< the same for the force's derivative by strain
  double invariant_defect = 0;  ///< largest over all stored and check points, see ArcQuadrature
  int stored_points = 0;
  int check_points = 0;
};

/// No law within the accuracy could be made over the whole range.
struct ArcNotSolved : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// beta(strain) on the branch from rest. On each piece beta/strain is a polynomial of degree 15
/// through solved equilibria at Chebyshev points; the pieces are as long as that keeps within
/// `tolerance`. Immutable: any number of threads may read it.
class ArcLaw {
 public:
  /// Bound on the relative error of the force, at rest and everywhere.
  static constexpr double tolerance = 1e-9;

  /// One polynomial, its integral and its derivative: they belong together to within rounding.
  struct State {
    double energy = 0;  ///< integral of beta by strain, from 0
    double force = 0;   ///< beta
    double slope = 0;   ///< d beta / d strain
    double error = 0;   ///< of beta, relative: the largest at this polynomial's check points
  };

  /// Precondition: 0 < half angle < pi, compliance > 0, range holds 0 and is finite.
  /// Throws ArcNotSolved.
  ArcLaw(const Arc& arc, const StrainRange& range);

  /// Empty outside of the range and for a strain that is not a number.
  std::optional<State> at(double strain) const;

  const StrainRange& range() const { return range_; }
  const ArcLawAccuracy& accuracy() const { return accuracy_; }

  /// Where two polynomials meet, ascending, and both ends of the range. Energy and force are
  /// continuous there, the slope to within its error.
  const std::vector<double>& breaks() const { return breaks_; }

 private:
  class Builder;
  static constexpr int terms = 16;
  using Series = std::array<double, terms>;  // of Chebyshev polynomials on a piece

  // With s = strain - origin: energy = origin_energy + s (origin_force + s curvature).
  struct Piece {
    double middle = 0;
    double half_length = 0;
    double origin = 0;  // the piece's end nearer to 0
    double origin_energy = 0;
    double origin_force = 0;
    double error = 0;    // relative, of the force
    Series stiffness{};  // beta/strain
    Series curvature{};  // the energy's second divided difference
  };

  static State evaluate(const Piece& piece, double strain);

  StrainRange range_;
  ArcLawAccuracy accuracy_;
  std::vector<double> breaks_;
  std::vector<Piece> pieces_;
};

}  // namespace latticast
