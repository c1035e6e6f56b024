// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/element_energy.h"

#include <cmath>
#include <memory>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

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

/// Sizes of an element with N nodes.
template <std::size_t N>
constexpr int size_of = ElementEnergy<N>::size;
template <std::size_t N>
constexpr int points_of = N == 27 ? 27 : 21;
template <std::size_t N>
constexpr int width_of = product_width(size_of<N>);
template <std::size_t N>
constexpr int rows_of = 9 * points_of<N> + pressures;
template <std::size_t N>
using Factor = Eigen::Matrix<double, Eigen::Dynamic, width_of<N>, Eigen::RowMajor>;
template <std::size_t N>
using Hessian = Eigen::Matrix<double, size_of<N>, size_of<N>, Eigen::RowMajor>;
template <std::size_t N>
using NodeVectors = Eigen::Matrix<double, 3, static_cast<int>(N)>;

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

/// What an element's nodes are at rest and now.
template <std::size_t N>
struct PlacedNodes {
  NodeVectors<N> rest;   // place
  NodeVectors<N> place;  // y, in the section's frame
  std::array<Matrix3, N> frames;
};

template <std::size_t N>
PlacedNodes<N> placed(const CellMesh& mesh, const CellElement<N>& element,
                      const std::array<std::array<double, 3>, N>& displacement) {
  PlacedNodes<N> nodes;
  for (std::size_t a = 0; a < N; ++a) {
    const CellNode& node = mesh.nodes[element.nodes[a]];
    nodes.frames[a] = frame_of(node);
    const Vector3 radial = nodes.frames[a].col(0) * node.radius_mm;
    const auto column = static_cast<Eigen::Index>(a);
    nodes.rest.col(column) = radial + Vector3(0, 0, node.height_mm);
    nodes.place.col(column) =
        radial + nodes.frames[a] * Eigen::Map<const Vector3>(displacement[a].data());
  }
  return nodes;
}

/// One Gauss point: how F depends on the unknowns, rows of F one after the other.
template <std::size_t N>
struct StrainAtPoint {
  double volume = 0;  // that it stands for
  Tensor gradient{};  // F
  Eigen::Matrix<double, 9, size_of<N>, Eigen::RowMajor> by_unknowns;
};

template <std::size_t N>
void evaluate_strain(const ShapeAtPoint& shape, const PlacedNodes<N>& nodes,
                     const TubeStrain& strain, StrainAtPoint<N>& at) {
  constexpr int n = static_cast<int>(N);
  const Eigen::Map<const NodeVectors<N>> own_slopes(shape.slope.front().data());
  const Eigen::Map<const Eigen::Matrix<double, n, 1>> values(shape.value.data());
  const Matrix3 map = nodes.rest * own_slopes.transpose();  // dX_i/dxi_j
  at.volume = shape.weight * map.determinant();
  const NodeVectors<N> slopes = map.inverse().transpose() * own_slopes;
  const Vector3 y = nodes.place * values;
  const Vector3 omega(strain[2], strain[3], strain[1]);
  const Matrix3 turning = cross_matrix(omega);
  Matrix3 f = nodes.place * slopes.transpose();
  f.col(2) += turning * y + Vector3(0, 0, 1 + strain[0]);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) at.gradient[3 * i + j] = f(i, j);
  }
  for (int a = 0; a < n; ++a) {
    const Matrix3 turned = values[a] * (turning * nodes.frames[a]);
    for (int i = 0; i < 3; ++i) {
      for (int c = 0; c < 3; ++c) {
        const double direction = nodes.frames[a](i, c);
        for (int j = 0; j < 3; ++j) {
          at.by_unknowns(3 * i + j, 3 * a + c) = direction * slopes(j, a);
        }
        at.by_unknowns(3 * i + 2, 3 * a + c) += turned(i, c);
      }
    }
  }
  at.by_unknowns.template rightCols<tube_strains>().setZero();
  at.by_unknowns(8, 3 * n) = 1;
  constexpr std::array<int, 3> axis_of = {2, 0, 1};  // of k, kappa_1, kappa_2
  for (int m = 0; m < 3; ++m) {
    const Vector3 moved = Vector3::Unit(axis_of[m]).cross(y);
    for (int i = 0; i < 3; ++i) at.by_unknowns(3 * i + 2, 3 * n + 1 + m) = moved[i];
  }
}

