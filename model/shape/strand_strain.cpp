// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/strand_strain.h"

#include <algorithm>
#include <cmath>

#include "design/units.h"
#include "geometry/pattern/rings.h"
#include "geometry/pattern/strand_path.h"
#include "model/shape/inflated_wall.h"
#include "model/strand/links.h"

namespace latticast {
namespace {

constexpr int fibre_intervals = 32;

// A family, with what each vertex asks of it.
struct Family {
  const Grid* grid = nullptr;
  int index = 0;
  double sine = 1;
  double cosine = 0;
  double spacing_mm = 0;   // along u
  double reach_mm = 0;     // of a strand's outline from its line
  PlacedStrand drawn;      // with the path as it is drawn
  std::vector<int> shape;  // of each strand; none: straight
};

// All that a segment's strands are found by.
struct Strands {
  std::vector<Family> families;
  std::vector<double> ring_centres_mm;
  double ring_width_mm = 0;
  double mid_radius_mm = 0;
};

// A strand and how far outside its outline a place lies; inside: negative.
struct Nearness {
  double outside_mm = HUGE_VAL;
  StrandMember member;
};

double cotangent(const Family& family) {
  return family.cosine / family.sine;
}

int shape_index(std::vector<LinkShape>& shapes, const LinkShape& shape) {
  const auto at = std::find(shapes.begin(), shapes.end(), shape);
  if (at != shapes.end()) return static_cast<int>(at - shapes.begin());
  shapes.push_back(shape);
  return static_cast<int>(shapes.size()) - 1;
}

Family family_of(const Segment& segment, int index, std::vector<LinkShape>& shapes) {
  const Grid& grid = segment.lattice->grids[index];
  const double angle = grid.angle_rad();
  Family family;
  family.grid = &grid;
  family.index = index;
  family.sine = std::sin(angle);
  family.cosine = grid.angle_deg == 90 ? 0 : std::cos(angle);
  family.spacing_mm = segment.lattice_circumference_mm() / grid.count();
  family.reach_mm = 0.5 * *std::max_element(grid.widths_mm.begin(), grid.widths_mm.end());
  family.drawn = closed(placed_strand(segment, grid));
  family.reach_mm += reach_mm(family.drawn);
  for (const double width : grid.widths_mm) {
    const auto link = link_shape(segment, grid, width);
    if (link) family.shape.push_back(shape_index(shapes, *link));
  }
  return family;
}

// Strand j of the family, `beside_mm` being the place's distance from its line along u.
double outside_mm(const Family& family, int strand, double beside_mm, double along_mm) {
  const double half_width = 0.5 * family.grid->widths_mm[strand];
  const double across = beside_mm * family.sine;
  const double along_chord = beside_mm * family.cosine + along_mm / family.sine;
  return centre_line_distance_mm(family.drawn, along_chord, across) - half_width;
}

// Neighbours on either side are asked for as long as they may be nearer.
Nearness nearest_strand(const Family& family, double mid_radius_mm, const WallPoint& point) {
  const double circumference = 2 * pi * mid_radius_mm;
  const double u = mid_radius_mm * point.theta_rad - point.along_mm * cotangent(family);
  const int count = family.grid->count();
  const double place = std::remainder(u, circumference) / family.spacing_mm;
  const auto middle = static_cast<int>(std::lround(place));
  Nearness nearest;
  for (int away = 0; away <= count / 2; ++away) {
    const double least = (away - 0.5) * family.spacing_mm * family.sine - family.reach_mm;
    if (least > nearest.outside_mm) break;
    for (const int number : {middle - away, middle + away}) {
      const int strand = (number % count + count) % count;
      const double beside = (place - number) * family.spacing_mm;
      const double outside = outside_mm(family, strand, beside, point.along_mm);
      if (outside >= nearest.outside_mm) continue;
      const double line_rad = point.theta_rad - beside / mid_radius_mm;
      nearest = {outside,
                 {family.index, family.shape.empty() ? -1 : family.shape[strand], line_rad}};
    }
  }
  return nearest;
}

Nearness nearest_ring(const std::vector<double>& centres, double width_mm, const WallPoint& point) {
  Nearness nearest;
  const auto above = std::lower_bound(centres.begin(), centres.end(), point.along_mm);
  for (const int side : {-1, 0}) {
    const auto at = above + side;
    if (at < centres.begin() || at >= centres.end()) continue;
    nearest.outside_mm =
        std::min(nearest.outside_mm, std::abs(point.along_mm - *at) - 0.5 * width_mm);
  }
  nearest.member.theta_rad = point.theta_rad;
  return nearest;
}

Strands strands_of(const Segment& segment, std::vector<LinkShape>& shapes) {
  const Lattice& lattice = *segment.lattice;
  Strands strands;
  strands.mid_radius_mm = segment.lattice_mid_radius_mm();
  strands.families.reserve(lattice.grids.size());
  for (int i = 0; i < static_cast<int>(lattice.grids.size()); ++i) {
    strands.families.push_back(family_of(segment, i, shapes));
  }
  if (!lattice.rings) return strands;
  strands.ring_centres_mm = ring_centres_mm(*lattice.rings, segment.length_mm);
  strands.ring_width_mm = lattice.rings->width_mm;
  return strands;
}

// Those that hold the point, or else the nearest.
void add_members(const Strands& strands, const WallPoint& point, double tolerance_mm,
                 std::vector<StrandMember>& members) {
  const std::size_t before = members.size();
  Nearness nearest;
  const auto meet = [&](const Nearness& strand) {
    if (strand.outside_mm <= tolerance_mm) members.push_back(strand.member);
    if (strand.outside_mm < nearest.outside_mm) nearest = strand;
  };
  meet(nearest_ring(strands.ring_centres_mm, strands.ring_width_mm, point));
  for (const Family& family : strands.families) {
    meet(nearest_strand(family, strands.mid_radius_mm, point));
  }
  if (members.size() == before) members.push_back(nearest.member);
}

// A mesh's flat facets approximate its round faces, so that a vertex of a face is off the face's
// radius by up to the mesh's tolerance. Such a vertex is taken to lie on the face.
WallPoint wall_point(const Point& p, double floor_mm, double ceiling_mm, double start_z_mm,
                     double tolerance_mm) {
  double radius = std::hypot(p[0], p[1]);
  const double face = radius < 0.5 * (floor_mm + ceiling_mm) ? floor_mm : ceiling_mm;
  if (std::abs(radius - face) <= tolerance_mm) radius = face;
  return {std::clamp(radius, floor_mm, ceiling_mm), std::atan2(p[1], p[0]), p[2] - start_z_mm};
}

// The direction of bending turns along the segment, while wall_stretch counts angles from that at
// the base.
WallStretch stretch_at(const Segment& segment, const State& state, double radius_mm,
                       double theta_rad, double along_mm) {
  return wall_stretch(segment, state, radius_mm,
                      theta_rad - state.frame_turn_rad_per_mm * along_mm);
}

double chord_strain(const StrandField& field, const State& state, const StrandMember& member,
                    const WallPoint& point) {
  const double angle = field.segment.lattice->grids[member.grid].angle_rad();
  const WallStretch at = stretch_at(field.segment, state, field.segment.lattice_mid_radius_mm(),
                                    member.theta_rad, point.along_mm);
  return at.along(angle) - 1;
}

// Largest fibre strain against chord strain, on a grid of chord strains that holds 0, where the
// curve has its corner.
struct FibreTable {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  std::vector<double> chord;
  std::vector<double> fibre;

