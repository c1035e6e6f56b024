// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/preview.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "design/text/written_number.h"
#include "geometry/mesh/weld.h"
#include "geometry/solid/geometry_error.h"
#include "geometry/solid/self_intersection.h"
#include "model/section/deformation.h"
#include "model/shape/shape.h"
#include "model/shape/strand_strain.h"
#include "prepared/prepared_responses.h"
#include "report/no_equilibrium.h"

namespace latticast {
namespace {

// More pressures than this in a file's name help nobody.
constexpr std::size_t most_named_pressures = 6;

constexpr int most_refinements = 3;

// A quadratic map leaves a flat triangle by sum of l_i l_j q_ij, which is q/4 in the middle of a
// side and at most q/3 anywhere.
constexpr double worst_inside_triangle = 4.0 / 3;

// Where a layer becomes as thin as the tolerance, its floor's facets would reach its ceiling's.
constexpr double most_of_thickness = 0.25;

double thinnest_layer_mm(const Segment& segment, const State& state) {
  const double middle =
      current_radius_mm(segment.inner_radius_mm(), segment.liner_outer_radius_mm(),
                        state.deformation(segment.inner_radius_mm()));
  const double liner = middle - state.inner_radius_mm;
  return segment.lattice ? std::min(liner, state.outer_radius_mm - middle) : liner;
}

// Grid points that are neighbours at rest stay at least two units of float32 apart where they are
// moved to. Two more for the sectors' steps, which are rounded to a power of two.
double least_step_mm(const PreviewShape& at, std::size_t segment) {
  const Shape& shape = at.shape;
  const double farthest = shape.length_mm() + at.states[segment].outer_radius_mm;
  const double least = std::max(1e-3, shape.least_stretch(segment));
  return 4 * 0x1p-23 * farthest / least;
}

std::string case_label(const LoadCase& load, std::size_t number) {
  const std::vector<double>& pressures = load.pressures_kpa;
  const bool alike = std::adjacent_find(pressures.begin(), pressures.end(),
                                        std::not_equal_to<>()) == pressures.end();
  if (alike) return fmt::format("{}kPa", pressures.front());
  if (pressures.size() > most_named_pressures) return fmt::format("case-{}", number);
  std::string label;
  for (const double pressure : pressures) {
    label += fmt::format("{}{}", label.empty() ? "" : "_", pressure);
  }
  return label + "kPa";
}

// "20 kPa", or those of all segments where they differ.
std::string case_title(const LoadCase& load) {
  const std::vector<double>& pressures = load.pressures_kpa;
  const bool alike = std::adjacent_find(pressures.begin(), pressures.end(),
                                        std::not_equal_to<>()) == pressures.end();
  std::string title;
  for (std::size_t i = 0; i < (alike ? 1 : pressures.size()); ++i) {
    title += (i == 0 ? "" : ", ") + written(pressures[i], 4);
  }
  return title + " kPa";
}

[[noreturn]] void refuse_case(const ChainResponse& chain, std::size_t load_case) {
  const std::vector<double>& pressures = chain.cases[load_case].pressures_kpa;
  std::string text;
  for (std::size_t s = 0; s < chain.responses.size(); ++s) {
    if (state_in(chain, load_case, s)) continue;
    text += fmt::format("{}preview at {} kPa, segment {}: {}", text.empty() ? "" : "\n",
                        written(pressures[s], 6), s + 1, chain.responses[s].message);
  }
  throw NoEquilibrium(text);
}

// Horizontal direction in which the tips move, all cases together; x when they stay on the axis.
double bending_plane_rad(const std::vector<PreviewShape>& shapes) {
  // Opposite bends share a plane: directions are added with their angles doubled.
  double cosine = 0;
  double sine = 0;
  for (const PreviewShape& at : shapes) {
    const Point tip = at.shape.tip().origin;
    const double twice = 2 * std::atan2(tip[1], tip[0]);
    cosine += std::hypot(tip[0], tip[1]) * std::cos(twice);
    sine += std::hypot(tip[0], tip[1]) * std::sin(twice);
  }
  const double length = shapes.back().shape.length_mm();
  if (std::hypot(cosine, sine) < 1e-3 * length) return 0.5 * std::numbers::pi;
  return 0.5 * std::atan2(sine, cosine);
}

Point middle(const Point& a, const Point& b) {
  return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])};
}

double area_mm2(const TriangleMesh& mesh) {
  double area = 0;
  for (const Triangle& t : mesh.triangles) {
    Point p{};
    Point q{};
    for (int i = 0; i < 3; ++i) {
      p[i] = mesh.vertices[t[1]][i] - mesh.vertices[t[0]][i];
      q[i] = mesh.vertices[t[2]][i] - mesh.vertices[t[0]][i];
    }
    area += 0.5 * std::hypot(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
                             p[0] * q[1] - p[1] * q[0]);
  }
  return area;
}

// How far a place's parts reach along a horizontal direction.
struct Reach {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
};

