// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/law/force_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "model/numerics/gauss.h"

namespace latticast {
namespace {

constexpr std::size_t terms = ForceTable::terms;

struct ValueAndSlope {
  double value;
  double slope;
};

// Clenshaw's recurrence, and its derivative.
ValueAndSlope sum_series(const ForceTable::Series& series, double x) {
  double value = 0;
  double value_before = 0;
  double slope = 0;
  double slope_before = 0;
  for (std::size_t k = terms - 1; k > 0; --k) {
    const double next_slope = 2 * (value + x * slope) - slope_before;
    slope_before = slope;
    slope = next_slope;
    const double next = series[k] + 2 * x * value - value_before;
    value_before = value;
    value = next;
  }
  return {series[0] + x * value - value_before, value + x * slope - slope_before};
}

}  // namespace

double chebyshev_point(std::size_t i) {
  return -std::cos(std::numbers::pi * static_cast<double>(i) / (terms - 1));
}

ForceTable::Series series_through(const ForceTable::Series& values) {
  ForceTable::Series series{};
  for (std::size_t k = 0; k < terms; ++k) {
    for (std::size_t i = 0; i < terms; ++i) {
      // T_k at point i, with the angle reduced to keep its accuracy.
      const auto turns = static_cast<double>((k * (terms - 1 - i)) % (2 * (terms - 1)));
      const double end = i == 0 || i == terms - 1 ? 0.5 : 1;
      series[k] += end * values[i] * std::cos(std::numbers::pi * turns / (terms - 1));
    }
    series[k] *= (k == 0 || k == terms - 1 ? 1.0 : 2.0) / (terms - 1);
  }
  return series;
}

// The energy's second divided difference is the mean of the slope with weight 1 - t, t from the
// origin (0) to the strain (1): a polynomial, and positive where the slope is. In this form the
// energy keeps its relative accuracy near rest, where a difference of energies would lose it.
void integrate(ForceTable::Piece& piece) {
  static const GaussRule rule = gauss_legendre(terms / 2 + 1);
  ForceTable::Series values{};
  for (std::size_t i = 0; i < terms; ++i) {
    const double s = piece.middle + piece.half_length * chebyshev_point(i) - piece.origin;
    for (std::size_t j = 0; j < rule.points.size(); ++j) {
      const double t = (1 + rule.points[j]) / 2;
      const double slope = ForceTable::evaluate(piece, piece.origin + t * s).slope;
      values[i] += rule.weights[j] / 2 * (1 - t) * slope;
    }
  }
  piece.curvature = series_through(values);
}

ForceTable::ForceTable(const StrainRange& range, std::vector<Piece> pieces,
                       const TableAccuracy& accuracy)
    : range_(range), accuracy_(accuracy), pieces_(std::move(pieces)) {
  breaks_.push_back(range.lowest);
  for (const Piece& piece : pieces_) {
    if (piece.origin > range.lowest) breaks_.push_back(piece.origin);
  }
  breaks_.push_back(range.highest);
  std::sort(breaks_.begin(), breaks_.end());
  breaks_.erase(std::unique(breaks_.begin(), breaks_.end()), breaks_.end());
}

ForceTable::State ForceTable::evaluate(const Piece& piece, double strain) {
  const double x = (strain - piece.middle) / piece.half_length;
  const double s = strain - piece.origin;
  const ValueAndSlope stiffness = sum_series(piece.stiffness, x);
  const double curvature = sum_series(piece.curvature, x).value;
  return {piece.origin_energy + s * (piece.origin_force + s * curvature), strain * stiffness.value,
          stiffness.value + strain * stiffness.slope / piece.half_length, piece.error};
}

std::optional<ForceTable::State> ForceTable::at(double strain) const {
  if (!(strain >= range_.lowest && strain <= range_.highest)) return {};
  const auto above = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, strain);
  return evaluate(pieces_[above - breaks_.begin() - 1], strain);
}

}  // namespace latticast
