// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/audit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "geometry/mesh/disjoint_sets.h"
#include "geometry/solid/nesting.h"
#include "geometry/solid/self_intersection.h"

namespace latticast {
namespace {

constexpr std::size_t listed_per_defect = 5;

// One side of a triangle, filed under its lower vertex.
struct Side {
  std::uint32_t upper;   // the other vertex
  std::uint32_t corner;  // 3 * triangle + position of the corner where the side starts
  bool ascending;        // runs from the lower to the upper vertex
};

// Sides grouped by lower vertex: those of vertex v are [first[v], first[v + 1]), sorted by upper
// vertex.
struct SideTable {
  std::vector<std::uint32_t> first;
  std::vector<Side> sides;
};

SideTable side_table(const TriangleMesh& mesh) {
  SideTable table{std::vector<std::uint32_t>(mesh.vertices.size() + 1, 0),
                  std::vector<Side>(3 * mesh.triangles.size())};
  const auto each_side = [&](auto&& visit) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        visit(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3], 3 * t + i);
      }
    }
  };
  each_side([&](auto from, auto to, auto) { ++table.first[std::min(from, to) + 1]; });
  std::partial_sum(table.first.begin(), table.first.end(), table.first.begin());
  std::vector<std::uint32_t> next(table.first.begin(), table.first.end() - 1);
  each_side([&](auto from, auto to, auto corner) {
    table.sides[next[std::min(from, to)]++] = {std::max(from, to), corner, from < to};
  });
  for (std::size_t v = 0; v + 1 < table.first.size(); ++v) {
    std::sort(table.sides.begin() + table.first[v], table.sides.begin() + table.first[v + 1],
              [](const Side& a, const Side& b) {
                return a.upper != b.upper ? a.upper < b.upper : a.corner < b.corner;
              });
  }
  return table;
}

class Auditor {
 public:
  explicit Auditor(const TriangleMesh& mesh)
      : mesh_(mesh), fans_(3 * mesh.triangles.size()), degenerate_(mesh.triangles.size(), 0) {
    audit_.triangles = mesh.triangles.size();
  }

  Audit run() {
    check_coordinates();
    if (audit_.count(Defect::not_finite) == 0) check_triangles();
    check_edges();
    check_fans();
    if (audit_.count(Defect::not_finite) == 0) {
      measure();
      search_intersections();
      check_facing();
    }
    std::stable_sort(audit_.findings.begin(), audit_.findings.end(),
                     [](const Finding& a, const Finding& b) { return a.defect < b.defect; });
    return std::move(audit_);
  }

 private:
  void report(Defect defect, const Point& where, std::size_t triangle) {
    std::size_t& count = audit_.counts[static_cast<std::size_t>(defect)];
    if (count++ < listed_per_defect) audit_.findings.push_back({defect, where, triangle});
  }

  const Point& vertex(std::uint32_t corner) const {
    return mesh_.vertices[mesh_.triangles[corner / 3][corner % 3]];
  }

