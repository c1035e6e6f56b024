// SPDX-License-Identifier: GPL-3.0-or-later
// Piecewise Chebyshev interpolant of a link's force against its strain, with its integral and
// derivative, free of units (docs/horseshoe.md#the-law-as-stored). force_table_builder.h makes it.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <vector>

namespace latticast {

/// Strains of the ends of a link: chord / rest chord - 1.
struct StrainRange {
  double lowest = 0;
  double highest = 0;
};

/// How good a table is.
struct TableAccuracy {
  double force_error = 0;  ///< largest relative error of the force at check points between nodes
  double slope_error = 0;  ///< the same for the force's derivative by strain
  double defect = 0;       ///< largest of all stored and check points' own (see the path's solver)
  int stored_points = 0;
  int check_points = 0;
};

/// No law within the accuracy could be made over the whole range.
struct LawNotSolved : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The force on the branch from rest. On each piece force/strain is a polynomial of degree 15
/// through solved equilibria at Chebyshev points; the pieces are as long as that keeps within
/// `tolerance`. Immutable: any number of threads may read it.
class ForceTable {
 public:
  /// Bound on the relative error of the force, at rest and everywhere.
  static constexpr double tolerance = 1e-9;

  /// One polynomial, its integral and its derivative: they belong together to within rounding.
  struct State {
    double energy = 0;  ///< integral of the force by strain, from 0
    double force = 0;
    double slope = 0;  ///< d force / d strain
    double error = 0;  ///< of the force, relative: the largest at this polynomial's check points
  };

  static constexpr int terms = 16;
  using Series = std::array<double, terms>;  ///< of Chebyshev polynomials on a piece

  /// With s = strain - origin: energy = origin_energy + s (origin_force + s curvature).
  struct Piece {
    double middle = 0;
    double half_length = 0;
    double origin = 0;  ///< the piece's end nearer to 0
    double origin_energy = 0;
    double origin_force = 0;
    double error = 0;    ///< relative, of the force
    Series stiffness{};  ///< force/strain
    Series curvature{};  ///< the energy's second divided difference
  };

  /// Precondition: the pieces follow each other and cover the range, in ascending order.
  ForceTable(const StrainRange& range, std::vector<Piece> pieces, const TableAccuracy& accuracy);

  /// Empty outside of the range and for a strain that is not a number.
  std::optional<State> at(double strain) const;

  const StrainRange& range() const { return range_; }
  const TableAccuracy& accuracy() const { return accuracy_; }

  /// Where two polynomials meet, ascending, and both ends of the range. Energy and force are
  /// continuous there, the slope to within its error.
  const std::vector<double>& breaks() const { return breaks_; }

  static State evaluate(const Piece& piece, double strain);

 private:
  StrainRange range_;
  TableAccuracy accuracy_;
  std::vector<double> breaks_;
  std::vector<Piece> pieces_;
};

/// Chebyshev point number i of a series, from -1 to 1.
double chebyshev_point(std::size_t i);

/// The polynomial through values at the Chebyshev points.
ForceTable::Series series_through(const ForceTable::Series& values);

/// Computes a piece's curvature from its stiffness.
void integrate(ForceTable::Piece& piece);

}  // namespace latticast
