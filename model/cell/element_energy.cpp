// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/element_energy.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "geometry/mesh/point_algebra.h"
#include "model/cell/element_shape.h"
#include "model/cell/point_energy.h"
#include "model/cell/symmetric_product.h"

namespace latticast {
namespace {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
constexpr int pressures = 4;  // 1, xi, eta, zeta

using Pressures = Eigen::Matrix<double, pressures, 1>;
using PressureMatrix = Eigen::Matrix<double, pressures, pressures>;

constexpr std::size_t largest_size = ElementEnergy<27>::size;

// Axes that k, kappa_1 and kappa_2 turn about.
constexpr std::array<int, 3> axis_of = {2, 0, 1};

/// Columns: the radial, tangential and axial direction at a node's rest angle.
Matrix3 frame_of(const CellNode& node) {
  const double cosine = std::cos(node.angle_rad);
  const double sine = std::sin(node.angle_rad);
  Matrix3 frame;
  frame << cosine, -sine, 0, sine, cosine, 0, 0, 0, 1;
  return frame;
}

Matrix3 cross_matrix(const Vector3& omega) {
  Matrix3 matrix;
  matrix << 0, -omega[2], omega[1], omega[2], 0, -omega[0], -omega[1], omega[0], 0;
  return matrix;
}

/// A node at rest and now, in the section's frame.
struct PlacedNode {
  Matrix3 frame;
  Vector3 rest;
  Vector3 place;
};

PlacedNode placed(const CellNode& node, const std::array<double, 3>& displacement) {
  PlacedNode result{frame_of(node), {}, {}};
  const Vector3 radial = result.frame.col(0) * node.radius_mm;
  result.rest = radial + Vector3(0, 0, node.height_mm);
  result.place = radial + result.frame * Eigen::Map<const Vector3>(displacement.data());
  return result;
}

/// Row-major rows of `width` doubles, the first `size` of them used.
struct Rows {
  double* first;
  std::size_t size;
  std::size_t width;

  double* row(std::size_t i) const { return first + i * width; }
};

/// result += factors rows: a row vector times the first rows.
void add_combined(std::span<const double> factors, double share, const Rows& rows, double* result) {
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const double factor = share * factors[i];
    const double* row = rows.row(i);
    for (std::size_t j = 0; j < rows.size; ++j) result[j] += factor * row[j];
  }
}

/// What a Gauss point stands for, and F there.
struct StrainAtPoint {
  double volume = 0;
  Tensor gradient{};
  VolumeRatio ratio;
};

/// What one evaluation needs room for; kept from one element to the next.
struct Scratch {
  std::vector<PlacedNode> nodes;
  std::vector<Vector3> slopes;  // of the shapes, by rest places
  std::vector<StrainAtPoint> points;
  std::vector<double> by_unknowns;  // of F, nine rows a point, then of the dilations
  std::vector<double> weighted;     // the same, times tangents
  std::vector<double> product;
};

struct Deformed {
  Matrix3 gradient;
  Vector3 place;
};

/// F and y; fills in the slopes by rest places.
Deformed deformed(const ShapeAtPoint& shape, const TubeStrain& strain, Scratch& scratch,
                  double& volume) {
  Matrix3 map = Matrix3::Zero();  // dX_i/dxi_j
  for (std::size_t a = 0; a < scratch.nodes.size(); ++a) {
    map += scratch.nodes[a].rest * Eigen::Map<const Vector3>(shape.slope[a].data()).transpose();
  }
  volume = shape.weight * map.determinant();
  const Matrix3 back = map.inverse().transpose();
  Deformed at{Matrix3::Zero(), Vector3::Zero()};
  for (std::size_t a = 0; a < scratch.nodes.size(); ++a) {
    scratch.slopes[a] = back * Eigen::Map<const Vector3>(shape.slope[a].data());
    at.gradient += scratch.nodes[a].place * scratch.slopes[a].transpose();
    at.place += shape.value[a] * scratch.nodes[a].place;
  }
  const Vector3 omega(strain[2], strain[3], strain[1]);
  at.gradient.col(2) += omega.cross(at.place) + Vector3(0, 0, 1 + strain[0]);
  return at;
}

/// How F depends on the unknowns: its nine entries, rows of F one after the other.
void differentiate(const ShapeAtPoint& shape, const TubeStrain& strain, const Vector3& place,
                   const Scratch& scratch, const Rows& by) {
  const Matrix3 turning = cross_matrix({strain[2], strain[3], strain[1]});
  for (std::size_t a = 0; a < scratch.nodes.size(); ++a) {
    const Matrix3& frame = scratch.nodes[a].frame;
    const Matrix3 turned = shape.value[a] * (turning * frame);
    const Vector3& slope = scratch.slopes[a];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        double* entry = by.row(3 * i + j) + 3 * a;
        for (int c = 0; c < 3; ++c) entry[c] = frame(i, c) * slope[j];
      }
      double* last = by.row(3 * i + 2) + 3 * a;
      for (int c = 0; c < 3; ++c) last[c] += turned(i, c);
    }
  }
  const std::size_t own = by.size - tube_strains;
  for (std::size_t i = 0; i < 9; ++i) std::fill_n(by.row(i) + own, tube_strains, 0);
  by.row(8)[own] = 1;
  for (std::size_t m = 0; m < 3; ++m) {
    const Vector3 moved = Vector3::Unit(axis_of[m]).cross(place);
    for (int i = 0; i < 3; ++i) by.row(3 * i + 2)[own + 1 + m] = moved[i];
  }
}

