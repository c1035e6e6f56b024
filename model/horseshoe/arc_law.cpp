// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/horseshoe/arc_law.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>

#include "model/horseshoe/arc_equilibrium.h"
#include "model/numerics/gauss.h"

namespace latticast {
namespace {

// Of beta/strain, relative: size of the last terms of a series that is good enough.
constexpr double tail_goal = 2e-10;

constexpr int most_pieces = 2000;
constexpr int most_attempts = 60;  // at one piece, each shorter than the one before

struct ValueAndSlope {
  double value;
  double slope;
};

// Clenshaw's recurrence, and its derivative.
template <std::size_t N>
ValueAndSlope sum_series(const std::array<double, N>& series, double x) {
  double value = 0;
  double value_before = 0;
  double slope = 0;
  double slope_before = 0;
  for (std::size_t k = N - 1; k > 0; --k) {
    const double next_slope = 2 * (value + x * slope) - slope_before;
    slope_before = slope;
    slope = next_slope;
    const double next = series[k] + 2 * x * value - value_before;
    value_before = value;
    value = next;
  }
  return {series[0] + x * value - value_before, value + x * slope - slope_before};
}

// Chebyshev point number i of N, from -1 to 1.
template <std::size_t N>
double chebyshev_point(std::size_t i) {
  return -std::cos(std::numbers::pi * static_cast<double>(i) / (N - 1));
}

// The polynomial through values at the Chebyshev points.
template <std::size_t N>
std::array<double, N> series_through(const std::array<double, N>& values) {
  std::array<double, N> series{};
  for (std::size_t k = 0; k < N; ++k) {
    for (std::size_t i = 0; i < N; ++i) {
      // T_k at point i, with the angle reduced to keep its accuracy.
      const auto turns = static_cast<double>((k * (N - 1 - i)) % (2 * (N - 1)));
      const double end = i == 0 || i == N - 1 ? 0.5 : 1;
      series[k] += end * values[i] * std::cos(std::numbers::pi * turns / (N - 1));
    }
    series[k] *= (k == 0 || k == N - 1 ? 1.0 : 2.0) / (N - 1);
  }
  return series;
}

}  // namespace

// Makes the pieces one after the other, from rest outwards.
class ArcLaw::Builder {
 public:
  explicit Builder(const Arc& arc) : solver_(arc), rule_(gauss_legendre(terms / 2 + 1)) {}

  // Pieces from 0 to `end`.
  std::vector<Piece> pieces_to(double end);

  const ArcLawAccuracy& accuracy() const { return accuracy_; }

 private:
  struct Draft {
    Piece piece;
    std::array<ArcEquilibrium, terms> nodes;  // from the origin outwards
    double tail = 0;                          // of the series, relative
  };

  std::optional<Draft> draft(const ArcEquilibrium& from, const State& origin, double end) const;
  void integrate(Piece& piece) const;
  bool passes(Draft& draft);

