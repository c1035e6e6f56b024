// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/preview.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <set>

#include <fmt/core.h>

#include "design/text/written_number.h"
#include "model/shape/shape.h"
#include "model/shape/strand_strain.h"
#include "prepared/prepared_responses.h"
#include "report/no_equilibrium.h"

namespace latticast {
namespace {

// More pressures than this in a file's name help nobody.
constexpr std::size_t most_named_pressures = 6;

// A quadratic map leaves a flat triangle by sum of l_i l_j q_ij, which is q/4 in the middle of a
// side and at most q/3 anywhere.
constexpr double worst_inside_triangle = 4.0 / 3;

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
    shapes.push_back({label, Shape(design.segments, *states), *states});
  }
  return shapes;
}

SolidOptions preview_options(const Design& design, std::size_t segment, double start_z_mm,
                             const std::vector<PreviewShape>& shapes) {
  SolidOptions options{design.output.tolerance_mm, start_z_mm, 0, 1};
  for (const PreviewShape& at : shapes) {
    const State& state = at.states[segment];
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
  StrainColours found{{}, strain_ramp(least, largest)};
  for (const std::vector<double>& of_shape : strains) {
    std::vector<Colour>& colours = found.of_shape.emplace_back();
    for (const double strain : of_shape) {
      const ByteColour bytes = colour_of(found.ramp, strain);
      colours.push_back({bytes[0] / 255.0, bytes[1] / 255.0, bytes[2] / 255.0});
    }
  }
  return found;
}

Image preview_picture(const std::vector<PicturePart>& parts,
                      const std::vector<PreviewShape>& shapes) {
  const double plane = bending_plane_rad(shapes);
  const std::vector<double> places = standing_places(reaches(parts, shapes.size(), plane));
  std::vector<PictureObject> objects;
  objects.reserve(parts.size());
  for (const PicturePart& part : parts) {
    const double along = places[part.place];
    objects.push_back({part.mesh,
                       part.is_liner ? preview_liner_colour : preview_lattice_colour,
                       {along * std::cos(plane), along * std::sin(plane), 0},
                       1});
  }
  const Camera camera{{-std::sin(plane), std::cos(plane), -0.22}, {0, 0, 1}, 12};
  return draw_picture(objects, camera);
}

}  // namespace latticast
