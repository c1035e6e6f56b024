// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/casting_checks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "checks/bed_check.h"
#include "checks/lattice_use.h"
#include "checks/strand_checks.h"
#include "design/design.h"
#include "design/text/written_number.h"
#include "design/units.h"
#include "geometry/pattern/drawing_problems.h"
#include "geometry/solid/geometry_error.h"
#include "molds/lattice_mold.h"
#include "molds/liner_mold.h"
#include "molds/mold_options.h"
#include "molds/pour_plan.h"
#include "molds/replica_mold.h"
#include "prepared/prepared_lattices.h"
#include "prepared/prepared_molds.h"

namespace latticast {
namespace {

constexpr double deepest_strap_mm = 1.5;
constexpr double strap_share_of_wall = 1.0 / 3;

class MoldChecks {
 public:
  MoldChecks(const Design& design, PreparedLattices& lattices, PreparedMolds& molds, std::size_t s)
      : design_(design),
        lattices_(lattices),
        molds_(molds),
        index_(s),
        number_(static_cast<int>(s) + 1),
        segment_(design.segments[s]) {}

  CheckFindings run() {
    if (design_.make.lattice_mold && segment_.lattice) {
      check_lattice_mold(*design_.make.lattice_mold);
    }
    if (design_.make.liner_mold) check_liner_mold(*design_.make.liner_mold);
    return std::move(findings_);
  }

 private:
  CheckFinding finding_of(std::string_view code, std::string part) const {
    CheckFinding finding = check_finding(code);
    finding.segment = number_;
    finding.part = std::move(part);
    return finding;
  }

  void check_lattice_mold(const LatticeMold& asked) {
    check_wall("lattice_mold", "lattice-mold", asked.wall_mm);
    if (!drawing_problems(segment_).empty()) return;
    try {
      if (asked.method == MoldMethod::replica) {
        check_pieces("lattice-mold", replica_extent(molds_.lattice_mold_plan(index_)));
      } else {
        check_direct_mold(molds_.lattice_mold_plan(index_));
      }
    } catch (const CannotMold& fault) {
      add_impossible("lattice-mold", fault.what());
    } catch (const GeometryError& fault) {
      add_impossible("lattice-mold", fault.what());
    }
  }

  void check_liner_mold(const LinerMold& asked) {
    check_wall("liner_mold", "liner-mold", asked.wall_mm);
    if (asked.keyed && !drawing_problems(segment_).empty()) return;
    try {
      check_pieces("liner-mold", extent_of(segment_, liner_mold_options(design_, segment_)));
    } catch (const CannotMold& fault) {
      add_impossible("liner-mold", fault.what());
    } catch (const GeometryError& fault) {
      add_impossible("liner-mold", fault.what());
    }
  }

  void add_impossible(const std::string& part, std::string why) {
    CheckFinding finding = finding_of("mold-impossible", part);
    finding.message = std::move(why);
    finding.remedy = "change what the message names";
    findings_.push_back(std::move(finding));
  }

  // The shell is thinnest under its strap grooves.
  void check_wall(const std::string& key, const std::string& part, double wall) {
    const double limit = least_wall_mm(design_.printer);
    const double left = wall - std::min(deepest_strap_mm, strap_share_of_wall * wall);
    if (!clearly_below(left, limit)) return;
    CheckFinding finding = finding_of("mold-wall-too-thin", part + " shell");
    finding.value = left;
    finding.limit = limit;
    finding.unit = "mm";
    finding.message = fmt::format(
        "a wall of {} mm leaves {} mm under the strap grooves; the printer's least wall is "
        "{} mm",
        written(wall, 4), written(left, 3), written(limit, 3));
    const double thin = limit / (1 - strap_share_of_wall);
    const double enough =
        strap_share_of_wall * thin <= deepest_strap_mm ? thin : limit + deepest_strap_mm;
    finding.remedy =
        fmt::format("{}.wall = {}", key, written(std::ceil(1000 * enough - 1e-6) / 1000, 4));
    findings_.push_back(std::move(finding));
  }

