// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/parting.h"

#include <algorithm>
#include <cmath>

#include "design/units.h"
#include "molds/strand_map.h"

namespace latticast {
namespace {

constexpr int fewest_pieces = 2;
constexpr int most_pieces = 12;
constexpr int turns_tried = 32;
constexpr double tooth_pitch_mm = 20;
constexpr double tooth_share_of_piece = 0.1;
constexpr double margin_mm = 0.5;  // between a seam and a strand that it does not cross
constexpr int map_cells = 1024;
constexpr double map_row_mm = 0.25;
constexpr int most_map_rows = 1000;

double into_turn(double angle) {
  return angle - 2 * pi * std::floor(angle / (2 * pi));
}

// To one side and to the other, with flanks as long as half a tooth's crest.
constexpr ToothCorner tooth[] = {{0, 0.14},  {1, 0.22},  {1, 0.42},
                                 {-1, 0.58}, {-1, 0.78}, {0, 0.86}};

// A half that reaches by the angle d past its middle needs core radius x (1 - cos d) of play.
double tooth_reach_mm(const PartingWish& wish, int pieces, double drawn_radius,
                      const CastLayer& layer) {
  const double sector = 2 * pi * drawn_radius / pieces;
  double reach = std::min(wish.tooth_mm, tooth_share_of_piece * sector);
  if (pieces == 2) {
    const double play = 0.5 * wish.clearance_mm;
    reach = std::min(reach, 0.7 * std::sqrt(2 * play / layer.floor_mm) * drawn_radius);
  }
  return reach;
}

// Rows in which the seams run over or beside strands. Where strands run all around there is no
// choice.
int covered_rows(const StrandMap& map, const Parting& parting) {
  int covered = 0;
  for (int row = 0; row < map.rows(); ++row) {
    if (map.is_full(row)) continue;
    const double beside = seam_offset_mm(parting, map.row_z_mm(row));
    for (int k = 0; k < parting.pieces; ++k) {
      covered += map.covers(row, parting.drawn_radius_mm * seam_rad(parting, k) + beside) ? 1 : 0;
    }
  }
  return covered;
}

Parting best_turn(const StrandMap& map, Parting parting) {
  Parting best = parting;
  int least = -1;
  for (int i = 0; i < turns_tried; ++i) {
    // Off the round angles at which strands and their edges like to lie.
    parting.first_seam_rad = (i + 0.37) * 2 * pi / parting.pieces / turns_tried;
    const int covered = covered_rows(map, parting);
    if (least < 0 || covered < least) {
      least = covered;
      best = parting;
    }
  }
  return best;
}

// One side of a strand's outline, with the distance to the strand's other side.
struct Side {
  PlanePoint from;
  PlanePoint to;
  double outward_u = 0;  // of the unit normal
  double width = 0;
};

double width_across(const std::vector<PlanePoint>& outline, std::size_t side, PlanePoint outward) {
  const PlanePoint& a = outline[side];
  const PlanePoint& b = outline[(side + 1) % outline.size()];
  const PlanePoint middle{0.5 * (a.u + b.u), 0.5 * (a.z + b.z)};
  double nearest = HUGE_VAL;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (i == side) continue;
    const PlanePoint& p = outline[i];
    const PlanePoint& q = outline[(i + 1) % outline.size()];
    // middle - t outward = p + s (q - p)
    const double du = q.u - p.u;
    const double dz = q.z - p.z;
    const double det = outward.u * dz - outward.z * du;
    if (det == 0) continue;
    const double pu = middle.u - p.u;
    const double pz = middle.z - p.z;
    const double t = (pu * dz - pz * du) / det;
    const double s = (outward.u * pz - outward.z * pu) / det;
    if (t > 0 && s >= 0 && s <= 1) nearest = std::min(nearest, t);
  }
  return nearest;
}

// Of the strip with the outline's area and perimeter. An end that cuts a strand slantwise leaves a
// corner without breadth, which gives way with the strand behind it.
double mean_width(const std::vector<PlanePoint>& outline) {
  double twice_area = 0;
  double perimeter = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PlanePoint& a = outline[i];
    const PlanePoint& b = outline[(i + 1) % outline.size()];
    twice_area += a.u * b.z - b.u * a.z;
    perimeter += std::hypot(b.u - a.u, b.z - a.z);
  }
  const double half = 0.5 * perimeter;
  return 0.5 * (half - std::sqrt(std::max(0.0, half * half - 2 * std::abs(twice_area))));
}

// A ring, which has no sides and hides those of the strands that cross it.
struct Ring {
  double from_z = 0;
  double to_z = 0;
};

struct GrooveWalls {
  std::vector<Side> sides;
  std::vector<Ring> rings;

  bool hidden(double z) const {
    return std::any_of(rings.begin(), rings.end(),
                       [&](const Ring& ring) { return ring.from_z <= z && z <= ring.to_z; });
  }
};

GrooveWalls groove_walls(const Pattern& strands) {
  // A ring's outline is closed by a line that is not there on the tube.
  const double whole_turn = strands.circumference_mm * (1 - 1e-9);
  GrooveWalls walls;
  for (const Strand& strand : strands.strands) {
    const std::vector<PlanePoint>& outline = strand.outline;
    const double mean = mean_width(outline);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const PlanePoint& a = outline[i];
      const PlanePoint& b = outline[(i + 1) % outline.size()];
      const double length = std::hypot(b.u - a.u, b.z - a.z);
      if (length == 0 || a.z == b.z) continue;
      const PlanePoint outward{(b.z - a.z) / length, (a.u - b.u) / length};
      const double width = width_across(outline, i, outward);
      if (width < whole_turn) {
        walls.sides.push_back({a, b, outward.u, std::max(width, mean)});
      } else if (a.u == b.u && std::isfinite(width)) {
        walls.rings.push_back({std::min(a.z, b.z), std::max(a.z, b.z)});
      }
    }
  }
  return walls;
}