std::vector<Reach> reaches(const std::vector<PicturePart>& parts, std::size_t places,
                           double direction_rad) {
  std::vector<Reach> found(places);
  const double cosine = std::cos(direction_rad);
  const double sine = std::sin(direction_rad);
  for (const PicturePart& part : parts) {
    Reach& reach = found[part.place];
    for (const Point& p : part.mesh.vertices) {
      const double along = p[0] * cosine + p[1] * sine;
      reach.low = std::min(reach.low, along);
      reach.high = std::max(reach.high, along);
    }
  }
  return found;
}

// Where each place's base stands, one place beside the other with a gap between them.
std::vector<double> standing_places(const std::vector<Reach>& reaches) {
  double widest = 0;
  for (const Reach& reach : reaches) widest = std::max(widest, reach.high - reach.low);
  std::vector<double> places;
  double edge = 0;
  for (const Reach& reach : reaches) {
    places.push_back(edge - reach.low);
    edge += reach.high - reach.low + 0.3 * widest;
  }
  return places;
}

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

Point centre(const TriangleMesh& mesh, const Triangle& t) {
  Point sum{};
  for (const std::uint32_t corner : t) {
    for (int i = 0; i < 3; ++i) sum[i] += mesh.vertices[corner][i] / 3;
  }
  return sum;
}

double reach(const TriangleMesh& mesh, const Triangle& t) {
  const Point middle = centre(mesh, t);
  double farthest = 0;
  for (const std::uint32_t corner : t) {
    const Point& p = mesh.vertices[corner];
    farthest = std::max(farthest, std::hypot(p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]));
  }
  return farthest;
}

// Triangles of one place meet because they are flat, others because the actuator touches itself.
bool far_parts_meet(const TriangleMesh& rest, const TriangleMesh& moved) {
  const std::vector<char> all(moved.triangles.size(), 0);
  const auto pairs = self_intersections(moved, all);
  return std::all_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
    const Triangle& a = rest.triangles[pair.first];
    const Triangle& b = rest.triangles[pair.second];
    const Point p = centre(rest, a);
    const Point q = centre(rest, b);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) >
           2 * (reach(rest, a) + reach(rest, b));
  });
}

PreviewPart one_attempt(const PreviewMaker& maker, std::size_t segment, const SolidOptions& options,
                        const std::vector<PreviewShape>& shapes) {
  PreviewPart part{options, maker.rest(options), {}, {}, {}};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    maker.begin(i);
    const Shape& shape = shapes[i].shape;
    part.moved.push_back(moved_solid(part.rest, shape, segment));
    const TriangleMesh in_file = weld(part.moved.back().mesh);
    part.audits.push_back(audit(in_file));
    const bool meets =
        part.audits.back().has_only(Defect::self_intersection) &&
        (shape.least_stretch(segment) <= 0 || far_parts_meet(part.rest.mesh, in_file));
    part.touches.push_back(meets ? 1 : 0);
  }
  return part;
}

bool is_folded(const PreviewPart& part) {
  for (std::size_t i = 0; i < part.audits.size(); ++i) {
    if (!part.audits[i].passes() && part.touches[i] == 0) return true;
  }
  return false;
}

std::string segment_title(const Segment& segment, std::size_t index) {
  return segment.name.empty() ? fmt::format("segment {}", index + 1) : segment.name;
}

PictureText preview_text(const std::vector<PicturePart>& parts,
                         const std::vector<PreviewShape>& shapes,
                         const std::vector<Segment>& segments, const std::vector<double>& places,
                         double plane) {
  const auto placed = [&](Point p, std::size_t place) {
    p[0] += places[place] * std::cos(plane);
    p[1] += places[place] * std::sin(plane);
    return p;
  };
  double lowest = HUGE_VAL;
  for (const PicturePart& part : parts) {
    for (const Point& p : part.mesh.vertices) lowest = std::min(lowest, p[2]);
  }
  PictureText text{.labels = {}, .scale_bar = true, .bar_at_mm = placed({}, 0)};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    text.labels.push_back({shapes[i].title, placed({0, 0, lowest}, i), 1.6});
  }
  for (std::size_t s = 0; segments.size() > 1 && s < segments.size(); ++s) {
    const Frame middle = shapes.front().shape.frame_at(s, 0.5 * segments[s].length_mm);
    text.labels.push_back({segment_title(segments[s], s), placed(middle.origin, 0), 0});
  }
  return text;
}

}  // namespace

std::vector<PreviewShape> predict_preview(PreparedResponses& responses) {
  const Design& design = responses.design();
  const ChainResponse chain = responses.chain(design.make.preview->cases);
  std::vector<PreviewShape> shapes;
  std::set<std::string> seen;
  for (std::size_t i = 0; i < chain.cases.size(); ++i) {
    const auto states = states_in(chain, i);
    if (!states) refuse_case(chain, i);
    const std::string label = case_label(chain.cases[i], i + 1);
    if (!seen.insert(label).second) continue;
    shapes.push_back({label, case_title(chain.cases[i]), Shape(design.segments, *states), *states});
  }
  return shapes;
}

double coarsest_preview_mm(const Segment& segment, std::size_t number,
                           const std::vector<PreviewShape>& shapes) {
  double coarsest = HUGE_VAL;
  for (const PreviewShape& at : shapes) {
    coarsest =
        std::min(coarsest, most_of_thickness * thinnest_layer_mm(segment, at.states[number]));
  }
  return coarsest;
}