  // Nothing is wider than the plates, and nothing higher than these.
  void check_pieces(const std::string& part, const MoldExtent& extent) {
    const double core = extent.core_diameter_mm;
    const double plate = extent.plate_diameter_mm;
    if (extent.core_length_mm > 0) check_bed(part + " core", {core, core, extent.core_length_mm});
    check_bed(part + " base", {plate, plate, extent.plate_height_mm});
    const double highest = std::max(extent.core_length_mm, extent.plate_height_mm);
    if (extent.shell_height_mm > highest) {
      check_bed(part + " shell", {0.5 * plate, 0.5 * plate, extent.shell_height_mm});
    }
  }

  void check_bed(const std::string& part, const StandingSize& size) {
    if (!design_.printer.bed_mm) return;
    auto finding = bed_finding(part, size, *design_.printer.bed_mm);
    if (!finding) return;
    finding->segment = number_;
    finding->remedy = "use a thinner wall, shorter segments or a larger printer";
    findings_.push_back(std::move(*finding));
  }

  void check_direct_mold(const LatticeMoldPlan& plan) {
    check_depth();
    check_demolding(plan);
    check_bores(plan);
    check_pour(plan);
    check_pieces("lattice-mold", extent_of(plan));
  }

  void check_depth() {
    const double width = narrowest_strand_mm(segment_);
    const double depth = segment_.lattice->thickness_mm;
    if (!clearly_above(depth / width, deepest_groove)) return;
    CheckFinding finding = finding_of("groove-too-deep", "lattice-mold shell");
    finding.value = depth / width;
    finding.limit = deepest_groove;
    finding.message = fmt::format(
        "the narrowest groove is {} mm wide and {} mm deep, {} times its width; up to "
        "{} times fill and release well",
        written(width, 3), written(depth, 3), written(depth / width, 3),
        written(deepest_groove, 3));
    finding.remedy = fmt::format("lattice.thickness = {}, or wider strands",
                                 written(std::floor(1000 * deepest_groove * width) / 1000, 3));
    findings_.push_back(std::move(finding));
  }

  void check_demolding(const LatticeMoldPlan& plan) {
    const Undercut worst = worst_undercut(plan.undercuts);
    const double limit = plan.options.allowed_strain;
    if (!clearly_above(worst.strain, limit)) return;
    CheckFinding finding =
        finding_of("demolding-strain", fmt::format("lattice-mold shell-{}", worst.piece + 1));
    const auto& at_break = segment_.lattice->material.elongation_at_break;
    if (at_break && worst.strain > *at_break) finding.severity = Severity::error;
    finding.place = place_in_mold(plan, worst.at);
    finding.value = worst.strain;
    finding.limit = limit;
    finding.message = fmt::format(
        "taking it off squeezes a strand of {} mm by {} mm, a strain of {}; {} should "
        "bear no more than {}",
        written(worst.strand_width_mm, 3), written(worst.undercut_mm, 3), written(worst.strain, 3),
        segment_.lattice->material.name, written(limit, 3));
    finding.remedy = gentler_parting();
    findings_.push_back(std::move(finding));
  }

  // What "auto" takes: perhaps no number of pieces is gentle enough.
  std::string gentler_parting() const {
    LatticeMoldOptions options = lattice_mold_options(design_, segment_);
    options.pieces.reset();
    const LatticeMoldPlan plan = plan_lattice_mold(lattices_.of(index_), options);
    if (!clearly_above(worst_undercut(plan.undercuts).strain, options.allowed_strain)) {
      return fmt::format("lattice_mold.pieces = {}", plan.shell.parting.pieces);
    }
    return "lattice_mold.method = \"replica\", which parts nothing, or a thinner lattice";
  }

