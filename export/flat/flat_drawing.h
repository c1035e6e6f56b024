// SPDX-License-Identifier: GPL-3.0-or-later
// Flat drawings, SVG and DXF: a sheet at true scale, for a laser cutter or a drawing board.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "design/design.h"

namespace latticast {

/// A closed outline, x to the right and y up, in mm; the last point is joined to the first.
using DrawnOutline = std::vector<std::array<double, 2>>;

/// Its outer outline first, then its holes.
struct DrawnPiece {
  std::vector<DrawnOutline> outlines;
};

/// What is cut lies in 0 <= x <= width, 0 <= y <= height.
struct FlatDrawing {
  std::string title;
  double width_mm = 0;   ///< once around the tube
  double height_mm = 0;  ///< along it
  std::vector<DrawnPiece> pieces;
  std::vector<std::string> notes;  ///< lines of ASCII below the title
};

/// What one who holds the drawing must know: the radius of unrolling, how to look at it, and the
/// angle, number and width of every family. Precondition: the segment has a lattice.
std::vector<std::string> drawing_notes(const Segment& segment);

/// SVG, a unit a millimetre. Groups, which drawing programs show as layers: "lattice" (a path a
/// piece, holes by the even-odd rule), "sheet" (the rectangle), "marks" (paths at Theta = 0, 90,
/// 180, 270 degrees, a scale bar of 50 mm, or of the height if that is less, title and notes).
/// Hairlines without fill, each group in a colour of its own. y is turned: up on paper is up along
/// the tube. Numbers are written so that they read back as the same doubles. Depends on the
/// arguments alone. Throws FileError as TemporaryFile does.
void write_svg(const std::filesystem::path& target, const FlatDrawing& drawing);

/// DXF, AutoCAD 2000, ASCII, its unit set to millimetres ($INSUNITS 4). The same as layers LATTICE
/// (closed LWPOLYLINE, holes too), SHEET and MARKS (LINE, TEXT), moved by whole millimetres so that
/// no coordinate is negative: some programs cut off what is. Letters beyond ASCII in the title are
/// written as \U+XXXX, those beyond U+FFFF as a question mark.
void write_dxf(const std::filesystem::path& target, const FlatDrawing& drawing);

}  // namespace latticast
