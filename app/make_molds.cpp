// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <fmt/core.h>

#include "app/makers.h"
#include "app/mold_picture.h"
#include "app/mold_set.h"
#include "export/picture/png_file.h"
#include "files/atomic_file.h"
#include "molds/print_size.h"

namespace latticast {
namespace {

void make_mold(Build& build, const PlannedMold& planned) {
  Delivery& delivery = build.delivery;
  const std::string stem = delivery.part_name(planned.segment, planned.kind);
  for (const MoldPiece& piece : planned.mold.pieces) {
    const Part part{stem + "-" + piece.name, planned.kind, planned.segment};
    delivery.progress().begin(part.stem);
    Solid printed = piece.solid;
    printed.mesh = printing_pose(piece);
    delivery.deliver(part, printed);
  }
  write_png(delivery.add_file(stem + ".png"), exploded_picture(planned.mold));
  write_file_atomically(delivery.add_file(stem + ".md"), planned.procedure);
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
  const auto molds = std::make_shared<const std::vector<PlannedMold>>(
      plan_molds(build.order.prepared, build.order.plan));
  for (const PlannedMold& planned : *molds) delivery.expect_meshes(planned.mold.pieces.size());
  delivery.note_time("molds, planned and meshed");
  for (std::size_t i = 0; i < molds->size(); ++i) {
    tasks.push_back({build.design().segments.size() + 1,
                     [&build, molds, i] { make_mold(build, (*molds)[i]); }});
  }
}

}  // namespace latticast
