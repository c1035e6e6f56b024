// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/equilibrium/state_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/numerics/small_matrix.h"

namespace latticast {

double state_error(const Balance& balance, const BranchPoint& x, const BalanceAt& at) {
  const auto finer = balance.finer_at(x);
  if (!finer) return std::numeric_limits<double>::infinity();
  const int n = balance.free_count();
  const BalanceAt::Vector doubt = balance.doubt(x, at);
  BalanceAt::Matrix stiffness = at.tangent_stiffness;
  BalanceAt::Matrix inverse;
  invert(std::span(stiffness).first(entry_count(n)), std::span(inverse).first(entry_count(n)));
  double error = 0;
  double largest = 1;
  for (int i = 0; i < n; ++i) {
    double moved = 0;
    double doubted = 0;
    for (int j = 0; j < n; ++j) {
      moved += inverse[j * n + i] * finer->residual[j];
      doubted += std::abs(inverse[j * n + i]) * doubt[j];
    }
    error = std::max(error, 2 * std::abs(moved) + doubted);
    largest = std::max(largest, 1 + std::abs(x[i]));
  }
  return error + largest * std::numeric_limits<double>::epsilon();
}

}  // namespace latticast
