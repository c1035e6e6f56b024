// SPDX-License-Identifier: GPL-3.0-or-later
// Unit cells that several tests share.
#pragma once

#include "design/units.h"
#include "model/cell/strip_cell.h"

namespace latticast::testing {

/// docs/unit-cell.md#accuracy: liner 12-16, lattice 16-18, 8 strips and rings of 2 mm, one each 10
/// mm.
inline StripTube strips(double angle_deg) {
  return {.inner_radius_mm = 12,
          .liner_outer_radius_mm = 16,
          .outer_radius_mm = 18,
          .angle_rad = radians(angle_deg),
          .strips = 8,
          .strip_width_mm = 2,
          .pitch_mm = 10,
          .ring_width_mm = 2,
          .liner = NeoHookean{0.08},
          .lattice = Linear{19.46, 0.49}};
}

inline constexpr StripDivision small_division = {
    .strip = 1, .gap = 2, .ring = 1, .span = 1, .liner = 2, .lattice = 1, .grading = 1};

/// A tube without lattice, `bulk_by_shear` times as stiff against a change of volume.
inline CellMesh bare_tube(double inner_mm, double outer_mm, const Law& law, StripDivision division,
                          double bulk_by_shear) {
  StripTube tube = strips(60);
  tube.inner_radius_mm = inner_mm;
  tube.liner_outer_radius_mm = outer_mm;
  tube.outer_radius_mm = outer_mm + 1e-9;
  tube.strip_width_mm = 0.4 * outer_mm;
  tube.liner = law;
  division.lattice = 0;
  CellMesh mesh = strip_cell(tube, division);
  mesh.materials[0].bulk_modulus_mpa = bulk_by_shear * rest_shear_modulus_mpa(law);
  return mesh;
}

}  // namespace latticast::testing
