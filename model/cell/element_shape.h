// SPDX-License-Identifier: GPL-3.0-or-later
// Shape functions of quadratic finite elements at their Gauss points: 27-node hexahedra and the
// 9-node faces that bound them ([Bathe 2014] 5.3).
#pragma once

#include <array>
#include <vector>

namespace latticast {

/// Values and slopes by the element's own coordinates, each from -1 to 1, at the points of a Gauss
/// rule.
struct ShapeAtPoint {
  double weight = 0;              ///< of the rule, in the element's own coordinates
  std::array<double, 3> place{};  ///< own coordinates; a face has two
  std::vector<double> value;      ///< one a node
  std::vector<std::array<double, 3>> slope;
};

/// Node (i, j, k) of three along each axis has number i + 3 j + 9 k; (i, j) of a face i + 3 j.
struct ElementShape {
  int nodes = 0;
  std::vector<ShapeAtPoint> points;
};

/// 3 x 3 x 3 points: exact for the stiffness of a box.
const ElementShape& hexahedron();

/// 4 x 4 points: the cavity is a cubic function of place and slopes.
const ElementShape& quadrilateral();

}  // namespace latticast
