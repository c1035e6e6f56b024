// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/straight_path.h"

#include <cmath>

#include "design/units.h"

namespace latticast {

double link_chord_mm(const StraightStrand& strand) {
  return strand.length_mm / std::sin(radians(strand.angle_deg));
}

double link_length_mm(const StraightStrand& strand) {
  return link_chord_mm(strand);
}

double largest_slope_deg(const StraightStrand& /*strand*/) {
  return 0;
}

double reach_mm(const StraightStrand& /*strand*/) {
  return 0;
}

double smallest_radius_mm(const StraightStrand& /*strand*/) {
  return HUGE_VAL;
}

StraightStrand closed(StraightStrand strand) {
  return strand;
}

StraightPath stretched(const StraightStrand& strand, double /*stretch*/) {
  return strand.shape;
}

double gap_within_mm(const StraightStrand& /*strand*/) {
  return HUGE_VAL;
}

double centre_distance_mm(const StraightStrand& strand, double spacing_u_mm) {
  return spacing_u_mm * std::sin(radians(strand.angle_deg));
}

double centre_line_distance_mm(const StraightStrand& /*strand*/, double /*along_mm*/,
                               double across_mm) {
  return std::abs(across_mm);
}

std::optional<std::string> closing_problem(const StraightStrand& /*strand*/) {
  return std::nullopt;
}

std::optional<std::string> own_problem(const StraightStrand& /*strand*/) {
  return std::nullopt;
}

Strand traced_strip(const std::array<PlanePoint, 4>& corners, std::size_t right, DrawnCurve owner) {
  Strand strip{.outline = {corners.begin(), corners.end()},
               .curves = {},
               .traces = std::vector<CurveRange>(4, {own_line, 0, 1})};
  for (const std::size_t corner : {right, (right + 2) % 4}) {
    owner.side = corner == right ? 1 : -1;
    owner.shape = StraightLine{corners[corner], corners[(corner + 1) % 4]};
    strip.traces[corner].curve = static_cast<std::uint32_t>(strip.curves.size());
    strip.curves.push_back(owner);
  }
  return strip;
}

DrawnStrand draw_strand(const StraightStrand& strand, double /*flatness_mm*/) {
  const double angle = radians(strand.angle_deg);
  const double half = 0.5 * strand.width_mm / std::sin(angle);
  // The cotangent of 90 degrees is exactly 0, so that axial columns are drawn axial.
  const double drift =
      strand.angle_deg == 90 ? 0.0 : strand.length_mm * std::cos(angle) / std::sin(angle);
  const double start = strand.start_u_mm;
  DrawnStrand drawn;
  drawn.links.push_back(traced_strip({{{start - half, 0},
                                       {start + half, 0},
                                       {start + drift + half, strand.length_mm},
                                       {start + drift - half, strand.length_mm}}},
                                     1, {.shape = {}, .part = CurvePart::strand, .link = 0}));
  return drawn;
}

}  // namespace latticast
