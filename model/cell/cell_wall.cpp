// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/cell_wall.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "geometry/mesh/point_algebra.h"
#include "model/cell/element_energy.h"
#include "model/numerics/small_matrix.h"

namespace latticast {
namespace {

using Displacements = std::vector<std::array<double, 3>>;
constexpr std::int32_t lattice_material = 1;
constexpr double same_radius = 1e-3;  // by itself: a middle may lie off its corners' circle

/// Where nodes lie: under a member, in a gap, elsewhere.
enum class Place { inside, gap, member };

bool is_at(double radius_mm, double asked_mm) {
  return std::abs(radius_mm - asked_mm) <= same_radius * asked_mm;
}

// An element's first node is a corner at its inner face.
double liner_outside_mm(const CellMesh& mesh) {
  double radius = HUGE_VAL;
  const auto look = [&](const auto& elements) {
    for (const auto& element : elements) {
      if (element.material != lattice_material) continue;
      radius = std::min(radius, mesh.nodes[element.nodes.front()].radius_mm);
    }
  };
  look(mesh.hexahedra);
  look(mesh.wedges);
  return radius;
}

std::vector<Place> places(const CellMesh& mesh) {
  const double outside = liner_outside_mm(mesh);
  std::vector<Place> found(mesh.nodes.size(), Place::inside);
  for (std::size_t n = 0; n < found.size(); ++n) {
    if (is_at(mesh.nodes[n].radius_mm, outside)) found[n] = Place::gap;
  }
  const auto mark = [&](const auto& elements) {
    for (const auto& element : elements) {
      if (element.material != lattice_material) continue;
      for (const std::int32_t node : element.nodes) {
        if (found[node] == Place::gap) found[node] = Place::member;
      }
    }
  };
  mark(mesh.hexahedra);
  mark(mesh.wedges);
  return found;
}

/// How far the nodes of the liner's outside have come out.
struct Growth {
  double angle_rad = 0;
  double mm = 0;
  Place place = Place::gap;
};

std::vector<Growth> growths(const CellMesh& mesh, const std::vector<Place>& places,
                            const Displacements& moved) {
  std::vector<Growth> found;
  for (std::size_t n = 0; n < places.size(); ++n) {
    if (places[n] == Place::inside) continue;
    const CellNode& node = mesh.nodes[n];
    const double now = std::hypot(node.radius_mm + moved[n][0], moved[n][1]);
    found.push_back({node.angle_rad, now - node.radius_mm, places[n]});
  }
  return found;
}

/// Takes out of the growths what a bent section does to a wall as a whole: their first harmonic.
void level(std::vector<Growth>& growths) {
  std::vector<double> normal(9);
  std::vector<double> right(3);
  for (const Growth& growth : growths) {
    if (growth.place != Place::member) continue;
    const std::array<double, 3> form = {1, std::cos(growth.angle_rad), std::sin(growth.angle_rad)};
    for (std::size_t i = 0; i < 3; ++i) {
      right[i] += form[i] * growth.mm;
      for (std::size_t j = 0; j < 3; ++j) normal[3 * j + i] += form[i] * form[j];
    }
  }
  solve_in_place(normal, right);
  for (Growth& growth : growths) {
    growth.mm -= right[1] * std::cos(growth.angle_rad) + right[2] * std::sin(growth.angle_rad);
  }
}

double bulge_mm(const std::vector<Growth>& growths) {
  double highest = -HUGE_VAL;
  double lowest = HUGE_VAL;
  for (const Growth& growth : growths) {
    if (growth.place == Place::gap) highest = std::max(highest, growth.mm);
    if (growth.place == Place::member) lowest = std::min(lowest, growth.mm);
  }
  return std::max(0.0, highest - lowest);
}

/// The largest principal stretch.
double largest_stretch(const Tensor& f) {
  std::array<double, 9> squared{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) squared[3 * i + j] += f[3 * k + i] * f[3 * k + j];
    }
  }
  std::array<double, 3> values{};
  symmetric_eigenvalues(squared, values);
  return std::sqrt(values[2]);
}

Point times(const Tensor& tensor, const Point& vector) {
  Point result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i] += tensor[3 * i + j] * vector[j];
  }
  return result;
}

