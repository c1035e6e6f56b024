// SPDX-License-Identifier: GPL-3.0-or-later
// Energy of one finite element in the moving frame of a section, with gradient and Hessian by its
// nodes and by the tube's coordinates: quadratic displacement, discontinuous linear pressure
// condensed in the element (Q2/P-1 and its wedge, [Bathe 2014] 4.5).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "model/cell/cell_mesh.h"
#include "model/cell/point_energy.h"

namespace latticast {

/// The tube's coordinates that strain a cell as a whole: lambda - 1, k, and kappa about two axes
/// (docs/model.md#coordinates). Its section at Z is placed and turned by them, so that
///     F = grad y + (lambda e3 + Omega x y) e3,  Omega = (kappa_1, kappa_2, k),
/// y being the place in the section's moving frame.
using TubeStrain = std::array<double, 4>;
inline constexpr int tube_strains = 4;

/// Pressure in an element, by 1, xi, eta and zeta: MPa.
using ElementPressure = std::array<double, 4>;

/// Of an element with N nodes, by its N x 3 components, node after node, then the tube's strains;
/// the Hessian's rows one after the other, upper triangle only.
template <std::size_t N>
struct ElementEnergy {
  static constexpr int size = N * 3 + tube_strains;
  double energy = 0;  ///< N mm
  std::array<double, size> gradient{};
  std::array<double, std::size_t{size} * size> hessian{};
  ElementPressure pressure{};                               ///< that the change of volume asks for
  std::array<double, std::size_t{4} * size> pressure_by{};  ///< its derivatives, row after row
};

/// Displacements of the element's nodes by their components. False where a Gauss point is turned
/// inside out or a law's limit is reached. With a pressure `held`, the curvature of the volume
/// ratio is weighed by that in place of the element's own: as Newton's method has it where
/// pressures are unknowns, which converges from much further away when the bulk modulus is high.
/// N: 27 or 21.
template <std::size_t N>
bool evaluate(const CellMesh& mesh, const CellElement<N>& element,
              const std::array<std::array<double, 3>, N>& displacement, const TubeStrain& strain,
              const ElementPressure* held, ElementEnergy<N>& result);

/// At a Gauss point, in the section's moving frame.
struct ElementPoint {
  double volume_mm3 = 0;          ///< at rest, that the point stands for
  std::array<double, 3> own{};    ///< coordinates of the element
  std::array<double, 3> place{};  ///< at rest: x, y, z in mm
  Tensor gradient{};              ///< F
  Tensor stress{};                ///< first Piola-Kirchhoff, MPa
};

/// Of an element under the pressure that its volume asks for; none where it is turned inside out or
/// its law's limit is reached. N: 27 or 21.
template <std::size_t N>
std::vector<ElementPoint> element_points(const CellMesh& mesh, const CellElement<N>& element,
                                         const std::array<std::array<double, 3>, N>& displacement,
                                         const TubeStrain& strain);

/// Volume that a bore face encloses with the tube's axis, over the cell's own length, exact for any
/// twist and bending:
///     integral of det[y, D_s y, D_Z y]/3 + lambda det[y, y_s, e3]/2 ds dZ,  D = d + Omega x,
/// with gradient and Hessian by its N x 3 components, then the tube's strains. N: 9 or 7.
template <std::size_t N>
struct CavityPart {
  static constexpr int size = N * 3 + tube_strains;
  double volume_mm3 = 0;
  std::array<double, size> gradient{};
  std::array<double, std::size_t{size} * size> hessian{};  ///< upper triangle
};
template <std::size_t N>
void evaluate(const CellMesh& mesh, const BoreFace<N>& face,
              const std::array<std::array<double, 3>, N>& displacement, const TubeStrain& strain,
              CavityPart<N>& result);

}  // namespace latticast
