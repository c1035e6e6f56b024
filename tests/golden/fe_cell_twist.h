// SPDX-License-Identifier: GPL-3.0-or-later
// The finite-element cell of 19 838 unknowns of twisting lattices (docs/unit-cell.md#accuracy).
#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace latticast::testing {

/// One pressure of tests/golden/fe_cell_twist.csv; twist per reference length, signed.
struct CellRow {
  double pressure_kpa = 0;
  double stretch = 1;
  double twist_rad_per_mm = 0;
};

/// All of one angle, by pressure. Throws std::runtime_error when there are none.
inline std::vector<CellRow> finite_element_rows(double angle_deg) {
  std::ifstream file(LATTICAST_SOURCE_DIR "/tests/golden/fe_cell_twist.csv");
  std::vector<CellRow> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::vector<double> numbers;
    for (std::string field; std::getline(fields, field, ',');) numbers.push_back(std::stod(field));
    if (numbers.at(0) == angle_deg) rows.push_back({numbers.at(4), numbers.at(5), numbers.at(6)});
  }
  if (rows.empty()) throw std::runtime_error("the finite-element cell cannot be read");
  return rows;
}

/// How far values are off, in percent, whatever the sign.
struct Deviation {
  double sum = 0;
  double worst = 0;
  int count = 0;

  void add(double value, double truth) {
    const double percent = 100 * std::abs(value / truth - 1);
    sum += percent;
    worst = std::max(worst, percent);
    ++count;
  }
  double mean() const { return sum / count; }
};

}  // namespace latticast::testing
