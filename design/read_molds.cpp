// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/read_molds.h"

#include <algorithm>

#include <fmt/core.h>

namespace latticast {
namespace {

bool has_lattice(const Segment& segment) {
  return segment.lattice.has_value();
}

// Reads make.*_mold.wall; where the default breaks a rule, the whole table is to blame.
struct Wall {
  double thickness_mm = 0;
  Field blamed;
};

Wall read_wall(TableReader& table, double default_mm) {
  const Field wall = table.may("wall");
  return {wall.number_or(default_mm, limits::length), wall.present() ? wall : table.table()};
}

void check_clearance(const Wall& wall, double clearance_mm) {
  if (clearance_mm < wall.thickness_mm) return;
  // Neither order is true of NaN.
  if (clearance_mm >= wall.thickness_mm) {
    wall.blamed.refuse(fmt::format("the printer's clearance, {} mm, must be less than the mold's "
                                   "wall, {} mm",
                                   clearance_mm, wall.thickness_mm),
                       "use a thicker wall, or a smaller printer.clearance");
  }
}

void check_groove_depth(const Wall& wall, const std::vector<Segment>& segments) {
  for (const Segment& segment : segments) {
    if (segment.lattice && segment.lattice->thickness_mm >= wall.thickness_mm) {
      wall.blamed.refuse(fmt::format("grooves for strands {} mm deep need more wall behind them "
                                     "than {} mm",
                                     segment.lattice->thickness_mm, wall.thickness_mm),
                         "use a wall thicker than the lattice");
      return;
    }
  }
}

void check_closed_length(const Field& ends, const std::vector<Segment>& segments) {
  for (const Segment& segment : segments) {
    if (segment.liner.thickness_mm >= segment.length_mm) {
      ends.refuse(fmt::format("a closed liner must be longer than it is thick, but {} mm is not "
                              "more than {} mm",
                              segment.length_mm, segment.liner.thickness_mm),
                  R"(use a longer segment, or ends = "open" with plugs)");
      return;
    }
  }
}

}  // namespace

std::optional<LatticeMold> read_lattice_mold(const Field& field, const MoldSurroundings& around) {
  if (!field.present()) return std::nullopt;
  constexpr Word<MoldMethod> methods[] = {{"direct", MoldMethod::direct},
                                          {"replica", MoldMethod::replica}};
  TableReader table =
      field.as_table(R"(write lattice_mold = { pieces = "auto", wall = 5 }, or {})");
  LatticeMold mold;
  const Field pieces = table.may("pieces");
  const bool is_auto = pieces.is_text() && pieces.text() == "auto";
  if (pieces.is_text() && !is_auto) {
    pieces.refuse("must be \"auto\" or a whole number", R"(write pieces = "auto" or pieces = 4)");
  } else if (!is_auto) {
    mold.pieces = pieces.whole(2, limits::mold_pieces);
  }
  const Wall wall = read_wall(table, mold.wall_mm);
  mold.wall_mm = wall.thickness_mm;
  mold.method = table.may("method").word_or(mold.method, methods);
  table.refuse_unknown_keys();
  check_clearance(wall, around.clearance_mm);
  if (mold.method == MoldMethod::direct) check_groove_depth(wall, around.segments);
  if (!around.segments.empty() &&
      std::none_of(around.segments.begin(), around.segments.end(), has_lattice)) {
    field.refuse("a lattice must be there to be made, but no segment has one",
                 "add [segment.lattice], or leave this out");
  }
  return mold;
}

std::optional<LinerMold> read_liner_mold(const Field& field, const MoldSurroundings& around) {
  if (!field.present()) return std::nullopt;
  constexpr Word<LinerEnds> words[] = {
      {"open", LinerEnds::open}, {"closed", LinerEnds::closed}, {"flanged", LinerEnds::flanged}};
  TableReader table = field.as_table("write liner_mold = { wall = 5 }, or {}");
  LinerMold mold;
  const Wall wall = read_wall(table, mold.wall_mm);
  mold.wall_mm = wall.thickness_mm;
  const Field ends = table.may("ends");
  const Field keyed = table.may("keyed");
  mold.ends = ends.word_or(mold.ends, words);
  mold.keyed = keyed.flag_or(mold.keyed);
  mold.pieces = table.may("pieces").whole(2, limits::mold_pieces).value_or(mold.pieces);
  table.refuse_unknown_keys();
  check_clearance(wall, around.clearance_mm);
  if (mold.ends == LinerEnds::closed) check_closed_length(ends, around.segments);
  const bool flanged = mold.ends == LinerEnds::flanged;
  if (flanged && mold.keyed) {
    keyed.refuse("the finished lattice would hang between the flanges, with nothing to stand on",
                 R"(use ends = "open" or "closed" with keyed = true)");
  } else if ((flanged || mold.keyed) &&
             !std::all_of(around.segments.begin(), around.segments.end(), has_lattice)) {
    (flanged ? ends : keyed)
        .refuse("a lattice must be on every segment for this, but one has none",
                "add [segment.lattice], or leave this out");
  }
  return mold;
}

}  // namespace latticast
