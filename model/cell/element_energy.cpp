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
#include "model/numerics/dual.h"

namespace latticast {
namespace {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
constexpr int element_size = ElementEnergy::size;
constexpr int hexahedron_points = 27;
constexpr int pressures = 4;  // 1, xi, eta, zeta

using Pressures = Eigen::Matrix<double, pressures, 1>;
using PressureMatrix = Eigen::Matrix<double, pressures, pressures>;
using ByUnknowns = Eigen::Matrix<double, Eigen::Dynamic, product_width, Eigen::RowMajor>;
constexpr int product_rows = 9 * hexahedron_points + pressures;
using Hessian = Eigen::Matrix<double, element_size, element_size, Eigen::RowMajor>;

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
struct PlacedNodes {
  Eigen::Matrix<double, 3, 27> rest;   // place
  Eigen::Matrix<double, 3, 27> place;  // y, in the section's frame
  std::array<Matrix3, 27> frames;
};

PlacedNodes placed(const CellMesh& mesh, const CellElement& element,
                   std::span<const std::array<double, 3>, 27> displacement) {
  PlacedNodes nodes;
  for (int a = 0; a < 27; ++a) {
    const CellNode& node = mesh.nodes[element.nodes[a]];
    nodes.frames[a] = frame_of(node);
    const Vector3 radial = nodes.frames[a].col(0) * node.radius_mm;
    nodes.rest.col(a) = radial + Vector3(0, 0, node.height_mm);
    nodes.place.col(a) =
        radial + nodes.frames[a] * Eigen::Map<const Vector3>(displacement[a].data());
  }
  return nodes;
}

/// One Gauss point: how F depends on the unknowns, rows of F one after the other.
struct StrainAtPoint {
  double volume = 0;  // that it stands for
  Tensor gradient{};  // F
  Eigen::Matrix<double, 9, element_size, Eigen::RowMajor> by_unknowns;
};

void evaluate_strain(const ShapeAtPoint& shape, const PlacedNodes& nodes, const TubeStrain& strain,
                     StrainAtPoint& at) {
  const Eigen::Map<const Eigen::Matrix<double, 3, 27>> own_slopes(shape.slope.front().data());
  const Eigen::Map<const Eigen::Matrix<double, 27, 1>> values(shape.value.data());
  const Matrix3 map = nodes.rest * own_slopes.transpose();  // dX_i/dxi_j
  at.volume = shape.weight * map.determinant();
  const Eigen::Matrix<double, 3, 27> slopes = map.inverse().transpose() * own_slopes;
  const Vector3 y = nodes.place * values;
  const Vector3 omega(strain[2], strain[3], strain[1]);
  const Matrix3 turning = cross_matrix(omega);
  Matrix3 f = nodes.place * slopes.transpose();
  f.col(2) += turning * y + Vector3(0, 0, 1 + strain[0]);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) at.gradient[3 * i + j] = f(i, j);
  }
  for (int a = 0; a < 27; ++a) {
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
  at.by_unknowns.rightCols<tube_strains>().setZero();
  at.by_unknowns(8, 81) = 1;
  constexpr std::array<int, 3> axis_of = {2, 0, 1};  // of k, kappa_1, kappa_2
  for (int m = 0; m < 3; ++m) {
    const Vector3 moved = Vector3::Unit(axis_of[m]).cross(y);
    for (int i = 0; i < 3; ++i) at.by_unknowns(3 * i + 2, 82 + m) = moved[i];
  }
}

/// Adds what the stress does through F's own curvature: the tube turns what the nodes move.
void add_turning(const ShapeAtPoint& shape, const PlacedNodes& nodes, const Tensor& stress,
                 double volume, Eigen::Map<Hessian>& hessian) {
  const Vector3 pull(stress[2], stress[5], stress[8]);
  constexpr std::array<int, 3> axis_of = {2, 0, 1};
  for (int m = 0; m < 3; ++m) {
    // pull . (e_m x d) = d . (pull x e_m)
    const Vector3 lever = pull.cross(Vector3::Unit(axis_of[m])) * volume;
    for (int a = 0; a < 27; ++a) {
      const Vector3 by = shape.value[a] * (nodes.frames[a].transpose() * lever);
      for (int c = 0; c < 3; ++c) hessian(3 * a + c, 82 + m) += by[c];
    }
  }
}

/// How an element's volume changes: the dilation J - 1 by the functions of its pressure.
struct DilatedElement {
  std::array<StrainAtPoint, hexahedron_points> strains;
  std::array<VolumeRatio, hexahedron_points> volumes;
  PressureMatrix mass = PressureMatrix::Zero();
  Pressures dilation = Pressures::Zero();
  Eigen::Matrix<double, pressures, element_size> by_unknowns;
};

Pressures basis(const ShapeAtPoint& point) {
  return {1, point.place[0], point.place[1], point.place[2]};
}

/// False where a point is turned inside out.
bool dilate(const PlacedNodes& nodes, const TubeStrain& strain, DilatedElement& element) {
  element.mass.setZero();
  element.dilation.setZero();
  element.by_unknowns.setZero();
  for (std::size_t g = 0; g < hexahedron_points; ++g) {
    const ShapeAtPoint& point = hexahedron().points[g];
    StrainAtPoint& at = element.strains[g];
    evaluate_strain(point, nodes, strain, at);
    VolumeRatio& volume = element.volumes[g];
    volume = volume_ratio(at.gradient);
    if (!(volume.value > 0) || !(at.volume > 0)) return false;
    const Pressures phi = at.volume * basis(point);
    element.mass += phi * basis(point).transpose();
    element.dilation += (volume.value - 1) * phi;
    const Eigen::Map<const Eigen::Matrix<double, 1, 9>> cofactor(volume.cofactor.data());
    const Eigen::Matrix<double, 1, element_size> by = cofactor * at.by_unknowns;
    element.by_unknowns += phi * by;
  }
  return true;
}

}  // namespace

