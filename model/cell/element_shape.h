// SPDX-License-Identifier: GPL-3.0-or-later
// Shape functions of quadratic finite elements at their Gauss points: 27-node hexahedra and 21-node
// wedges, and the faces that bound them ([Bathe 2014] 5.3).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace latticast {

/// Values and slopes by the element's own coordinates at the points of a Gauss rule.
struct ShapeAtPoint {
  double weight = 0;              ///< of the rule, in the element's own coordinates
  std::array<double, 3> place{};  ///< own coordinates from the element's middle; a face has two
  std::vector<double> value;      ///< one a node
  std::vector<std::array<double, 3>> slope;
};

struct ElementShape {
  int nodes = 0;
  std::vector<ShapeAtPoint> points;
};

/// Own coordinates from -1 to 1; node (i, j, k) of three along each axis has number i + 3 j + 9 k.
/// 3 x 3 x 3 points: exact for the stiffness of a box.
const ElementShape& hexahedron();

/// A quadratic triangle with a bubble, times a parabola: node p of the triangle on level k of three
/// has number p + 7 k. Triangle: corners 0, 1, 2 at (0, 0), (1, 0), (0, 1), middles of the edges
/// 01, 12, 20, then the centre. 7 x 3 points: exact for the forces of a constant stress where the
/// centre lies as the triangle's other nodes have it.
const ElementShape& wedge();

/// Node (i, j) has number i + 3 j. 4 x 4 points: the cavity is a cubic function of place and
/// slopes.
const ElementShape& quadrilateral();

/// The wedge's triangle. 4 x 4 points, exact to the sixth order.
const ElementShape& triangle();

template <std::size_t N>
const ElementShape& shape_of() {
  if constexpr (N == 27) return hexahedron();
  if constexpr (N == 21) return wedge();
  if constexpr (N == 9) return quadrilateral();
  if constexpr (N == 7) return triangle();
}

}  // namespace latticast
