// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <fmt/core.h>

#include "app/makers.h"
#include "app/mold_picture.h"
#include "app/mold_set.h"
#include "app/piece_files.h"
#include "export/picture/png_file.h"
#include "files/atomic_file.h"
#include "molds/print_size.h"

namespace latticast {
namespace {

// All molds of a build.
struct MoldSet {
  std::vector<PlannedMold> molds;
  std::vector<std::string> stems;
  PieceFiles files;
};

void deliver_piece(Build& build, const MoldSet& set, const PieceFile& file, const Colour& colour) {
  Delivery& delivery = build.delivery;
  const PlannedMold& planned = set.molds[file.mold];
  const MoldPiece& piece = planned.mold.pieces[file.piece];
  const int prints = static_cast<int>(file.uses.size());
  delivery.progress().begin(file.stem);
  Solid printed = piece.solid;
  printed.mesh = printing_pose(piece);
  delivery.deliver({.stem = file.stem,
                    .kind = planned.kind,
                    .segment = planned.segment,
                    .colour = colour,
                    .prints = prints},
                   printed);
  if (prints > 1) delivery.tell(fmt::format("{}: print {} \u00D7\n", file.stem, prints));
}

void make_mold(Build& build, const MoldSet& set, std::size_t number) {
  Delivery& delivery = build.delivery;
  const PlannedMold& planned = set.molds[number];
  const std::string& stem = set.stems[number];
  const std::vector<Colour> colours = piece_colours(planned.mold);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const PieceFile& file = set.files.files[set.files.of_piece[number][i]];
    if (file.mold == number && file.piece == i) deliver_piece(build, set, file, colours[i]);
  }
  build.pictures.push_back({stem + ", taken apart", encode_png(exploded_picture(planned.mold))});
  write_file_atomically(delivery.add_file(stem + ".png"), build.pictures.back().png);
  write_file_atomically(delivery.add_file(stem + ".md"),
                        planned.procedure + shared_files_text(set.files, number));
  delivery.record({.name = stem + ", poured",
                   .kind = "pour",
                   .segment = planned.segment,
                   .material = poured_material(build.design(), planned),
                   .volume_mm3 = planned.mold.cavity_mm3});
  delivery.tell(
      fmt::format("{0}.md: pieces, assembly and pouring; {0}.png: the mold taken apart\n", stem));
}

}  // namespace

void make_molds(Build& build, std::vector<Task>& tasks) {
  Delivery& delivery = build.delivery;
  delivery.progress().begin("molds");
  const auto set = std::make_shared<MoldSet>();
  set->molds = plan_molds(build.order.prepared, build.order.plan);
  for (const PlannedMold& planned : set->molds) {
    set->stems.push_back(delivery.part_name(planned.segment, planned.kind));
  }
  set->files = piece_files(set->molds, set->stems);
  delivery.expect_meshes(set->files.files.size());
  delivery.note_time("molds, planned and meshed");
  for (std::size_t i = 0; i < set->molds.size(); ++i) {
    tasks.push_back(
        {build.design().segments.size() + 1, [&build, set, i] { make_mold(build, *set, i); }});
  }
}

}  // namespace latticast
