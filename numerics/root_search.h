// SPDX-License-Identifier: GPL-3.0-or-later
// Root of a function of one variable between two arguments where its signs differ: inverse
// quadratic interpolation where it is sure to work, bisection elsewhere ([Chandrupatla 1997]).
#pragma once

#include <cmath>
#include <utility>

namespace latticast {

/// A search that its caller drives, for functions that may fail or carry more than a value:
///     RootSearch search(a, f(a), b, f(b));
///     while (...) { const double x = search.next(); search.narrow(x, f(x)); }
/// The bracket shrinks in every step and holds a root of any continuous function. Values that are
/// infinite on either side lead to bisection. Precondition: f(a) and f(b) differ in sign.
class RootSearch {
 public:
  RootSearch(double a, double at_a, double b, double at_b)
      : newest_{a, at_a}, other_{b, at_b}, dropped_{newest_} {
    // The secant first: most callers' functions are nearly linear.
    fraction_ = at_a / (at_a - at_b);
  }

  /// Where to look next, inside the bracket by at least `margin` of its width.
  double next(double margin = 0) const {
    const bool inside = fraction_ > 0 && fraction_ < 1;
    const double fraction = inside ? fraction_ : 0.5;
    const double least = margin < 0.5 ? margin : 0.5;
    const double kept = fraction < least ? least : (fraction > 1 - least ? 1 - least : fraction);
    return newest_.x + kept * (other_.x - newest_.x);
  }

  /// Takes the function's value at `x`, an argument that next() gave.
  void narrow(double x, double value) {
    if ((value > 0) == (newest_.value > 0)) {
      dropped_ = newest_;
    } else {
      dropped_ = other_;
      other_ = newest_;
    }
    newest_ = {x, value};
    fraction_ = interpolated();
  }

  /// Whether `x` lies inside the bracket, ends excluded: no longer so when both ends are
  /// neighbours.
  bool encloses(double x) const { return (x > newest_.x) == (x < other_.x) && x != newest_.x; }

  double width() const { return std::abs(other_.x - newest_.x); }

  /// The end of the bracket with the smaller value.
  double best() const {
    return std::abs(newest_.value) < std::abs(other_.value) ? newest_.x : other_.x;
  }

 private:
  struct Sample {
    double x = 0;
    double value = 0;
  };

  /// Fraction of the way from the newest sample to the other end.
  double interpolated() const {
    const auto [x1, f1] = newest_;
    const auto [x2, f2] = other_;
    const auto [x3, f3] = dropped_;
    const double xi = (x1 - x2) / (x3 - x2);
    const double phi = (f1 - f2) / (f3 - f2);
    // Otherwise the inverse quadratic through the three samples is not monotone in the bracket.
    if (!(phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)) return 0.5;
    return f1 / (f2 - f1) * f3 / (f2 - f3) +
           (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2);
  }

  Sample newest_;
  Sample other_;
  Sample dropped_;
  double fraction_ = 0.5;
};

/// The root between a and b to within `tolerance`, or as close as numbers lie. An end where the
/// value is exactly zero is the root.
template <class Function>
double bracketed_root(const Function& function, double a, double at_a, double b, double at_b,
                      double tolerance) {
  constexpr int most_steps = 200;
  if (at_a == 0) return a;
  if (at_b == 0) return b;
  RootSearch search(a, at_a, b, at_b);
  for (int i = 0; i < most_steps && search.width() > tolerance; ++i) {
    const double x = search.next(0.5 * tolerance / search.width());
    if (!search.encloses(x)) break;
    const double value = function(x);
    if (value == 0) return x;
    search.narrow(x, value);
  }
  return search.best();
}

}  // namespace latticast
