// SPDX-License-Identifier: GPL-3.0-or-later
// Unit cell condensed to a section: the least energy that a cell stores at given coordinates of the
// tube, its nodes and its pressure being free, with exact gradient and Hessian by static
// condensation.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "model/cell/cell_mesh.h"
#include "model/section/deformation.h"
#include "model/section/section_energy.h"

namespace latticast {

/// The cell takes the place of a section: its bore's radius a stands for the cavity's volume,
/// V = pi a^2 lambda per mm of reference length, which is held while the nodes find their least
/// energy. So the energy exists, and is smooth, on both sides of the pressure's limit point.
class CondensedCell {
 public:
  /// `passing_correction`: last Newton correction of a node, by the bore's radius, with which a
  /// deformation is left that is only passed; its square is what the derivatives may be off by. One
  /// that is asked for twice, or nearly so, is good to rounding of its own.
  explicit CondensedCell(CellMesh mesh, double passing_correction = 3e-4);
  ~CondensedCell();
  CondensedCell(CondensedCell&&) noexcept;
  CondensedCell& operator=(CondensedCell&&) noexcept;

  /// Per mm of reference length, N. Found by Newton's method from the deformation that was asked
  /// for before, so that successive ones should be near each other. Empty where the cell cannot be
  /// followed there.
  std::optional<SectionEnergy> at(const Deformation& deformation);

  /// Of the nodes, by their components, where at() has led last; zero before it was asked.
  std::vector<std::array<double, 3>> displacements() const;
  /// The tube's strain (a TubeStrain) there.
  std::array<double, 4> tube_strain() const;

  /// Factorisations so far.
  int factorisations() const;
  /// Whether the nodes' energy, at the coordinates last asked for, is a minimum: if it is not, the
  /// wall buckles within the cell.
  bool is_minimum() const;

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace latticast