/// Adds what the stress does through F's own curvature: the tube turns what the nodes move.
template <std::size_t N>
void add_turning(const ShapeAtPoint& shape, const PlacedNodes<N>& nodes, const Tensor& stress,
                 double volume, Eigen::Map<Hessian<N>>& hessian) {
  constexpr int n = static_cast<int>(N);
  const Vector3 pull(stress[2], stress[5], stress[8]);
  constexpr std::array<int, 3> axis_of = {2, 0, 1};
  for (int m = 0; m < 3; ++m) {
    // pull . (e_m x d) = d . (pull x e_m)
    const Vector3 lever = pull.cross(Vector3::Unit(axis_of[m])) * volume;
    for (int a = 0; a < n; ++a) {
      const Vector3 by = shape.value[a] * (nodes.frames[a].transpose() * lever);
      for (int c = 0; c < 3; ++c) hessian(3 * a + c, 3 * n + 1 + m) += by[c];
    }
  }
}

/// How an element's volume changes: the dilation J - 1 by the functions of its pressure.
template <std::size_t N>
struct DilatedElement {
  std::array<StrainAtPoint<N>, points_of<N>> strains;
  std::array<VolumeRatio, points_of<N>> volumes;
  PressureMatrix mass = PressureMatrix::Zero();
  Pressures dilation = Pressures::Zero();
  Eigen::Matrix<double, pressures, size_of<N>> by_unknowns;
};

Pressures basis(const ShapeAtPoint& point) {
  return {1, point.place[0], point.place[1], point.place[2]};
}

/// False where a point is turned inside out.
template <std::size_t N>
bool dilate(const PlacedNodes<N>& nodes, const TubeStrain& strain, DilatedElement<N>& element) {
  element.mass.setZero();
  element.dilation.setZero();
  element.by_unknowns.setZero();
  for (std::size_t g = 0; g < element.strains.size(); ++g) {
    const ShapeAtPoint& point = shape_of<N>().points[g];
    StrainAtPoint<N>& at = element.strains[g];
    evaluate_strain(point, nodes, strain, at);
    VolumeRatio& volume = element.volumes[g];
    volume = volume_ratio(at.gradient);
    if (!(volume.value > 0) || !(at.volume > 0)) return false;
    const Pressures phi = at.volume * basis(point);
    element.mass += phi * basis(point).transpose();
    element.dilation += (volume.value - 1) * phi;
    const Eigen::Map<const Eigen::Matrix<double, 1, 9>> cofactor(volume.cofactor.data());
    const Eigen::Matrix<double, 1, size_of<N>> by = cofactor * at.by_unknowns;
    element.by_unknowns += phi * by;
  }
  return true;
}

}  // namespace

template <std::size_t N>
bool evaluate(const CellMesh& mesh, const CellElement<N>& element,
              const std::array<std::array<double, 3>, N>& displacement, const TubeStrain& strain,
              const ElementPressure* held, ElementEnergy<N>& result) {
  constexpr int element_size = size_of<N>;
  const CellMaterial& material = mesh.materials[element.material];
  const PlacedNodes<N> nodes = placed(mesh, element, displacement);
  // On the heap: what a thread keeps for itself is set to zero when the program starts.
  thread_local const auto scratch = std::make_unique<DilatedElement<N>>();
  DilatedElement<N>& dilated = *scratch;
  if (!dilate(nodes, strain, dilated)) return false;
  const PressureMatrix stiffness = material.bulk_modulus_mpa * dilated.mass.inverse();
  const Pressures pressure = stiffness * dilated.dilation;
  Eigen::Map<Pressures>(result.pressure.data()) = pressure;
  Eigen::Map<Eigen::Matrix<double, pressures, element_size, Eigen::RowMajor>> pressure_by(
      result.pressure_by.data());
  pressure_by.noalias() = stiffness * dilated.by_unknowns;
  const Pressures weighing =
      held != nullptr ? Pressures(Eigen::Map<const Pressures>(held->data())) : pressure;

  result.energy = 0.5 * pressure.dot(dilated.dilation);
  Eigen::Map<Eigen::Matrix<double, element_size, 1>> gradient(result.gradient.data());
  Eigen::Map<Hessian<N>> hessian(result.hessian.data());
  gradient = dilated.by_unknowns.transpose() * pressure;
  hessian.setZero();
  thread_local Factor<N> left = Factor<N>::Zero(rows_of<N>, width_of<N>);
  thread_local Factor<N> right = Factor<N>::Zero(rows_of<N>, width_of<N>);
  thread_local Factor<N> product = Factor<N>::Zero(width_of<N>, width_of<N>);
  Eigen::Index row = 0;
  for (std::size_t g = 0; g < dilated.strains.size(); ++g, row += 9) {
    const ShapeAtPoint& shape = shape_of<N>().points[g];
    const StrainAtPoint<N>& at = dilated.strains[g];
    auto point = isochoric_energy(material.law, at.gradient);
    if (!point) return false;
    result.energy += at.volume * point->energy;
    const double p = weighing.dot(basis(shape));
    add_volume_curvature(at.gradient, p, point->tangent);
    left.template block<9, element_size>(row, 0) = at.by_unknowns;
    tangent_product<width_of<N>>(point->tangent.data(), at.volume, &left(row, 0), &right(row, 0));
    const Eigen::Map<const Eigen::Matrix<double, 9, 1>> stress(point->stress.data());
    gradient += at.volume * (at.by_unknowns.transpose() * stress);
    Tensor whole{};
    for (std::size_t i = 0; i < 9; ++i) {
      whole[i] = point->stress[i] + p * dilated.volumes[g].cofactor[i];
    }
    add_turning<N>(shape, nodes, whole, at.volume, hessian);
  }
  left.template block<pressures, element_size>(row, 0) = dilated.by_unknowns;
  right.template block<pressures, element_size>(row, 0) = pressure_by;
  symmetric_product<width_of<N>>(left.data(), right.data(), rows_of<N>, product.data());
  hessian += product.template topLeftCorner<element_size, element_size>();
  return true;
}