// What catches at one point of a side; strain 0 when the land lies on the other side.
Undercut undercut_at(const Side& side, PlanePoint at, const Parting& parting,
                     const CastLayer& layer) {
  Undercut found{piece_at(parting, at), at, 0, 0, side.width, 0};
  const double from_pull =
      std::remainder(at.u / parting.drawn_radius_mm - pull_rad(parting, found.piece), 2 * pi);
  if (from_pull * side.outward_u <= 0) return found;
  const double phi = std::abs(from_pull);
  const double turned = phi - std::asin(layer.floor_mm / layer.ceiling_mm * std::sin(phi));
  found.around_mm = turned * parting.drawn_radius_mm;
  found.undercut_mm = found.around_mm * std::abs(side.outward_u);
  found.strain = found.undercut_mm / side.width;
  return found;
}

void add_worst_of_side(const GrooveWalls& walls, const Side& side, const Parting& parting,
                       const CastLayer& layer, double spacing, std::vector<Undercut>& map) {
  const double length = std::hypot(side.to.u - side.from.u, side.to.z - side.from.z);
  const int steps = std::max(1, static_cast<int>(std::ceil(length / spacing)));
  Undercut worst;
  int piece = -1;
  for (int i = 0; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    const PlanePoint at{std::lerp(side.from.u, side.to.u, part),
                        std::lerp(side.from.z, side.to.z, part)};
    if (walls.hidden(at.z)) continue;
    const Undercut here = undercut_at(side, at, parting, layer);
    if (here.piece != piece) {
      if (worst.strain > 0) map.push_back(worst);
      worst = here;
      piece = here.piece;
    } else if (here.strain > worst.strain) {
      worst = here;
    }
  }
  if (worst.strain > 0) map.push_back(worst);
}

std::vector<Undercut> map_of(const GrooveWalls& walls, const Parting& parting,
                             const CastLayer& layer, double spacing) {
  std::vector<Undercut> map;
  for (const Side& side : walls.sides) {
    add_worst_of_side(walls, side, parting, layer, spacing, map);
  }
  return map;
}

}  // namespace

std::vector<PlanePoint> toothed_line(double length_mm, double pitch_mm, double reach_mm,
                                     double rest, std::span<const ToothCorner> corners) {
  const int teeth = std::max(1, static_cast<int>(std::lround(length_mm / pitch_mm)));
  const double pitch = length_mm / teeth;
  std::vector<PlanePoint> line{{rest * reach_mm, 0}};
  for (int i = 0; i < teeth; ++i) {
    for (const ToothCorner& corner : corners) {
      line.push_back({corner.reach * reach_mm, (i + corner.pitch) * pitch});
    }
  }
  line.push_back({rest * reach_mm, length_mm});
  return line;
}

double seam_rad(const Parting& parting, int seam) {
  return parting.first_seam_rad + seam * 2 * pi / parting.pieces;
}

double pull_rad(const Parting& parting, int piece) {
  return parting.first_seam_rad + (piece + 0.5) * 2 * pi / parting.pieces;
}

double seam_offset_mm(const Parting& parting, double z_mm) {
  const auto above = std::find_if(parting.seam.begin() + 1, parting.seam.end() - 1,
                                  [&](const PlanePoint& p) { return p.z >= z_mm; });
  const PlanePoint& a = *(above - 1);
  const PlanePoint& b = *above;
  return std::lerp(a.u, b.u, (z_mm - a.z) / (b.z - a.z));
}

int piece_at(const Parting& parting, PlanePoint point) {
  const double u = point.u - seam_offset_mm(parting, point.z);
  const double turned = into_turn(u / parting.drawn_radius_mm - parting.first_seam_rad);
  return std::min(static_cast<int>(turned / (2 * pi) * parting.pieces), parting.pieces - 1);
}

std::vector<Undercut> undercut_map(const Pattern& strands, const Parting& parting,
                                   const CastLayer& layer, double spacing_mm) {
  return map_of(groove_walls(strands), parting, layer, spacing_mm);
}

Undercut worst_undercut(const std::vector<Undercut>& map) {
  const auto worst = std::max_element(
      map.begin(), map.end(), [](const auto& a, const auto& b) { return a.strain < b.strain; });
  return worst == map.end() ? Undercut{} : *worst;
}

Parting choose_parting(const Pattern& strands, const PartingWish& wish, const CastLayer& layer) {
  const int rows = std::clamp(static_cast<int>(strands.length_mm / map_row_mm), 20, most_map_rows);
  const StrandMap map(strands, map_cells, rows, margin_mm);
  const double radius = strands.circumference_mm / (2 * pi);
  const GrooveWalls walls = groove_walls(strands);
  const auto parted_in = [&](int pieces) {
    const double reach = tooth_reach_mm(wish, pieces, radius, layer);
    return best_turn(
        map, {pieces, 0, radius, toothed_line(strands.length_mm, tooth_pitch_mm, reach, 0, tooth)});
  };
  if (wish.pieces) return parted_in(*wish.pieces);
  Parting best;
  double least = HUGE_VAL;
  for (int pieces = fewest_pieces; pieces <= most_pieces; ++pieces) {
    const Parting parting = parted_in(pieces);
    const double strain = worst_undercut(map_of(walls, parting, layer, 0.25)).strain;
    if (strain < least) {
      least = strain;
      best = parting;
    }
    if (strain <= wish.allowed_strain) break;
  }
  return best;
}

}  // namespace latticast
