// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/flat_pattern.h"

#include <fmt/core.h>

#include "design/text/written_number.h"

namespace latticast {
namespace {

DrawnOutline drawn(const std::vector<PlanePoint>& points) {
  DrawnOutline outline;
  outline.reserve(points.size());
  for (const PlanePoint& p : points) outline.push_back({p.u, p.z});
  return outline;
}

std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

FlatDrawing flat_drawing(const Design& design, std::size_t segment, const FlatPattern& sheet) {
  FlatDrawing drawing;
  drawing.title = design.name;
  if (design.segments.size() > 1) drawing.title += fmt::format(", segment {}", segment + 1);
  drawing.title += ": lattice, flat";
  drawing.width_mm = sheet.circumference_mm;
  drawing.height_mm = sheet.length_mm;
  drawing.notes = drawing_notes(design.segments[segment]);
  for (const FlatPiece& piece : sheet.pieces) {
    DrawnPiece& part = drawing.pieces.emplace_back();
    part.outlines.push_back(drawn(piece.outer));
    for (const auto& hole : piece.holes) part.outlines.push_back(drawn(hole));
  }
  return drawing;
}

std::string describe(const FlatPattern& sheet) {
  std::size_t holes = 0;
  for (const FlatPiece& piece : sheet.pieces) holes += piece.holes.size();
  return fmt::format("{} mm around (R = {} mm), {} mm along, {}, {}, outlines to {} mm",
                     written(sheet.circumference_mm, 6), written(sheet.radius_mm, 6),
                     written(sheet.length_mm, 6), counted(sheet.pieces.size(), "piece"),
                     counted(holes, "hole"), written(sheet.error.distance_mm, 2));
}

}  // namespace latticast
