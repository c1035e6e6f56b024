// SPDX-License-Identifier: GPL-3.0-or-later
// How large a solid's mesh will be, before it is made: from the strands' outlines, drawn coarsely.
#pragma once

#include <functional>
#include <vector>

#include "geometry/solid/tube_solids.h"

namespace latticast {

/// What one mesh may have; more than that fills the memory of the machines that make and print it.
inline constexpr double most_triangles = 20e6;

/// The outlines of a lattice's families of strands: all that its mesh's size depends on.
class LatticeSize {
 public:
  /// Keeps a reference. Precondition: the segment has a lattice. Throws CannotDraw.
  explicit LatticeSize(const Segment& segment);

  /// Triangles of lattice_solid() with these options, within a factor of about 1.5.
  double triangles(const SolidOptions& options) const;

 private:
  struct Family {
    double corners = 0;    // of outlines, where lines meet
    double chords = 0;     // of curves, drawn at the flatness below
    double around_mm = 0;  // way of the outlines around the tube, and along it
    double along_mm = 0;
    double covered = 0;  // share of the plane
  };
  Family family_of(const Lattice& alone) const;

  const Segment& segment_;
  double flatness_mm_;
  std::vector<Family> families_;
};

/// Triangles of liner_solid().
double liner_triangles(const Segment& segment, const SolidOptions& options);

/// Whether an estimate is beyond most_triangles by more than it may be off.
bool is_surely_too_large(double triangles);

/// A tolerance of two digits, at least 1e-5 mm, at which a mesh that is estimated to have
/// `triangles(tolerance)` keeps to most_triangles even if the estimate is off.
double fitting_tolerance_mm(const std::function<double(double tolerance_mm)>& triangles);

/// Memory that making and proving a mesh takes, in bytes; measured, 450 to 650 a triangle.
double memory_of_mesh(double triangles);

}  // namespace latticast