template bool evaluate(const CellMesh&, const CellElement<27>&,
                       const std::array<std::array<double, 3>, 27>&, const TubeStrain&,
                       const ElementPressure*, ElementEnergy<27>&);
template bool evaluate(const CellMesh&, const CellElement<21>&,
                       const std::array<std::array<double, 3>, 21>&, const TubeStrain&,
                       const ElementPressure*, ElementEnergy<21>&);

namespace {

struct FacePoint {
  Vector3 place = Vector3::Zero();
  std::array<Vector3, 2> slopes = {Vector3::Zero(), Vector3::Zero()};
  std::array<double, 2> height_slopes{};
};

/// Volume per area in the face's own coordinates, by its variables: y, y's slopes a and b along the
/// face's two coordinates, lambda, Omega.
constexpr int face_numbers = 13;
struct CavityDensity {
  double value = 0;
  Eigen::Matrix<double, face_numbers, 1> gradient;
  Eigen::Matrix<double, face_numbers, face_numbers> hessian;
};

/// det[y, a, b]/3, plus with c = Z_b a - Z_a b, D along a curve of the face being d + dZ (Omega x
/// y),
///     y . (c x (Omega x y))/3 + lambda e3 . (y x c)/2.
CavityDensity cavity_density(const FacePoint& point, const TubeStrain& strain) {
  const Vector3& y = point.place;
  const Vector3& a = point.slopes[0];
  const Vector3& b = point.slopes[1];
  const double rise_a = point.height_slopes[0];
  const double rise_b = point.height_slopes[1];
  const Vector3 c = rise_b * a - rise_a * b;
  const double stretch = 1 + strain[0];
  const Vector3 omega(strain[2], strain[3], strain[1]);
  const Vector3 axis = Vector3::UnitZ();
  const double cy = c.dot(y);
  const double oy = omega.dot(y);
  const double co = c.dot(omega);
  const double yy = y.dot(y);

  CavityDensity density;
  const double level = 0.5 * axis.dot(y.cross(c));
  density.value = (y.dot(a.cross(b)) + oy * cy - yy * co) / 3 + stretch * level;
  // By y, c, lambda and Omega first; a and b follow c.
  const Vector3 by_y =
      (a.cross(b) + cy * omega + oy * c - 2 * co * y) / 3 + 0.5 * stretch * c.cross(axis);
  const Vector3 by_c = (oy * y - yy * omega) / 3 + 0.5 * stretch * axis.cross(y);
  const Vector3 by_omega = (cy * y - yy * c) / 3;
  auto& g = density.gradient;
  g.segment<3>(0) = by_y;
  g.segment<3>(3) = b.cross(y) / 3 + rise_b * by_c;
  g.segment<3>(6) = y.cross(a) / 3 - rise_a * by_c;
  g[9] = level;
  // TubeStrain has k first, then Omega's other two.
  g[10] = by_omega[2];
  g[11] = by_omega[0];
  g[12] = by_omega[1];

  const Matrix3 identity = Matrix3::Identity();
  const Matrix3 yy_by = (omega * c.transpose() + c * omega.transpose() - 2 * co * identity) / 3;
  const Matrix3 yc_by = (omega * y.transpose() + oy * identity - 2 * y * omega.transpose()) / 3 -
                        0.5 * stretch * cross_matrix(axis);
  const Matrix3 yo_by = (cy * identity + c * y.transpose() - 2 * y * c.transpose()) / 3;
  const Matrix3 co_by = (y * y.transpose() - yy * identity) / 3;
  auto& h = density.hessian;
  h.setZero();
  h.block<3, 3>(0, 0) = yy_by;
  h.block<3, 3>(0, 3) = -cross_matrix(b) / 3 + rise_b * yc_by;
  h.block<3, 3>(0, 6) = cross_matrix(a) / 3 - rise_a * yc_by;
  h.block<3, 3>(3, 6) = -cross_matrix(y) / 3;
  const Vector3 y_stretch = 0.5 * c.cross(axis);
  const Vector3 c_stretch = 0.5 * axis.cross(y);
  h.block<3, 1>(0, 9) = y_stretch;
  h.block<3, 1>(3, 9) = rise_b * c_stretch;
  h.block<3, 1>(6, 9) = -rise_a * c_stretch;
  constexpr std::array<int, 3> axis_of = {2, 0, 1};  // of k, kappa_1, kappa_2
  for (int m = 0; m < 3; ++m) {
    h.block<3, 1>(0, 10 + m) = yo_by.col(axis_of[m]);
    h.block<3, 1>(3, 10 + m) = rise_b * co_by.col(axis_of[m]);
    h.block<3, 1>(6, 10 + m) = -rise_a * co_by.col(axis_of[m]);
  }
  h.triangularView<Eigen::StrictlyLower>() = h.transpose();
  return density;
}

}  // namespace

