// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/arc_continuation.h"

#include <algorithm>

namespace latticast {

std::optional<Eigen::VectorXd> followed(const SolveNear& solve, const Eigen::VectorXd& rest,
                                        double strain) {
  Eigen::VectorXd here = rest;
  Eigen::VectorXd by_way = Eigen::VectorXd::Zero(rest.size());
  double way = 0;  // of the strain, from 0 to 1
  double step = 1.0 / 8;
  while (way < 1) {
    const double next = std::min(1.0, way + step);
    const auto found = solve(strain * next, here + by_way * (next - way));
    if (!found) {
      step /= 2;
      if (step < 1e-3) return std::nullopt;
      continue;
    }
    by_way = (*found - here) / (next - way);
    here = *found;
    way = next;
    step *= 2;
  }
  return here;
}

}  // namespace latticast
