// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/plane_checks.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "checks/strand_checks.h"
#include "design/text/written_number.h"
#include "numerics/root_search.h"

namespace latticast {
namespace {

constexpr std::size_t most_parts_named = 8;
constexpr double level_mm = 1e-3;
constexpr double even_share = 0.5;
constexpr double rough_share = 0.1;
constexpr double fine_share = 0.01;
constexpr double grid_mm = 1e-3;
constexpr double drawn_mm = 0.02;  // arcs are chords, and corners grid points: finer is not meant

PlanePoint between(PlanePoint a, PlanePoint b, double part) {
  return {a.u + part * (b.u - a.u), a.z + part * (b.z - a.z)};
}

// A point of the outline counted on from any other, u stretched; i may be negative or too large.
PlanePoint point_at(const Outline& outline, std::ptrdiff_t i, double stretch) {
  const auto n = static_cast<std::ptrdiff_t>(outline.points.size());
  const std::ptrdiff_t turns = i >= 0 ? i / n : -((n - 1 - i) / n);
  PlanePoint point = outline.points[static_cast<std::size_t>(i - turns * n)];
  point.u = stretch * (point.u + static_cast<double>(turns) * outline.around_mm);
  return point;
}

double length_mm(const Outline& outline, double stretch) {
  double length = 0;
  for (std::size_t i = 0; i < outline.points.size(); ++i) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    length += distance(point_at(outline, at, stretch), point_at(outline, at + 1, stretch));
  }
  return length;
}

// Walks along an outline from a corner, one way or the other.
class Walk {
 public:
  Walk(const Outline& outline, std::ptrdiff_t corner, int direction, double stretch)
      : outline_(outline), at_(corner), direction_(direction), stretch_(stretch) {
    edge_mm_ = distance(from(), to());
  }

  PlanePoint from() const { return point_at(outline_, at_, stretch_); }
  PlanePoint to() const { return point_at(outline_, at_ + direction_, stretch_); }
  double rest_mm() const { return edge_mm_ - gone_mm_; }
  PlanePoint place(double further_mm) const {
    return between(from(), to(), (gone_mm_ + further_mm) / edge_mm_);
  }
  void advance(double way_mm) {
    gone_mm_ += way_mm;
    if (rest_mm() > 1e-12 * edge_mm_) return;
    at_ += direction_;
    gone_mm_ = 0;
    edge_mm_ = distance(from(), to());
  }

 private:
  const Outline& outline_;
  std::ptrdiff_t at_;
  int direction_;
  double stretch_;
  double edge_mm_ = 0;
  double gone_mm_ = 0;
};

double turn_mm(const UnitedLattice& lattice, double radius_mm) {
  return radius_mm / lattice.segment.lattice_mid_radius_mm();
}

std::vector<PlanePoint> stretched(std::vector<PlanePoint> points, double stretch) {
  for (PlanePoint& p : points) p.u *= stretch;
  return points;
}

PlanePoint middle_of(const std::vector<PlanePoint>& points) {
  PlanePoint middle;
  for (const PlanePoint& p : points) {
    middle.u += p.u / static_cast<double>(points.size());
    middle.z += p.z / static_cast<double>(points.size());
  }
  return middle;
}

CheckFinding finding_at(const UnitedLattice& lattice, std::string_view code, const LatticeUse& use,
                        PlanePoint point) {
  CheckFinding finding = check_finding(code);
  finding.segment = lattice.number;
  finding.part = use.part("lattice");
  finding.place = place_of(lattice, point);
  finding.unit = "mm";
  return finding;
}

// A small opening that fills adds a little plastic; a thin land of a mold breaks.
Severity severity_of_filling(const LatticeUse& use) {
  return use.grooved ? Severity::warning : Severity::note;
}

void check_cells(const UnitedLattice& lattice, const LatticeUse& use, CheckFindings& findings) {
  const double stretch = turn_mm(lattice, lattice.segment.liner_outer_radius_mm());
  const double limit = use.least_between_mm;
  double least = HUGE_VAL;
  int cells = 0;
  const Outline* smallest = nullptr;
  for (const Outline& outline : lattice.plane.outlines) {
    if (!outline.is_cell()) continue;
    const double width =
        inscribed_width_mm(stretched(outline.points, stretch), limit, rough_share * limit);
    if (!clearly_below(width + grid_mm, limit)) continue;
    ++cells;
    if (width >= least) continue;
    least = width;
    smallest = &outline;
  }
  if (smallest == nullptr) return;
  least = inscribed_width_mm(stretched(smallest->points, stretch), limit, fine_share * limit);
  CheckFinding finding = finding_at(lattice, "cell-too-small", use, middle_of(smallest->points));
  finding.severity = severity_of_filling(use);
  finding.value = least;
  finding.limit = limit;
  finding.message = fmt::format(
      "{} of its {} {} less than the printer's {} of {} mm across; the smallest is {} mm "
      "at its inner radius, {}",
      cells, use.grooved ? "lands" : "openings", cells == 1 ? "is" : "are", use.between_limit(),
      written(limit, 3), written(least, 3), use.grooved ? "a pin that breaks" : "and fills");
  finding.remedy =
      fmt::format("fillet = {} closes openings that small; or change a count or an angle",
                  written(std::ceil(500 * limit / stretch) / 1000, 4));
  findings.push_back(std::move(finding));
}

struct Wedge {
  double length_mm = 0;
  PlanePoint corner;
};

Wedge longest_wedge(const UnitedLattice& lattice, double width) {
  Wedge longest;
  for (const double radius :
       {lattice.segment.liner_outer_radius_mm(), lattice.segment.outer_radius_mm()}) {
    const double stretch = turn_mm(lattice, radius);
    for (const Outline& outline : lattice.plane.outlines) {
      for (std::size_t i = 0; i < outline.points.size(); ++i) {
        const double length = wedge_length_mm(outline, i, width, stretch);
        if (length > longest.length_mm) longest = {length, outline.points[i]};
      }
    }
  }
  return longest;
}

void check_corners(const UnitedLattice& lattice, const LatticeUse& use, CheckFindings& findings) {
  const double limit = narrowest_strand_mm(lattice.segment);
  const Wedge wedge = longest_wedge(lattice, use.least_between_mm);
  if (!clearly_above(wedge.length_mm - drawn_mm, limit)) return;
  CheckFinding finding = finding_at(lattice, "acute-corner", use, wedge.corner);
  finding.severity = severity_of_filling(use);
  finding.value = wedge.length_mm;
  finding.limit = limit;
  finding.message = fmt::format(
      "outlines meet so sharply that the {} between them is narrower than the printer's {} of "
      "{} mm for {} mm, more than the narrowest strand is wide ({} mm): {}",
      use.between_word(), use.between_limit(), written(use.least_between_mm, 3),
      written(wedge.length_mm, 3), written(limit, 3),
      use.grooved ? "its tip breaks off" : "it fills, and the joint grows");
  finding.remedy = fmt::format("fillet = {}, or a larger angle between the strands",
                               written(std::ceil(500 * use.least_between_mm) / 1000, 4));
  findings.push_back(std::move(finding));
}

// Rings alone are put on one by one, each at its height; strands alone have nothing that holds
// their distance.
Severity severity_of_parts(const Segment& segment) {
  return segment.lattice->grids.empty() ? Severity::warning : Severity::error;
}

void check_parts(const UnitedLattice& lattice, const LatticeUse& use, CheckFindings& findings) {
  const std::vector<LatticePart>& parts = lattice.plane.parts;
  const std::size_t named = std::min(parts.size(), most_parts_named + 1);
  for (std::size_t i = 1; i < named; ++i) {
    CheckFinding finding = finding_at(lattice, "loose-part", use, parts[i].place);
    finding.severity = severity_of_parts(lattice.segment);
    finding.value = parts[i].area_mm2;
    finding.unit = "mm2";
    finding.message = fmt::format(
        "a part of {} mm2 is not connected to the rest: the lattice falls into {} parts",
        written(parts[i].area_mm2, 3), parts.size());
    if (i + 1 == named && named < parts.size()) {
      finding.message += fmt::format("; {} more are not named", parts.size() - named);
    }
    finding.remedy = lattice.segment.lattice->rings
                         ? "add a grid whose strands cross the rings"
                         : "add rings, as rings = { count = 2, width = 2 }";
    if (parts.front().area_mm2 > even_share * lattice.plane.area_mm2) {
      finding.remedy += ", or change an angle or a count so that strands meet";
    }
    findings.push_back(std::move(finding));
  }
}

}  // namespace

