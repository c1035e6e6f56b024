// SPDX-License-Identifier: GPL-3.0-or-later
// Lattices, liners and flat patterns, segment by segment.
#include <fmt/core.h>

#include "app/flat_pattern.h"
#include "app/makers.h"
#include "design/design.h"
#include "geometry/solid/tube_solids.h"
#include "prepared/prepared_design.h"

namespace latticast {
namespace {

SolidOptions rest_options(const Build& build, std::size_t segment) {
  return {.tolerance_mm = build.design().output.tolerance_mm,
          .start_z_mm = build.start_z_mm(segment)};
}

void deliver_at_rest(Build& build, const Part& part, const Solid& solid) {
  build.delivery.deliver(part, solid);
  if (build.delivery.writes(MeshFormat::three_mf)) {
    build.together.push_back({part.stem, solid.mesh, part.colour});
  }
}

void make_flat_pattern(Build& build, std::size_t s) {
  const Design& design = build.design();
  Delivery& delivery = build.delivery;
  const std::string stem = delivery.part_name(s, "flat");
  delivery.progress().begin(stem);
  if (!design.segments[s].lattice) {
    delivery.tell(fmt::format("{}: no flat pattern, the segment has no lattice\n", stem));
    return;
  }
  const FlatPattern sheet =
      flat_pattern(build.order.prepared.lattices.of(s), design.output.tolerance_mm);
  const FlatDrawing drawing = flat_drawing(design, s, sheet);
  write_svg(delivery.add_file(stem + ".svg"), drawing);
  write_dxf(delivery.add_file(stem + ".dxf"), drawing);
  delivery.tell(fmt::format("{0}.svg, {0}.dxf: flat pattern, {1}\n", stem, describe(sheet)));
  delivery.note_time(stem);
}

}  // namespace

void make_lattices(Build& build, std::vector<Task>& tasks) {
  const std::vector<Segment>& segments = build.design().segments;
  build.delivery.expect_meshes(segments.size());
  for (std::size_t s = 0; s < segments.size(); ++s) {
    if (!segments[s].lattice) continue;
    ++build.expected_together;
    tasks.push_back({s, [&build, s] {
                       const Part part{build.delivery.part_name(s, "lattice"), "lattice", s,
                                       &build.design().segments[s].lattice->material,
                                       lattice_colour};
                       build.delivery.progress().begin(part.stem);
                       deliver_at_rest(build, part,
                                       lattice_solid(build.order.prepared.lattices.of(s),
                                                     rest_options(build, s)));
                     }});
  }
}

void make_liners(Build& build, std::vector<Task>& tasks) {
  const std::vector<Segment>& segments = build.design().segments;
  build.delivery.expect_meshes(segments.size());
  build.expected_together += segments.size();
  for (std::size_t s = 0; s < segments.size(); ++s) {
    tasks.push_back({s, [&build, s] {
                       const Segment& segment = build.design().segments[s];
                       const Part part{build.delivery.part_name(s, "liner"), "liner", s,
                                       &segment.liner.material, liner_colour};
                       build.delivery.progress().begin(part.stem);
                       deliver_at_rest(build, part, liner_solid(segment, rest_options(build, s)));
                     }});
  }
}

void make_flat_patterns(Build& build, std::vector<Task>& tasks) {
  const std::size_t segments = build.design().segments.size();
  build.delivery.progress().expect(static_cast<int>(segments));
  for (std::size_t s = 0; s < segments; ++s) {
    tasks.push_back({s, [&build, s] { make_flat_pattern(build, s); }});
  }
}

// 3MF holds several parts in their places; each was proved in its own file.
void make_rest_together(Build& build, std::vector<Task>& tasks) {
  tasks.push_back({build.design().segments.size(), [&build] {
                     const bool all = build.together.size() == build.expected_together;
                     if (build.together.size() < 2 || !all) return;
                     const std::string file = build.design().name + ".3mf";
                     write_three_mf(build.delivery.add_file(file), build.together);
                     build.delivery.tell(fmt::format("{}: {} parts in their places\n", file,
                                                     build.together.size()));
                   }});
}

}  // namespace latticast