SolidOptions preview_options(const Design& design, std::size_t segment, double start_z_mm,
                             const std::vector<PreviewShape>& shapes) {
  SolidOptions options;
  options.tolerance_mm = std::min(design.output.tolerance_mm,
                                  coarsest_preview_mm(design.segments[segment], segment, shapes));
  options.start_z_mm = start_z_mm;
  for (const PreviewShape& at : shapes) {
    const State& state = at.states[segment];
    options.least_step_mm = std::max(options.least_step_mm, least_step_mm(at, segment));
    // Bending curves the walls too: the mesh is cut as for a twist that curves them as much.
    options.twist_rad_per_mm =
        std::max(options.twist_rad_per_mm, at.shape.curving_rad_per_mm(segment));
    options.stretch_radius = std::max(
        options.stretch_radius, state.outer_radius_mm / design.segments[segment].outer_radius_mm());
    options.stretch = std::max(options.stretch, at.shape.largest_stretch(segment));
  }
  return options;
}

TriangleMesh moved_mesh(const TriangleMesh& rest, const Shape& shape, std::size_t segment) {
  TriangleMesh moved = rest;
  for (Point& point : moved.vertices) point = shape.moved(point, segment);
  return moved;
}

SolidError moved_error(const Solid& rest, const TriangleMesh& moved, const Shape& shape,
                       std::size_t segment) {
  double worst = 0;
  for (const Triangle& t : rest.mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i];
      const std::uint32_t b = t[(i + 1) % 3];
      if (a > b) continue;  // the triangle beside this one has the edge as b, a
      const Point exact =
          shape.moved(middle(rest.mesh.vertices[a], rest.mesh.vertices[b]), segment);
      const Point chord = middle(moved.vertices[a], moved.vertices[b]);
      worst = std::max(worst,
                       std::hypot(exact[0] - chord[0], exact[1] - chord[1], exact[2] - chord[2]));
    }
  }
  SolidError error;
  error.surface_mm =
      shape.largest_stretch(segment) * rest.error.surface_mm + worst_inside_triangle * worst;
  error.volume_mm3 = error.surface_mm * area_mm2(moved);
  return error;
}

PreviewPart preview_part(const PreviewMaker& maker, std::size_t segment,
                         const SolidOptions& options, const std::vector<PreviewShape>& shapes) {
  PreviewPart part = one_attempt(maker, segment, options, shapes);
  for (SolidOptions finer = options; is_folded(part) && finer.refinement < most_refinements;) {
    ++finer.refinement;
    try {
      part = one_attempt({maker.rest}, segment, finer, shapes);
    } catch (const GeometryError&) {
      break;  // too many triangles: what there is will be judged
    }
  }
  return part;
}

StrainColours strain_colours(const Segment& segment, std::size_t number, bool is_liner,
                             const TriangleMesh& rest, const SolidOptions& options,
                             const std::vector<PreviewShape>& shapes) {
  const double start = options.start_z_mm;
  std::optional<StrandField> field;
  if (!is_liner) field = strand_field(segment, rest, start, options.tolerance_mm);
  std::vector<std::vector<double>> strains;
  double least = 0;
  double largest = 0;
  for (const PreviewShape& at : shapes) {
    const State& state = at.states[number];
    strains.push_back(is_liner ? liner_strains(segment, rest, start, options.tolerance_mm, state)
                               : strand_strains(*field, state));
    const auto [low, high] = std::minmax_element(strains.back().begin(), strains.back().end());
    least = std::min(least, *low);
    largest = std::max(largest, *high);
  }
  StrainColours found{{}, std::move(strains), strain_ramp(least, largest)};
  for (const std::vector<double>& of_shape : found.strains) {
    std::vector<Colour>& colours = found.of_shape.emplace_back();
    for (const double strain : of_shape) {
      const ByteColour bytes = colour_of(found.ramp, strain);
      colours.push_back({bytes[0] / 255.0, bytes[1] / 255.0, bytes[2] / 255.0});
    }
  }
  return found;
}

Image preview_picture(const std::vector<PicturePart>& parts,
                      const std::vector<PreviewShape>& shapes,
                      const std::vector<Segment>& segments) {
  const double plane = bending_plane_rad(shapes);
  const std::vector<double> places = standing_places(reaches(parts, shapes.size(), plane));
  std::vector<PictureObject> objects;
  objects.reserve(parts.size());
  for (const PicturePart& part : parts) {
    const double along = places[part.place];
    objects.push_back({part.mesh,
                       part.is_liner ? liner_colour : lattice_colour,
                       {along * std::cos(plane), along * std::sin(plane), 0},
                       1});
  }
  const Camera camera{{-std::sin(plane), std::cos(plane), -0.22}, {0, 0, 1}, 12};
  PictureOptions options;
  options.margin = 0.1;  // texts stand below the shapes
  return draw_picture(objects, camera, options,
                      preview_text(parts, shapes, segments, places, plane));
}

}  // namespace latticast