  static Point middle(const Point& a, const Point& b) {
    return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])};
  }

  Point middle(std::uint32_t triangle) const {
    Point sum{};
    for (const std::uint32_t v : mesh_.triangles[triangle]) {
      for (int axis = 0; axis < 3; ++axis) sum[axis] += mesh_.vertices[v][axis] / 3;
    }
    return sum;
  }

  void check_coordinates() {
    for (std::uint32_t corner = 0; corner < 3 * mesh_.triangles.size(); ++corner) {
      const Point& p = vertex(corner);
      if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])) continue;
      report(Defect::not_finite, p, corner / 3);
    }
  }

  void check_triangles() {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      degenerate_[t] = is_degenerate(mesh_, mesh_.triangles[t]) ? 1 : 0;
      if (degenerate_[t]) report(Defect::degenerate, middle(t), t);
    }
  }

  void check_edges() {
    const SideTable table = side_table(mesh_);
    for (std::size_t v = 0; v + 1 < table.first.size(); ++v) {
      for (std::uint32_t i = table.first[v]; i < table.first[v + 1];) {
        std::uint32_t end = i;
        while (end < table.first[v + 1] && table.sides[end].upper == table.sides[i].upper) ++end;
        check_edge(&table.sides[i], end - i);
        i = end;
      }
    }
  }

  void check_edge(const Side* sides, std::size_t count) {
    ++audit_.edges;
    const Point where = middle(vertex(sides[0].corner), vertex(next_corner(sides[0].corner)));
    const std::size_t triangle = sides[0].corner / 3;
    if (count == 1) report(Defect::open_edge, where, triangle);
    if (count > 2) report(Defect::crowded_edge, where, triangle);
    if (count == 2 && sides[0].ascending == sides[1].ascending) {
      report(Defect::inconsistent_edge, where, triangle);
    }
    for (std::size_t i = 1; i < count; ++i) join(sides[0], sides[i]);
  }

  static std::uint32_t next_corner(std::uint32_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
  }

  // Two triangles at an edge belong to the same fan at both its ends.
  void join(const Side& a, const Side& b) {
    const bool opposite = a.ascending != b.ascending;
    fans_.join(a.corner, opposite ? next_corner(b.corner) : b.corner);
    fans_.join(next_corner(a.corner), opposite ? b.corner : next_corner(b.corner));
  }

  // A vertex with more than one fan is pinched; the fans' number is the Euler count's vertex
  // number.
  void check_fans() {
    std::vector<std::uint32_t> fan_of(mesh_.vertices.size(), 0);
    std::vector<char> seen(mesh_.vertices.size(), 0);
    std::size_t fans = 0;
    DisjointSets bodies(3 * mesh_.triangles.size());
    for (std::uint32_t corner = 0; corner < 3 * mesh_.triangles.size(); ++corner) {
      const std::uint32_t fan = fans_.root(corner);
      bodies.join(corner, 3 * (corner / 3));
      bodies.join(corner, fan);
      if (fan != corner) continue;
      ++fans;
      const std::uint32_t v = mesh_.triangles[corner / 3][corner % 3];
      if (seen[v]) report(Defect::pinched_vertex, mesh_.vertices[v], corner / 3);
      audit_.vertices += !seen[v];
      seen[v] = 1;
    }
    collect_bodies(bodies);
    audit_.components = static_cast<int>(bodies_.size());
    const auto euler = static_cast<long>(fans) - static_cast<long>(audit_.edges) +
                       static_cast<long>(audit_.triangles);
    audit_.genus = audit_.components - static_cast<int>(euler / 2);
  }

  // The triangles of each connected body, in file order.
  void collect_bodies(DisjointSets& corners) {
    std::vector<std::uint32_t> body_of(3 * mesh_.triangles.size(), 0);  // by root corner, from 1
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      std::uint32_t& body = body_of[corners.root(3 * t)];
      if (body == 0) {
        bodies_.emplace_back();
        body = static_cast<std::uint32_t>(bodies_.size());
      }
      bodies_[body - 1].push_back(t);
    }
  }

  void measure() {
    audit_.lowest = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
    audit_.highest = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (const Triangle& t : mesh_.triangles) {
      const Point& a = mesh_.vertices[t[0]];
      std::array<double, 3> u{};
      std::array<double, 3> v{};
      for (int axis = 0; axis < 3; ++axis) {
        u[axis] = mesh_.vertices[t[1]][axis] - a[axis];
        v[axis] = mesh_.vertices[t[2]][axis] - a[axis];
        for (const std::uint32_t corner : t) {
          audit_.lowest[axis] = std::min(audit_.lowest[axis], mesh_.vertices[corner][axis]);
          audit_.highest[axis] = std::max(audit_.highest[axis], mesh_.vertices[corner][axis]);
        }
      }
      const std::array<double, 3> normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                         u[0] * v[1] - u[1] * v[0]};
      audit_.area_mm2 += 0.5 * std::hypot(normal[0], normal[1], normal[2]);
      audit_.volume_mm3 += (a[0] * normal[0] + a[1] * normal[1] + a[2] * normal[2]) / 6;
    }
  }

  // Six times the volume of one body, from its own first vertex: far from the origin the sum over
  // the mesh may lose the sign of a small one.
  double six_volumes(const std::vector<std::uint32_t>& body) const {
    const Point& origin = mesh_.vertices[mesh_.triangles[body.front()][0]];
    double sum = 0;
    for (const std::uint32_t t : body) {
      std::array<Point, 3> r{};
      for (int i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
          r[i][axis] = mesh_.vertices[mesh_.triangles[t][i]][axis] - origin[axis];
        }
      }
      sum += r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1]) +
             r[0][1] * (r[1][2] * r[2][0] - r[1][0] * r[2][2]) +
             r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
    }
    return sum;
  }

  void check_facing() {
    if (audit_.findings.empty()) {
      const std::vector<int> around = surrounding_winding(mesh_, bodies_);
      for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const int expected = six_volumes(bodies_[i]) > 0 ? 0 : 1;
        const std::uint32_t triangle = bodies_[i].front();
        if (around[i] != expected) report(Defect::inside_out, middle(triangle), triangle);
      }
      return;
    }
    const bool closed = audit_.count(Defect::open_edge) + audit_.count(Defect::crowded_edge) +
                            audit_.count(Defect::inconsistent_edge) ==
                        0;
    if (closed && audit_.volume_mm3 < 0) report(Defect::inside_out, middle(0U), 0);
  }

  void search_intersections() {
    audit_.searched_intersections = true;
    for (const auto& [first, second] : self_intersections(mesh_, degenerate_)) {
      report(Defect::self_intersection, middle(first), first);
    }
  }

  const TriangleMesh& mesh_;
  DisjointSets fans_;  // of triangle corners around their vertex
  std::vector<char> degenerate_;
  std::vector<std::vector<std::uint32_t>> bodies_;
  Audit audit_;
};

}  // namespace

bool Audit::has_only(Defect defect) const {
  std::size_t all = 0;
  for (const std::size_t count : counts) all += count;
  return all > 0 && all == count(defect);
}

std::string_view name(Defect defect) {
  constexpr std::array<std::string_view, 8> names{"coordinate that is not finite",
                                                  "triangle without area",
                                                  "open edge",
                                                  "edge with more than two triangles",
                                                  "edge with inconsistent orientation",
                                                  "pinched vertex",
                                                  "self-intersection",
                                                  "mesh turned inside out"};
  return names[static_cast<std::size_t>(defect)];
}

Audit audit(const TriangleMesh& welded) {
  return Auditor(welded).run();
}

}  // namespace latticast
