// SPDX-License-Identifier: GPL-3.0-or-later
// Solids around an axis made of radial layers: rods, shells with grooves and bores, rings with
// steps.
#pragma once

#include <optional>
#include <vector>

#include "geometry/pattern/pattern.h"
#include "geometry/solid/layers.h"
#include "geometry/solid/tube_solids.h"

namespace latticast {

/// One layer's radial interval. The next layer's floor is this one's ceiling.
struct RadialLayer {
  double floor_mm = 0;  ///< 0 for the first layer of a solid rod
  double ceiling_mm = 0;
  /// Of the steepest wall (relief.h); absent: as the tube says.
  std::optional<double> steepness = {};
};

/// What is drawn on each sheet, at one common radius and 0 <= z <= length, and what it means.
struct LayeredTube {
  double drawn_radius_mm = 0;  ///< where the plane is unrolled: u = drawn radius x Theta
  double length_mm = 0;
  double start_z_mm = 0;          ///< added to every z
  std::vector<Pattern> sheets{};  ///< 1 to most_sheets; material is closed where it touches in
                                  ///< points on sheet 0 only
  Filling filling{};              ///< layers that are material, by the sheets that cover a place
  std::vector<RadialLayer> layers{};
  std::vector<double> cuts_mm{};  ///< heights at which all walls are cut, rising, between the ends
  double steepness =
      0;  ///< of the steepest wall (relief.h): 0 when all run along or around the tube
  bool sheet_0_is_closed = false;  ///< by closed_sheet_0() for the tolerance of the solid
};

/// The solid, within `tolerance_mm` of the true cylinders and walls. Its exact volume is the sum
/// over layers of area x (ceiling^2 - floor^2) / (2 drawn radius), its pieces and genus those of
/// topology() (relief.h, whose precondition on neighbouring layers holds here too). Throws
/// GeometryError where edges of different sheets meet in a point: move one of them.
Solid layered_solid(const LayeredTube& tube, double tolerance_mm);

/// Sheet 0 with its touching points closed as layered_solid closes them, for tubes that share it.
/// Throws GeometryError as closed_pattern does (region.h).
Pattern closed_sheet_0(const LayeredTube& tube, double tolerance_mm);

/// A level band all around the tube, and a rectangle of it, to draw with; z from 0.
Strand drawn_band(double drawn_radius_mm, double z_from_mm, double z_to_mm);
Strand drawn_window(double drawn_radius_mm, double from_rad, double to_rad, double z_from_mm,
                    double z_to_mm);

/// A disc of the given radius, drawn round within `flatness_mm`, with the disc's exact area.
Strand drawn_disc(double drawn_radius_mm, double at_rad, double z_mm, double radius_mm,
                  double flatness_mm);

/// What a drawn disc adds to its pattern's error. Its area is lost or gained only where something
/// else cuts it.
DrawingError disc_error(double radius_mm, double flatness_mm);

/// Gives the edge between the face at `z_mm` and the cylinder of `radius_mm` a lead-in chamfer of
/// 45 degrees, and takes its ring off the volume: the edge's vertices move inwards by `depth_mm`.
/// The band of walls beside the face must have been cut at that distance from it: draw a line of
/// the material there. The facets must be within chamfer_tolerance_mm() of the cylinder, so that
/// its vertices are known.
void chamfer(Solid& solid, double z_mm, double radius_mm, double depth_mm);

/// The given tolerance, made as fine as `chamfer` needs it on a cylinder of that radius.
double chamfer_tolerance_mm(double tolerance_mm, double radius_mm);

}  // namespace latticast