template <std::size_t N>
void evaluate(const CellMesh& mesh, const BoreFace<N>& face,
              const std::array<std::array<double, 3>, N>& displacement, const TubeStrain& strain,
              CavityPart<N>& result) {
  constexpr int size = CavityPart<N>::size;
  std::array<Matrix3, N> frames;
  std::array<Vector3, N> places;
  for (std::size_t a = 0; a < N; ++a) {
    const CellNode& node = mesh.nodes[face[a]];
    frames[a] = frame_of(node);
    places[a] = frames[a].col(0) * node.radius_mm +
                frames[a] * Eigen::Map<const Vector3>(displacement[a].data());
  }
  Eigen::Map<Eigen::Matrix<double, size, 1>> gradient(result.gradient.data());
  Eigen::Map<Eigen::Matrix<double, size, size, Eigen::RowMajor>> hessian(result.hessian.data());
  gradient.setZero();
  hessian.setZero();
  result.volume_mm3 = 0;
  for (const ShapeAtPoint& shape : shape_of<N>().points) {
    FacePoint point;
    Eigen::Matrix<double, face_numbers, size> by =
        Eigen::Matrix<double, face_numbers, size>::Zero();
    by.template bottomRightCorner<tube_strains, tube_strains>().setIdentity();
    for (std::size_t a = 0; a < N; ++a) {
      const auto column = static_cast<Eigen::Index>(3 * a);
      point.place += shape.value[a] * places[a];
      by.template block<3, 3>(0, column) = shape.value[a] * frames[a];
      for (std::size_t i = 0; i < 2; ++i) {
        point.slopes[i] += shape.slope[a][i] * places[a];
        point.height_slopes[i] += shape.slope[a][i] * mesh.nodes[face[a]].height_mm;
        by.template block<3, 3>(static_cast<Eigen::Index>(3 * i + 3), column) =
            shape.slope[a][i] * frames[a];
      }
    }
    const CavityDensity density = cavity_density(point, strain);
    result.volume_mm3 += shape.weight * density.value;
    gradient += by.transpose() * (shape.weight * density.gradient);
    const Eigen::Matrix<double, face_numbers, size> turned = (shape.weight * density.hessian) * by;
    hessian.template triangularView<Eigen::Upper>() += by.transpose() * turned;
  }
}

template void evaluate(const CellMesh&, const BoreFace<9>&,
                       const std::array<std::array<double, 3>, 9>&, const TubeStrain&,
                       CavityPart<9>&);
template void evaluate(const CellMesh&, const BoreFace<7>&,
                       const std::array<std::array<double, 3>, 7>&, const TubeStrain&,
                       CavityPart<7>&);

}  // namespace latticast