  void meet(double strain) {
    low = std::min(low, strain);
    high = std::max(high, strain);
  }

  void fill(const LinkShape& shape) {
    for (int i = 0; i <= fibre_intervals; ++i) {
      chord.push_back(std::lerp(low, high, static_cast<double>(i) / fibre_intervals));
    }
    if (low < 0 && high > 0) chord.push_back(0);
    std::sort(chord.begin(), chord.end());
    chord.erase(std::unique(chord.begin(), chord.end()), chord.end());
    for (const double strain : chord) {
      fibre.push_back(largest_fibre_strain(shape, strain).value_or(0));
    }
  }

  double at(double strain) const {
    const auto above = std::upper_bound(chord.begin(), chord.end(), strain);
    if (above == chord.end()) return fibre.back();
    if (above == chord.begin()) return fibre.front();
    const auto i = static_cast<std::size_t>(above - chord.begin());
    return std::lerp(fibre[i - 1], fibre[i], (strain - chord[i - 1]) / (chord[i] - chord[i - 1]));
  }
};

// One per shape of the field.
std::vector<FibreTable> fibre_tables(const StrandField& field, const State& state) {
  std::vector<FibreTable> tables(field.shapes.size());
  if (tables.empty()) return tables;
  for (std::size_t v = 0; v < field.points.size(); ++v) {
    for (std::uint32_t m = field.first[v]; m < field.first[v + 1]; ++m) {
      const StrandMember& member = field.members[m];
      if (member.shape < 0) continue;
      tables[member.shape].meet(chord_strain(field, state, member, field.points[v]));
    }
  }
  for (std::size_t i = 0; i < tables.size(); ++i) {
    if (tables[i].low <= tables[i].high) tables[i].fill(field.shapes[i]);
  }
  return tables;
}

}  // namespace

StrandField strand_field(const Segment& segment, const TriangleMesh& rest, double start_z_mm,
                         double tolerance_mm) {
  StrandField field;
  field.segment = segment;
  const Strands strands = strands_of(segment, field.shapes);
  field.points.reserve(rest.vertices.size());
  field.first.reserve(rest.vertices.size() + 1);
  field.first.push_back(0);
  for (const Point& p : rest.vertices) {
    field.points.push_back(wall_point(p, segment.liner_outer_radius_mm(), segment.outer_radius_mm(),
                                      start_z_mm, tolerance_mm));
    add_members(strands, field.points.back(), tolerance_mm, field.members);
    field.first.push_back(static_cast<std::uint32_t>(field.members.size()));
  }
  return field;
}

std::vector<double> strand_strains(const StrandField& field, const State& state) {
  const std::vector<FibreTable> tables = fibre_tables(field, state);
  std::vector<double> strains;
  strains.reserve(field.points.size());
  for (std::size_t v = 0; v < field.points.size(); ++v) {
    const WallPoint& point = field.points[v];
    const WallStretch at =
        stretch_at(field.segment, state, point.radius_mm, point.theta_rad, point.along_mm);
    double largest = 0;
    for (std::uint32_t m = field.first[v]; m < field.first[v + 1]; ++m) {
      const StrandMember& member = field.members[m];
      double strain = at.hoop - 1;
      if (member.shape >= 0) {
        strain = tables[member.shape].at(chord_strain(field, state, member, point));
      } else if (member.grid >= 0) {
        strain = at.along(field.segment.lattice->grids[member.grid].angle_rad()) - 1;
      }
      if (std::abs(strain) > std::abs(largest)) largest = strain;
    }
    strains.push_back(largest);
  }
  return strains;
}

std::vector<double> liner_strains(const Segment& segment, const TriangleMesh& rest,
                                  double start_z_mm, double tolerance_mm, const State& state) {
  std::vector<double> strains;
  strains.reserve(rest.vertices.size());
  for (const Point& p : rest.vertices) {
    const WallPoint point = wall_point(p, segment.inner_radius_mm(),
                                       segment.liner_outer_radius_mm(), start_z_mm, tolerance_mm);
    const WallStretch at =
        stretch_at(segment, state, point.radius_mm, point.theta_rad, point.along_mm);
    strains.push_back(at.largest_principal() - 1);
  }
  return strains;
}

}  // namespace latticast
