// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/swept_cell.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "design/units.h"
#include "model/cell/cell_materials.h"
#include "model/cell/strip_grid.h"

namespace latticast {
namespace {

constexpr double on_end_mm = 1e-6;

/// Radii of the elements' faces and middles, from the bore outwards.
std::vector<double> levels_mm(const Segment& segment, const SweptDivision& division) {
  std::vector<double> r = {segment.inner_radius_mm()};
  append_steps(r, segment.liner_outer_radius_mm(), division.liner, 1 / division.grading);
  append_steps(r, segment.outer_radius_mm(), division.lattice, 1);
  return with_middles(r);
}

class SweptCellBuilder {
 public:
  SweptCellBuilder(const Segment& segment, const PeriodMesh& plane, const SweptPeriod& period,
                   const SweptDivision& division)
      : plane_(plane),
        period_(period),
        drawn_radius_mm_(segment.lattice_mid_radius_mm()),
        levels_mm_(levels_mm(segment, division)),
        liner_(division.liner) {
    mesh_.materials =
        cell_materials(segment.liner.material.law, std::get<Linear>(segment.lattice->material.law));
    mesh_.inner_radius_mm = segment.inner_radius_mm();
    mesh_.per_mm = period.repeats / (plane.box.z_to_mm - plane.box.z_from_mm);
  }

  CellMesh build() {
    const auto layers = static_cast<int>(levels_mm_.size() / 2);
    for (int k = 0; k < layers; ++k) {
      for (std::uint32_t t = 0; t < plane_.triangles.size(); ++t) {
        if (k >= liner_ && plane_.triangles[t].layers == 0) continue;
        add_wedge(t, k);
      }
    }
    if (period_.repeats == 1) find_axis();
    return std::move(mesh_);
  }

 private:
  void add_wedge(std::uint32_t t, int layer) {
    CellWedge wedge;
    wedge.material = layer < liner_ ? cell_liner : cell_lattice;
    for (int level = 0; level < 3; ++level) {
      for (std::size_t p = 0; p < 7; ++p) {
        wedge.nodes[p + 7 * static_cast<std::size_t>(level)] = node(t, p, 2 * layer + level);
      }
    }
    if (layer == 0) {
      BoreTriangle face{};
      std::copy_n(wedge.nodes.begin(), 7, face.begin());
      mesh_.bore_triangles.push_back(face);
    }
    mesh_.wedges.push_back(wedge);
  }

  struct CylinderPlace {
    double radius_mm = 0;
    double angle_rad = 0;
    double height_mm = 0;
  };

  CylinderPlace place(PlanePoint at, int level) const {
    return {levels_mm_[static_cast<std::size_t>(level)], at.u / drawn_radius_mm_, at.z};
  }

  /// Where the six other nodes' quadratic map has its centre, so that the map has no bubble.
  CylinderPlace centre(const PeriodMesh::Triangle& triangle, int level) const {
    std::array<double, 3> sum{};
    for (std::size_t p = 0; p < 6; ++p) {
      const CylinderPlace at = place(plane_.nodes[triangle.nodes[p]].at, level);
      const double share = p < 3 ? -1.0 / 9 : 4.0 / 9;
      sum[0] += share * at.radius_mm * std::cos(at.angle_rad);
      sum[1] += share * at.radius_mm * std::sin(at.angle_rad);
      sum[2] += share * at.height_mm;
    }
    return {std::hypot(sum[0], sum[1]), std::atan2(sum[1], sum[0]), sum[2]};
  }

  /// Plane nodes by their number, then centres by their triangle's.
  std::int32_t node(std::uint32_t t, std::size_t p, int level) {
    const PeriodMesh::Triangle& triangle = plane_.triangles[t];
    const auto count = static_cast<std::uint32_t>(plane_.nodes.size());
    const std::uint32_t number = p < 6 ? triangle.nodes[p] : count + t;
    const auto [found, is_new] =
        numbers_.try_emplace({number, level}, static_cast<std::int32_t>(mesh_.nodes.size()));
    if (!is_new) return found->second;
    const CylinderPlace at =
        p < 6 ? place(plane_.nodes[number].at, level) : centre(triangle, level);
    const std::uint32_t image = p < 6 ? plane_.nodes[number].image : number;
    mesh_.nodes.push_back({.radius_mm = at.radius_mm,
                           .angle_rad = at.angle_rad,
                           .height_mm = at.height_mm,
                           .unknown = unknowns_of(image, at.height_mm, level)});
    return found->second;
  }

  using Unknowns = std::array<NodeUnknown, 3>;

  Unknowns unknowns_of(std::uint32_t image, double height_mm, int level) {
    const auto [found, is_new] = first_unknown_.try_emplace({image, level}, Unknowns{});
    if (is_new) found->second = new_unknowns(height_mm);
    return found->second;
  }

  /// A mirror's nodes stay in its plane. What no symmetry holds, turning about the axis and moving
  /// along it, the first node does without.
  Unknowns new_unknowns(double height_mm) {
    const bool in_mirror =
        period_.mirrored && (std::abs(height_mm - plane_.box.z_from_mm) < on_end_mm ||
                             std::abs(height_mm - plane_.box.z_to_mm) < on_end_mm);
    const bool is_first = mesh_.unknowns == 0;
    Unknowns unknowns;
    unknowns[0].number = mesh_.unknowns++;
    if (!is_first || period_.repeats == 1) unknowns[1].number = mesh_.unknowns++;
    if (!in_mirror && !is_first) unknowns[2].number = mesh_.unknowns++;
    return unknowns;
  }

