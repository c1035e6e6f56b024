// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "app/makers.h"
#include "design/design.h"
#include "design/text/written_number.h"
#include "export/mesh/glb_file.h"
#include "export/picture/png_file.h"
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

// A lattice or liner before it is moved.
struct RestPart {
  std::size_t segment = 0;
  bool is_liner = false;
  Solid solid;
  StrainColours colours;

  const char* kind() const { return is_liner ? "liner" : "lattice"; }
};

// The wall is incompressible; bending alone makes one side larger and the other smaller.
void keep_volume(const Solid& rest, Solid& moved) {
  moved.volume_mm3 = rest.volume_mm3;
  moved.volume_bound_mm3 = moved.error.volume_mm3;
  moved.error.volume_mm3 = rest.error.volume_mm3;
}

Solid moved_solid(const Solid& rest, const Shape& shape, std::size_t segment) {
  Solid moved{
      .mesh = moved_mesh(rest.mesh, shape, segment), .pieces = rest.pieces, .genus = rest.genus};
  moved.error = moved_error(rest, moved.mesh, shape, segment);
  if (shape.bend_rad(segment) == 0) keep_volume(rest, moved);
  return moved;
}

RestPart rest_part(Build& build, std::size_t s, bool is_liner, const SolidOptions& options,
                   const std::vector<PreviewShape>& shapes) {
  const Segment& segment = build.design().segments[s];
  Delivery& delivery = build.delivery;
  RestPart rest{s,
                is_liner,
                is_liner ? liner_solid(segment, options)
                         : lattice_solid(build.order.prepared.lattices.of(s), options),
                {}};
  if (!delivery.writes(MeshFormat::ply)) return rest;
  rest.colours = strain_colours(segment, s, is_liner, rest.solid.mesh, options, shapes);
  delivery.tell(fmt::format("{}: colours in PLY from strain {} to {}\n",
                            delivery.part_name(s, fmt::format("preview-{}", rest.kind())),
                            written(rest.colours.ramp.low, 6), written(rest.colours.ramp.high, 6)));
  return rest;
}

void make_part(Build& build, const RestPart& rest, const std::vector<PreviewShape>& shapes,
               PreviewParts& parts) {
  Delivery& delivery = build.delivery;
  const std::size_t s = rest.segment;
  SceneBody body{delivery.part_name(s, rest.kind()), rest.solid.mesh,
                 rest.is_liner ? preview_liner_colour : preview_lattice_colour};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    Part part{delivery.part_name(s, fmt::format("preview-{}-{}", shapes[i].label, rest.kind())), "",
              s};
    if (!rest.colours.of_shape.empty()) part.colours = rest.colours.of_shape[i];
    delivery.progress().begin(part.stem);
    Solid moved = moved_solid(rest.solid, shapes[i].shape, s);
    delivery.deliver(part, moved);
    body.targets.push_back({shapes[i].label, moved.mesh.vertices});
    parts.picture.push_back({std::move(moved.mesh), i, rest.is_liner});
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
    const SolidOptions options = preview_options(design, s, build.start_z_mm(s), shapes);
    for (const bool is_liner : {false, true}) {
      if (!is_liner && !design.segments[s].lattice) continue;
      make_part(build, rest_part(build, s, is_liner, options, shapes), shapes, parts);
    }
  }
  const std::string picture = design.name + "-preview.png";
  delivery.progress().begin(picture);
  write_png(delivery.add_file(picture), preview_picture(parts.picture, shapes));
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