bool evaluate(const CellMesh& mesh, const CellElement& element,
              std::span<const std::array<double, 3>, 27> displacement, const TubeStrain& strain,
              const ElementPressure* held, ElementEnergy& result) {
  const CellMaterial& material = mesh.materials[element.material];
  const PlacedNodes nodes = placed(mesh, element, displacement);
  // On the heap: what a thread keeps for itself is set to zero when the program starts.
  thread_local const auto scratch = std::make_unique<DilatedElement>();
  DilatedElement& dilated = *scratch;
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
  Eigen::Map<Hessian> hessian(result.hessian.data());
  gradient = dilated.by_unknowns.transpose() * pressure;
  hessian.setZero();
  thread_local ByUnknowns left = ByUnknowns::Zero(product_rows, product_width);
  thread_local ByUnknowns right = ByUnknowns::Zero(product_rows, product_width);
  thread_local ByUnknowns product = ByUnknowns::Zero(product_width, product_width);
  Eigen::Index row = 0;
  for (std::size_t g = 0; g < hexahedron_points; ++g, row += 9) {
    const ShapeAtPoint& shape = hexahedron().points[g];
    const StrainAtPoint& at = dilated.strains[g];
    auto point = isochoric_energy(material.law, at.gradient);
    if (!point) return false;
    result.energy += at.volume * point->energy;
    const double p = weighing.dot(basis(shape));
    add_volume_curvature(at.gradient, p, point->tangent);
    const Eigen::Map<const Eigen::Matrix<double, 9, 9, Eigen::RowMajor>> tangent(
        point->tangent.data());
    left.block<9, element_size>(row, 0) = at.by_unknowns;
    right.block<9, element_size>(row, 0).noalias() = (at.volume * tangent) * at.by_unknowns;
    const Eigen::Map<const Eigen::Matrix<double, 9, 1>> stress(point->stress.data());
    gradient += at.volume * (at.by_unknowns.transpose() * stress);
    Tensor whole{};
    for (std::size_t i = 0; i < 9; ++i) {
      whole[i] = point->stress[i] + p * dilated.volumes[g].cofactor[i];
    }
    add_turning(shape, nodes, whole, at.volume, hessian);
  }
  left.block<pressures, element_size>(row, 0) = dilated.by_unknowns;
  right.block<pressures, element_size>(row, 0) = pressure_by;
  symmetric_product(left.data(), right.data(), product_rows, product.data());
  hessian += product.topLeftCorner<element_size, element_size>();
  return true;
}

