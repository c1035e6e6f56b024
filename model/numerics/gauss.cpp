// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/numerics/gauss.h"

#include <cmath>
#include <numbers>

namespace latticast {
namespace {

struct Legendre {
  double value;
  double slope;
};

Legendre legendre(int degree, double x) {
  double before = 1;
  double value = x;
  for (int n = 2; n <= degree; ++n) {
    const double next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
    before = value;
    value = next;
  }
  return {value, degree * (x * value - before) / (x * x - 1)};
}

}  // namespace

GaussRule gauss_legendre(int count) {
  GaussRule rule{std::vector<double>(count), std::vector<double>(count)};
  for (int i = 0; i < (count + 1) / 2; ++i) {
    const bool middle = 2 * i + 1 == count;
    double x = middle ? 0.0 : std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
    // The starting value is good to three digits, and Newton doubles them.
    for (int step = 0; step < 4 && !middle; ++step) {
      const Legendre p = legendre(count, x);
      x -= p.value / p.slope;
    }
    const double slope = legendre(count, x).slope;
    const double weight = 2 / ((1 - x * x) * slope * slope);
    rule.points[i] = -x;
    rule.points[count - 1 - i] = x;
    rule.weights[i] = rule.weights[count - 1 - i] = weight;
  }
  return rule;
}

}  // namespace latticast