  /// The bore's circle at the lower end, each node with the share of it that is nearest.
  void find_axis() {
    std::vector<std::pair<double, std::int32_t>> circle;
    for (const auto& [key, number] : numbers_) {
      const auto& [plane_node, level] = key;
      if (level != 0 || plane_node >= plane_.nodes.size()) continue;
      const PlanePoint at = plane_.nodes[plane_node].at;
      if (std::abs(at.z - plane_.box.z_from_mm) > on_end_mm) continue;
      circle.emplace_back(at.u, number);
    }
    std::sort(circle.begin(), circle.end());
    const double around = plane_.box.width_mm;
    circle.pop_back();  // the first one's image
    const std::size_t n = circle.size();
    for (std::size_t i = 0; i < n; ++i) {
      const double before = i > 0 ? circle[i - 1].first : circle[n - 1].first - around;
      const double after = i + 1 < n ? circle[i + 1].first : circle[0].first + around;
      mesh_.centred.push_back({circle[i].second, 0.5 * (after - before) / around});
    }
  }

  const PeriodMesh& plane_;
  SweptPeriod period_;
  double drawn_radius_mm_;
  std::vector<double> levels_mm_;
  int liner_;
  CellMesh mesh_;
  std::map<std::pair<std::uint32_t, int>, std::int32_t> numbers_;
  std::map<std::pair<std::uint32_t, int>, Unknowns> first_unknown_;
};

class SweptWedgeBuilder {
 public:
  SweptWedgeBuilder(const Segment& segment, const PeriodMesh& plane, int sectors,
                    const SweptDivision& division)
      : plane_(plane),
        drawn_radius_mm_(segment.lattice_mid_radius_mm()),
        levels_mm_(levels_mm(segment, division)),
        liner_(division.liner) {
    mesh_.sectors = sectors;
    mesh_.length_mm = segment.length_mm;
    mesh_.inner_radius_mm = segment.inner_radius_mm();
  }

  WedgeMesh build() {
    const auto layers = static_cast<int>(levels_mm_.size() / 2);
    for (int k = 0; k < layers; ++k) {
      for (const PeriodMesh::Triangle& triangle : plane_.triangles) {
        if (k < liner_ || triangle.layers != 0) add_wedge(triangle, k);
      }
    }
    if (mesh_.sectors > 1) add_ties();
    return std::move(mesh_);
  }

 private:
  void add_wedge(const PeriodMesh::Triangle& triangle, int layer) {
    Wedge wedge{.part = layer < liner_ ? WedgePart::liner : WedgePart::lattice};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t corner = triangle.nodes[c];
      const std::uint32_t middle = triangle.nodes[3 + c];
      wedge.nodes[c] = node(corner, 2 * layer);
      wedge.nodes[3 + c] = node(corner, 2 * layer + 2);
      wedge.nodes[6 + c] = node(middle, 2 * layer);
      wedge.nodes[9 + c] = node(middle, 2 * layer + 2);
      wedge.nodes[12 + c] = node(corner, 2 * layer + 1);
    }
    if (layer == 0) mesh_.bore.push_back(static_cast<std::int32_t>(mesh_.wedges.size()));
    if (layer == liner_) {
      for (const std::size_t n : {0, 1, 2, 6, 7, 8}) bond(wedge.nodes[n]);
    }
    mesh_.wedges.push_back(wedge);
  }

  void bond(std::int32_t node) {
    if (bonded_.insert(node).second) mesh_.bond.push_back(node);
  }

  /// Of a whole tube, both sides of the plane are one.
  std::int32_t node(std::uint32_t plane_node, int level) {
    if (mesh_.sectors == 1) plane_node = plane_.nodes[plane_node].image;
    const auto [found, is_new] =
        numbers_.try_emplace({plane_node, level}, static_cast<std::int32_t>(mesh_.nodes.size()));
    if (!is_new) return found->second;
    const PlanePoint at = plane_.nodes[plane_node].at;
    const double radius = levels_mm_[static_cast<std::size_t>(level)];
    const double angle = at.u / drawn_radius_mm_;
    mesh_.nodes.push_back({radius * std::cos(angle), radius * std::sin(angle), at.z});
    if (at.z < on_end_mm) mesh_.base.push_back(found->second);
    if (at.z > mesh_.length_mm - on_end_mm) mesh_.tip.push_back(found->second);
    return found->second;
  }

  void add_ties() {
    for (const auto& [key, far] : numbers_) {
      const auto& [plane_node, level] = key;
      const std::uint32_t image = plane_.nodes[plane_node].image;
      if (image != plane_node) mesh_.ties.emplace_back(numbers_.at({image, level}), far);
    }
  }

  const PeriodMesh& plane_;
  double drawn_radius_mm_;
  std::vector<double> levels_mm_;
  int liner_;
  WedgeMesh mesh_;
  std::map<std::pair<std::uint32_t, int>, std::int32_t> numbers_;
  std::set<std::int32_t> bonded_;
};

}  // namespace

WedgeMesh swept_wedges(const Segment& segment, const PeriodMesh& plane, int sectors,
                       const SweptDivision& division) {
  return SweptWedgeBuilder(segment, plane, sectors, division).build();
}

CellMesh swept_cell(const Segment& segment, const PeriodMesh& plane, const SweptPeriod& period,
                    const SweptDivision& division) {
  return SweptCellBuilder(segment, plane, period, division).build();
}

}  // namespace latticast
