// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/drawing_problems.h"

#include <algorithm>
#include <optional>
#include <set>

#include <fmt/core.h>

#include "design/text/written_number.h"
#include "geometry/pattern/cannot_draw.h"
#include "geometry/pattern/pattern.h"
#include "geometry/pattern/strand_path.h"

namespace latticast {
namespace {

// The most strands below `count` that leave a gap between neighbours of these widths.
std::optional<int> fewer_strands(const PlacedStrand& strand, int count, double circumference,
                                 double needed) {
  for (int fewer = count - 1; fewer >= 1; --fewer) {
    if (centre_distance_mm(strand, circumference / fewer) > needed) return fewer;
  }
  return std::nullopt;
}

class Family {
 public:
  Family(const Segment& segment, std::size_t number)
      : grid_(segment.lattice->grids[number]),
        circumference_(segment.lattice_circumference_mm()),
        strand_(placed_strand(segment, grid_)),
        path_(describe(grid_.path)),
        key_(fmt::format("lattice.grid[{}].{}", number, path_.name)) {}

  std::vector<std::string> own() {
    if (const auto problem = closing_problem(strand_)) lines_.push_back(key_ + ": " + *problem);
    strand_ = closed(strand_);
    for (int i = 0; i < grid_.count(); ++i) add_strand(i);
    return std::move(lines_);
  }

  std::vector<std::string> with_neighbours() {
    strand_ = closed(strand_);
    distance_ = centre_distance_mm(strand_, circumference_ / grid_.count());
    for (int i = 0; i < grid_.count(); ++i) add_neighbours(i);
    return std::move(lines_);
  }

 private:
  void add(int strand, const std::string& problem) {
    lines_.push_back(fmt::format("{}: strand {} of {} (at {:.1f} degrees around the tube): {}",
                                 key_, strand + 1, grid_.count(), 360.0 * strand / grid_.count(),
                                 problem));
  }

  void add_strand(int strand) {
    strand_.width_mm = grid_.widths_mm[strand];
    if (!seen_widths_.insert(strand_.width_mm).second) return;
    if (const auto problem = own_problem(strand_)) add(strand, *problem);
  }

  void add_neighbours(int strand) {
    strand_.width_mm = grid_.widths_mm[strand];
    const int next = (strand + 1) % grid_.count();
    const double needed = 0.5 * (strand_.width_mm + grid_.widths_mm[next]);
    if (distance_ > needed || !seen_sums_.insert(needed).second) return;
    std::string remedy = distance_ > 1e-3 * needed
                             ? fmt::format("widths below {} mm", written(distance_, 4))
                             : std::string(path_.narrower);
    if (const auto fewer = fewer_strands(strand_, grid_.count(), circumference_, needed)) {
      remedy = fmt::format("count {}, or ", *fewer) + remedy;
    }
    add(strand, fmt::format("overlaps strand {} by {} mm; {} would leave a gap", next + 1,
                            written(needed - distance_, 3), remedy));
  }

  const Grid& grid_;
  double circumference_;
  PlacedStrand strand_;
  PathDescription path_;
  std::string key_;
  double distance_ = 0;  // between neighbours' centre lines
  std::set<double> seen_widths_;
  std::set<double> seen_sums_;
  std::vector<std::string> lines_;
};

/// What `ask` gives of each family of curved strands.
template <class Ask>
std::vector<std::string> of_curved(const Segment& segment, Ask&& ask) {
  std::vector<std::string> problems;
  if (!segment.lattice) return problems;
  for (std::size_t i = 0; i < segment.lattice->grids.size(); ++i) {
    if (!is_curved(segment.lattice->grids[i].path)) continue;
    const std::vector<std::string> lines = ask(i);
    problems.insert(problems.end(), lines.begin(), lines.end());
  }
  return problems;
}

}  // namespace

std::vector<std::string> drawing_problems(const Segment& segment) {
  return of_curved(segment, [&](std::size_t i) { return Family(segment, i).own(); });
}

std::vector<std::string> overlapping_neighbours(const Segment& segment) {
  return of_curved(segment, [&](std::size_t i) { return Family(segment, i).with_neighbours(); });
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