/// Adds what the stress does through F's own curvature: the tube turns what the nodes move.
void add_turning(const ShapeAtPoint& shape, std::span<const PlacedNode> nodes, const Tensor& stress,
                 double volume, const Rows& hessian) {
  const Vector3 pull(stress[2], stress[5], stress[8]);
  const std::size_t own = hessian.size - tube_strains;
  for (std::size_t m = 0; m < 3; ++m) {
    // pull . (e_m x d) = d . (pull x e_m)
    const Vector3 lever = pull.cross(Vector3::Unit(axis_of[m])) * volume;
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const Vector3 by = shape.value[a] * (nodes[a].frame.transpose() * lever);
      for (int c = 0; c < 3; ++c) {
        hessian.row(3 * a + static_cast<std::size_t>(c))[own + 1 + m] += by[c];
      }
    }
  }
}

/// The dilation J - 1 by the functions of an element's pressure.
struct Dilation {
  PressureMatrix mass = PressureMatrix::Zero();
  Pressures value = Pressures::Zero();
};

Pressures basis(const ShapeAtPoint& point) {
  return {1, point.place[0], point.place[1], point.place[2]};
}

Rows rows_at(std::vector<double>& matrix, std::size_t row, std::size_t size, std::size_t width) {
  return {matrix.data() + row * width, size, width};
}

/// Evaluates F and the dilation, with derivatives. Empty where a point is turned inside out.
std::optional<Dilation> dilate(const ElementShape& shape, const TubeStrain& strain,
                               std::size_t size, std::size_t width, Scratch& scratch) {
  Dilation dilation;
  const std::size_t count = shape.points.size();
  const Rows by_unknowns = rows_at(scratch.by_unknowns, 9 * count, size, width);
  std::fill_n(by_unknowns.first, pressures * width, 0);
  std::array<double, largest_size> by{};
  for (std::size_t g = 0; g < count; ++g) {
    const ShapeAtPoint& point = shape.points[g];
    StrainAtPoint& at = scratch.points[g];
    const Deformed now = deformed(point, strain, scratch, at.volume);
    for (int i = 0; i < 9; ++i) at.gradient[i] = now.gradient(i / 3, i % 3);
    at.ratio = volume_ratio(at.gradient);
    if (!(at.ratio.value > 0) || !(at.volume > 0)) return std::nullopt;
    const Rows rows = rows_at(scratch.by_unknowns, 9 * g, size, width);
    differentiate(point, strain, now.place, scratch, rows);
    const Pressures phi = at.volume * basis(point);
    dilation.mass += phi * basis(point).transpose();
    dilation.value += (at.ratio.value - 1) * phi;
    by.fill(0);
    add_combined(at.ratio.cofactor, 1, rows, by.data());
    for (int i = 0; i < pressures; ++i) {
      double* row = by_unknowns.row(i);
      for (std::size_t j = 0; j < size; ++j) row[j] += phi[i] * by[j];
    }
  }
  return dilation;
}

