// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/shell.h"

#include <algorithm>
#include <cstdint>
#include <numbers>

#include "geometry/solid/layered_solid.h"
#include "geometry/solid/tolerance_budget.h"

namespace latticast {
namespace {

enum class ShellSheet : std::uint8_t { lattice, piece, bores, straps };

// Lands between the lattice's grooves, the wall behind the grooves, and what the straps' grooves
// are cut into.
enum class ShellLayer : std::uint8_t { lands, wall, outside };

Layers shell_layers(unsigned sheets) {
  if (!has(sheets, ShellSheet::piece) || has(sheets, ShellSheet::bores)) return 0;
  Layers material = only(ShellLayer::wall);
  if (!has(sheets, ShellSheet::lattice)) material |= only(ShellLayer::lands);
  if (!has(sheets, ShellSheet::straps)) material |= only(ShellLayer::outside);
  return material;
}

// The sheet of the lattice, on which the pieces' own are laid.
LayeredTube tube_of(const Shell& shell) {
  LayeredTube tube;
  tube.drawn_radius_mm = shell.parting.drawn_radius_mm;
  tube.length_mm = shell.lattice.length_mm;
  tube.start_z_mm = shell.start_z_mm;
  tube.sheets = {shell.lattice};
  tube.filling = shell_layers;
  tube.layers = {{shell.cast.floor_mm + 0.5 * shell.clearance_mm, shell.cast.ceiling_mm},
                 {shell.cast.ceiling_mm, shell.strap_radius_mm},
                 {shell.strap_radius_mm, shell.outer_radius_mm}};
  tube.steepness = 1;
  return tube;
}

}  // namespace

Strand drawn_piece(const Shell& shell, int piece) {
  const Parting& parting = shell.parting;
  const double back = 0.5 * shell.clearance_mm;
  const double left = parting.drawn_radius_mm * seam_rad(parting, piece) + back;
  const double right = parting.drawn_radius_mm * seam_rad(parting, piece + 1) - back;
  Strand outline;
  std::vector<PlanePoint> left_side;
  for (const PlanePoint& p : parting.seam) {
    outline.outline.push_back({right + p.u, p.z});
    left_side.push_back({left + p.u, p.z});
  }
  outline.outline.insert(outline.outline.end(), left_side.rbegin(), left_side.rend());
  return outline;
}

Shell with_closed_lattice(Shell shell, double tolerance_mm) {
  shell.lattice = closed_sheet_0(tube_of(shell), tolerance_mm);
  shell.closed_for_mm = tolerance_mm;
  return shell;
}

Solid shell_solid(const Shell& shell, int piece, double tolerance_mm) {
  const double drawn = shell.parting.drawn_radius_mm;
  const double around = shell.lattice.circumference_mm;
  const double length = shell.lattice.length_mm;
  const double flatness = layered_budget(tolerance_mm).drawing_mm;
  Pattern bores{around, length, {}};
  for (const Bore& b : shell.bores) {
    bores.strands.push_back(
        drawn_disc(drawn, b.middle.u / drawn, b.middle.z, b.radius_mm, flatness));
    bores.error += disc_error(b.radius_mm, flatness);
  }
  Pattern straps{around, length, {}};
  for (const StrapGroove& groove : shell.straps) {
    straps.strands.push_back(drawn_band(drawn, groove.from_mm, groove.to_mm));
  }
  LayeredTube tube = tube_of(shell);
  tube.sheets.push_back({around, length, {drawn_piece(shell, piece)}});
  tube.sheets.push_back(std::move(bores));
  tube.sheets.push_back(std::move(straps));
  tube.sheet_0_is_closed = shell.closed_for_mm == tolerance_mm;
  return layered_solid(tube, tolerance_mm);
}

}  // namespace latticast
