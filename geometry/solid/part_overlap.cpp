// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/part_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "geometry/solid/box_tree.h"

namespace latticast {
namespace {

constexpr std::size_t lines = 100;  // along each side of the common box
constexpr std::size_t most_found = 100;
constexpr std::size_t most_work = 300000000;                // triangles that are looked at
constexpr std::size_t work_of_a_pair = 10 * lines * lines;  // beside its triangles

struct Interval {
  double low = 0;
  double high = 0;
};
using Intervals = std::vector<Interval>;

// A line passes into the object where `turn` is 1, and out of it where it is -1.
struct Crossing {
  double height = 0;
  int turn = 0;
};

Box<3> box_of(const TriangleMesh& mesh) {
  Box<3> box;
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t vertex : t) box.add(mesh.vertices[vertex]);
  }
  return box;
}

Box<3> common(const Box<3>& a, const Box<3>& b) {
  Box<3> box;
  for (int i = 0; i < 3; ++i) {
    box.low[i] = std::max(a.low[i], b.low[i]);
    box.high[i] = std::min(a.high[i], b.high[i]);
  }
  return box;
}

bool is_thick(const Box<3>& box) {
  for (int i = 0; i < 3; ++i) {
    if (!(box.high[i] - box.low[i] > contact_depth_mm)) return false;
  }
  return true;
}

// The lines parallel to one axis through the middles of the cells of a grid.
class LineGrid {
 public:
  LineGrid(const Box<3>& box, int along) : along_(along), u_((along + 1) % 3), v_((along + 2) % 3) {
    for (int i = 0; i < 3; ++i) {
      low_[i] = box.low[i];
      step_[i] = (box.high[i] - box.low[i]) / lines;
    }
  }

  int along() const { return along_; }
  double area() const { return step_[u_] * step_[v_]; }

  Point at(std::size_t line, double height) const {
    Point point{};
    point[along_] = height;
    point[u_] = position(u_, line / lines);
    point[v_] = position(v_, line % lines);
    return point;
  }

  std::size_t line_near(const Point& point) const {
    return cell(u_, point[u_]) * lines + cell(v_, point[v_]);
  }

  // Calls cross(line, crossing) for every line that passes through the triangle.
  template <class Cross>
  void for_each_crossing(const std::array<Point, 3>& t, const Cross& cross) const {
    const double area = side(t[0], t[1], t[2][u_], t[2][v_]);
    if (area == 0) return;
    const auto [u_from, u_to] = cells(t, u_);
    const auto [v_from, v_to] = cells(t, v_);
    for (std::size_t i = u_from; i < u_to; ++i) {
      for (std::size_t j = v_from; j < v_to; ++j) {
        const double u = position(u_, i);
        const double v = position(v_, j);
        const double a = side(t[1], t[2], u, v) / area;
        const double b = side(t[2], t[0], u, v) / area;
        const double c = side(t[0], t[1], u, v) / area;
        if (a < 0 || b < 0 || c < 0) continue;
        cross(i * lines + j,
              {a * t[0][along_] + b * t[1][along_] + c * t[2][along_], area > 0 ? -1 : 1});
      }
    }
  }

 private:
  // Off the middle, so that lines through the round coordinates of drawn parts are rare.
  static constexpr double offset = 0.4871;

  double position(int axis, std::size_t cell) const {
    return low_[axis] + step_[axis] * (static_cast<double>(cell) + offset);
  }

  std::size_t cell(int axis, double place) const {
    const double number = (place - low_[axis]) / step_[axis];
    return static_cast<std::size_t>(std::clamp(number, 0.0, lines - 1.0));
  }

  std::pair<std::size_t, std::size_t> cells(const std::array<Point, 3>& t, int axis) const {
    const auto [least, most] = std::minmax({t[0][axis], t[1][axis], t[2][axis]});
    if (most < low_[axis] || least > low_[axis] + step_[axis] * lines) return {0, 0};
    return {cell(axis, least), cell(axis, most) + 1};
  }

  double side(const Point& from, const Point& to, double u, double v) const {
    return (to[u_] - from[u_]) * (v - from[v_]) - (to[v_] - from[v_]) * (u - from[u_]);
  }

  int along_;
  int u_;
  int v_;
  Point low_{};
  Point step_{};
};

// Where the line is inside of the object; nothing for a line that grazes it and counts badly.
Intervals inside(std::vector<Crossing>& crossings) {
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return a.height != b.height ? a.height < b.height : a.turn > b.turn;
  });
  Intervals result;
  int depth = 0;
  for (const Crossing& crossing : crossings) {
    if (depth == 0 && crossing.turn > 0) result.push_back({crossing.height, crossing.height});
    depth += crossing.turn;
    if (depth < 0) return {};
    if (depth == 0) result.back().high = crossing.height;
  }
  return depth == 0 ? result : Intervals{};
}