CheckPlace place_of(const UnitedLattice& lattice, PlanePoint point) {
  const double turns = point.u / lattice.plane.circumference_mm;
  return {360 * (turns - std::floor(turns)), point.z};
}

double wedge_length_mm(const Outline& outline, std::size_t corner, double width_mm,
                       double stretch) {
  if (outline.points.size() < 3) return 0;
  const auto at = static_cast<std::ptrdiff_t>(corner);
  const PlanePoint tip = point_at(outline, at, stretch);
  const PlanePoint before = point_at(outline, at - 1, stretch);
  const PlanePoint after = point_at(outline, at + 1, stretch);
  // Material lies on the left: only where the outline turns right is the corner a gap's.
  if (cross(before, tip, after) >= 0) return 0;
  if ((before.u - tip.u) * (after.u - tip.u) + (before.z - tip.z) * (after.z - tip.z) <= 0) {
    return 0;
  }
  Walk back(outline, at, -1, stretch);
  Walk ahead(outline, at, 1, stretch);
  const double half = 0.5 * length_mm(outline, stretch);
  double way = 0;
  while (way < half) {
    const double step = std::min({back.rest_mm(), ahead.rest_mm(), half - way});
    const double apart = distance(back.place(step), ahead.place(step));
    if (apart >= width_mm) {
      const auto excess = [&](double further) {
        return distance(back.place(further), ahead.place(further)) - width_mm;
      };
      return way + bracketed_root(excess, 0, std::min(0.0, excess(0)), step, apart - width_mm, 0);
    }
    way += step;
    back.advance(step);
    ahead.advance(step);
    if (!(step > 0)) break;
  }
  return way;
}

CheckFindings plane_checks(const UnitedLattice& lattice, const LatticeUse& use,
                           bool gaps_are_wide) {
  CheckFindings findings;
  check_parts(lattice, use, findings);
  if (gaps_are_wide) check_cells(lattice, use, findings);
  check_corners(lattice, use, findings);
  return findings;
}

Bridge longest_bridge(const UnitedLattice& lattice) {
  const double stretch = turn_mm(lattice, lattice.segment.outer_radius_mm());
  Bridge longest;
  for (const Outline& outline : lattice.plane.outlines) {
    const auto n = static_cast<std::ptrdiff_t>(outline.points.size());
    for (std::ptrdiff_t i = 0; i < n; ++i) {
      const PlanePoint a = point_at(outline, i, 1);
      const PlanePoint b = point_at(outline, i + 1, 1);
      if (std::abs(b.z - a.z) > level_mm || a.z < level_mm) continue;
      // Material is above where the outline runs towards larger u.
      const double length = stretch * (b.u - a.u);
      if (length > longest.length_mm) longest = {length, between(a, b, 0.5)};
    }
  }
  return longest;
}

}  // namespace latticast
