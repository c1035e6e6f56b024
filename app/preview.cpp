// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preview.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace latticast {
namespace {

constexpr Colour lattice_colour{0.16, 0.36, 0.62};
constexpr Colour liner_colour{0.93, 0.86, 0.76};

State state_at(const Response& response, std::size_t i, std::size_t segment, double pressure) {
  if (response.states[i]) return *response.states[i];
  throw NoEquilibrium(
      fmt::format("preview at {:g} kPa, segment {}: {}", pressure, segment + 1, response.message));
}

double widest(const std::vector<PicturePart>& parts) {
  double radius = 0;
  for (const PicturePart& part : parts) {
    for (const Point& p : part.mesh.vertices) radius = std::max(radius, std::hypot(p[0], p[1]));
  }
  return radius;
}

}  // namespace

std::vector<PressureShape> predict_preview(const Design& design) {
  const std::vector<double>& pressures = design.make.preview->pressures_kpa;
  std::vector<Response> responses;
  for (const Segment& segment : design.segments) {
    responses.push_back(predict(segment, design.model, pressures));
  }
  std::vector<PressureShape> shapes;
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    std::vector<State> states;
    for (std::size_t s = 0; s < design.segments.size(); ++s) {
      states.push_back(state_at(responses[s], i, s, pressures[i]));
    }
    shapes.push_back({pressures[i], Shape(design.segments, states), states});
  }
  return shapes;
}

SolidOptions preview_options(const Design& design, std::size_t segment, double start_z_mm,
                             const std::vector<PressureShape>& shapes) {
  SolidOptions options{design.output.tolerance_mm, start_z_mm, 0, 1};
  for (const PressureShape& at : shapes) {
    const State& state = at.states[segment];
    // Bending curves the walls too: the mesh is cut as for a twist that curves them as much.
    options.twist_rad_per_mm =
        std::max(options.twist_rad_per_mm, at.shape.curving_rad_per_mm(segment));
    options.stretch_radius = std::max(
        options.stretch_radius, state.outer_radius_mm / design.segments[segment].outer_radius_mm());
  }
  return options;
}

TriangleMesh moved_mesh(const TriangleMesh& rest, const Shape& shape, std::size_t segment) {
  TriangleMesh moved = rest;
  for (Point& point : moved.vertices) point = shape.moved(point, segment);
  return moved;
}

Image preview_picture(const std::vector<PicturePart>& parts) {
  const double spacing = 2.7 * widest(parts);
  std::vector<PictureObject> objects;
  objects.reserve(parts.size());
  for (const PicturePart& part : parts) {
    objects.push_back({part.mesh,
                       part.is_liner ? liner_colour : lattice_colour,
                       {0, spacing * static_cast<double>(part.place), 0},
                       1});
  }
  const Camera camera{{-1, 0, -0.22}, {0, 0, 1}, 12};
  return draw_picture(objects, camera);
}

}  // namespace latticast