void make_room(const ElementShape& shape, std::size_t width, Scratch& scratch) {
  const std::size_t nodes = shape.nodes;
  const std::size_t rows = 9 * shape.points.size() + pressures;
  scratch.nodes.resize(nodes);
  scratch.slopes.resize(nodes);
  scratch.points.resize(shape.points.size());
  // Columns beyond an element's own are never written: they stay zero.
  if (scratch.by_unknowns.size() == rows * width) return;
  scratch.by_unknowns.assign(rows * width, 0);
  scratch.weighted.assign(rows * width, 0);
  scratch.product.assign(width * width, 0);
}

/// Of an element whose nodes have been placed.
struct ElementParts {
  double& energy;
  double* gradient;
  Rows hessian;
  Pressures& pressure;
  Rows pressure_by;
};

/// Adds the strain energy of the points, and leaves their tangents' products in `weighted`.
template <std::size_t width>
bool add_points(const ElementShape& shape, const Law& law, const Pressures& weighing,
                Scratch& scratch, ElementParts& parts) {
  for (std::size_t g = 0; g < shape.points.size(); ++g) {
    const ShapeAtPoint& at_point = shape.points[g];
    const StrainAtPoint& at = scratch.points[g];
    auto point = isochoric_energy(law, at.gradient);
    if (!point) return false;
    parts.energy += at.volume * point->energy;
    const double p = weighing.dot(basis(at_point));
    add_volume_curvature(at.gradient, p, point->tangent);
    const Rows rows = rows_at(scratch.by_unknowns, 9 * g, parts.hessian.size, width);
    tangent_product<width>(point->tangent.data(), at.volume, rows.first,
                           scratch.weighted.data() + 9 * g * width);
    add_combined(point->stress, at.volume, rows, parts.gradient);
    Tensor whole{};
    for (std::size_t i = 0; i < 9; ++i) whole[i] = point->stress[i] + p * at.ratio.cofactor[i];
    add_turning(at_point, scratch.nodes, whole, at.volume, parts.hessian);
  }
  return true;
}

template <std::size_t width>
bool evaluate_placed(const ElementShape& shape, const CellMaterial& material,
                     const TubeStrain& strain, const ElementPressure* held, Scratch& scratch,
                     ElementParts& parts) {
  const std::size_t size = parts.hessian.size;
  const auto dilation = dilate(shape, strain, size, width, scratch);
  if (!dilation) return false;
  const PressureMatrix stiffness = material.bulk_modulus_mpa * dilation->mass.inverse();
  parts.pressure = stiffness * dilation->value;
  const std::size_t last = 9 * shape.points.size();
  const Rows by_unknowns = rows_at(scratch.by_unknowns, last, size, width);
  std::fill_n(parts.pressure_by.first, pressures * size, 0);
  for (int i = 0; i < pressures; ++i) {
    const Pressures row = stiffness.row(i);
    add_combined({row.data(), pressures}, 1, by_unknowns, parts.pressure_by.row(i));
    std::copy_n(parts.pressure_by.row(i), size, scratch.weighted.data() + (last + i) * width);
  }
  const Pressures weighing =
      held != nullptr ? Pressures(Eigen::Map<const Pressures>(held->data())) : parts.pressure;
  parts.energy = 0.5 * parts.pressure.dot(dilation->value);
  std::fill_n(parts.gradient, size, 0);
  add_combined({parts.pressure.data(), pressures}, 1, by_unknowns, parts.gradient);
  std::fill_n(parts.hessian.first, size * size, 0);
  if (!add_points<width>(shape, material.law, weighing, scratch, parts)) return false;
  symmetric_product<width>(scratch.by_unknowns.data(), scratch.weighted.data(), last + pressures,
                           scratch.product.data());
  for (std::size_t i = 0; i < size; ++i) {
    const double* product = scratch.product.data() + i * width;
    for (std::size_t j = 0; j < size; ++j) parts.hessian.row(i)[j] += product[j];
  }
  return true;
}

}  // namespace

