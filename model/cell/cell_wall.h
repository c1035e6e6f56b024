// SPDX-License-Identifier: GPL-3.0-or-later
// Local state of a wall in its unit cell: bulging of the liner between members, largest strains,
// and the traction on the bond (docs/unit-cell.md#wall).
#pragma once

#include <optional>

#include "model/cell/condensed_cell.h"
#include "model/cell/unit_cell.h"

namespace latticast {

/// On the cell's finer mesh. At corners of the drawing and edges of the bond, stress in an elastic
/// body has no bound; so strains are what a hundredth of the part's volume exceeds, tractions means
/// over the bond.
struct CellWall {
  double bulge_mm = 0;        ///< how much farther out the liner's outside comes between members
                              ///< than under them, at most
  double lattice_strain = 0;  ///< largest principal stretch - 1
  double liner_strain = 0;
  /// Between liner and lattice, per present area: the magnitude of what acts along the bond, and
  /// what acts away from the liner (negative: pressed on it); in the liner's outermost Gauss
  /// points.
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
