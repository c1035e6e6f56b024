// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/strand_checks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "design/text/written_number.h"
#include "design/units.h"
#include "design/unsupported_design.h"
#include "geometry/pattern/rings.h"
#include "geometry/pattern/strand_path.h"

namespace latticast {
namespace {

// Remedies are written with this many decimals, to the safe side.
double rounded_up(double length_mm) {
  return std::ceil(1000 * length_mm - 1e-6) / 1000;
}

double rounded_down(double length_mm) {
  return std::floor(1000 * length_mm + 1e-6) / 1000;
}

double around_tube_mm(const Segment& segment) {
  return 2 * std::numbers::pi * segment.lattice_mid_radius_mm();
}

double shrunk(const Segment& segment) {
  return segment.liner_outer_radius_mm() / segment.lattice_mid_radius_mm();
}

// Between the centre lines of neighbouring strands, square to them, of a family of `count`.
double centre_distance(const Segment& segment, const Grid& grid, int count) {
  const double spacing = around_tube_mm(segment) / count;
  return centre_distance_mm(closed(placed_strand(segment, grid)), spacing);
}

// What lies between neighbours at R_c, seen at the inner radius.
double gap_at_bore(const Segment& segment, const Grid& grid, double gap_mm) {
  if (is_curved(grid.path)) return gap_mm * shrunk(segment);
  return width_at_radius_mm(segment, grid.angle_deg, gap_mm, segment.liner_outer_radius_mm());
}

CheckFinding finding_at(std::string_view code, int number, std::string part, double value,
                        double limit) {
  CheckFinding finding = check_finding(code);
  finding.segment = number;
  finding.part = std::move(part);
  finding.value = value;
  finding.limit = limit;
  finding.unit = "mm";
  return finding;
}

class StrandChecks {
 public:
  StrandChecks(const Segment& segment, int number, const LatticeUse& use)
      : segment_(segment), lattice_(*segment.lattice), number_(number), use_(use) {}

  CheckFindings run() {
    check_layer();
    if (lattice_.rings) check_rings(*lattice_.rings);
    for (std::size_t g = 0; g < lattice_.grids.size(); ++g) {
      check_strands(lattice_.grids[g], g);
      check_gaps(lattice_.grids[g], g);
    }
    return std::move(findings_);
  }

 private:
  // A groove may be shallow.
  void check_layer() {
    const double thickness = lattice_.thickness_mm;
    if (use_.grooved || !clearly_below(thickness, use_.least_strand_mm)) return;
    CheckFinding finding =
        finding_at("layer-too-thin", number_, "lattice", thickness, use_.least_strand_mm);
    finding.message = fmt::format(
        "is {} mm thick from its inner to its outer radius; the printer's {} is "
        "{} mm",
        written(thickness, 3), use_.strand_limit(), written(use_.least_strand_mm, 3));
    finding.remedy =
        fmt::format("lattice.thickness = {}", written(rounded_up(use_.least_strand_mm), 4));
    findings_.push_back(std::move(finding));
  }

  void check_rings(const Rings& rings) {
    if (clearly_below(rings.width_mm, use_.least_strand_mm)) add_thin_rings(rings);
    const double gap = ring_pitch_mm(rings, segment_.length_mm) - rings.width_mm;
    const bool several = ring_centres_mm(rings, segment_.length_mm).size() > 1;
    if (several && !closed_by_fillet(gap) && clearly_below(gap, use_.least_between_mm)) {
      add_close_rings(rings, gap);
    }
  }

  void add_thin_rings(const Rings& rings) {
    CheckFinding finding = finding_at("ring-too-thin", number_, use_.part("rings"), rings.width_mm,
                                      use_.least_strand_mm);
    finding.place = CheckPlace{0, ring_centres_mm(rings, segment_.length_mm).front()};
    finding.message = fmt::format(
        "each {} is {} mm wide; the printer's {} is {} mm", use_.grooved ? "ring's groove" : "ring",
        written(rings.width_mm, 3), use_.strand_limit(), written(use_.least_strand_mm, 3));
    finding.remedy = fmt::format("rings.width = {}", written(rounded_up(use_.least_strand_mm), 4));
    findings_.push_back(std::move(finding));
  }

  void add_close_rings(const Rings& rings, double gap) {
    CheckFinding finding =
        finding_at("gap-too-small", number_, use_.part("rings"), gap, use_.least_between_mm);
    const std::vector<double> centres = ring_centres_mm(rings, segment_.length_mm);
    finding.place = CheckPlace{0, 0.5 * (centres[0] + centres[1])};
    finding.message = between_message("rings", gap, "");
    if (rings.pitch_mm) {
      finding.remedy = fmt::format("rings.pitch = {}",
                                   written(rounded_up(rings.width_mm + use_.least_between_mm), 6));
    } else {
      // n w + (n - 1) gap = L
      const double count = std::floor((segment_.length_mm + use_.least_between_mm) /
                                          (rings.width_mm + use_.least_between_mm) +
                                      1e-9);
      finding.remedy = count >= 2 ? fmt::format("rings.count = {}", written(count, 6))
                                  : "use thinner rings or a longer segment";
    }
    add_gap(std::move(finding));
  }

