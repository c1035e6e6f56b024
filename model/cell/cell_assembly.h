// SPDX-License-Identifier: GPL-3.0-or-later
// Assembly of a unit cell: energy and cavity of all elements, with derivatives by the mesh's
// unknowns and by the tube's strains.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/cell/cell_mesh.h"
#include "model/cell/element_energy.h"
#include "model/cell/sparse_solver.h"

namespace latticast {

/// Of L = W - P V at one place, W the stored energy and V the cavity, both of the cell: N mm, mm^3.
/// q are the tube's strains, u the unknowns.
struct AssembledCell {
  double energy = 0;  ///< W
  double volume_mm3 = 0;
  std::vector<double> residual;                         ///< dL/du
  std::vector<double> volume_slope;                     ///< dV/du
  std::array<std::vector<double>, tube_strains> mixed;  ///< d2L/du dq
  std::vector<ElementPressure> pressures;               ///< that the elements' volumes ask for
  std::array<double, tube_strains> by_strain{};         ///< dL/dq
  std::array<double, tube_strains> volume_by_strain{};  ///< dV/dq
  std::array<double, std::size_t{tube_strains} * tube_strains>
      strain_curvature{};  ///< d2L/dq2, upper
};

class CellAssembly {
 public:
  explicit CellAssembly(CellMesh mesh);

  /// d2L/du2 goes into matrix(). False where an element cannot be evaluated.
  /// `held`: see evaluate() of an element; none at rest.
  bool assemble(std::span<const double> unknowns, const TubeStrain& strain, double pressure_mpa,
                std::span<const ElementPressure> held, AssembledCell& result);

  /// Element pressures where a step of the unknowns leads from what was assembled last.
  std::vector<ElementPressure> pressures_after(std::span<const double> step,
                                               const AssembledCell& from) const;

  SparseSolver& matrix() { return matrix_; }
  const CellMesh& mesh() const { return mesh_; }

 private:
  /// Where an element's components stand among the unknowns, and their pairs in the matrix: upper
  /// triangle, row after row, -1 for none.
  template <std::size_t N>
  struct Scatter {
    std::array<std::int32_t, N> unknown{};
    std::array<double, N> sign{};
    std::vector<std::int32_t> place;
  };

  template <std::size_t N, class Nodes>
  Scatter<N> scatter_of(const Nodes& nodes) const;
  template <std::size_t N>
  void find_places(Scatter<N>& scatter) const;
  template <std::size_t N>
  static auto components(const Scatter<N>& scatter, std::span<const double> unknowns);
  template <std::size_t N, class Part>
  void add(const Scatter<N>& scatter, const Part& part, double factor, AssembledCell& result);
  SparseSolver make_matrix();

  CellMesh mesh_;
  std::vector<Scatter<81>> elements_;
  std::vector<Scatter<27>> bore_;
  SparseSolver matrix_;
  ElementEnergy element_;
  std::vector<std::array<double, std::size_t{4} * ElementEnergy::size>> pressure_by_;
  CavityPart cavity_;
};

}  // namespace latticast