/// Values that stand for shares of a part.
class Spread {
 public:
  void add(double value, double share) { values_.emplace_back(value, share); }

  /// What a hundredth of the part exceeds; zero where there is nothing.
  double exceeded_by_a_hundredth() {
    double rest = 0;
    for (const auto& [value, share] : values_) rest += 0.01 * share;
    std::sort(values_.begin(), values_.end(), std::greater<>());
    for (const auto& [value, share] : values_) {
      rest -= share;
      if (rest <= 0) return value;
    }
    return 0;
  }

  double mean() const {
    double sum = 0;
    double whole = 0;
    for (const auto& [value, share] : values_) {
      sum += value * share;
      whole += share;
    }
    return whole > 0 ? sum / whole : 0;
  }

 private:
  std::vector<std::pair<double, double>> values_;
};

struct WallSpreads {
  Spread lattice_strain, liner_strain, bond_shear, bond_pull;
};

/// Of the surface that was square to the radius at rest.
void add_traction(const ElementPoint& point, WallSpreads& wall) {
  const double radius = std::hypot(point.place[0], point.place[1]);
  const Point outward = {point.place[0] / radius, point.place[1] / radius, 0};
  const Point force = times(point.stress, outward);
  const Point area = times(volume_ratio(point.gradient).cofactor, outward);
  const double size = length(area);
  const double pull = dot(force, area) / (size * size);
  const Point along = moved(force, area, -pull / size);
  // All of them stand for one share of the liner's thickness.
  wall.bond_shear.add(length(along) / size, point.volume_mm3);
  wall.bond_pull.add(pull, point.volume_mm3);
}

/// Whether all of an element's nodes on the liner's outside lie under a member, and some do.
template <class Element>
bool is_bonded(const Element& element, const std::vector<Place>& places) {
  const auto count = [&](Place place) {
    return std::count_if(element.nodes.begin(), element.nodes.end(),
                         [&](std::int32_t node) { return places[node] == place; });
  };
  return element.material != lattice_material && count(Place::member) > 0 && count(Place::gap) == 0;
}

/// False where an element cannot be evaluated.
template <std::size_t N>
bool add_elements(const CellMesh& mesh, const std::vector<CellElement<N>>& elements,
                  const std::vector<Place>& places, const Displacements& moved,
                  const TubeStrain& strain, WallSpreads& wall) {
  for (const CellElement<N>& element : elements) {
    std::array<std::array<double, 3>, N> displacement;
    for (std::size_t a = 0; a < N; ++a) displacement[a] = moved[element.nodes[a]];
    const auto points = element_points<N>(mesh, element, displacement, strain);
    if (points.empty()) return false;
    Spread& strains =
        element.material == lattice_material ? wall.lattice_strain : wall.liner_strain;
    const bool bonded = is_bonded(element, places);
    for (const ElementPoint& point : points) {
      strains.add(largest_stretch(point.gradient) - 1, point.volume_mm3);
      // The third coordinate leads outwards; three points along it.
      if (bonded && point.own[2] > 0.5) add_traction(point, wall);
    }
  }
  return true;
}

}  // namespace

CellWalls::CellWalls(const UnitCell& cell)
    : mesh_(cell.fine), bends_(cell.bends), cell_(cell.fine) {}

std::optional<CellWall> CellWalls::at(const Deformation& deformation) {
  if (!cell_.at(deformation)) return std::nullopt;
  const Displacements moved = cell_.displacements();
  const std::vector<Place> found = places(mesh_);
  std::vector<Growth> grown = growths(mesh_, found, moved);
  if (bends_) level(grown);
  const TubeStrain strain = cell_.tube_strain();
  WallSpreads spreads;
  if (!add_elements(mesh_, mesh_.hexahedra, found, moved, strain, spreads)) return std::nullopt;
  if (!add_elements(mesh_, mesh_.wedges, found, moved, strain, spreads)) return std::nullopt;
  return CellWall{.bulge_mm = bulge_mm(grown),
                  .lattice_strain = spreads.lattice_strain.exceeded_by_a_hundredth(),
                  .liner_strain = spreads.liner_strain.exceeded_by_a_hundredth(),
                  .bond_shear_mpa = spreads.bond_shear.mean(),
                  .bond_pull_mpa = spreads.bond_pull.mean()};
}

}  // namespace latticast