  // A round hole that is narrower than the least gap prints shut.
  void check_bores(const LatticeMoldPlan& plan) {
    const double limit = least_gap_mm(design_.printer);
    const Bore* narrowest = nullptr;
    for (const Bore& bore : plan.shell.bores) {
      if (narrowest == nullptr || bore.radius_mm < narrowest->radius_mm) narrowest = &bore;
    }
    if (narrowest != nullptr && clearly_below(2 * narrowest->radius_mm, limit)) {
      add_narrow_bore(plan, *narrowest, limit);
    }
    const int vents = static_cast<int>(plan.fill.vents.size());
    if (vents <= most_vents) return;
    CheckFinding finding = finding_of("many-vents", "lattice-mold shell");
    finding.value = vents;
    finding.limit = most_vents;
    finding.unit = "vents";
    finding.message =
        fmt::format("{} vents let the air out, each with a stub to cut off; {} are little work",
                    vents, most_vents);
    // A high point all around the tube gets a vent in every piece.
    finding.remedy = plan.fill.high_points.size() <= most_vents
                         ? fmt::format("lattice_mold.pieces = {}", most_vents)
                         : "rings by count end flush and collect the air in one; arcs of at most "
                           "180 degrees have no high points of their own";
    findings_.push_back(std::move(finding));
  }

  void add_narrow_bore(const LatticeMoldPlan& plan, const Bore& bore, double limit) {
    CheckFinding finding = finding_of("trapped-air", "lattice-mold shell");
    finding.place = place_in_mold(plan, bore.middle);
    finding.value = 2 * bore.radius_mm;
    finding.limit = limit;
    finding.unit = "mm";
    finding.message = fmt::format(
        "a bore inside a strand is {} mm wide; below the printer's least gap of {} mm it "
        "prints shut, and air stays in the groove",
        written(2 * bore.radius_mm, 3), written(limit, 3));
    finding.remedy = "drill it, or use wider strands where they end in high points";
    findings_.push_back(std::move(finding));
  }

  void check_pour(const LatticeMoldPlan& plan) {
    const CastLayer& cast = plan.shell.cast;
    const double cavity = plan.fill.area_mm2 * (cast.ceiling_mm - cast.floor_mm);
    const double mixed = pour_amount(cavity, segment_.lattice->material).mixed_ml;
    const double needed = 1e-3 * (cavity + beside_cavity_mm3(plan));
    if (!clearly_above(needed, mixed)) return;
    CheckFinding finding = finding_of("pour-volume", "lattice-mold");
    finding.value = needed;
    finding.limit = mixed;
    finding.unit = "ml";
    finding.message = fmt::format(
        "cavity, bores and the film between lands and core take up to {} ml; the procedure "
        "mixes {} ml for a lattice of {} ml",
        written(needed, 3), written(mixed, 3), written(1e-3 * cavity, 3));
    finding.remedy = fmt::format("mix {:.0f} ml, or use a finer clearance", std::ceil(needed));
    findings_.push_back(std::move(finding));
  }

  static CheckPlace place_in_mold(const LatticeMoldPlan& plan, PlanePoint point) {
    const double turns = point.u / (2 * pi * plan.shell.parting.drawn_radius_mm);
    return {360 * (turns - std::floor(turns)), point.z - plan.land_mm};
  }

  const Design& design_;
  PreparedLattices& lattices_;
  PreparedMolds& molds_;
  std::size_t index_;
  int number_;
  const Segment& segment_;
  CheckFindings findings_;
};

}  // namespace

double beside_cavity_mm3(const LatticeMoldPlan& plan) {
  const Shell& shell = plan.shell;
  const double core = shell.cast.floor_mm;
  const double drawn = shell.parting.drawn_radius_mm;
  const double lands = 2 * pi * core * shell.lattice.length_mm - plan.fill.area_mm2 * core / drawn;
  double volume = lands * 0.5 * shell.clearance_mm;
  for (const Bore& bore : shell.bores) {
    volume +=
        pi * bore.radius_mm * bore.radius_mm * (shell.outer_radius_mm - shell.cast.ceiling_mm);
  }
  return volume;
}

CheckFindings casting_checks(const Design& design, PreparedLattices& lattices,
                             PreparedMolds& molds) {
  CheckFindings findings;
  for (std::size_t s = 0; s < design.segments.size(); ++s) {
    CheckFindings more = MoldChecks(design, lattices, molds, s).run();
    std::move(more.begin(), more.end(), std::back_inserter(findings));
  }
  return findings;
}

}  // namespace latticast
