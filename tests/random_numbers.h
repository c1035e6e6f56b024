// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers for random designs, of tests and of studies.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace latticast::testing {

/// Uniform and log-uniform numbers from one seeded stream, the same on every platform.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}

  /// Of case `index` of a seed: any case can be repeated by itself.
  Random(unsigned seed, int index) : engine_((std::uint64_t{seed} << 32) + index) {}

  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  double log_between(double low, double high) {
    return std::exp(between(std::log(low), std::log(high)));
  }
  int integer(int low, int high) {  // both included
    return low + static_cast<int>(between(0, 1) * (high - low + 1));
  }
  bool chance(double probability) { return between(0, 1) < probability; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace latticast::testing
