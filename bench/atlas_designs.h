// SPDX-License-Identifier: GPL-3.0-or-later
// The designs of the stability atlas: maps of two axes, and a random sample of all axes at once.
#pragma once

#include <string>
#include <vector>

#include "bench/atlas_check.h"

namespace latticast {

/// One axis of a map: values, and what they are.
struct AtlasAxis {
  std::string name;
  std::vector<double> values;
};

/// A design for each place of a grid; the design at place x, y has one pressure.
struct AtlasMap {
  std::string name;
  AtlasAxis x;
  AtlasAxis y;
  std::vector<AtlasDesign> designs;  ///< x.values.size() * y.values.size(), y in the inner loop
};

/// The four maps, `per_axis` values along each axis:
///   stiffness  E/mu 1e-3 to 1e9 against pressure, 0.01 to 100 times the reference pressure
///   wall       R_i/R_m 0.05 to 0.999 against alpha, 0.01 to 179.99 degrees, at half of it
///   horseshoe  w/R_h 1e-3 to 100 against pressure
///   widths     w_2/w_1 1 to 1000 against pressure
std::vector<AtlasMap> atlas_maps(int per_axis);

/// Design number `index` of the random sample: all axes at once, two pressures of one sign.
AtlasDesign random_atlas_design(unsigned seed, int index);

/// All numbers of a design, so that it can be made again.
std::string description(const AtlasDesign& design);

}  // namespace latticast
