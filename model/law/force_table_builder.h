// SPDX-License-Identifier: GPL-3.0-or-later
// Builder of force tables: interpolates the equilibria of a link piece by piece, outwards from
// rest, and compares each piece with equilibria between its nodes
// (docs/horseshoe.md#the-law-as-stored).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "model/law/force_table.h"

namespace latticast {

/// Equilibria of a link along the branch from rest. Empty where the branch cannot be followed.
template <class Branch>
concept LinkBranch = requires(const Branch& branch, const typename Branch::Point& point,
                              double strain) {
  { point.strain } -> std::convertible_to<double>;
  { branch.rest() } -> std::convertible_to<typename Branch::Point>;
  { branch.force(point) } -> std::convertible_to<double>;
  { branch.slope(point) } -> std::convertible_to<double>;  // of the force by strain
  /// From an equilibrium to that of another strain.
  { branch.advance(point, strain) } -> std::same_as<std::optional<typename Branch::Point>>;
  /// The same, as well as it can be had: what pieces are compared with.
  { branch.check(point, strain) } -> std::same_as<std::optional<typename Branch::Point>>;
  { branch.defect(point) } -> std::convertible_to<double>;
  { branch.first_piece() } -> std::convertible_to<double>;  // its length, as a first guess
};

/// Precondition: the range holds 0 and is finite. Throws LawNotSolved.
template <LinkBranch Branch>
class ForceTableBuilder {
 public:
  explicit ForceTableBuilder(const Branch& branch) : branch_(branch) {}

  ForceTable build(const StrainRange& range) {
    std::vector<Piece> pieces = pieces_to(range.lowest);
    std::reverse(pieces.begin(), pieces.end());
    std::ranges::copy(pieces_to(range.highest), std::back_inserter(pieces));
    return {range, std::move(pieces), accuracy_};
  }

 private:
  using Point = typename Branch::Point;
  using Piece = ForceTable::Piece;
  static constexpr std::size_t terms = ForceTable::terms;

  // Of force/strain, relative: size of the last terms of a series that is good enough.
  static constexpr double tail_goal = 2e-10;
  static constexpr int most_pieces = 2000;
  static constexpr int most_attempts = 60;  // at one piece, each shorter than the one before

  struct Draft {
    Piece piece;
    std::array<Point, terms> nodes;  // from the origin outwards
    double tail = 0;                 // of the series, relative
  };

  std::optional<Draft> draft(const Point& from, const ForceTable::State& origin, double end) const {
    Draft draft;
    Piece& piece = draft.piece;
    piece.origin = from.strain;
    piece.middle = (from.strain + end) / 2;
    piece.half_length = std::abs(end - from.strain) / 2;
    piece.origin_energy = origin.energy;
    piece.origin_force = origin.force;
    ForceTable::Series values{};
    Point here = from;
    double smallest = INFINITY;
    for (std::size_t i = 0; i < terms; ++i) {
      const double outward = (1 + chebyshev_point(i)) / 2;
      const double strain = i == terms - 1 ? end : from.strain + (end - from.strain) * outward;
      const std::optional<Point> next = branch_.advance(here, strain);
      if (!next) return {};
      here = *next;
      draft.nodes[i] = here;
      const double stiffness =
          strain == 0 ? branch_.slope(branch_.rest()) : branch_.force(here) / strain;
      values[end > 0 ? i : terms - 1 - i] = stiffness;
      smallest = std::min(smallest, std::abs(stiffness));
    }
    piece.stiffness = series_through(values);
    draft.tail =
        (std::abs(piece.stiffness[terms - 1]) + std::abs(piece.stiffness[terms - 2])) / smallest;
    return draft;
  }

  // Compares with equilibria solved between the nodes, where an interpolant is worst.
  bool passes(Draft& draft) {
    TableAccuracy accuracy = accuracy_;
    for (const std::size_t i : {0, 4, 10, 14}) {
      const double strain = (draft.nodes[i].strain + draft.nodes[i + 1].strain) / 2;
      const std::optional<Point> solved = branch_.check(draft.nodes[i], strain);
      if (!solved) return false;
      const ForceTable::State state = ForceTable::evaluate(draft.piece, strain);
      const double error = std::abs(state.force / branch_.force(*solved) - 1);
      if (!(error <= ForceTable::tolerance / 4)) return false;
      draft.piece.error = std::max(draft.piece.error, error);
      accuracy.force_error = std::max(accuracy.force_error, error);
      accuracy.slope_error =
          std::max(accuracy.slope_error, std::abs(state.slope / branch_.slope(*solved) - 1));
      accuracy.defect = std::max(accuracy.defect, branch_.defect(*solved));
      ++accuracy.check_points;
    }
    for (const Point& node : draft.nodes) {
      accuracy.defect = std::max(accuracy.defect, branch_.defect(node));
    }
    accuracy.stored_points += terms;
    accuracy_ = accuracy;
    return true;
  }

  std::vector<Piece> pieces_to(double end) {
    std::vector<Piece> pieces;
    Point from = branch_.rest();
    ForceTable::State origin;
    double length = branch_.first_piece();
    int attempts = 0;
    while (from.strain != end) {
      // Equal steps for what is left, so that no sliver remains.
      const double left = std::abs(end - from.strain);
      const double steps = std::ceil(left / length);
      const double target = steps > 1 ? from.strain + (end - from.strain) / steps : end;
      std::optional<Draft> next = draft(from, origin, target);
      const bool good = next && next->tail <= tail_goal && passes(*next);
      if (!good && (++attempts > most_attempts || pieces.size() >= most_pieces)) {
        throw LawNotSolved("a link's force could be followed to a strain of " +
                           std::to_string(from.strain) + " only");
      }
      // A series' tail falls with the 15th power of its length or faster.
      const double ratio = next ? tail_goal / std::max(next->tail, 1e-16) : 0;
      length = left / steps *
               std::clamp(0.9 * std::pow(ratio, 1.0 / (terms - 1)), 0.3, good ? 2.5 : 0.8);
      if (!good) continue;
      attempts = 0;
      integrate(next->piece);
      origin = ForceTable::evaluate(next->piece, target);
      from = next->nodes[terms - 1];
      pieces.push_back(next->piece);
    }
    return pieces;
  }

  const Branch& branch_;
  TableAccuracy accuracy_;
};

}  // namespace latticast
