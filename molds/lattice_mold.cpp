// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/lattice_mold.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/core.h>

#include "design/text/written_number.h"
#include "design/units.h"
#include "geometry/solid/geometry_error.h"
#include "geometry/solid/lattice_drawing.h"
#include "geometry/solid/self_intersection.h"
#include "geometry/solid/tolerance_budget.h"
#include "molds/mold_rings.h"

namespace latticast {
namespace {

constexpr double shortest_land_mm = 4;
constexpr double socket_mm = 5;
constexpr double floor_mm = 4;
constexpr double strap_width_mm = 6;
constexpr double strap_depth_mm = 1.5;
constexpr double strap_step_mm = 0.5;
constexpr double least_piece_mm = 2;
constexpr double finest_share_of_clearance = 0.2;
constexpr double largest_bore_mm = 4;
constexpr double bore_share_of_piece = 0.4;
constexpr int most_attempts = 8;
constexpr int most_refinements = 4;
constexpr double seam_nudge_mm = 0.037;

Segment grown(Segment segment, double growth) {
  segment.length_mm *= growth;
  segment.liner.inner_radius_mm *= growth;
  segment.liner.thickness_mm *= growth;
  if (!segment.lattice) return segment;
  Lattice& lattice = *segment.lattice;
  lattice.thickness_mm *= growth;
  lattice.fillet_mm *= growth;
  if (lattice.rings) {
    lattice.rings->width_mm *= growth;
    if (lattice.rings->pitch_mm) *lattice.rings->pitch_mm *= growth;
  }
  for (Grid& grid : lattice.grids) {
    for (double& width : grid.widths_mm) width *= growth;
    grid.path = scaled(grid.path, growth);
  }
  return segment;
}

Pattern raised(Pattern pattern, double land) {
  for (Strand& strand : pattern.strands) strand = moved(std::move(strand), {0, land});
  pattern.length_mm += 2 * land;
  return pattern;
}

void refuse_impossible(const Segment& segment, const MoldFit& fit) {
  if (!(fit.wall_mm > 0)) throw CannotMold("the mold needs a wall: give wall more than 0");
  if (!(fit.clearance_mm > 0)) {
    throw CannotMold("pieces without clearance cannot be put together: give clearance more than 0");
  }
  if (!(fit.clearance_mm < fit.wall_mm)) {
    throw CannotMold(
        fmt::format("a clearance of {} mm leaves nothing of a wall of {} mm: use a thicker "
                    "wall or a finer printer",
                    written(fit.clearance_mm, 3), written(fit.wall_mm, 3)));
  }
  if (!(0.5 * fit.clearance_mm < segment.lattice->thickness_mm)) {
    throw CannotMold(
        fmt::format("half the clearance of {} mm is as deep as the lattice's grooves, {} mm: use a "
                    "thicker lattice or a finer printer",
                    written(fit.clearance_mm, 3), written(segment.lattice->thickness_mm, 3)));
  }
}

void refuse_narrow_pieces(const Parting& parting, double clearance) {
  const double breadth = 2 * pi * parting.drawn_radius_mm / parting.pieces - clearance;
  if (breadth >= least_piece_mm) return;
  throw CannotMold(fmt::format("{} shell pieces would be {} mm broad: ask for fewer",
                               parting.pieces, written(std::max(0.0, breadth), 2)));
}

int bores_under(const StrapGroove& strap, const std::vector<Bore>& bores) {
  return static_cast<int>(std::count_if(bores.begin(), bores.end(), [&](const Bore& b) {
    return b.middle.z + b.radius_mm > strap.from_mm && b.middle.z - b.radius_mm < strap.to_mm;
  }));
}

// Of the places between two heights, the one that covers fewest bores, as near as possible to
// `wanted`.
StrapGroove place_strap(double lowest, double highest, double wanted,
                        const std::vector<Bore>& bores) {
  StrapGroove best{wanted, wanted + strap_width_mm};
  int fewest = bores_under(best, bores);
  for (double off = strap_step_mm; fewest > 0 && off < highest - lowest; off += strap_step_mm) {
    for (const double from : {wanted - off, wanted + off}) {
      if (from < lowest || from + strap_width_mm > highest) continue;
      const StrapGroove strap{from, from + strap_width_mm};
      const int under = bores_under(strap, bores);
      if (under >= fewest) continue;
      fewest = under;
      best = strap;
    }
  }
  return best;
}

// One in either half of the shell, between the rims of base and cap; one in the middle of a short
// shell, none where there is no room.
std::vector<StrapGroove> place_straps(double length, double rim, const std::vector<Bore>& bores) {
  const double lowest = rim + 1;
  const double highest = length - rim - 1;
  const double middle = 0.5 * length;
  const double half = highest - middle;
  if (half < 0.5 * strap_width_mm) return {};
  if (half < 1.5 * strap_width_mm) {
    return {place_strap(lowest, highest, middle - 0.5 * strap_width_mm, bores)};
  }
  const double in = 0.5 * (half - strap_width_mm);
  return {place_strap(lowest, middle - 1, lowest + in, bores),
          place_strap(middle + 1, highest, highest - in - strap_width_mm, bores)};
}

// Where an arc or a bore grazes another outline, the walls on either side may leave their surfaces
// by more than the land between them is broad. Finer walls keep apart.
Solid clear_shell_solid(const LatticeMoldPlan& plan, const Shell& closed, int piece) {
  double tolerance = plan.options.fit.tolerance_mm;
  for (int i = 0; i < most_refinements; ++i, tolerance /= 4) {
    Solid solid = shell_solid(i == 0 ? closed : plan.shell, piece, tolerance);
    if (!intersects_itself(solid.mesh)) return solid;
  }
  throw GeometryError(
      "arcs, fillets or bores graze strands so finely that the land between them cannot be made; "
      "change a width, a radius or the number of shell pieces slightly");
}

Mold shell_pieces(const LatticeMoldPlan& plan) {
  const Shell& shell = plan.shell;
  const Shell closed = with_closed_lattice(shell, plan.options.fit.tolerance_mm);
  Mold mold;
  for (int k = 0; k < shell.parting.pieces; ++k) {
    mold.pieces.push_back({fmt::format("shell-{}", k + 1), clear_shell_solid(plan, closed, k),
                           "grooved shell, strapped around the core", true,
                           std::remainder(pull_rad(shell.parting, k), 2 * pi)});
    if (mold.pieces.back().solid.pieces != 1) {
      throw GeometryError("a bore cuts a piece of the shell in two: ask for fewer shell pieces");
    }
  }
  return mold;
}

Mold shell_pieces_nudged(LatticeMoldPlan plan) {
  const Parting& parting = plan.shell.parting;
  const double first = parting.first_seam_rad;
  for (int attempt = 1;; ++attempt) {
    try {
      return shell_pieces(plan);
    } catch (const GeometryError&) {
      if (attempt == most_attempts) throw;
      plan.shell.parting.first_seam_rad = first + attempt * seam_nudge_mm / parting.drawn_radius_mm;
    }
  }
}

void add_rings(const LatticeMoldPlan& plan, Mold& mold) {
  const MoldFit& fit = plan.options.fit;
  const double length = plan.segment.length_mm;
  const double core = plan.shell.cast.floor_mm;
  const double low = plan.shell.start_z_mm;
  const double high = length + plan.land_mm;
  const double chamfer = std::min(1.0, 0.25 * core);
  mold.pieces.push_back(
      {"core",
       core_solid({core, low - socket_mm, high + socket_mm - fit.clearance_mm, chamfer},
                  fit.tolerance_mm),
       "smooth rod, the lattice's inner face"});
  EndPlate plate;
  plate.core_radius_mm = core;
  plate.shell_radius_mm = plan.shell.outer_radius_mm;
  plate.rim_mm = plan.land_mm - 1;
  plate.socket_mm = socket_mm;
  plate.floor_mm = floor_mm;
  plate.wall_mm = fit.wall_mm;
  plate.clearance_mm = fit.clearance_mm;
  mold.pieces.push_back({"base", end_plate_solid(plate, low, false, fit.tolerance_mm),
                         "holds core and shell on one axis"});
  mold.pieces.push_back({"cap", end_plate_solid(plate, high, true, fit.tolerance_mm),
                         "holds core and shell on one axis"});
}

// "Undercuts: shell-1 0.93 mm (47 %), shell-2 ..."
std::string undercut_list(const LatticeMoldPlan& plan) {
  std::string text;
  for (int piece = 0; piece < plan.shell.parting.pieces; ++piece) {
    std::vector<Undercut> here;
    std::copy_if(plan.undercuts.begin(), plan.undercuts.end(), std::back_inserter(here),
                 [&](const Undercut& undercut) { return undercut.piece == piece; });
    const Undercut worst = worst_undercut(here);
    text += fmt::format("{} shell-{} {:.2f} mm ({:.0f} %)", piece == 0 ? "Undercuts:" : ",",
                        piece + 1, worst.undercut_mm, 100 * worst.strain);
  }
  return text + ".";
}

void add_notes(const LatticeMoldPlan& plan, Mold& mold) {
  const Undercut worst = worst_undercut(plan.undercuts);
  const double radius = plan.shell.parting.drawn_radius_mm;
  if (worst.strain > 0) {
    mold.notes.push_back(fmt::format(
        "Taking off shell-{} squeezes a strand of {:.2f} mm by {:.2f} mm ({:.0f} %), at {:.0f} "
        "degrees and z = {:.1f} mm: the most anywhere.",
        worst.piece + 1, worst.strand_width_mm, worst.undercut_mm, 100 * worst.strain,
        degrees(std::remainder(worst.at.u / radius, 2 * pi)), worst.at.z - plan.land_mm));
  }
  mold.notes.push_back(undercut_list(plan));
  if (worst.strain > plan.options.allowed_strain) {
    mold.notes.push_back(
        fmt::format("That is more than the {:.0f} % that the cast material should bear: use more "
                    "shell pieces, or demold while the casting is still soft.",
                    100 * plan.options.allowed_strain));
  }
  mold.notes.push_back(fmt::format("Bores: {} at the bottom to fill through, {} vents.",
                                   plan.fill.sprues.size(), plan.fill.vents.size()));
  if (plan.shell.straps.empty()) {
    mold.notes.emplace_back("The shell is too short for strap grooves: hold it by base and cap.");
  }
  for (const StrapGroove& strap : plan.shell.straps) {
    if (const int under = bores_under(strap, plan.shell.bores); under > 0) {
      mold.notes.push_back(fmt::format(
          "The strap between z = {:.1f} and {:.1f} mm crosses {} bores: leave these open.",
          strap.from_mm - plan.land_mm, strap.to_mm - plan.land_mm, under));
    }
  }
}

}  // namespace

LatticeMoldPlan plan_lattice_mold(const Segment& segment, const LatticeMoldOptions& options) {
  LatticeDrawing drawing(segment, options.fit.tolerance_mm);
  return plan_lattice_mold(drawing, options);
}

LatticeMoldPlan plan_lattice_mold(LatticeDrawing& drawing, const LatticeMoldOptions& options) {
  LatticeMoldPlan plan;
  plan.options = options;
  plan.segment = grown(drawing.segment(), options.fit.growth);
  MoldFit& fit = plan.options.fit;
  const Segment& s = plan.segment;
  refuse_impossible(s, fit);
  // Half the clearance lies between core and shell, and either may be off by the tolerance.
  fit.tolerance_mm = std::min(fit.tolerance_mm, finest_share_of_clearance * fit.clearance_mm);

  Shell& shell = plan.shell;
  plan.land_mm = std::max(fit.wall_mm, shortest_land_mm);
  shell.start_z_mm = -plan.land_mm;
  shell.cast = {s.liner_outer_radius_mm(), s.outer_radius_mm()};
  shell.clearance_mm = fit.clearance_mm;
  shell.outer_radius_mm = s.outer_radius_mm() + fit.wall_mm;
  shell.strap_radius_mm = shell.outer_radius_mm - std::min(strap_depth_mm, fit.wall_mm / 3);

  const double flatness =
      layered_budget(fit.tolerance_mm).drawing_mm * s.lattice_mid_radius_mm() / s.outer_radius_mm();
  LatticeDrawing larger(s, options.fit.growth * drawing.sliver_mm());
  LatticeDrawing& drawn = options.fit.growth == 1 ? drawing : larger;
  const Pattern strands = raised(drawn.strands(flatness), plan.land_mm);
  shell.lattice = raised(drawn.outlines(flatness), plan.land_mm);
  shell.parting = choose_parting(
      strands, {options.pieces, options.allowed_strain, fit.clearance_mm}, shell.cast);
  refuse_narrow_pieces(shell.parting, fit.clearance_mm);
  plan.undercuts = undercut_map(strands, shell.parting, shell.cast);

  std::vector<double> pulls;
  pulls.reserve(shell.parting.pieces);
  for (int k = 0; k < shell.parting.pieces; ++k) pulls.push_back(pull_rad(shell.parting, k));
  const double breadth = strands.circumference_mm / shell.parting.pieces;
  plan.fill = plan_fill(shell.lattice, {pulls, strands.circumference_mm / 3,
                                        std::min(largest_bore_mm, bore_share_of_piece * breadth)});
  shell.bores = plan.fill.sprues;
  shell.bores.insert(shell.bores.end(), plan.fill.vents.begin(), plan.fill.vents.end());
  shell.straps = place_straps(strands.length_mm, plan.land_mm - 1, shell.bores);
  return plan;
}

MoldExtent extent_of(const LatticeMoldPlan& plan) {
  const MoldFit& fit = plan.options.fit;
  const double rim_mm = plan.land_mm - 1;
  const double shell = plan.segment.length_mm + 2 * plan.land_mm;
  return {
      .plate_diameter_mm = 2 * (plan.shell.outer_radius_mm + 0.5 * fit.clearance_mm + fit.wall_mm),
      .plate_height_mm = rim_mm + socket_mm + floor_mm,
      .core_diameter_mm = 2 * plan.shell.cast.floor_mm,
      .core_length_mm = shell + 2 * socket_mm - fit.clearance_mm,
      .shell_height_mm = shell};
}

Mold lattice_mold(const LatticeMoldPlan& plan) {
  Mold mold = shell_pieces_nudged(plan);
  add_rings(plan, mold);
  const CastLayer& cast = plan.shell.cast;
  mold.cavity_mm3 = plan.fill.area_mm2 * (cast.ceiling_mm - cast.floor_mm);
  add_notes(plan, mold);
  return mold;
}

Mold lattice_mold(const Segment& segment, const LatticeMoldOptions& options) {
  return lattice_mold(plan_lattice_mold(segment, options));
}

}  // namespace latticast
