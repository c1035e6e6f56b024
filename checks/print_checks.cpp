// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/print_checks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

namespace latticast {
namespace {

/// Width of a strand, square to itself, at another radius: its extent around the tube grows with
/// the radius, its pitch along the tube stays.
double width_at_mm(const Segment& segment, const Grid& grid, double width_mm, double radius_mm) {
  const double angle = grid.angle_deg * std::numbers::pi / 180;
  const double stretch = radius_mm / segment.lattice_mid_radius_mm();
  return width_mm * stretch / std::hypot(stretch * std::cos(angle), std::sin(angle));
}

void check_strand_widths(const Design& design, std::size_t s, CheckFindings& findings) {
  const Segment& segment = design.segments[s];
  const double limit = least_wall_mm(design.printer);
  for (std::size_t g = 0; g < segment.lattice->grids.size(); ++g) {
    const Grid& grid = segment.lattice->grids[g];
    const auto thinnest = std::min_element(grid.widths_mm.begin(), grid.widths_mm.end());
    if (thinnest == grid.widths_mm.end()) continue;
    const double width = width_at_mm(segment, grid, *thinnest, segment.liner_outer_radius_mm());
    if (!clearly_below(width, limit)) continue;
    CheckFinding finding = check_finding("strand-too-thin");
    finding.segment = static_cast<int>(s) + 1;
    finding.part = fmt::format("grid {} strand {}", g, thinnest - grid.widths_mm.begin());
    finding.value = width;
    finding.limit = limit;
    finding.unit = "mm";
    finding.message = fmt::format(
        "is {:.3g} mm wide at its inner radius; the printer's least wall "
        "is {:.3g} mm",
        width, limit);
    finding.remedy =
        fmt::format("width = {:.3g}", std::ceil(1000 * *thinnest * limit / width) / 1000);
    findings.push_back(std::move(finding));
  }
}

}  // namespace

double least_wall_mm(const Printer& printer) {
  return printer.min_wall_mm.value_or(printer.process == Process::sla ? 0.4 : 0.8);
}

double least_gap_mm(const Printer& printer) {
  return printer.min_gap_mm.value_or(printer.process == Process::sla ? 0.2 : 0.4);
}

CheckFindings print_checks(const Design& design) {
  CheckFindings findings;
  for (std::size_t s = 0; s < design.segments.size(); ++s) {
    if (!design.segments[s].lattice) continue;
    check_strand_widths(design, s, findings);
  }
  return findings;
}

}  // namespace latticast