namespace {

/// Room for an element of this size alone, for the columns that stay zero; its nodes placed.
template <std::size_t N>
Scratch& scratch_of(const CellMesh& mesh, const CellElement<N>& element,
                    const std::array<std::array<double, 3>, N>& displacement) {
  // On the heap: what a thread keeps for itself is set to zero when the program starts.
  thread_local const auto scratch = std::make_unique<Scratch>();
  make_room(shape_of<N>(), product_width(ElementEnergy<N>::size), *scratch);
  for (std::size_t a = 0; a < N; ++a) {
    scratch->nodes[a] = placed(mesh.nodes[element.nodes[a]], displacement[a]);
  }
  return *scratch;
}

}  // namespace

template <std::size_t N>
bool evaluate(const CellMesh& mesh, const CellElement<N>& element,
              const std::array<std::array<double, 3>, N>& displacement, const TubeStrain& strain,
              const ElementPressure* held, ElementEnergy<N>& result) {
  constexpr std::size_t size = ElementEnergy<N>::size;
  Scratch& scratch = scratch_of<N>(mesh, element, displacement);
  Pressures pressure;
  ElementParts parts{result.energy, result.gradient.data(), Rows{result.hessian.data(), size, size},
                     pressure, Rows{result.pressure_by.data(), size, size}};
  if (!evaluate_placed<product_width(size)>(shape_of<N>(), mesh.materials[element.material], strain,
                                            held, scratch, parts)) {
    return false;
  }
  Eigen::Map<Pressures>(result.pressure.data()) = pressure;
  return true;
}

template <std::size_t N>
std::vector<ElementPoint> element_points(const CellMesh& mesh, const CellElement<N>& element,
                                         const std::array<std::array<double, 3>, N>& displacement,
                                         const TubeStrain& strain) {
  constexpr std::size_t size = ElementEnergy<N>::size;
  const ElementShape& shape = shape_of<N>();
  const CellMaterial& material = mesh.materials[element.material];
  Scratch& scratch = scratch_of<N>(mesh, element, displacement);
  const auto dilation = dilate(shape, strain, size, product_width(size), scratch);
  if (!dilation) return {};
  const Pressures pressure =
      material.bulk_modulus_mpa * (dilation->mass.inverse() * dilation->value);
  std::vector<ElementPoint> points;
  points.reserve(shape.points.size());
  for (std::size_t g = 0; g < shape.points.size(); ++g) {
    const StrainAtPoint& at = scratch.points[g];
    const auto energy = isochoric_energy(material.law, at.gradient);
    if (!energy) return {};
    ElementPoint& point = points.emplace_back();
    point.volume_mm3 = at.volume;
    point.own = shape.points[g].place;
    point.gradient = at.gradient;
    const double p = pressure.dot(basis(shape.points[g]));
    for (std::size_t i = 0; i < 9; ++i) {
      point.stress[i] = energy->stress[i] + p * at.ratio.cofactor[i];
    }
    for (std::size_t a = 0; a < N; ++a) {
      const Vector3& rest = scratch.nodes[a].rest;
      for (int i = 0; i < 3; ++i) point.place[i] += shape.points[g].value[a] * rest[i];
    }
  }
  return points;
}

template std::vector<ElementPoint> element_points(const CellMesh&, const CellElement<27>&,
                                                  const std::array<std::array<double, 3>, 27>&,
                                                  const TubeStrain&);
template std::vector<ElementPoint> element_points(const CellMesh&, const CellElement<21>&,
                                                  const std::array<std::array<double, 3>, 21>&,
                                                  const TubeStrain&);
template bool evaluate(const CellMesh&, const CellElement<27>&,
                       const std::array<std::array<double, 3>, 27>&, const TubeStrain&,
                       const ElementPressure*, ElementEnergy<27>&);
template bool evaluate(const CellMesh&, const CellElement<21>&,
                       const std::array<std::array<double, 3>, 21>&, const TubeStrain&,
                       const ElementPressure*, ElementEnergy<21>&);

