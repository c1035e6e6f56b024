// SPDX-License-Identifier: GPL-3.0-or-later
// The finite-element cell of a lattice at 36 degrees, rings 10 mm apart
// (docs/model.md#what-it-leaves-out).
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace latticast::testing {

/// One pressure of tests/golden/fe_alpha36.csv.
struct CellState {
  double pressure_kpa = 0;
  double stretch = 1;
  double twist_rad_per_mm = 0;  ///< per reference length, magnitude
  double inner_radius_mm = 0;
  double ring_growth_mm = 0;  ///< of the liner's outer radius under a ring
  double void_growth_mm = 0;  ///< and in the middle of a free patch
};

/// All of them, by pressure. Throws std::runtime_error when the file cannot be read.
inline std::vector<CellState> finite_element_cell() {
  std::ifstream file(LATTICAST_SOURCE_DIR "/tests/golden/fe_alpha36.csv");
  std::vector<CellState> states;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    CellState s;
    char comma = 0;
    fields >> s.pressure_kpa >> comma >> s.stretch >> comma >> s.twist_rad_per_mm >> comma >>
        s.inner_radius_mm >> comma >> s.ring_growth_mm >> comma >> s.void_growth_mm;
    if (!fields) throw std::runtime_error("not a row of the finite-element cell: " + line);
    states.push_back(s);
  }
  if (states.empty()) throw std::runtime_error("the finite-element cell cannot be read");
  return states;
}

}  // namespace latticast::testing
