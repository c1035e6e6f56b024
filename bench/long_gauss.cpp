// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/long_gauss.h"

#include <cmath>
#include <numbers>

namespace latticast {

LongGaussRule long_gauss(int count) {
  LongGaussRule rule{std::vector<long double>(count), std::vector<long double>(count)};
  for (int i = 0; i < count; ++i) {
    long double x = -std::cos(std::numbers::pi_v<long double> * (i + 0.75L) / (count + 0.5L));
    long double slope = 1;
    for (int step = 0; step < 6; ++step) {
      long double before = 1;
      long double value = x;
      for (int n = 2; n <= count; ++n) {
        const long double next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
        before = value;
        value = next;
      }
      slope = count * (x * value - before) / (x * x - 1);
      x -= value / slope;
    }
    rule.points[i] = x;
    rule.weights[i] = 2 / ((1 - x * x) * slope * slope);
  }
  return rule;
}

}  // namespace latticast