namespace {

/// y and its slopes along a face's two coordinates, and those of the rest height.
struct FacePoint {
  Point place{};
  std::array<Point, 2> slopes{};
  std::array<double, 2> height_slopes{};
};

/// Volume per area in the face's own coordinates, by its variables: y, y's slopes a and b along the
/// face's two coordinates, lambda, Omega in the order of a TubeStrain.
constexpr std::size_t face_numbers = 13;
struct CavityDensity {
  double value = 0;
  std::array<double, face_numbers> gradient{};
  std::array<std::array<double, face_numbers>, face_numbers> hessian{};
};

/// What a density is made of: c = rise_b a - rise_a b.
struct CavityTerms {
  Point y{}, a{}, b{}, c{}, omega{};
  double rise_a = 0, rise_b = 0;
  double stretch = 1;
  double cy = 0, oy = 0, co = 0, yy = 0;
};

CavityTerms cavity_terms(const FacePoint& point, const TubeStrain& strain) {
  CavityTerms t;
  t.y = point.place;
  t.a = point.slopes[0];
  t.b = point.slopes[1];
  t.omega = {strain[2], strain[3], strain[1]};
  t.rise_a = point.height_slopes[0];
  t.rise_b = point.height_slopes[1];
  t.stretch = 1 + strain[0];
  t.oy = dot(t.omega, t.y);
  t.yy = dot(t.y, t.y);
  for (std::size_t i = 0; i < 3; ++i) t.c[i] = t.rise_b * t.a[i] - t.rise_a * t.b[i];
  t.cy = dot(t.c, t.y);
  t.co = dot(t.c, t.omega);
  return t;
}

constexpr Point axis = {0, 0, 1};

void set_gradient(const CavityTerms& t, CavityDensity& density) {
  const Point ab = cross(t.a, t.b);
  const Point by = cross(t.b, t.y);
  const Point ya = cross(t.y, t.a);
  const Point c_axis = cross(t.c, axis);
  const Point axis_y = cross(axis, t.y);
  auto& g = density.gradient;
  for (std::size_t i = 0; i < 3; ++i) {
    const double by_c = (t.oy * t.y[i] - t.yy * t.omega[i]) / 3 + 0.5 * t.stretch * axis_y[i];
    g[i] = (ab[i] + t.cy * t.omega[i] + t.oy * t.c[i] - 2 * t.co * t.y[i]) / 3 +
           0.5 * t.stretch * c_axis[i];
    g[3 + i] = by[i] / 3 + t.rise_b * by_c;
    g[6 + i] = ya[i] / 3 - t.rise_a * by_c;
  }
  g[9] = 0.5 * dot(axis, cross(t.y, t.c));
  for (std::size_t m = 0; m < 3; ++m) {
    g[10 + m] = (t.cy * t.y[axis_of[m]] - t.yy * t.c[axis_of[m]]) / 3;
  }
}

/// Entry (i, j) of the matrix that multiplies as `vector x` does.
double cross_entry(const Point& vector, std::size_t i, std::size_t j) {
  if (i == j) return 0;
  const double entry = vector[3 - i - j];
  return (i + 1) % 3 == j ? -entry : entry;
}

/// By y, c, lambda and Omega first; a and b follow c.
void set_hessian(const CavityTerms& t, CavityDensity& density) {
  const Point c_axis = cross(t.c, axis);
  const Point axis_y = cross(axis, t.y);
  auto& h = density.hessian;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double one = i == j ? 1 : 0;
      const double yc = (t.omega[i] * t.y[j] + t.oy * one - 2 * t.y[i] * t.omega[j]) / 3 -
                        0.5 * t.stretch * cross_entry(axis, i, j);
      h[i][j] = (t.omega[i] * t.c[j] + t.c[i] * t.omega[j] - 2 * t.co * one) / 3;
      h[i][3 + j] = -cross_entry(t.b, i, j) / 3 + t.rise_b * yc;
      h[i][6 + j] = cross_entry(t.a, i, j) / 3 - t.rise_a * yc;
      h[3 + i][6 + j] = -cross_entry(t.y, i, j) / 3;
    }
    h[i][9] = 0.5 * c_axis[i];
    h[3 + i][9] = 0.5 * t.rise_b * axis_y[i];
    h[6 + i][9] = -0.5 * t.rise_a * axis_y[i];
    for (std::size_t m = 0; m < 3; ++m) {
      const std::size_t k = axis_of[m];
      const double one = i == k ? 1 : 0;
      const double co = (t.y[i] * t.y[k] - t.yy * one) / 3;
      h[i][10 + m] = (t.cy * one + t.c[i] * t.y[k] - 2 * t.y[i] * t.c[k]) / 3;
      h[3 + i][10 + m] = t.rise_b * co;
      h[6 + i][10 + m] = -t.rise_a * co;
    }
  }
  for (std::size_t i = 0; i < face_numbers; ++i) {
    for (std::size_t j = 0; j < i; ++j) h[i][j] = h[j][i];
  }
}

