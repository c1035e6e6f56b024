// SPDX-License-Identifier: GPL-3.0-or-later
// Why horseshoes cannot be drawn as asked (drawing_problems.h), and what works.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "design/text/written_number.h"
#include "geometry/pattern/horseshoe_path.h"

namespace latticast {
namespace {

constexpr double closing_tolerance = 2e-3;  // relative change of the radius that goes unsaid
constexpr int most_more_arcs = 200;         // tried, to keep a strand in one piece

double whole_arcs(const HorseshoeColumn& column) {
  return std::max(1.0, std::round(arcs_on_segment(column)));
}

// The same column with another number of arcs on the segment.
HorseshoeColumn with_arcs(const HorseshoeColumn& column, double arcs) {
  HorseshoeColumn changed = column;
  changed.shape.radius_mm *= arcs_on_segment(column) / arcs;
  return changed;
}

bool folds_over(const HorseshoeColumn& column) {
  return column.width_mm >= 2 * column.shape.radius_mm;
}

// Arcs beyond a half circle reach sideways over their ends, to the next arc on their side.
bool runs_into_own_arcs(const HorseshoeColumn& column) {
  const Horseshoe& shape = column.shape;
  if (shape.arc_deg <= 180) return false;
  return !shape.alternate || 2 * chord_mm(shape) <= 2 * shape.radius_mm + column.width_mm;
}

bool in_one_piece(const HorseshoeColumn& column) {
  return draw_strand(column, trial_flatness_mm(column.width_mm)).in_one_piece;
}

std::string fold_problem(const HorseshoeColumn& column) {
  const double radius = column.shape.radius_mm;
  const double most_arcs = std::ceil(whole_arcs(column) * 2 * radius / column.width_mm) - 1;
  std::string remedy = fmt::format("a width below {} mm avoids it", written(2 * radius, 6));
  if (most_arcs >= 1) {
    const HorseshoeColumn fewer = with_arcs(column, most_arcs);
    remedy = fmt::format("radius {} mm, {} arcs, or {}", written(fewer.shape.radius_mm, 6),
                         written(most_arcs, 6), remedy);
  }
  return fmt::format("{} mm wide, its arcs fold over themselves: {}", written(column.width_mm, 6),
                     remedy);
}

// The largest arc, in tenths of a degree, that stays clear of the next on its side, closed.
std::optional<HorseshoeColumn> with_smaller_arc(HorseshoeColumn column) {
  const double radius = column.shape.radius_mm;
  for (int tenths = static_cast<int>(std::ceil(10 * column.shape.arc_deg)) - 1; tenths >= 1800;
       --tenths) {
    column.shape.arc_deg = 0.1 * tenths;
    column.shape.radius_mm = radius;
    column.shape.radius_mm = closing_radius_mm(column);
    if (!runs_into_own_arcs(column) && !folds_over(column)) return column;
  }
  return std::nullopt;
}

std::string own_arcs_problem(const HorseshoeColumn& column) {
  const std::optional<HorseshoeColumn> smaller = with_smaller_arc(column);
  return fmt::format(
      "arcs of {} degrees run into the next ones on their side{}", written(column.shape.arc_deg, 6),
      smaller ? fmt::format("; arc {:.1f} with radius {} mm stays clear", smaller->shape.arc_deg,
                            written(smaller->shape.radius_mm, 6))
              : "; use a smaller arc");
}

std::string parted_problem(const HorseshoeColumn& column) {
  std::string remedy = "; use smaller arcs or a steeper angle";
  for (int i = 1; i <= most_more_arcs; ++i) {
    const double more = whole_arcs(column) + i;
    const HorseshoeColumn smaller = with_arcs(column, more);
    if (folds_over(smaller)) break;
    if (!in_one_piece(smaller)) continue;
    remedy = fmt::format("; radius {} mm, {} arcs, keeps it whole",
                         written(smaller.shape.radius_mm, 6), written(more, 6));
    break;
  }
  return "its arcs bulge past the segment's end, and the level cut there parts it" + remedy;
}

}  // namespace

std::optional<std::string> closing_problem(const HorseshoeColumn& column) {
  const double closing = closing_radius_mm(column);
  const double radius = column.shape.radius_mm;
  if (std::abs(closing - radius) <= closing_tolerance * radius) return std::nullopt;
  return fmt::format(
      "{} arcs of radius {} mm fill the segment, not a whole number; radius "
      "{} mm closes it with {}",
      written(arcs_on_segment(column), 4), written(radius, 6), written(closing, 6),
      written(whole_arcs(column), 6));
}

std::optional<std::string> own_problem(const HorseshoeColumn& asked) {
  const HorseshoeColumn column = closed(asked);
  if (folds_over(column)) return fold_problem(column);
  if (runs_into_own_arcs(column)) return own_arcs_problem(column);
  if (!in_one_piece(column)) return parted_problem(column);
  return std::nullopt;
}

}  // namespace latticast
