// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/strand_path.h"

#include <cmath>
#include <utility>

#include "design/units.h"
#include "geometry/pattern/horseshoe_path.h"
#include "geometry/pattern/sinusoid_path.h"
#include "geometry/pattern/straight_path.h"

namespace latticast {
namespace {

template <class Path>
Placed<Path> with_path(const PlacedStrand& strand, const Path& path) {
  return {path, strand.start_u_mm, strand.angle_deg, strand.width_mm, strand.length_mm};
}

// Hands the strand to the home of its path.
template <class Ask>
auto ask(const PlacedStrand& strand, const Ask& question) {
  return std::visit([&](const auto& path) { return question(with_path(strand, path)); },
                    strand.shape);
}

}  // namespace

StrandFrame strand_frame(double start_u_mm, double angle_deg) {
  const double angle = radians(angle_deg);
  const double cosine = angle_deg == 90 ? 0.0 : std::cos(angle);
  return {{start_u_mm, 0}, {cosine, std::sin(angle)}, {std::sin(angle), -cosine}};
}

PlacedStrand placed_strand(const Segment& segment, const Grid& grid, int number) {
  return {grid.path, number * segment.lattice_circumference_mm() / grid.count(), grid.angle_deg,
          grid.widths_mm[number], segment.length_mm};
}

double link_chord_mm(const PlacedStrand& strand) {
  return ask(strand, [](const auto& s) { return link_chord_mm(s); });
}

double link_length_mm(const PlacedStrand& strand) {
  return ask(strand, [](const auto& s) { return link_length_mm(s); });
}

double largest_slope_deg(const PlacedStrand& strand) {
  return ask(strand, [](const auto& s) { return largest_slope_deg(s); });
}

double reach_mm(const PlacedStrand& strand) {
  return ask(strand, [](const auto& s) { return reach_mm(s); });
}

double smallest_radius_mm(const PlacedStrand& strand) {
  return ask(strand, [](const auto& s) { return smallest_radius_mm(s); });
}

PlacedStrand closed(const PlacedStrand& strand) {
  return ask(strand, [&](const auto& s) { return with_path<StrandPath>(strand, closed(s).shape); });
}

StrandPath stretched(const PlacedStrand& strand, double stretch) {
  return ask(strand, [&](const auto& s) { return StrandPath(stretched(s, stretch)); });
}

double gap_within_mm(const PlacedStrand& strand) {
  return ask(strand, [](const auto& s) { return gap_within_mm(s); });
}

double centre_distance_mm(const PlacedStrand& strand, double spacing_u_mm) {
  return ask(strand, [&](const auto& s) { return centre_distance_mm(s, spacing_u_mm); });
}

double centre_line_distance_mm(const PlacedStrand& strand, double along_mm, double across_mm) {
  return ask(strand,
             [&](const auto& s) { return centre_line_distance_mm(s, along_mm, across_mm); });
}

std::optional<std::string> closing_problem(const PlacedStrand& strand) {
  return ask(strand, [](const auto& s) { return closing_problem(s); });
}

std::optional<std::string> own_problem(const PlacedStrand& strand) {
  return ask(strand, [](const auto& s) { return own_problem(s); });
}

DrawnStrand draw_strand(const PlacedStrand& strand, double flatness_mm) {
  return ask(strand, [&](const auto& s) { return draw_strand(s, flatness_mm); });
}

}  // namespace latticast
