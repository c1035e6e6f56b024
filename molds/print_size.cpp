// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/print_size.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "design/text/written_number.h"

namespace latticast {

namespace {

struct Box {
  Point low;
  Point high;
};

Box box_of(const TriangleMesh& mesh) {
  Box box{mesh.vertices.at(0), mesh.vertices.at(0)};
  for (const Point& p : mesh.vertices) {
    for (std::size_t i = 0; i < 3; ++i) {
      box.low[i] = std::min(box.low[i], p[i]);
      box.high[i] = std::max(box.high[i], p[i]);
    }
  }
  return box;
}

}  // namespace

TriangleMesh printing_pose(const MoldPiece& piece) {
  TriangleMesh mesh = piece.solid.mesh;
  const double turn = piece.pulls_sideways ? piece.pull_rad : 0;
  const double over = piece.name == "cap" ? -1 : 1;
  for (Point& p : mesh.vertices) {
    const double x = p[0] * std::cos(turn) + p[1] * std::sin(turn);
    const double y = p[1] * std::cos(turn) - p[0] * std::sin(turn);
    p = {x, over * y, over * p[2]};
  }
  const auto [low, high] = box_of(mesh);
  for (Point& p : mesh.vertices) {
    p[0] -= 0.5 * (low[0] + high[0]);
    p[1] -= 0.5 * (low[1] + high[1]);
    p[2] -= low[2];
  }
  return mesh;
}

PrintSize print_size(const MoldPiece& piece) {
  const auto [low, high] = box_of(printing_pose(piece));
  return {high[0] - low[0], high[1] - low[1], high[2] - low[2]};
}

std::string bed_problem(const MoldPiece& piece, const std::array<double, 3>& bed_mm) {
  const PrintSize size = print_size(piece);
  const bool high = size.height_mm > bed_mm[2];
  const auto lies = [&](double width, double depth) {
    return width <= bed_mm[0] && depth <= bed_mm[1];
  };
  const bool wide = !lies(size.width_mm, size.depth_mm) && !lies(size.depth_mm, size.width_mm);
  if (!high && !wide) return "";
  std::string change;
  if (wide) {
    change = piece.pulls_sideways ? "use more pieces, a thinner wall or a larger printer"
                                  : "use a thinner wall or a larger printer";
  }
  if (high) {
    change += wide ? ", and divide the segment into shorter ones"
                   : "divide the segment into shorter ones, or use a higher printer";
  }
  return fmt::format(
      "{} is {} x {} x {} mm, standing on its end; the printer takes "
      "{} x {} x {} mm: {}",
      piece.name, written(size.width_mm, 4), written(size.depth_mm, 4), written(size.height_mm, 4),
      written(bed_mm[0], 4), written(bed_mm[1], 4), written(bed_mm[2], 4), change);
}

}  // namespace latticast
