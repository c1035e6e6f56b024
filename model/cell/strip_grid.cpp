// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/strip_grid.h"

#include <algorithm>
#include <cmath>

namespace latticast {

void append_steps(std::vector<double>& ends, double to, int count, double grading) {
  if (count == 0) return;
  const double from = ends.back();
  const double ratio = count > 1 ? std::pow(grading, 1.0 / (count - 1)) : 1;
  double sum = 0;
  double step = 1;
  std::vector<double> sums;
  sums.reserve(count);
  for (int i = 0; i < count; ++i, step *= ratio) sums.push_back(sum += step);
  for (const double reached : sums) ends.push_back(from + (to - from) * reached / sum);
  ends.back() = to;
}

void append_graded(std::vector<double>& ends, double to, int count, double grading) {
  const double from = ends.back();
  const double ratio = count > 2 ? std::pow(grading, 1.0 / std::floor((count - 1) / 2.0)) : 1;
  std::vector<double> sums;
  sums.reserve(count);
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    sums.push_back(sum += std::pow(ratio, std::min(i, count - 1 - i)));
  }
  for (const double reached : sums) ends.push_back(from + (to - from) * reached / sum);
  ends.back() = to;
}

std::vector<double> with_middles(const std::vector<double>& ends) {
  std::vector<double> all;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    all.push_back(ends[i]);
    all.push_back(0.5 * (ends[i] + ends[i + 1]));
  }
  all.push_back(ends.back());
  return all;
}

}  // namespace latticast