namespace {

/// A bore's point: y, y_s and y_Z by the face's two coordinates, then lambda and Omega.
constexpr std::size_t face_numbers = 13;
using FaceNumber = Dual<face_numbers>;
using FaceVector = std::array<FaceNumber, 3>;

FaceVector cross(const FaceVector& a, const FaceVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

FaceNumber dot(const FaceVector& a, const FaceVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

FaceVector variables(const Vector3& v, std::size_t first) {
  return {FaceNumber::variable(first, v[0]), FaceNumber::variable(first + 1, v[1]),
          FaceNumber::variable(first + 2, v[2])};
}

struct FacePoint {
  Vector3 place = Vector3::Zero();
  std::array<Vector3, 2> slopes = {Vector3::Zero(), Vector3::Zero()};
  std::array<double, 2> height_slopes{};
};

/// Volume per area in the face's own coordinates.
FaceNumber cavity_density(const FacePoint& point, const TubeStrain& strain) {
  const FaceVector at = variables(point.place, 0);
  const FaceVector first = variables(point.slopes[0], 3);
  const FaceVector second = variables(point.slopes[1], 6);
  const FaceNumber stretch = FaceNumber::variable(9, 1 + strain[0]);
  const FaceVector omega = {FaceNumber::variable(11, strain[2]),
                            FaceNumber::variable(12, strain[3]),
                            FaceNumber::variable(10, strain[1])};
  // D along a curve of the face is d + dZ (Omega x y); the part of lambda keeps its own.
  FaceVector across;
  for (std::size_t i = 0; i < 3; ++i) {
    across[i] = first[i] * point.height_slopes[1] - second[i] * point.height_slopes[0];
  }
  const FaceNumber swept = dot(at, cross(first, second)) + dot(at, cross(across, cross(omega, at)));
  return swept * (1.0 / 3) + (at[0] * across[1] - at[1] * across[0]) * stretch * 0.5;
}

}  // namespace

void evaluate(const CellMesh& mesh, const std::array<std::int32_t, 9>& face,
              std::span<const std::array<double, 3>, 9> displacement, const TubeStrain& strain,
              CavityPart& result) {
  constexpr int size = CavityPart::size;
  std::array<Matrix3, 9> frames;
  std::array<Vector3, 9> places;
  for (std::size_t a = 0; a < 9; ++a) {
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
  for (const ShapeAtPoint& shape : quadrilateral().points) {
    FacePoint point;
    Eigen::Matrix<double, face_numbers, size> by =
        Eigen::Matrix<double, face_numbers, size>::Zero();
    by.bottomRightCorner<tube_strains, tube_strains>().setIdentity();
    for (std::size_t a = 0; a < 9; ++a) {
      const auto column = static_cast<Eigen::Index>(3 * a);
      point.place += shape.value[a] * places[a];
      by.block<3, 3>(0, column) = shape.value[a] * frames[a];
      for (std::size_t i = 0; i < 2; ++i) {
        point.slopes[i] += shape.slope[a][i] * places[a];
        point.height_slopes[i] += shape.slope[a][i] * mesh.nodes[face[a]].height_mm;
        by.block<3, 3>(static_cast<Eigen::Index>(3 * i + 3), column) =
            shape.slope[a][i] * frames[a];
      }
    }
    const FaceNumber density = cavity_density(point, strain) * shape.weight;
    result.volume_mm3 += density.value;
    Eigen::Matrix<double, face_numbers, face_numbers> second;
    for (std::size_t i = 0; i < face_numbers; ++i) {
      for (std::size_t j = 0; j < face_numbers; ++j) {
        second(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = density.second(i, j);
      }
    }
    gradient += by.transpose() *
                Eigen::Map<const Eigen::Matrix<double, face_numbers, 1>>(density.gradient.data());
    hessian.triangularView<Eigen::Upper>() += by.transpose() * (second * by);
  }
}

}  // namespace latticast
