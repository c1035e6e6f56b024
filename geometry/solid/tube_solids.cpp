// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/tube_solids.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>

#include "geometry/pattern/pattern.h"
#include "geometry/solid/arrangement.h"
#include "geometry/solid/cutting.h"
#include "geometry/solid/geometry_error.h"
#include "geometry/solid/lattice_drawing.h"
#include "geometry/solid/mesh_size.h"
#include "geometry/solid/region.h"
#include "geometry/solid/relief.h"
#include "geometry/solid/self_intersection.h"
#include "geometry/solid/tolerance_budget.h"

namespace latticast {
namespace {

constexpr double coarser = 4;  // grid steps where arcs graze other outlines

using Unite = std::function<Region(const PlaneGrid&, std::span<const std::int32_t> cuts)>;

// What is drawn, and between which radii it stands.
struct Layer {
  double circumference_mm = 0;  // of the plane
  Unite united;
  double floor_mm = 0;
  double ceiling_mm = 0;
  ToleranceBudget budget;
  double steepness = 0;  // of its walls (relief.h)
  double thinnest_strand_mm = HUGE_VAL;
  bool has_curves = false;
};

std::vector<std::int32_t> cut_heights(const Segment& segment, const SolidOptions& options,
                                      const PlaneGrid& grid) {
  const double bands = bands_of(segment, options, grid.sectors);
  if (bands > grid.length_steps / 16.0) {
    throw GeometryError("the preview twists so far that it would need " + std::to_string(bands) +
                        " cuts along the tube; use a coarser tolerance");
  }
  std::vector<std::int32_t> heights;
  for (int i = 1; i < bands; ++i) {
    heights.push_back(static_cast<std::int32_t>(std::lround(i * (grid.length_steps / bands))));
  }
  return heights;
}

void check_widths(const Layer& layer, const PlaneGrid& grid) {
  const double least = least_width_mm(grid);
  if (layer.thinnest_strand_mm >= least) return;
  throw GeometryError("a strand or ring of " + std::to_string(layer.thinnest_strand_mm) +
                      " mm is too thin for the coordinates of a mesh file on a tube this large or "
                      "this far along the actuator; here it needs at least " +
                      std::to_string(least) + " mm");
}

void check_size(const Relief& relief) {
  const double levels = static_cast<double>(relief.radii_mm.front().size()) - 1;
  const double triangles = 2 * static_cast<double>(relief.plane.triangles.size()) +
                           4 * levels * static_cast<double>(relief.plane.outline.size());
  if (triangles <= most_triangles) return;
  throw GeometryError("the mesh would have about " + std::to_string(std::llround(triangles / 1e6)) +
                      " million triangles; the limit is " +
                      std::to_string(std::llround(most_triangles / 1e6)) +
                      " million: use a coarser tolerance or fewer strands");
}

// A layer's region on a grid, and what stands on it.
struct LaidOut {
  Region region;
  Relief relief;
};

// How finely a layer is laid out: its grid, and the levels of its walls beyond what they need.
struct Fineness {
  double step_mm = finest_step_mm;
  int levels = 1;
};

LaidOut lay_out(const Segment& segment, const SolidOptions& options, const Layer& layer,
                const Fineness& fineness) {
  const PlaneGrid grid = make_plane_grid(layer.circumference_mm, segment.length_mm,
                                         sectors_of(segment, options, layer.budget.facets_mm),
                                         fineness.step_mm, options.start_z_mm);
  check_widths(layer, grid);
  Region region = layer.united(grid, cut_heights(segment, options, grid));
  const double tolerance = layer.budget.walls_mm / fineness.levels;
  Relief relief{triangulate(region),
                {wall_radii(layer.floor_mm, layer.ceiling_mm, grid.sector_angle_rad(),
                            layer.steepness, tolerance)},
                options.start_z_mm};
  check_size(relief);
  return {std::move(region), std::move(relief)};
}

// Where an arc grazes another outline, the space between them may be narrower than what their walls
// leave their surfaces by. A coarser grid joins such outlines, further levels keep walls apart.
LaidOut lay_out_clear(const Segment& segment, const SolidOptions& options, const Layer& layer,
                      TriangleMesh& mesh) {
  const double coarsest =
      std::min(layer.budget.coarsest_step_mm, layer.thinnest_strand_mm / (2 * fewest_steps_across));
  Fineness fineness{std::max(finest_step_mm, options.least_step_mm), 1 << options.refinement};
  LaidOut laid_out = lay_out(segment, options, layer, fineness);
  mesh = wrap(laid_out.relief);
  while (layer.has_curves && fineness.step_mm < coarsest && intersects_itself(mesh)) {
    fineness = {std::min(coarsest, coarser * fineness.step_mm), 2 * fineness.levels};
    laid_out = lay_out(segment, options, layer, fineness);
    mesh = wrap(laid_out.relief);
  }
  return laid_out;
}

// Of the outline, at the radius where the plane is unrolled.
double outline_length_mm(const PlaneMesh& plane) {
  const double around = static_cast<double>(plane.grid.sectors) * plane.grid.sector_steps;
  double length = 0;
  for (const OutlineEdge& edge : plane.outline) {
    const PlaneMeshVertex& from = plane.vertices[edge.from];
    const PlaneMeshVertex& to = plane.vertices[edge.to];
    const double u = static_cast<double>(to.sector - from.sector) * plane.grid.sector_steps +
                     to.point.u - from.point.u;
    const double z = to.point.z - from.point.z;
    length +=
        std::hypot(std::remainder(u, around) * plane.grid.u_step_mm, z * plane.grid.z_step_mm);
  }
  return length;
}

Solid wrap_layer(const Segment& segment, const SolidOptions& options, const Layer& layer) {
  Solid solid;
  const LaidOut laid_out = lay_out_clear(segment, options, layer, solid.mesh);
  const double height = layer.ceiling_mm - layer.floor_mm;
  const double mid_radius = layer.circumference_mm / (2 * std::numbers::pi);
  const double both_radii = layer.ceiling_mm + layer.floor_mm;
  const double area = area_mm2(laid_out.region);
  solid.volume_mm3 = area * height * both_radii / (2 * mid_radius);
  // Floor and ceiling lie within the tolerance of their cylinders, and all surfaces move by up to
  // half a float32 step each way when coordinates are rounded.
  const double rounding = std::numbers::sqrt3 * 0x1p-24 *
                          std::max(layer.ceiling_mm, options.start_z_mm + segment.length_mm);
  const double walls = outline_length_mm(laid_out.relief.plane) * layer.ceiling_mm / mid_radius;
  solid.volume_bound_mm3 = area / mid_radius * both_radii * (options.tolerance_mm + rounding) +
                           walls * height * rounding;
  solid.pieces = pieces(laid_out.relief.plane);
  solid.genus = outline_loops(laid_out.region) - solid.pieces;
  solid.error = solid_error(laid_out.region, laid_out.relief.radii_mm, mid_radius,
                            std::span(&layer.steepness, 1));
  return solid;
}

}  // namespace

Solid lattice_solid(const Segment& segment, const SolidOptions& options) {
  LatticeDrawing drawing(segment, options.tolerance_mm);
  return lattice_solid(drawing, options);
}

Solid lattice_solid(LatticeDrawing& drawing, const SolidOptions& options) {
  const Segment& segment = drawing.segment();
  const Lattice& lattice = *segment.lattice;
  const LatticeCutting cutting = lattice_cutting(segment, options);
  const ToleranceBudget& budget = cutting.budget;
  const auto united = [&](const PlaneGrid& grid, std::span<const std::int32_t> cuts) {
    return drawing.united(budget.drawing_mm, grid, cuts, budget.closing_mm);
  };
  return wrap_layer(segment, options,
                    {.circumference_mm = drawing.outlines(budget.drawing_mm).circumference_mm,
                     .united = united,
                     .floor_mm = segment.liner_outer_radius_mm(),
                     .ceiling_mm = segment.outer_radius_mm(),
                     .budget = budget,
                     .steepness = cutting.steepness,
                     .thinnest_strand_mm = thinnest_strand_mm(lattice),
                     .has_curves = has_curved_outlines(lattice)});
}

Solid liner_solid(const Segment& segment, const SolidOptions& options) {
  const double inner = segment.inner_radius_mm();
  const double outer = segment.liner_outer_radius_mm();
  const ToleranceBudget budget = layered_budget(options.tolerance_mm);
  const Pattern sleeve = draw_sleeve(0.5 * (inner + outer), segment.length_mm);
  const auto united = [&](const PlaneGrid& grid, std::span<const std::int32_t> cuts) {
    return unite(sleeve, grid, cuts, budget.closing_mm);
  };
  return wrap_layer(segment, options,
                    {.circumference_mm = sleeve.circumference_mm,
                     .united = united,
                     .floor_mm = inner,
                     .ceiling_mm = outer,
                     .budget = budget});
}

}  // namespace latticast