  ArcSolver solver_;
  GaussRule rule_;
  ArcLawAccuracy accuracy_;
};

std::optional<ArcLaw::Builder::Draft> ArcLaw::Builder::draft(const ArcEquilibrium& from,
                                                             const State& origin,
                                                             double end) const {
  Draft draft;
  Piece& piece = draft.piece;
  piece.origin = from.strain;
  piece.middle = (from.strain + end) / 2;
  piece.half_length = std::abs(end - from.strain) / 2;
  piece.origin_energy = origin.energy;
  piece.origin_force = origin.force;
  Series values{};
  ArcEquilibrium here = from;
  double smallest = INFINITY;
  for (std::size_t i = 0; i < terms; ++i) {
    const double outward = (1 + chebyshev_point<terms>(i)) / 2;
    const double strain = i == terms - 1 ? end : from.strain + (end - from.strain) * outward;
    const std::optional<ArcEquilibrium> next = solver_.advance(here, strain);
    if (!next) return {};
    here = *next;
    draft.nodes[i] = here;
    const double stiffness =
        strain == 0 ? solver_.rest().force_by_strain : here.bent.force / strain;
    values[end > 0 ? i : terms - 1 - i] = stiffness;
    smallest = std::min(smallest, std::abs(stiffness));
  }
  piece.stiffness = series_through(values);
  draft.tail =
      (std::abs(piece.stiffness[terms - 1]) + std::abs(piece.stiffness[terms - 2])) / smallest;
  return draft;
}

// The energy's second divided difference is the mean of the slope with weight 1 - t, t from the
// origin (0) to the strain (1): a polynomial, and positive where the slope is. Written this way the
// energy is exact near rest too, where it is a difference of nothing.
void ArcLaw::Builder::integrate(Piece& piece) const {
  Series values{};
  for (std::size_t i = 0; i < terms; ++i) {
    const double s = piece.middle + piece.half_length * chebyshev_point<terms>(i) - piece.origin;
    for (std::size_t j = 0; j < rule_.points.size(); ++j) {
      const double t = (1 + rule_.points[j]) / 2;
      const double slope = evaluate(piece, piece.origin + t * s).slope;
      values[i] += rule_.weights[j] / 2 * (1 - t) * slope;
    }
  }
  piece.curvature = series_through(values);
}

// Compares with equilibria solved between the nodes, where an interpolant is worst.
bool ArcLaw::Builder::passes(Draft& draft) {
  ArcLawAccuracy accuracy = accuracy_;
  for (const std::size_t i : {0, 4, 10, 14}) {
    const double strain = (draft.nodes[i].strain + draft.nodes[i + 1].strain) / 2;
    const std::optional<ArcEquilibrium> solved = solver_.advance(draft.nodes[i], strain);
    if (!solved) return false;
    const State state = evaluate(draft.piece, strain);
    const double error = std::abs(state.force / solved->bent.force - 1);
    if (!(error <= tolerance / 4)) return false;
    draft.piece.error = std::max(draft.piece.error, error);
    accuracy.force_error = std::max(accuracy.force_error, error);
    accuracy.slope_error =
        std::max(accuracy.slope_error, std::abs(state.slope / solved->force_by_strain - 1));
    accuracy.invariant_defect =
        std::max(accuracy.invariant_defect, solver_.invariant_defect(*solved));
    ++accuracy.check_points;
  }
  for (const ArcEquilibrium& node : draft.nodes) {
    accuracy.invariant_defect = std::max(accuracy.invariant_defect, solver_.invariant_defect(node));
  }
  accuracy.stored_points += terms;
  accuracy_ = accuracy;
  return true;
}

std::vector<ArcLaw::Piece> ArcLaw::Builder::pieces_to(double end) {
  const double half_angle = solver_.arc().half_angle_rad;
  std::vector<Piece> pieces;
  ArcEquilibrium from = solver_.rest();
  State origin;
  double length = (half_angle / std::sin(half_angle) - 1) / 2;  // half way to straight
  int attempts = 0;
  while (from.strain != end) {
    // Equal steps for what is left, so that no sliver remains.
    const double left = std::abs(end - from.strain);
    const double steps = std::ceil(left / length);
    const double target = steps > 1 ? from.strain + (end - from.strain) / steps : end;
    std::optional<Draft> next = draft(from, origin, target);
    const bool good = next && next->tail <= tail_goal && passes(*next);
    if (!good && (++attempts > most_attempts || pieces.size() >= most_pieces)) {
      throw ArcNotSolved("the arc's force could be followed to a strain of " +
                         std::to_string(from.strain) + " only");
    }
    // A series' tail falls with the 15th power of its length or faster.
    const double ratio = next ? tail_goal / std::max(next->tail, 1e-16) : 0;
    length =
        left / steps * std::clamp(0.9 * std::pow(ratio, 1.0 / (terms - 1)), 0.3, good ? 2.5 : 0.8);
    if (!good) continue;
    attempts = 0;
    integrate(next->piece);
    origin = evaluate(next->piece, target);
    from = next->nodes[terms - 1];
    pieces.push_back(next->piece);
  }
  return pieces;
}

ArcLaw::ArcLaw(const Arc& arc, const StrainRange& range) : range_(range) {
  Builder builder(arc);
  pieces_ = builder.pieces_to(range.lowest);
  std::reverse(pieces_.begin(), pieces_.end());
  std::ranges::copy(builder.pieces_to(range.highest), std::back_inserter(pieces_));
  accuracy_ = builder.accuracy();
  breaks_.push_back(range.lowest);
  for (const Piece& piece : pieces_) {
    if (piece.origin > range.lowest) breaks_.push_back(piece.origin);
  }
  breaks_.push_back(range.highest);
  std::sort(breaks_.begin(), breaks_.end());
  breaks_.erase(std::unique(breaks_.begin(), breaks_.end()), breaks_.end());
}

ArcLaw::State ArcLaw::evaluate(const Piece& piece, double strain) {
  const double x = (strain - piece.middle) / piece.half_length;
  const double s = strain - piece.origin;
  const ValueAndSlope stiffness = sum_series(piece.stiffness, x);
  const double curvature = sum_series(piece.curvature, x).value;
  return {piece.origin_energy + s * (piece.origin_force + s * curvature), strain * stiffness.value,
          stiffness.value + strain * stiffness.slope / piece.half_length, piece.error};
}

std::optional<ArcLaw::State> ArcLaw::at(double strain) const {
  if (!(strain >= range_.lowest && strain <= range_.highest)) return {};
  const auto above = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, strain);
  return evaluate(pieces_[above - breaks_.begin() - 1], strain);
}

}  // namespace latticast
