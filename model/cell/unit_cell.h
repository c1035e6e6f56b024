// SPDX-License-Identifier: GPL-3.0-or-later
// Unit cell of a segment: the drawn lattice bonded on the liner, one period of it, meshed twice;
// its energy is extrapolated from both meshes (docs/unit-cell.md).
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "design/design.h"
#include "model/cell/cell_mesh.h"
#include "model/cell/condensed_cell.h"

namespace latticast {

enum class UnitCellKind {
  strips,  ///< of one even family of strips: hexahedra that follow them
  drawn    ///< of what the plane shows: wedges
};

/// Immutable, like everything that prediction shares.
struct UnitCell {
  CellMesh coarse;
  CellMesh fine;
  double extrapolation = 0;  ///< of the energy, by what it differs between both
  UnitCellKind kind = UnitCellKind::strips;
  bool twists = true;   ///< false: k = 0 by symmetry
  bool bends = false;   ///< false: kappa = 0 by symmetry
  std::string assumed;  ///< what was changed to find a period; mostly empty
};

/// A segment's cell, or why there is none.
struct FoundCell {
  std::shared_ptr<const UnitCell> cell;
  std::string reason;  ///< "needs a liner of rubber, this one is linear"
};

/// One even family of straight strips that leave gaps, with or without evenly pitched rings, has a
/// cell of its own; any other lattice that repeats along the tube has the cell that is drawn. Its
/// meshes are refined until rest_error_percent() is at most `error_percent`; 0 asks for none.
FoundCell find_unit_cell(const Segment& segment, double error_percent = 0);

/// How far the response to pressure at rest is estimated to be off: the largest share of stretch,
/// bore, twist or bending, of those that are not small beside the others. Infinite where the cell
/// cannot be solved there.
double rest_error_percent(const UnitCell& cell);

/// Extrapolated to elements of no size, and a quarter of what that changed: what errors are
/// measured by.
struct ExtrapolatedEnergy {
  SectionEnergy energy;
  SectionEnergy doubt;
};

/// A cell's stored energy as a function of the section's coordinates; it follows them, so one
/// object belongs to one path of states.
class UnitCellEnergy {
 public:
  /// `most_factorisations`: of the finer mesh, before it is given up; by default what takes about a
  /// minute.
  explicit UnitCellEnergy(const UnitCell& cell, std::optional<int> most_factorisations = {});

  /// Empty where a mesh cannot be followed.
  std::optional<ExtrapolatedEnergy> at(const Deformation& deformation);

  /// Whether the wall buckled within the cell where at() was empty.
  bool buckled() const { return buckled_; }

  /// Whether at() was empty because the cell had been factored as often as it may be.
  bool exhausted() const { return fine_.factorisations() > most_factorisations_; }

 private:
  CondensedCell coarse_;
  CondensedCell fine_;
  double extrapolation_;
  bool buckled_ = false;
  int most_factorisations_;
};

}  // namespace latticast
