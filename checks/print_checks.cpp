// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/print_checks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "checks/bed_check.h"
#include "checks/lattice_use.h"
#include "checks/plane_checks.h"
#include "checks/strand_checks.h"
#include "design/text/written_number.h"
#include "design/units.h"
#include "design/unsupported_design.h"
#include "geometry/pattern/drawing_problems.h"
#include "geometry/pattern/strand_path.h"
#include "geometry/solid/geometry_error.h"
#include "geometry/solid/lattice_drawing.h"
#include "prepared/prepared_lattices.h"

namespace latticast {
namespace {

void append(CheckFindings& findings, CheckFindings more) {
  std::move(more.begin(), more.end(), std::back_inserter(findings));
}

bool is_to_be_drawn(const Make& make) {
  return make.lattice || make.lattice_mold || make.preview ||
         (make.liner_mold && make.liner_mold->keyed);
}

CheckFinding cannot_draw(int number, std::string why) {
  CheckFinding finding = check_finding("cannot-draw");
  finding.segment = number;
  finding.part = "lattice";
  finding.message = std::move(why);
  finding.remedy = "change what the message names";
  return finding;
}

// "KEY: what is wrong; what works": the keys of problems name the family.
CheckFindings drawing_findings(const Segment& segment, int number) {
  CheckFindings findings;
  for (const std::string& problem : drawing_problems(segment)) {
    findings.push_back(cannot_draw(number, problem));
  }
  if (!findings.empty()) return findings;
  for (const std::string& overlap : overlapping_neighbours(segment)) {
    CheckFinding finding = check_finding("columns-fused");
    finding.segment = number;
    finding.part = "lattice";
    finding.message = overlap + ". They are drawn as one net";
    finding.remedy = "what the message names; or kind = \"unit-cell\", which predicts the net";
    findings.push_back(std::move(finding));
  }
  return findings;
}

std::optional<UnitedLattice> united_lattice(const Segment& segment, LatticeDrawing& drawing,
                                            int number, CheckFindings& findings) {
  try {
    return UnitedLattice{segment, number, lattice_plane(drawing)};
  } catch (const GeometryError& fault) {
    findings.push_back(cannot_draw(number, fault.what()));
    return std::nullopt;
  }
}

void check_overhang(const Segment& segment, int number, const FreePrinting& free,
                    CheckFindings& findings) {
  for (std::size_t g = 0; g < segment.lattice->grids.size(); ++g) {
    const double slope = least_slope_deg(segment, segment.lattice->grids[g]);
    if (!clearly_below(slope, free.least_slope_deg)) continue;
    CheckFinding finding = check_finding("overhang");
    finding.segment = number;
    finding.part = grid_name(g);
    finding.value = slope;
    finding.limit = free.least_slope_deg;
    finding.unit = "degrees";
    finding.message = fmt::format(
        "its strands rise {} {} degrees from the bed where they are flattest, standing on the "
        "segment's end; {} degrees print without supports",
        is_curved(segment.lattice->grids[g].path) ? "as little as" : "at", written(slope, 3),
        written(free.least_slope_deg, 3));
    finding.remedy = "print it with supports, or cast it: lattice_mold = {}";
    findings.push_back(std::move(finding));
  }
}

void check_bridges(const UnitedLattice& lattice, const FreePrinting& free,
                   CheckFindings& findings) {
  const Bridge bridge = longest_bridge(lattice);
  if (!clearly_above(bridge.length_mm, free.longest_bridge_mm)) return;
  CheckFinding finding = check_finding("long-bridge");
  finding.segment = lattice.number;
  finding.part = "rings";
  finding.place = place_of(lattice, bridge.middle);
  finding.value = bridge.length_mm;
  finding.limit = free.longest_bridge_mm;
  finding.unit = "mm";
  finding.message = fmt::format(
      "the underside runs level for {} mm between supports, at the outer radius; {} mm "
      "print without supports",
      written(bridge.length_mm, 4), written(free.longest_bridge_mm, 3));
  finding.remedy = "print it with supports, use more strands, or cast it: lattice_mold = {}";
  findings.push_back(std::move(finding));
}

bool has_code(const CheckFindings& findings, std::string_view code) {
  return std::any_of(findings.begin(), findings.end(),
                     [&](const CheckFinding& finding) { return finding.code == code; });
}

void check_use(const UnitedLattice& lattice, const LatticeUse& use, const FreePrinting& free,
               CheckFindings& findings) {
  CheckFindings sizes = strand_checks(lattice.segment, lattice.number, use);
  const bool gaps_are_wide = !has_code(sizes, "gap-too-small");
  append(findings, std::move(sizes));
  append(findings, plane_checks(lattice, use, gaps_are_wide));
  if (!use.free_standing) return;
  check_overhang(lattice.segment, lattice.number, free, findings);
  check_bridges(lattice, free, findings);
}

void check_slivers(LatticeDrawing& drawing, int number, CheckFindings& findings) {
  const std::vector<PlanePoint>& places = drawing.near_places();
  if (places.empty()) return;
  CheckFinding finding = check_finding("gap-closed");
  finding.segment = number;
  finding.part = "lattice";
  const double around = 2 * pi * drawing.segment().lattice_mid_radius_mm();
  finding.place = {360 * places.front().u / around, places.front().z};
  finding.value = static_cast<double>(places.size());
  finding.unit = "places";
  finding.limit = 0;
  finding.message = fmt::format(
      "outlines come nearer than the tolerance of {} mm without meeting, in {} place{}; such gaps "
      "are closed, and necks of fillets parted, in all that is made",
      written(drawing.sliver_mm(), 3), places.size(), places.size() == 1 ? "" : "s");
  finding.remedy =
      "none needed; a fillet rounds such corners, a finer tolerance keeps more of them";
  findings.push_back(std::move(finding));
}

void check_lattice(const Design& design, PreparedLattices& lattices, std::size_t s,
                   CheckFindings& findings) {
  const Segment& segment = design.segments[s];
  const int number = static_cast<int>(s) + 1;
  const std::vector<LatticeUse> uses = lattice_uses(design);
  const bool drawn = is_to_be_drawn(design.make);
  if (!drawn && uses.empty()) return;
  const bool drawable = drawing_problems(segment).empty();
  if (drawn) append(findings, drawing_findings(segment, number));
  if (!drawable) return;
  const auto lattice = united_lattice(segment, lattices.of(s), number, findings);
  if (!lattice) return;
  check_slivers(lattices.of(s), number, findings);
  for (std::size_t i = 0; i < uses.size(); ++i) {
    CheckFindings more;
    check_use(*lattice, uses[i], free_printing(design.printer.process), more);
    // What falls apart does so however it is made.
    if (i > 0) std::erase_if(more, [](const CheckFinding& f) { return f.code == "loose-part"; });
    append(findings, std::move(more));
  }
}

void check_printed_liner(const Design& design, std::size_t s, CheckFindings& findings) {
  const double thickness = design.segments[s].liner.thickness_mm;
  const double limit = least_wall_mm(design.printer);
  if (!clearly_below(thickness, limit)) return;
  CheckFinding finding = check_finding("layer-too-thin");
  finding.segment = static_cast<int>(s) + 1;
  finding.part = "liner";
  finding.value = thickness;
  finding.limit = limit;
  finding.unit = "mm";
  finding.message = fmt::format("is {} mm thick; the printer's least wall is {} mm",
                                written(thickness, 3), written(limit, 3));
  finding.remedy = fmt::format("liner.thickness = {}", written(limit, 4));
  findings.push_back(std::move(finding));
}

void check_bed(const Design& design, std::size_t s, CheckFindings& findings) {
  if (!design.printer.bed_mm) return;
  const Segment& segment = design.segments[s];
  const auto add = [&](const std::string& part, double radius) {
    auto finding =
        bed_finding(part, {2 * radius, 2 * radius, segment.length_mm}, *design.printer.bed_mm);
    if (!finding) return;
    finding->segment = static_cast<int>(s) + 1;
    finding->remedy = "use a larger printer";
    const double highest = (*design.printer.bed_mm)[2];
    if (segment.length_mm > highest) {
      finding->remedy += fmt::format(", or segments of at most {} mm", written(highest, 6));
    }
    findings.push_back(std::move(*finding));
  };
  if (design.make.lattice && segment.lattice) add("lattice", segment.outer_radius_mm());
  if (design.make.liner) add("liner", segment.liner_outer_radius_mm());
}

}  // namespace

FreePrinting free_printing(Process process) {
  return process == Process::sla ? FreePrinting{19, 21} : FreePrinting{45, 10};
}

double least_slope_deg(const Segment& segment, const Grid& grid) {
  const double turned = largest_slope_deg(placed_strand(segment, grid));
  const double slope = std::max(0.0, 90 - std::abs(grid.angle_deg - 90) - turned);
  if (slope == 0 || slope == 90) return slope;
  const double stretch = segment.outer_radius_mm() / segment.lattice_mid_radius_mm();
  return degrees(std::atan(std::tan(radians(slope)) / stretch));
}

CheckFindings print_checks(const Design& design, PreparedLattices& lattices) {
  CheckFindings findings;
  for (std::size_t s = 0; s < design.segments.size(); ++s) {
    if (design.segments[s].lattice) check_lattice(design, lattices, s, findings);
    if (design.make.liner) check_printed_liner(design, s, findings);
    check_bed(design, s, findings);
  }
  return findings;
}

}  // namespace latticast
