// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "app/makers.h"
#include "design/design.h"
#include "design/text/written_number.h"
#include "export/mesh/glb_file.h"
#include "export/picture/png_file.h"
#include "files/atomic_file.h"
#include "model/shape/shape.h"
#include "prepared/prepared_design.h"
#include "report/preview.h"

namespace latticast {
namespace {

// All parts of a preview, for its picture and its animation.
struct PreviewParts {
  std::vector<PicturePart> picture;
  Scene scene;
};

struct PartKind {
  std::size_t segment = 0;
  bool is_liner = false;

  const char* name() const { return is_liner ? "liner" : "lattice"; }
  Colour colour() const { return is_liner ? liner_colour : lattice_colour; }
};

PreviewPart made_part(Build& build, const PartKind& kind, const std::vector<PreviewShape>& shapes) {
  Delivery& delivery = build.delivery;
  const std::size_t s = kind.segment;
  const Segment& segment = build.design().segments[s];
  const auto rest = [&](const SolidOptions& options) {
    return kind.is_liner ? liner_solid(segment, options)
                         : lattice_solid(build.order.prepared.lattices.of(s), options);
  };
  const auto begin = [&](std::size_t i) {
    delivery.progress().begin(
        delivery.part_name(s, fmt::format("preview-{}-{}", shapes[i].label, kind.name())));
  };
  const SolidOptions options = preview_options(build.design(), s, build.start_z_mm(s), shapes);
  return preview_part({rest, begin}, s, options, shapes);
}

// Where parts have colours: those of strains, on one scale for all shapes.
StrainColours colours_of(Build& build, const PartKind& kind, const PreviewPart& part,
                         const std::vector<PreviewShape>& shapes) {
  Delivery& delivery = build.delivery;
  if (!delivery.writes(MeshFormat::ply)) return {};
  StrainColours colours = strain_colours(build.design().segments[kind.segment], kind.segment,
                                         kind.is_liner, part.rest.mesh, part.options, shapes);
  delivery.tell(
      fmt::format("{}: colours in PLY from strain {} to {}\n",
                  delivery.part_name(kind.segment, fmt::format("preview-{}", kind.name())),
                  written(colours.ramp.low, 6), written(colours.ramp.high, 6)));
  return colours;
}

void make_part(Build& build, const PartKind& kind, const std::vector<PreviewShape>& shapes,
               PreviewParts& parts) {
  Delivery& delivery = build.delivery;
  PreviewPart made = made_part(build, kind, shapes);
  const StrainColours colours = colours_of(build, kind, made, shapes);
  SceneBody body{delivery.part_name(kind.segment, kind.name()), made.rest.mesh, kind.colour()};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    Part part{.stem = delivery.part_name(
                  kind.segment, fmt::format("preview-{}-{}", shapes[i].label, kind.name())),
              .kind = "",
              .segment = kind.segment,
              .colour = kind.colour(),
              .touches_itself = made.touches[i] != 0};
    if (!colours.of_shape.empty()) {
      part.vertex_colours = colours.of_shape[i];
      part.vertex_strains = colours.strains[i];
    }
    Solid& moved = made.moved[i];
    delivery.deliver(part, moved, &made.audits[i]);
    body.targets.push_back({shapes[i].label, moved.mesh.vertices});
    parts.picture.push_back({std::move(moved.mesh), i, kind.is_liner});
  }
  parts.scene.bodies.push_back(std::move(body));
  parts.scene.animated = true;
}

void preview(Build& build) {
  const Design& design = build.design();
  Delivery& delivery = build.delivery;
  const std::vector<PreviewShape> shapes = predict_preview(build.order.prepared.responses);
  PreviewParts parts;
  for (std::size_t s = 0; s < design.segments.size(); ++s) {
    for (const bool is_liner : {false, true}) {
      if (!is_liner && !design.segments[s].lattice) continue;
      make_part(build, {s, is_liner}, shapes, parts);
    }
  }
  const std::string picture = design.name + "-preview.png";
  delivery.progress().begin(picture);
  build.pictures.push_back({"Shapes under pressure",
                            encode_png(preview_picture(parts.picture, shapes, design.segments))});
  write_file_atomically(delivery.add_file(picture), build.pictures.back().png);
  delivery.tell(fmt::format("{}: {} shapes side by side\n", picture, shapes.size()));
  if (delivery.writes(MeshFormat::glb)) {
    const std::string animation = design.name + "-preview.glb";
    write_glb(delivery.add_file(animation), parts.scene);
    delivery.tell(fmt::format("{}: all of them, as an animation from rest\n", animation));
  }
  delivery.note_time("preview, picture");
}

}  // namespace

void make_preview(Build& build, std::vector<Task>& tasks) {
  const std::size_t segments = build.design().segments.size();
  build.delivery.expect_meshes(2 * segments * build.design().make.preview->cases.size());
  build.delivery.progress().expect(1);  // the picture
  tasks.push_back({segments + 2, [&build] { preview(build); }});
}

}  // namespace latticast
