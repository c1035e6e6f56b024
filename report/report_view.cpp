// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/report_view.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/core.h>

#include "design/design.h"
#include "design/text/written_number.h"
#include "design/units.h"
#include "export/mesh/glb_file.h"
#include "model/shape/shape.h"
#include "prepared/prepared_design.h"
#include "report/preview.h"

namespace latticast {
namespace {

constexpr double finest_mm = 0.05;
constexpr double coarsest_mm = 1;
constexpr std::size_t most_vertices = 110000;  // in all states together
constexpr int fewest_steps = 4;
constexpr int most_steps = 24;
constexpr double step_rad = radians(20);  // its chord runs 1.5 % inside the arc

State rest_state(const Segment& segment) {
  State state;
  state.inner_radius_mm = segment.inner_radius_mm();
  state.outer_radius_mm = segment.outer_radius_mm();
  state.stable = true;
  return state;
}

// How different two states look.
double seen_distance(const State& a, const State& b, const Segment& segment) {
  const double length = segment.length_mm;
  const double turn = (b.twist_rad_per_mm - a.twist_rad_per_mm) * length;
  const double bend = std::hypot(b.bend_rad_per_mm[0] - a.bend_rad_per_mm[0],
                                 b.bend_rad_per_mm[1] - a.bend_rad_per_mm[1]) *
                      length;
  const double growth =
      std::abs(b.stretch - a.stretch) + std::abs(b.outer_radius_mm / a.outer_radius_mm - 1);
  return std::abs(turn) + bend + growth;
}

// Rest, both ends of the branch, and between them states at even distances.
std::vector<State> chosen_states(const std::vector<State>& all, const Segment& segment) {
  std::vector<double> along = {0};
  for (std::size_t i = 1; i < all.size(); ++i) {
    along.push_back(along.back() + seen_distance(all[i - 1], all[i], segment));
  }
  const int steps =
      std::clamp(static_cast<int>(std::ceil(along.back() / step_rad)), fewest_steps, most_steps);
  std::vector<State> chosen;
  double next = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool due = along[i] >= next - 1e-12 * along.back();
    if (!due && all[i].pressure_kpa != 0 && i + 1 != all.size()) continue;
    chosen.push_back(all[i]);
    while (next <= along[i]) next += std::max(along.back(), 1e-12) / steps;
  }
  return chosen;
}

std::vector<State> states_of(const Design& design, const ReportCurves* curves, std::size_t s) {
  if (curves != nullptr) {
    const std::vector<State> all = curves->segments[s].states();
    if (!all.empty()) return chosen_states(all, design.segments[s]);
  }
  return {rest_state(design.segments[s])};
}

// The segment by itself, its base at the origin.
std::vector<PreviewShape> shapes_of(const Segment& segment, const std::vector<State>& states) {
  std::vector<PreviewShape> shapes;
  shapes.reserve(states.size());
  for (const State& state : states) {
    shapes.push_back({"", "", Shape(std::span(&segment, 1), std::span(&state, 1)), {state}});
  }
  return shapes;
}

ViewBody make_body(std::string node, bool is_liner, TriangleMesh rest,
                   const std::vector<PreviewShape>& shapes) {
  ViewBody body{std::move(node), is_liner, std::move(rest), {}};
  for (const PreviewShape& shape : shapes) {
    if (shape.states.front().pressure_kpa == 0) continue;
    body.poses.push_back(moved_mesh(body.rest, shape.shape, 0).vertices);
  }
  return body;
}

ViewSegment make_segment(PreparedDesign& prepared, std::size_t s, const std::vector<State>& states,
                         double tolerance_mm) {
  const Segment& segment = prepared.design.segments[s];
  const std::vector<PreviewShape> shapes = shapes_of(segment, states);
  Design alone;
  alone.segments = {segment};
  alone.output.tolerance_mm = tolerance_mm;
  const SolidOptions options = preview_options(alone, 0, 0, shapes);
  ViewSegment view{{}, states};
  if (segment.lattice) {
    view.bodies.push_back(make_body(fmt::format("segment-{}-lattice", s + 1), false,
                                    lattice_solid(prepared.lattices.of(s), options).mesh, shapes));
  }
  view.bodies.push_back(make_body(fmt::format("segment-{}-liner", s + 1), true,
                                  liner_solid(segment, options).mesh, shapes));
  return view;
}

std::size_t size_of(const ReportView& view) {
  std::size_t size = 0;
  for (const ViewSegment& segment : view.segments) {
    for (const ViewBody& body : segment.bodies) {
      size += body.rest.vertices.size() * (body.poses.size() + 1);
    }
  }
  return size;
}

}  // namespace

ReportView make_view(PreparedDesign& prepared, const ReportCurves* curves) {
  const Design& design = prepared.design;
  std::vector<std::vector<State>> states;
  for (std::size_t s = 0; s < design.segments.size(); ++s) {
    states.push_back(states_of(design, curves, s));
  }
  const double wanted = std::max(finest_mm, design.output.tolerance_mm);
  ReportView view;
  for (view.tolerance_mm = wanted;;
       view.tolerance_mm *= size_of(view) > 3 * most_vertices ? 4 : 2) {
    view.segments.clear();
    for (std::size_t s = 0; s < design.segments.size(); ++s) {
      view.segments.push_back(make_segment(prepared, s, states[s], view.tolerance_mm));
    }
    if (size_of(view) <= most_vertices || 2 * view.tolerance_mm > coarsest_mm) break;
  }
  if (view.tolerance_mm > wanted) {
    view.note = fmt::format("Meshes in this view are within {} mm, to keep the page small.",
                            written(view.tolerance_mm, 6));
  }
  return view;
}

std::string view_glb(const ReportView& view) {
  Scene scene;
  for (const ViewSegment& segment : view.segments) {
    for (const ViewBody& body : segment.bodies) {
      SceneBody& shown = scene.bodies.emplace_back();
      shown.name = body.node;
      shown.mesh = body.rest;
      shown.colour = body.is_liner ? liner_colour : lattice_colour;
      std::size_t pose = 0;
      for (const State& state : segment.states) {
        if (state.pressure_kpa == 0) continue;
        shown.targets.push_back(
            {fmt::format("{} kPa", written(state.pressure_kpa, 6)), body.poses[pose++]});
      }
    }
  }
  return encode_glb(scene);
}

}  // namespace latticast
