// SPDX-License-Identifier: GPL-3.0-or-later
// Local state of a wall in its unit cell: bulging of the liner between members, largest strains,
// and the traction on the bond (docs/unit-cell.md#wall).
#pragma once

#include <optional>

#include "model/cell/condensed_cell.h"
#include "model/cell/unit_cell.h"

namespace latticast {

/// On the cell's finer mesh. Strains are largest principal stretches - 1, those of the cell's Gauss
/// points: at corners of the drawing, where an elastic body's strain has no bound, they grow slowly
/// as the mesh is refined.
struct CellWall {
  double bulge_mm = 0;        ///< how much farther out the liner's outside comes between members
                              ///< than under them, at most
  double lattice_strain = 0;  ///< along whatever direction is stretched most
  double liner_strain = 0;
  /// Between liner and lattice, per present area, in the liner's outermost Gauss points: along the
  /// bond, and away from the liner (negative where it is pressed on it everywhere).
  double bond_shear_mpa = 0;
  double bond_pull_mpa = 0;
};

/// The wall along a path of states, which should be near each other: each is found from the one
/// before. One object belongs to one path.
class CellWalls {
 public:
  /// `cell` must outlive this.
  explicit CellWalls(const UnitCell& cell);

  /// Of the wall whose section is deformed like this. Empty where the cell cannot be followed.
  std::optional<CellWall> at(const Deformation& deformation);

 private:
  const CellMesh& mesh_;
  bool bends_;
  CondensedCell cell_;
};

}  // namespace latticast