  void check_strands(const Grid& grid, std::size_t g) {
    const auto thinnest = std::min_element(grid.widths_mm.begin(), grid.widths_mm.end());
    if (thinnest == grid.widths_mm.end()) return;
    const double width = least_width_mm(segment_, grid, *thinnest);
    if (!clearly_below(width, use_.least_strand_mm)) return;
    const auto strand = thinnest - grid.widths_mm.begin();
    CheckFinding finding =
        finding_at("strand-too-thin", number_,
                   use_.part(fmt::format("{} strand {}", grid_name(g), strand + 1)), width,
                   use_.least_strand_mm);
    finding.place = CheckPlace{360.0 * static_cast<double>(strand) / grid.count(), 0};
    finding.message = fmt::format("{} {} mm wide at its inner radius; the printer's {} is {} mm",
                                  use_.grooved ? "its groove is" : "is", written(width, 4),
                                  use_.strand_limit(), written(use_.least_strand_mm, 3));
    finding.remedy =
        fmt::format("width = {}", written(rounded_up(*thinnest * use_.least_strand_mm / width), 4));
    findings_.push_back(std::move(finding));
  }

  void check_gaps(const Grid& grid, std::size_t g) {
    if (grid.widths_mm.empty()) return;
    const double apart = centre_distance(segment_, grid, grid.count());
    double least = HUGE_VAL;
    int strand = 0;
    for (int i = 0; i < grid.count(); ++i) {
      const double gap = apart - 0.5 * (grid.widths_mm[i] + grid.widths_mm[(i + 1) % grid.count()]);
      if (gap < least) strand = i;
      least = std::min(least, gap);
    }
    // Overlapping columns are cannot-draw's concern.
    if (least <= 0 || closed_by_fillet(least)) return;
    const double gap = gap_at_bore(segment_, grid, least);
    if (clearly_below(gap, use_.least_between_mm)) add_close_strands(grid, g, strand, gap);
  }

  void add_close_strands(const Grid& grid, std::size_t g, int strand, double gap) {
    const int next = (strand + 1) % grid.count();
    CheckFinding finding = finding_at(
        "gap-too-small", number_, use_.part(fmt::format("{} strand {}", grid_name(g), strand + 1)),
        gap, use_.least_between_mm);
    finding.place = CheckPlace{360.0 * (strand + 0.5) / grid.count(), 0};
    finding.message = between_message(fmt::format("strands {} and {}", strand + 1, next + 1), gap,
                                      " at the inner radius");
    finding.remedy = wider_gap(grid);
    add_gap(std::move(finding));
  }

  // The most strands of the widest width that leave what is needed, or a width that does.
  std::string wider_gap(const Grid& grid) const {
    const double widest = *std::max_element(grid.widths_mm.begin(), grid.widths_mm.end());
    const auto passes = [&](int count, double width) {
      const double gap = centre_distance(segment_, grid, count) - width;
      return gap > 0 && !clearly_below(gap_at_bore(segment_, grid, gap), use_.least_between_mm);
    };
    const double needed = use_.least_between_mm / gap_at_bore(segment_, grid, 1.0);
    const double narrower = rounded_down(centre_distance(segment_, grid, grid.count()) - needed);
    int fewer = grid.count() - 1;
    while (fewer > 0 && !passes(fewer, widest)) --fewer;
    const bool narrow_enough = narrower > 0 && narrower >= use_.least_strand_mm;
    if (fewer > 0 && narrow_enough) {
      return fmt::format("count = {}, or no width above {}", fewer, written(narrower, 4));
    }
    if (fewer > 0) return fmt::format("count = {}", fewer);
    if (narrow_enough) return fmt::format("no width above {}", written(narrower, 4));
    return "use a larger tube or a finer printer";
  }

  std::string between_message(const std::string& between, double gap,
                              const std::string& where) const {
    return fmt::format("the {} between {} is {} mm{}; the printer's {} is {} mm{}",
                       use_.between_word(), between, written(gap, 3), where, use_.between_limit(),
                       written(use_.least_between_mm, 3),
                       use_.between_is_stated ? "" : " as is usual for its process");
  }

  // What a printer can do is known only where the file says so.
  void add_gap(CheckFinding finding) {
    if (!use_.between_is_stated) finding.severity = Severity::warning;
    findings_.push_back(std::move(finding));
  }

  bool closed_by_fillet(double gap_mm) const { return gap_mm < 2 * lattice_.fillet_mm; }

  const Segment& segment_;
  const Lattice& lattice_;
  int number_;
  const LatticeUse& use_;
  CheckFindings findings_;
};

}  // namespace

double width_at_radius_mm(const Segment& segment, double angle_deg, double width_mm,
                          double radius_mm) {
  const double stretch = radius_mm / segment.lattice_mid_radius_mm();
  const double angle = radians(angle_deg);
  return width_mm * stretch / std::hypot(stretch * std::cos(angle), std::sin(angle));
}

double least_width_mm(const Segment& segment, const Grid& grid, double width_mm) {
  const double turned = largest_slope_deg(placed_strand(segment, grid));
  const double off_axis = std::max(0.0, std::abs(grid.angle_deg - 90) - turned);
  return width_at_radius_mm(segment, 90 - off_axis, width_mm, segment.liner_outer_radius_mm());
}

double narrowest_strand_mm(const Segment& segment) {
  const Lattice& lattice = *segment.lattice;
  double narrowest = lattice.rings ? lattice.rings->width_mm : HUGE_VAL;
  for (const Grid& grid : lattice.grids) {
    for (const double width : grid.widths_mm) {
      narrowest = std::min(narrowest, least_width_mm(segment, grid, width));
    }
  }
  return narrowest;
}

CheckFindings strand_checks(const Segment& segment, int number, const LatticeUse& use) {
  return StrandChecks(segment, number, use).run();
}

}  // namespace latticast