std::vector<Intervals> inside(const TriangleMesh& mesh, const LineGrid& grid) {
  std::vector<std::vector<Crossing>> crossings(lines * lines);
  for (const Triangle& t : mesh.triangles) {
    grid.for_each_crossing(
        {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]},
        [&](std::size_t line, const Crossing& crossing) { crossings[line].push_back(crossing); });
  }
  std::vector<Intervals> result;
  result.reserve(crossings.size());
  for (std::vector<Crossing>& line : crossings) result.push_back(inside(line));
  return result;
}

Intervals common(const Intervals& a, const Intervals& b) {
  Intervals result;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const Interval both{std::max(a[i].low, b[j].low), std::min(a[i].high, b[j].high)};
    if (both.low < both.high) result.push_back(both);
    a[i].high < b[j].high ? ++i : ++j;
  }
  return result;
}

// What both objects claim, along the lines of one direction.
struct Claimed {
  LineGrid grid;
  std::vector<Intervals> lines;

  double volume() const {
    double length = 0;
    for (const Intervals& line : lines) {
      for (const Interval& claimed : line) length += claimed.high - claimed.low;
    }
    return length * grid.area();
  }

  double length_through(const Point& point) const {
    const double height = point[grid.along()];
    for (const Interval& claimed : lines[grid.line_near(point)]) {
      if (claimed.low <= height && height <= claimed.high) return claimed.high - claimed.low;
    }
    return 0;
  }
};

Claimed claimed_by_both(const TriangleMesh& a, const TriangleMesh& b, const Box<3>& box,
                        int along) {
  Claimed claimed{LineGrid(box, along), inside(a, LineGrid(box, along))};
  const std::vector<Intervals> other = inside(b, claimed.grid);
  for (std::size_t i = 0; i < other.size(); ++i) {
    claimed.lines[i] = common(claimed.lines[i], other[i]);
  }
  return claimed;
}

void measure_depth(const std::array<Claimed, 3>& claimed, PartOverlap& overlap) {
  for (const Claimed& direction : claimed) {
    for (std::size_t line = 0; line < direction.lines.size(); ++line) {
      for (const Interval& part : direction.lines[line]) {
        const Point middle = direction.grid.at(line, 0.5 * (part.low + part.high));
        double depth = part.high - part.low;
        for (const Claimed& other : claimed) depth = std::min(depth, other.length_through(middle));
        if (depth <= overlap.depth_mm) continue;
        overlap.depth_mm = depth;
        overlap.where = middle;
      }
    }
  }
}

PartOverlap measured(const TriangleMesh& a, const TriangleMesh& b, const Box<3>& box) {
  const std::array<Claimed, 3> claimed{claimed_by_both(a, b, box, 0), claimed_by_both(a, b, box, 1),
                                       claimed_by_both(a, b, box, 2)};
  PartOverlap overlap;
  for (const Claimed& direction : claimed) overlap.volume_mm3 += direction.volume() / 3;
  measure_depth(claimed, overlap);
  return overlap;
}

}  // namespace

PartOverlaps overlapping_parts(const std::vector<MeshObject>& objects,
                               const std::vector<bool>& sound) {
  std::vector<Box<3>> boxes;
  boxes.reserve(objects.size());
  for (const MeshObject& object : objects) boxes.push_back(box_of(object.mesh));
  std::vector<std::size_t> order(objects.size());
  std::iota(order.begin(), order.end(), 0U);
  std::erase_if(order, [&](std::size_t i) { return !sound[i]; });
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return boxes[a].low[0] < boxes[b].low[0]; });
  PartOverlaps result;
  std::size_t work = 0;
  for (std::size_t i = 0; i < order.size() && result.searched_all; ++i) {
    for (std::size_t j = i + 1;
         j < order.size() && boxes[order[j]].low[0] < boxes[order[i]].high[0]; ++j) {
      const auto [first, second] = std::minmax(order[i], order[j]);
      const Box<3> box = common(boxes[first], boxes[second]);
      work += is_thick(box) ? work_of_a_pair + objects[first].mesh.triangles.size() +
                                  objects[second].mesh.triangles.size()
                            : 1;
      if (work > most_work || result.found.size() == most_found) {
        result.searched_all = false;
        break;
      }
      if (!is_thick(box)) continue;
      PartOverlap overlap = measured(objects[first].mesh, objects[second].mesh, box);
      if (!(overlap.depth_mm > contact_depth_mm)) continue;
      overlap.first = first;
      overlap.second = second;
      result.found.push_back(overlap);
    }
  }
  std::sort(result.found.begin(), result.found.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  });
  return result;
}

}  // namespace latticast