/// det[y, a, b]/3, plus with c = Z_b a - Z_a b, D along a curve of the face being d + dZ (Omega x
/// y),
///     y . (c x (Omega x y))/3 + lambda e3 . (y x c)/2.
CavityDensity cavity_density(const FacePoint& point, const TubeStrain& strain) {
  const CavityTerms t = cavity_terms(point, strain);
  CavityDensity density;
  set_gradient(t, density);
  set_hessian(t, density);
  density.value =
      (dot(t.y, cross(t.a, t.b)) + t.oy * t.cy - t.yy * t.co) / 3 + t.stretch * density.gradient[9];
  return density;
}

/// How a face point's variables depend on the unknowns, `size` columns wide.
void differentiate(const ShapeAtPoint& shape, std::span<const PlacedNode> nodes, const Rows& by) {
  std::fill_n(by.first, face_numbers * by.size, 0);
  const std::size_t own = by.size - tube_strains;
  for (std::size_t i = 0; i < tube_strains; ++i) by.row(9 + i)[own + i] = 1;
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const std::array<double, 3> shares = {shape.value[a], shape.slope[a][0], shape.slope[a][1]};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 3; ++i) {
        double* entry = by.row(3 * k + i) + 3 * a;
        for (std::size_t c = 0; c < 3; ++c) {
          entry[c] = shares[k] * nodes[a].frame(static_cast<int>(i), static_cast<int>(c));
        }
      }
    }
  }
}

/// The upper triangle of by^T (share * matrix) by.
void add_congruent(const CavityDensity& density, double share, const Rows& by,
                   const Rows& hessian) {
  std::array<double, largest_size> turned{};
  for (std::size_t k = 0; k < face_numbers; ++k) {
    turned.fill(0);
    add_combined(density.hessian[k], share, by, turned.data());
    const double* row = by.row(k);
    for (std::size_t i = 0; i < by.size; ++i) {
      if (row[i] == 0) continue;
      double* result = hessian.row(i);
      for (std::size_t j = i; j < by.size; ++j) result[j] += row[i] * turned[j];
    }
  }
}

}  // namespace

template <std::size_t N>
void evaluate(const CellMesh& mesh, const BoreFace<N>& face,
              const std::array<std::array<double, 3>, N>& displacement, const TubeStrain& strain,
              CavityPart<N>& result) {
  constexpr std::size_t size = CavityPart<N>::size;
  std::array<PlacedNode, N> nodes;
  for (std::size_t a = 0; a < N; ++a) nodes[a] = placed(mesh.nodes[face[a]], displacement[a]);
  result.gradient.fill(0);
  result.hessian.fill(0);
  result.volume_mm3 = 0;
  std::array<double, face_numbers * size> room;
  const Rows by{room.data(), size, size};
  for (const ShapeAtPoint& shape : shape_of<N>().points) {
    FacePoint point;
    for (std::size_t a = 0; a < N; ++a) {
      const Vector3& y = nodes[a].place;
      const Point place = {y[0], y[1], y[2]};
      point.place = moved(point.place, place, shape.value[a]);
      for (std::size_t i = 0; i < 2; ++i) {
        point.slopes[i] = moved(point.slopes[i], place, shape.slope[a][i]);
        point.height_slopes[i] += shape.slope[a][i] * mesh.nodes[face[a]].height_mm;
      }
    }
    const CavityDensity density = cavity_density(point, strain);
    differentiate(shape, nodes, by);
    result.volume_mm3 += shape.weight * density.value;
    add_combined(density.gradient, shape.weight, by, result.gradient.data());
    add_congruent(density, shape.weight, by, Rows{result.hessian.data(), size, size});
  }
}

template void evaluate(const CellMesh&, const BoreFace<9>&,
                       const std::array<std::array<double, 3>, 9>&, const TubeStrain&,
                       CavityPart<9>&);
template void evaluate(const CellMesh&, const BoreFace<7>&,
                       const std::array<std::array<double, 3>, 7>&, const TubeStrain&,
                       CavityPart<7>&);

}  // namespace latticast
