// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/solid_error.h"

#include <algorithm>
#include <cmath>

#include "geometry/solid/relief.h"

namespace latticast {
namespace {

// Equal steps along a chord are not equal angles: tan(x) = s tan(h) against x = s h, with h half of
// the sector's angle, differ most at s = 1/sqrt(3), by 2 h^3 / (9 sqrt(3)).
double angle_shift(double sector_angle) {
  const double half = 0.5 * sector_angle;
  return 2 * half * half * half / (9 * std::sqrt(3.0));
}

// Walls along rings are drawn on the sector's chords like everything else; others stand at angles.
bool has_standing_walls(const Region& region) {
  return std::any_of(region.sectors.begin(), region.sectors.end(), [](const auto& sector) {
    return std::any_of(sector.begin(), sector.end(), [](const RegionEdge& edge) {
      return edge.is_outline() && edge.a.z != edge.b.z;
    });
  });
}

double deepest_level(const std::vector<double>& radii) {
  double deepest = 0;
  for (std::size_t i = 1; i < radii.size(); ++i) {
    deepest = std::max(deepest, radii[i] - radii[i - 1]);
  }
  return deepest;
}

}  // namespace

SolidError solid_error(const Region& region, const std::vector<std::vector<double>>& radii_mm,
                       double drawn_radius_mm, std::span<const double> steepness) {
  const double angle = region.grid.sector_angle_rad();
  const double shift = has_standing_walls(region) ? angle_shift(angle) : 0;
  SolidError error;
  for (std::size_t layer = 0; layer < radii_mm.size(); ++layer) {
    const double floor = radii_mm[layer].front();
    const double ceiling = radii_mm[layer].back();
    const DrawingError plane = region_error(region, static_cast<int>(layer));
    const double grown = std::max(1.0, ceiling / drawn_radius_mm);
    const double depth = deepest_level(radii_mm[layer]);
    const double bulge = wall_error_mm(depth, angle, steepness[layer]);
    const double chords = chord_error_mm(ceiling, angle);
    // `edge`: how far a wall's upper edge is displaced along the ceiling. `bulge`: how far the wall
    // leaves its ruled surface half way down to the next level; at the share s of the depth below
    // the edge that is 16 s (1/2 - s) bulge. `chords`: how far a corner of the ceiling lies outside
    // of the cylinder. The last stands square to the others, and both are largest together at the
    // depth `chords` below the rim.
    const double edge = ceiling * shift + grown * plane.distance_mm;
    const double over = std::min(0.25, chords / depth);
    const double rim = std::hypot(edge + 16 * over * (0.5 - over) * bulge, chords);
    error.surface_mm = std::max({error.surface_mm, rim, edge + bulge});
    error.volume_mm3 +=
        plane.area_mm2 * (ceiling * ceiling - floor * floor) / (2 * drawn_radius_mm);
  }
  return error;
}

double rounding_mm(const TriangleMesh& mesh) {
  double farthest = 0;
  for (const Point& p : mesh.vertices) {
    double square = 0;
    for (const double x : p) {
      const double off = x - static_cast<double>(static_cast<float>(x));
      square += off * off;
    }
    farthest = std::max(farthest, square);
  }
  return std::sqrt(farthest);
}

}  // namespace latticast
