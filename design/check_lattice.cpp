// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/check_lattice.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/core.h>

#include "design/text/written_number.h"
#include "design/units.h"

namespace latticast {
namespace {

/// How far round the tube a strand runs from one end to the other, in turns, with sign.
double strand_turns(const Grid& grid, const Segment& segment) {
  return segment.length_mm / std::tan(grid.angle_rad()) / segment.lattice_circumference_mm();
}

void check_counted_rings(const Rings& rings, double length_mm, const Field& field) {
  const double covered = *rings.count * rings.width_mm;
  if (covered >= length_mm) {
    field.refuse(fmt::format("rings must not touch, but {} rings of {} mm cover {} mm of the "
                             "segment's {} mm",
                             *rings.count, rings.width_mm, covered, length_mm),
                 "use fewer or narrower rings");
  }
}

void check_pitched_rings(const Rings& rings, double length_mm, const Field& field) {
  const double pitch = *rings.pitch_mm;
  const double first_far_edge = rings.first_centre_mm() + 0.5 * rings.width_mm;
  if (rings.width_mm >= pitch) {
    field.refuse(fmt::format("must be more than the rings' width, {} mm, so that they do not touch",
                             rings.width_mm),
                 "use a larger pitch or narrower rings");
  } else if (first_far_edge > length_mm) {
    field.refuse(
        fmt::format("at least one ring must lie on the segment, but the first would end at "
                    "{} mm of {} mm",
                    first_far_edge, length_mm),
        rings.phase == Rings::usual_phase
            ? "the first ring's centre is at half a pitch: use a smaller pitch"
            : fmt::format("the first ring's centre is at {} mm: use a smaller pitch or another "
                          "phase",
                          written(rings.first_centre_mm(), 6)));
  } else if (length_mm / pitch > limits::strands_or_rings) {
    field.refuse(fmt::format("must not give more than {} rings; this one gives {}",
                             limits::strands_or_rings, written(length_mm / pitch, 6)),
                 "use a larger pitch");
  }
}

}  // namespace

void check_rings(const Rings& rings, double segment_length_mm, const Field& field) {
  if (rings.width_mm >= segment_length_mm) {
    field.refuse(
        fmt::format("rings must be narrower than the segment is long, but {} mm is not less "
                    "than {} mm",
                    rings.width_mm, segment_length_mm),
        "use narrower rings");
  } else if (rings.count) {
    check_counted_rings(rings, segment_length_mm, field);
  } else if (rings.pitch_mm) {
    check_pitched_rings(rings, segment_length_mm, field);
  }
}

void check_strand_gaps(const Grid& grid, const Segment& segment, const Field& width) {
  if (grid.widths_mm.empty()) return;
  const std::size_t count = grid.widths_mm.size();
  const double room = segment.lattice_circumference_mm() * std::sin(grid.angle_rad());
  const double sum = std::accumulate(grid.widths_mm.begin(), grid.widths_mm.end(), 0.0);
  if (sum >= room) {
    width.refuse(fmt::format("strands of one family must leave gaps, but they fill {} of the tube "
                             "(sum of widths {} mm, room {} mm)",
                             written(sum / room, 4), written(sum, 6), written(room, 6)),
                 "use fewer or narrower strands, or a steeper angle");
    return;
  }
  const double share = room / static_cast<double>(count);
  for (std::size_t j = 0; j < count; ++j) {
    const std::size_t next = (j + 1) % count;
    const double needed = 0.5 * (grid.widths_mm[j] + grid.widths_mm[next]);
    if (needed >= share) {
      width.refuse(fmt::format("neighbouring strands must not touch, but strands {} and {} need "
                               "{} mm between their middles and have {} mm",
                               j + 1, next + 1, written(needed, 6), written(share, 6)),
                   "use fewer or narrower strands");
      return;
    }
  }
}

void check_strand_turns(const Grid& grid, const Segment& segment, const Field& angle) {
  const double turns = std::abs(strand_turns(grid, segment));
  if (turns > limits::strand_turns) {
    angle.refuse(fmt::format("a strand must not wind around the tube more than {} times; this one "
                             "does {} times",
                             limits::strand_turns, written(turns, 6)),
                 "use a steeper angle; for rings, write [segment.lattice.rings]");
  }
}

void check_fillet(const Segment& segment, const Field& fillet) {
  const double most = segment.lattice_mid_radius_mm();
  if (segment.lattice->fillet_mm >= most) {
    fillet.refuse(
        fmt::format("must be less than the lattice's mid radius, {} mm", written(most, 6)),
        "use a smaller radius: gaps narrower than twice the fillet close");
  }
}

void check_crossings(const Segment& segment, const Field& lattice) {
  const Lattice& drawn = *segment.lattice;
  double rings = 0;
  if (drawn.rings && drawn.rings->count) rings = *drawn.rings->count;
  if (drawn.rings && drawn.rings->pitch_mm) rings = segment.length_mm / *drawn.rings->pitch_mm;
  double crossings = rings;
  for (auto grid = drawn.grids.begin(); grid != drawn.grids.end(); ++grid) {
    crossings += rings * grid->count();
    for (auto other = grid + 1; other != drawn.grids.end(); ++other) {
      const double turns = strand_turns(*grid, segment) - strand_turns(*other, segment);
      crossings += std::abs(turns) * grid->count() * other->count();
    }
  }
  if (crossings > limits::crossings) {
    lattice.refuse(fmt::format("strands and rings must not cross more than {} times; these cross "
                               "about {} times",
                               limits::crossings, written(crossings, 3)),
                   "use fewer strands or rings");
  }
}

}  // namespace latticast
