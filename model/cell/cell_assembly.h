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
  /// Where the components of N nodes stand among the unknowns, and their pairs in the matrix: upper
  /// triangle, row after row, -1 for none.
  template <std::size_t N>
  struct Scatter {
    std::array<std::int32_t, 3 * N> unknown{};
    std::array<double, 3 * N> sign{};
    std::vector<std::int32_t> place;
  };

  /// All elements of one kind, and how their pressures depend on their components.
  template <std::size_t N>
  struct Elements {
    std::vector<Scatter<N>> scatters;
    std::vector<std::array<double, std::size_t{4} * ElementEnergy<N>::size>> pressure_by;
  };

  using Entries = std::vector<std::pair<int, int>>;
  template <std::size_t N>
  Scatter<N> scatter_of(const std::array<std::int32_t, N>& nodes) const;
  template <std::size_t N>
  void add_elements(const std::vector<CellElement<N>>& from, Elements<N>& to,
                    Entries& entries) const;
  template <std::size_t N>
  void find_places(Scatter<N>& scatter) const;
  template <std::size_t N>
  static auto components(const Scatter<N>& scatter, std::span<const double> unknowns);
  template <std::size_t N, class Part>
  void add(const Scatter<N>& scatter, const Part& part, double factor, AssembledCell& result);
  template <std::size_t N>
  bool add_energies(const std::vector<CellElement<N>>& elements, std::span<const double> unknowns,
                    const TubeStrain& strain, std::span<const ElementPressure> held,
                    std::size_t first, Elements<N>& kept, AssembledCell& result);
  template <std::size_t N>
  void add_cavity(const std::vector<BoreFace<N>>& faces, const std::vector<Scatter<N>>& scatters,
                  std::span<const double> unknowns, const TubeStrain& strain, double pressure_mpa,
                  AssembledCell& result);
  template <std::size_t N>
  static void add_steps(const Elements<N>& elements, std::span<const double> step,
                        std::size_t first, std::vector<ElementPressure>& pressures);
  void add_springs(std::span<const double> unknowns, AssembledCell& result);
  void make_springs(Entries& entries);
  SparseSolver make_matrix();

  /// A linear form of the unknowns that a stiff spring keeps at zero.
  struct Spring {
    std::vector<std::pair<std::int32_t, double>> terms;
    double stiffness = 0;
  };

  CellMesh mesh_;
  Elements<27> hexahedra_;
  Elements<21> wedges_;
  std::vector<Scatter<9>> quadrilaterals_;
  std::vector<Scatter<7>> triangles_;
  std::vector<Spring> springs_;
  SparseSolver matrix_;
};

}  // namespace latticast
