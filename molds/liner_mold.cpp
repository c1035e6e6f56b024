// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/liner_mold.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/core.h>

#include "design/text/written_number.h"
#include "design/units.h"
#include "geometry/solid/lattice_drawing.h"
#include "geometry/solid/layered_solid.h"
#include "molds/cannot_mold.h"
#include "molds/mold_rings.h"
#include "molds/parting.h"
#include "molds/stepped_solid.h"

namespace latticast {
namespace {

constexpr double strap_mm = 6;
constexpr double flange_tooth_pitch_mm = 12;
constexpr double narrowest_piece_mm = 0.5;

struct Frame {
  LinerCavity cavity;
  double clearance_mm = 0;
  double wall_mm = 0;
  double tolerance_mm = 0;
  int pieces = 0;
  double outside_mm = 0;  // radius of the shell
  double groove_mm = 0;   // depth of the straps' grooves
  double rim_mm = 0;      // of base and cap, over the shell
  double socket_mm = 0;
  double tooth_mm = 0;  // from one side of a seam to the other, along the bore
};

Frame make_frame(const LinerCavity& cavity, const LinerMoldOptions& options) {
  Frame frame;
  frame.cavity = cavity;
  frame.clearance_mm = options.fit.clearance_mm;
  frame.wall_mm = options.fit.wall_mm;
  frame.pieces = options.pieces;
  frame.outside_mm = cavity.flange_radius_mm + frame.wall_mm;
  frame.groove_mm = std::min(1.5, frame.wall_mm / 3);
  frame.rim_mm = std::min(6.0, cavity.height_mm / 4);
  frame.socket_mm = std::max(5.0, 2 * frame.clearance_mm);
  // Chords of two pieces that face each other may both err by the tolerance.
  frame.tolerance_mm = std::min({options.fit.tolerance_mm, frame.clearance_mm / 8,
                                 (cavity.bore_radius_mm - cavity.core_radius_mm) / 8});
  const double share = 2 * pi * cavity.bore_radius_mm / frame.pieces;
  frame.tooth_mm = std::min({1.5, 0.2 * share, cavity.height_mm / 4});
  if (share - frame.tooth_mm - frame.clearance_mm < narrowest_piece_mm) {
    throw CannotMold(fmt::format(
        "{} shell pieces around a bore of {} mm radius are too narrow "
        "for seams with {} mm clearance: use fewer pieces",
        frame.pieces, written(cavity.bore_radius_mm, 4), written(frame.clearance_mm, 4)));
  }
  return frame;
}

// The middle of a seam, from the bottom up, as distances along the bore from its angle: flanks of
// teeth lean, so that the pieces find each other.
std::vector<PlanePoint> seam(const Frame& frame) {
  constexpr ToothCorner tooth[] = {{-1, 0.2}, {1, 0.3}, {1, 0.7}, {-1, 0.8}};
  return toothed_line(frame.cavity.height_mm, flange_tooth_pitch_mm, 0.5 * frame.tooth_mm, -1,
                      tooth);
}

Strand shell_outline(const Frame& frame, int piece) {
  const double share = 2 * pi * frame.cavity.bore_radius_mm / frame.pieces;
  const double left = piece * share + 0.5 * frame.clearance_mm;
  const double right = (piece + 1) * share - 0.5 * frame.clearance_mm;
  std::vector<PlanePoint> line = seam(frame);
  Strand strand;
  for (const PlanePoint& p : line) strand.outline.push_back({right + p.u, p.z});
  std::reverse(line.begin(), line.end());
  for (const PlanePoint& p : line) strand.outline.push_back({left + p.u, p.z});
  return strand;
}

// Heights at which the straps' grooves begin.
std::vector<double> strap_grooves(const Frame& frame) {
  const double free = frame.cavity.height_mm - 2 * frame.rim_mm;
  const auto at = [&](double share) { return frame.rim_mm + share * free - 0.5 * strap_mm; };
  if (free >= 4 * strap_mm) return {at(0.25), at(0.75)};
  if (free >= 1.5 * strap_mm) return {at(0.5)};
  return {};
}

enum class FlangedSheet : std::uint8_t { piece, straps, flanges };

// Layers of a shell with flanges; without them it has the two outer ones, counted from 0.
enum class FlangedLayer : std::uint8_t { between_flanges, wall, outside };

Layers flanged_shell_layers(unsigned sheets) {
  if (!has(sheets, FlangedSheet::piece)) return 0;
  Layers material = only(FlangedLayer::wall);
  if (!has(sheets, FlangedSheet::straps)) material |= only(FlangedLayer::outside);
  if (!has(sheets, FlangedSheet::flanges)) material |= only(FlangedLayer::between_flanges);
  return material;
}

Layers plain_shell_layers(unsigned sheets) {
  return flanged_shell_layers(sheets) >> static_cast<unsigned>(FlangedLayer::wall);
}

Solid shell_solid(const Frame& frame, int piece) {
  const LinerCavity& cavity = frame.cavity;
  const double drawn = cavity.bore_radius_mm;
  const double height = cavity.height_mm;
  const double around = 2 * pi * drawn;
  LayeredTube tube;
  tube.drawn_radius_mm = drawn;
  tube.length_mm = height;
  tube.steepness = 1;
  tube.sheets = {{around, height, {shell_outline(frame, piece)}}, {around, height, {}}};
  for (const double z : strap_grooves(frame)) {
    tube.sheets[1].strands.push_back(drawn_band(drawn, z, z + strap_mm));
  }
  const double groove_radius = frame.outside_mm - frame.groove_mm;
  const bool flanged = cavity.flange_mm > 0;
  if (flanged) {
    const double upper = height - cavity.flange_mm;
    tube.sheets.push_back(
        {around,
         height,
         {drawn_band(drawn, 0, cavity.flange_mm), drawn_band(drawn, upper, height)}});
    tube.layers.push_back({cavity.bore_radius_mm, cavity.flange_radius_mm});
  }
  tube.layers.push_back({cavity.flange_radius_mm, groove_radius});
  tube.layers.push_back({groove_radius, frame.outside_mm});
  tube.filling = flanged ? flanged_shell_layers : plain_shell_layers;
  return layered_solid(tube, frame.tolerance_mm);
}

EndPlate plain_plate(const Frame& frame) {
  EndPlate plate;
  plate.core_radius_mm = frame.cavity.core_radius_mm;
  plate.shell_radius_mm = frame.outside_mm;
  plate.rim_mm = frame.rim_mm;
  plate.socket_mm = frame.socket_mm;
  plate.wall_mm = frame.wall_mm;
  plate.clearance_mm = frame.clearance_mm;
  return plate;
}

// Windows over the annulus; where it leaves no room for a wall around the socket, from the socket
// to beyond the shell's rim, which then is the floor of a small basin.
void open_over_annulus(EndPlate& plate, const Frame& frame) {
  constexpr double socket_wall_mm = 0.8;
  constexpr double narrowest_mm = 1;
  constexpr double basin_mm = 2;
  const double socket = frame.cavity.core_radius_mm + 0.5 * frame.clearance_mm;
  const double widest = frame.cavity.flange_radius_mm;
  plate.openings_rad = {pi / 3, pi, 5 * pi / 3};
  plate.opening_width_rad = pi / 3;
  plate.opening_from_mm = socket + socket_wall_mm;
  plate.opening_to_mm = widest;
  if (widest - plate.opening_from_mm < narrowest_mm) {
    plate.opening_from_mm = socket;
    plate.opening_to_mm =
        std::min(std::max(widest, socket + basin_mm), widest + 0.5 * frame.wall_mm);
  }
}

// A round hole to pour through, and vents where the shell meets the cap.
void open_over_closed_end(EndPlate& plate, const Frame& frame) {
  constexpr double widest_hole_mm = 15;
  const double bore = frame.cavity.bore_radius_mm;
  plate.core_radius_mm = 0;
  plate.socket_mm = 0;
  plate.hole_radius_mm = std::min(widest_hole_mm, 0.4 * bore);
  plate.opening_from_mm = std::max(0.8 * bore, bore - 3);
  plate.opening_to_mm = bore;
  plate.openings_rad = {pi / 3, pi, 5 * pi / 3};
  plate.opening_width_rad = 0.3;
}

Solid base_with_core(const Frame& frame) {
  const EndPlate plate = plain_plate(frame);
  const double shell = plate.shell_radius_mm + 0.5 * plate.clearance_mm;
  const double core = plate.floor_mm + frame.cavity.height_mm - frame.cavity.closed_mm;
  SteppedRod rod;
  rod.steps = {{plate.core_radius_mm, core},
               {shell, plate.floor_mm},
               {shell + plate.wall_mm, plate.floor_mm + plate.rim_mm}};
  rod.start_z_mm = -plate.floor_mm;
  return stepped_solid(rod, frame.tolerance_mm);
}

void add_core_and_base(Mold& mold, const Frame& frame) {
  const LinerCavity& cavity = frame.cavity;
  if (cavity.closed_mm > 0) {
    mold.pieces.push_back(
        {"base", base_with_core(frame), "core on the plate that centres the shell"});
    return;
  }
  Core core;
  core.radius_mm = cavity.core_radius_mm;
  core.from_mm = -frame.socket_mm;
  core.to_mm = cavity.height_mm + frame.socket_mm - frame.clearance_mm;
  core.chamfer_mm = std::min(1.0, 0.25 * cavity.core_radius_mm);
  mold.pieces.push_back({"core", core_solid(core, frame.tolerance_mm), "inside of the liner"});
  mold.pieces.push_back({"base", end_plate_solid(plain_plate(frame), 0, false, frame.tolerance_mm),
                         "plate that centres core and shell"});
}

void add_shell(Mold& mold, const Frame& frame) {
  for (int i = 0; i < frame.pieces; ++i) {
    const std::string use = fmt::format("outside of the liner, part {} of {}", i + 1, frame.pieces);
    mold.pieces.push_back({fmt::format("shell-{}", i + 1), shell_solid(frame, i), use, true,
                           2 * pi * (i + 0.5) / frame.pieces});
  }
}

void add_cap(Mold& mold, const Frame& frame) {
  EndPlate plate = plain_plate(frame);
  const bool closed = frame.cavity.closed_mm > 0;
  if (closed) {
    open_over_closed_end(plate, frame);
  } else {
    open_over_annulus(plate, frame);
  }
  mold.pieces.push_back({"cap",
                         end_plate_solid(plate, frame.cavity.height_mm, true, frame.tolerance_mm),
                         closed ? "plate on top, with a hole to pour through and vents"
                                : "plate on top, with windows to pour through and for air"});
}

std::vector<std::string> notes_of(const Frame& frame, const LinerMoldOptions& options) {
  constexpr double thin_mm = 0.5;
  constexpr double slight_mm = 0.01;
  std::vector<std::string> notes;
  const LinerCavity& cavity = frame.cavity;
  if (options.fit.growth != 1) {
    notes.push_back(fmt::format("{} is {} % larger than the design, against shrinkage.",
                                options.keyed ? "The core" : "The cavity",
                                written(100 * (options.fit.growth - 1), 4)));
  }
  if (strap_grooves(frame).empty()) {
    notes.emplace_back("The shell is too short for strap grooves: base and cap hold it together.");
  }
  const double gap = cavity.bore_radius_mm - cavity.core_radius_mm;
  if (gap < thin_mm) {
    notes.push_back(fmt::format(
        "The cavity is only {} mm wide: rubber hardly flows into it. Warm or thin it, fill "
        "under vacuum, or brush the liner onto the core instead.",
        written(gap, 3)));
  }
  // Tooth tips of half shells reach past the middle.
  const double past = 0.5 * (frame.tooth_mm - frame.clearance_mm) / cavity.bore_radius_mm;
  const double undercut = past > 0 ? cavity.bore_radius_mm * (1 - std::cos(past)) : 0;
  if (frame.pieces == 2 && undercut > slight_mm) {
    notes.push_back(fmt::format(
        "At their teeth, the half shells reach {} mm behind the casting, which gives way.",
        written(undercut, 2)));
  }
  return notes;
}

void check(const Segment& segment, const LinerMoldOptions& options) {
  const MoldFit& fit = options.fit;
  const bool flanged = options.ends == LinerEnds::flanged;
  if (options.pieces < 2) {
    throw CannotMold("a shell in one piece cannot be taken off: use two pieces or more");
  }
  if (!(fit.clearance_mm > 0 && fit.tolerance_mm > 0 && fit.growth > 0)) {
    throw CannotMold("clearance, tolerance and growth must be positive");
  }
  if (!(fit.wall_mm > fit.clearance_mm)) {
    throw CannotMold(
        fmt::format("a wall of {} mm is not more than the clearance, {} mm: "
                    "use a thicker wall",
                    written(fit.wall_mm, 4), written(fit.clearance_mm, 4)));
  }
  if ((flanged || options.keyed) && !segment.lattice) {
    throw CannotMold(fmt::format("{} needs a lattice, and the segment has none: leave it out",
                                 flanged ? "a liner with flanges" : "a keyed mold"));
  }
  if (flanged && options.keyed) {
    throw CannotMold(
        "a keyed mold has nothing for the lattice to stand on between flanges: use "
        "open or closed ends");
  }
}

}  // namespace

double LinerCavity::volume_mm3() const {
  const auto disc = [](double radius) { return pi * radius * radius; };
  return disc(bore_radius_mm) * (height_mm - 2 * flange_mm) +
         2 * disc(flange_radius_mm) * flange_mm - disc(core_radius_mm) * (height_mm - closed_mm);
}

LinerCavity liner_cavity(const Segment& segment, const LinerMoldOptions& options) {
  check(segment, options);
  const double growth = options.fit.growth;
  const double along = options.keyed ? 1 : growth;
  LinerCavity cavity;
  cavity.core_radius_mm = growth * segment.inner_radius_mm();
  cavity.bore_radius_mm = options.keyed ? segment.outer_radius_mm() + 0.5 * options.fit.clearance_mm
                                        : growth * segment.liner_outer_radius_mm();
  cavity.flange_radius_mm = cavity.bore_radius_mm;
  if (options.ends == LinerEnds::flanged) {
    cavity.flange_mm = growth * liner_flange_mm;
    cavity.flange_radius_mm = growth * segment.outer_radius_mm();
  }
  cavity.height_mm = along * segment.length_mm + 2 * cavity.flange_mm;
  if (options.ends == LinerEnds::closed) cavity.closed_mm = along * segment.liner.thickness_mm;
  if (cavity.closed_mm >= cavity.height_mm) {
    throw CannotMold(
        fmt::format("a closed liner {} mm thick must be longer than {} mm: "
                    "use a longer segment or open ends",
                    written(cavity.closed_mm, 4), written(cavity.height_mm, 4)));
  }
  if (options.keyed && cavity.core_radius_mm >= segment.liner_outer_radius_mm()) {
    throw CannotMold(fmt::format(
        "the core, grown to {} mm against shrinkage, leaves no liner "
        "inside a lattice of {} mm: use a thicker liner",
        written(cavity.core_radius_mm, 4), written(segment.liner_outer_radius_mm(), 4)));
  }
  return cavity;
}

MoldExtent extent_of(const Segment& segment, const LinerMoldOptions& options) {
  const Frame frame = make_frame(liner_cavity(segment, options), options);
  const LinerCavity& cavity = frame.cavity;
  const EndPlate plate = plain_plate(frame);
  const bool closed = cavity.closed_mm > 0;
  const double above_floor = closed ? std::max(frame.rim_mm, cavity.height_mm - cavity.closed_mm)
                                    : frame.socket_mm + frame.rim_mm;
  const double whole_core = cavity.height_mm + 2 * frame.socket_mm - frame.clearance_mm;
  return {.plate_diameter_mm = 2 * (frame.outside_mm + 0.5 * frame.clearance_mm + frame.wall_mm),
          .plate_height_mm = plate.floor_mm + above_floor,
          .core_diameter_mm = 2 * cavity.core_radius_mm,
          .core_length_mm = closed ? 0 : whole_core,
          .shell_height_mm = cavity.height_mm};
}

Mold liner_mold(const Segment& segment, const LinerMoldOptions& options, LatticeDrawing* drawing) {
  const Frame frame = make_frame(liner_cavity(segment, options), options);
  Mold mold;
  add_core_and_base(mold, frame);
  add_shell(mold, frame);
  add_cap(mold, frame);
  mold.cavity_mm3 = frame.cavity.volume_mm3();
  if (options.keyed) {
    SolidOptions lattice;
    lattice.tolerance_mm = options.fit.tolerance_mm;
    LatticeDrawing own(segment, options.fit.tolerance_mm);
    mold.cavity_mm3 -= lattice_solid(drawing != nullptr ? *drawing : own, lattice).volume_mm3;
  }
  mold.notes = notes_of(frame, options);
  return mold;
}

}  // namespace latticast
