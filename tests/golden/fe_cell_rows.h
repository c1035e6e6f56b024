// SPDX-License-Identifier: GPL-3.0-or-later
// The finite-element cells of another program: elongating and bending lattices
// (docs/unit-cell.md#any-lattice).
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace latticast::testing {

/// Fields of the rows of a file under tests/golden/, its heading left out. Throws
/// std::runtime_error when there are none.
inline std::vector<std::vector<std::string>> golden_rows(const std::string& name) {
  std::ifstream file(std::string(LATTICAST_SOURCE_DIR "/tests/golden/") + name);
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream in(line);
    std::vector<std::string>& fields = rows.emplace_back();
    for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  }
  if (rows.empty()) throw std::runtime_error(name + " cannot be read");
  return rows;
}

/// One pressure of tests/golden/fe_cell_elongation.csv.
struct ElongationRow {
  double pressure_kpa = 0;
  double stretch = 1;
  double twist_rad_per_mm = 0;  ///< per reference length, magnitude
};

/// Columns 2:2 with the rings' centres there.
inline std::vector<ElongationRow> elongation_rows(const std::string& ring_centre) {
  std::vector<ElongationRow> rows;
  for (const auto& fields : golden_rows("fe_cell_elongation.csv")) {
    if (fields.at(1) != ring_centre) continue;
    rows.push_back({std::stod(fields.at(2)), std::stod(fields.at(3)), std::stod(fields.at(4))});
  }
  return rows;
}

/// One pressure of tests/golden/fe_cell_bending.csv.
struct BendingRow {
  double pressure_kpa = 0;
  double bend_rad_per_mm = 0;  ///< per reference length, magnitude
};

/// Of one mesh of a pair of widths, rings on the bulges.
inline std::vector<BendingRow> bending_rows(const std::string& widths, int unknowns) {
  std::vector<BendingRow> rows;
  for (const auto& fields : golden_rows("fe_cell_bending.csv")) {
    if (fields.at(0) != widths || std::stoi(fields.at(6)) != unknowns) continue;
    rows.push_back({std::stod(fields.at(2)), std::stod(fields.at(4))});
  }
  return rows;
}

}  // namespace latticast::testing
