// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/drawing_problems.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include <fmt/core.h>

#include "geometry/pattern/horseshoe_path.h"
#include "geometry/pattern/pattern.h"

namespace latticast {
namespace {

constexpr double closing_tolerance = 2e-3;  // relative change of the radius that goes unsaid
constexpr double trial_flatness = 0.01;     // of the strand's width
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
  return draw_horseshoe(column, trial_flatness * column.width_mm).in_one_piece;
}

std::optional<std::string> closing_problem(const HorseshoeColumn& column) {
  const double closing = closing_radius_mm(column);
  const double radius = column.shape.radius_mm;
  if (std::abs(closing - radius) <= closing_tolerance * radius) return std::nullopt;
  return fmt::format(
      "{:.4g} arcs of radius {:g} mm fill the segment, not a whole number; radius "
      "{:.6g} mm closes it with {:g}",
      arcs_on_segment(column), radius, closing, whole_arcs(column));
}

std::string fold_problem(const HorseshoeColumn& column) {
  const double radius = column.shape.radius_mm;
  const double most_arcs = std::ceil(whole_arcs(column) * 2 * radius / column.width_mm) - 1;
  std::string remedy = fmt::format("a width below {:.6g} mm avoids it", 2 * radius);
  if (most_arcs >= 1) {
    const HorseshoeColumn fewer = with_arcs(column, most_arcs);
    remedy =
        fmt::format("radius {:.6g} mm, {:g} arcs, or {}", fewer.shape.radius_mm, most_arcs, remedy);
  }
  return fmt::format("{:g} mm wide, its arcs fold over themselves: {}", column.width_mm, remedy);
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
  return fmt::format("arcs of {:g} degrees run into the next ones on their side{}",
                     column.shape.arc_deg,
                     smaller ? fmt::format("; arc {:.1f} with radius {:.6g} mm stays clear",
                                           smaller->shape.arc_deg, smaller->shape.radius_mm)
                             : "; use a smaller arc");
}

std::string parted_problem(const HorseshoeColumn& column) {
  std::string remedy = "; use smaller arcs or a steeper angle";
  for (int i = 1; i <= most_more_arcs; ++i) {
    const double more = whole_arcs(column) + i;
    const HorseshoeColumn smaller = with_arcs(column, more);
    if (folds_over(smaller)) break;
    if (!in_one_piece(smaller)) continue;
    remedy =
        fmt::format("; radius {:.6g} mm, {:g} arcs, keeps it whole", smaller.shape.radius_mm, more);
    break;
  }
  return "its arcs bulge past the segment's end, and the level cut there parts it" + remedy;
}

// A problem of one strand alone.
std::optional<std::string> own_problem(HorseshoeColumn column) {
  column.shape.radius_mm = closing_radius_mm(column);
  if (folds_over(column)) return fold_problem(column);
  if (runs_into_own_arcs(column)) return own_arcs_problem(column);
  if (!in_one_piece(column)) return parted_problem(column);
  return std::nullopt;
}

// The most strands below `count` that leave a gap between neighbours of these widths.
std::optional<int> fewer_columns(const HorseshoeColumn& column, int count, double circumference,
                                 double needed) {
  for (int fewer = count - 1; fewer >= 1; --fewer) {
    if (centre_distance_mm(column, circumference / fewer) > needed) return fewer;
  }
  return std::nullopt;
}

class Family {
 public:
  Family(const Segment& segment, std::size_t number)
      : grid_(segment.lattice->grids[number]),
        circumference_(segment.lattice_circumference_mm()),
        column_{*grid_.horseshoe, 0, grid_.angle_deg, 0, segment.length_mm},
        key_(fmt::format("lattice.grid[{}].horseshoe", number)) {}

  std::vector<std::string> run() {
    if (const auto problem = closing_problem(column_)) lines_.push_back(key_ + ": " + *problem);
    column_.shape.radius_mm = closing_radius_mm(column_);
    distance_ = centre_distance_mm(column_, circumference_ / grid_.count());
    for (int i = 0; i < grid_.count(); ++i) add_strand(i);
    for (int i = 0; i < grid_.count(); ++i) add_neighbours(i);
    return std::move(lines_);
  }

 private:
  void add(int strand, const std::string& problem) {
    lines_.push_back(fmt::format("{}: strand {} of {} (at {:.1f} degrees around the tube): {}",
                                 key_, strand, grid_.count(), 360.0 * strand / grid_.count(),
                                 problem));
  }

  void add_strand(int strand) {
    column_.width_mm = grid_.widths_mm[strand];
    if (!seen_widths_.insert(column_.width_mm).second) return;
    if (const auto problem = own_problem(column_)) add(strand, *problem);
  }

  void add_neighbours(int strand) {
    column_.width_mm = grid_.widths_mm[strand];
    const int next = (strand + 1) % grid_.count();
    const double needed = 0.5 * (column_.width_mm + grid_.widths_mm[next]);
    if (distance_ > needed || !seen_sums_.insert(needed).second) return;
    std::string remedy = distance_ > 1e-3 * needed
                             ? fmt::format("widths below {:.4g} mm", distance_)
                             : "arcs of a smaller radius";
    if (const auto fewer = fewer_columns(column_, grid_.count(), circumference_, needed)) {
      remedy = fmt::format("count {}, or ", *fewer) + remedy;
    }
    add(strand, fmt::format("overlaps strand {} by {:.3g} mm; {} would leave a gap", next,
                            needed - distance_, remedy));
  }

  const Grid& grid_;
  double circumference_;
  HorseshoeColumn column_;
  std::string key_;
  double distance_ = 0;  // between neighbours' centre lines
  std::set<double> seen_widths_;
  std::set<double> seen_sums_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> drawing_problems(const Segment& segment) {
  std::vector<std::string> problems;
  if (!segment.lattice) return problems;
  for (std::size_t i = 0; i < segment.lattice->grids.size(); ++i) {
    if (!segment.lattice->grids[i].horseshoe) continue;
    const std::vector<std::string> lines = Family(segment, i).run();
    problems.insert(problems.end(), lines.begin(), lines.end());
  }
  return problems;
}

void require_drawable(std::span<const Segment> segments) {
  std::string text;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (const std::string& problem : drawing_problems(segments[i])) {
      text += fmt::format("\n  segment[{}].{}", i, problem);
    }
  }
  if (!text.empty()) throw CannotDraw("the lattice cannot be drawn:" + text);
}

}  // namespace latticast
