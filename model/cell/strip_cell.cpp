// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/strip_cell.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "design/units.h"
#include "model/cell/cell_materials.h"
#include "model/cell/strip_grid.h"

namespace latticast {
namespace {

/// The cell's grid: t around the tube, following the strip, from one edge of a strip to that of the
/// next; z along it from the middle of a ring to the middle between two; r through the wall.
struct CellGrid {
  std::vector<double> t_rad;
  std::vector<double> z_mm;
  std::vector<double> r_mm;
  std::vector<char> strip;  // by elements in t
  std::vector<char> ring;   // in z
  int liner = 0;            // elements in r

  std::size_t steps_t() const { return t_rad.size() - 1; }
};

CellGrid grid_of(const StripTube& tube, const StripDivision& division) {
  CellGrid grid;
  const double radius = 0.5 * (tube.liner_outer_radius_mm + tube.outer_radius_mm);
  const double strip = 0.5 * tube.strip_width_mm / (std::sin(tube.angle_rad) * radius);
  std::vector<double> t = {-strip};
  append_steps(t, strip, division.strip, 1);
  append_graded(t, 2 * pi / tube.strips - strip, division.gap, division.grading);
  grid.t_rad = with_middles(t);
  for (int i = 0; i < division.strip + division.gap; ++i) {
    grid.strip.push_back(i < division.strip ? 1 : 0);
  }
  const int ring = tube.ring_width_mm > 0 ? division.ring : 0;
  std::vector<double> z = {0};
  if (ring > 0) append_steps(z, 0.5 * tube.ring_width_mm, ring, 1);
  append_steps(z, 0.5 * tube.pitch_mm, division.span, ring > 0 ? division.grading : 1);
  for (int i = 0; i < ring + division.span; ++i) grid.ring.push_back(i < ring ? 1 : 0);
  if (division.whole) {
    for (std::size_t i = z.size() - 1; i-- > 0;) z.push_back(tube.pitch_mm - z[i]);
    for (std::size_t i = grid.ring.size(); i-- > 0;) grid.ring.push_back(grid.ring[i]);
  }
  grid.z_mm = with_middles(z);
  std::vector<double> r = {tube.inner_radius_mm};
  append_steps(r, tube.liner_outer_radius_mm, division.liner, 1 / division.grading);
  append_steps(r, tube.outer_radius_mm, division.lattice, 1);
  grid.r_mm = with_middles(r);
  grid.liner = division.liner;
  return grid;
}

/// Builds nodes as elements ask for them.
class StripCellBuilder {
 public:
  StripCellBuilder(const StripTube& tube, const StripDivision& division)
      : tube_(tube), grid_(grid_of(tube, division)), whole_(division.whole) {
    const double radius = 0.5 * (tube.liner_outer_radius_mm + tube.outer_radius_mm);
    const bool axial = std::abs(tube.angle_rad - 0.5 * pi) < 1e-12;
    strip_elements_ = static_cast<std::size_t>(division.strip);
    turn_rad_per_mm_ = axial ? 0 : 1 / (std::tan(tube.angle_rad) * radius);
  }

  CellMesh build() {
    for (std::size_t k = 0; 2 * k + 2 < grid_.r_mm.size(); ++k) {
      for (std::size_t j = 0; 2 * j + 2 < grid_.z_mm.size(); ++j) {
        for (std::size_t i = 0; 2 * i + 2 < grid_.t_rad.size(); ++i) add_element(i, j, k);
      }
    }
    mesh_.materials = cell_materials(tube_.liner, tube_.lattice);
    mesh_.inner_radius_mm = tube_.inner_radius_mm;
    mesh_.per_mm = (whole_ ? 1 : 2) * tube_.strips / tube_.pitch_mm;
    return std::move(mesh_);
  }

 private:
  void add_element(std::size_t i, std::size_t j, std::size_t k) {
    const bool in_liner = static_cast<int>(k) < grid_.liner;
    if (!in_liner && grid_.strip[i] == 0 && grid_.ring[j] == 0) return;
    CellHexahedron element;
    element.material = in_liner ? cell_liner : cell_lattice;
    std::size_t place = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t b = 0; b < 3; ++b) {
        for (std::size_t a = 0; a < 3; ++a) {
          element.nodes[place++] = node(2 * i + a, 2 * j + b, 2 * k + c);
        }
      }
    }
    mesh_.hexahedra.push_back(element);
    if (k > 0) return;
    std::array<std::int32_t, 9> face{};
    std::copy_n(element.nodes.begin(), 9, face.begin());
    mesh_.bore_quadrilaterals.push_back(face);
  }

  /// Numbers of a node on the grid; the one at its far side in t is the near side's image.
  std::int32_t node(std::size_t i, std::size_t j, std::size_t k) {
    const auto [found, is_new] =
        numbers_.try_emplace({i, j, k}, static_cast<std::int32_t>(mesh_.nodes.size()));
    if (!is_new) return found->second;
    CellNode node{.radius_mm = grid_.r_mm[k],
                  .angle_rad = grid_.t_rad[i] + turn_rad_per_mm_ * grid_.z_mm[j],
                  .height_mm = grid_.z_mm[j],
                  .unknown = unknowns_of(i, j, k)};
    mesh_.nodes.push_back(node);
    return found->second;
  }

  std::array<NodeUnknown, 3> unknowns_of(std::size_t i, std::size_t j, std::size_t k) {
    const std::size_t steps = grid_.steps_t();
    i %= steps;
    if (whole_) return unknowns_of_whole(i, j % (grid_.z_mm.size() - 1), k);
    const bool on_axis = j == 0 || j + 1 == grid_.z_mm.size();
    // Half a turn about the strip's middle, which is node `strip` of the grid.
    const std::size_t partner = (2 * strip_elements_ + steps - i) % steps;
    const bool turned = on_axis && partner < i;
    const bool own_image = on_axis && partner == i;
    const std::array<std::size_t, 3> key = {turned ? partner : i, j, k};
    const auto [found, is_new] = first_unknown_.try_emplace(key, mesh_.unknowns);
    if (is_new) mesh_.unknowns += own_image ? 1 : 3;
    const std::int32_t first = found->second;
    if (own_image) return {{{first, 1}, {-1, 1}, {-1, 1}}};
    const double sign = turned ? -1 : 1;
    return {{{first, 1}, {first + 1, sign}, {first + 2, sign}}};
  }

  /// One node keeps its place along and around the tube, which nothing else holds.
  std::array<NodeUnknown, 3> unknowns_of_whole(std::size_t i, std::size_t j, std::size_t k) {
    const auto [found, is_new] = first_unknown_.try_emplace({i, j, k}, mesh_.unknowns);
    const bool is_held = i == 0 && j == 0 && k == 0;
    if (is_new) mesh_.unknowns += is_held ? 1 : 3;
    const std::int32_t first = found->second;
    if (is_held) return {{{first, 1}, {-1, 1}, {-1, 1}}};
    return {{{first, 1}, {first + 1, 1}, {first + 2, 1}}};
  }

  StripTube tube_;
  CellGrid grid_;
  bool whole_ = false;
  double turn_rad_per_mm_ = 0;
  std::size_t strip_elements_ = 0;
  CellMesh mesh_;
  std::map<std::array<std::size_t, 3>, std::int32_t> numbers_;
  std::map<std::array<std::size_t, 3>, std::int32_t> first_unknown_;
};

}  // namespace

CellMesh strip_cell(const StripTube& tube, const StripDivision& division) {
  return StripCellBuilder(tube, division).build();
}

}  // namespace latticast
