// SPDX-License-Identifier: GPL-3.0-or-later
// What a report's picture in space moves: meshes of every segment in its own frame, at rest and in
// a few states of its load.
#pragma once

#include <string>
#include <vector>

#include "export/colour.h"
#include "geometry/mesh/triangle_mesh.h"
#include "report/report_curves.h"

namespace latticast {

struct PreparedDesign;

/// A lattice or liner, its segment's base at the origin and its axis along +z.
struct ViewBody {
  std::string node;  ///< "segment-1-lattice"
  bool is_liner = false;
  TriangleMesh rest;
  std::vector<std::vector<Point>> poses;  ///< vertices in each state but rest
};

/// One segment's bodies and the states they are shown in.
struct ViewSegment {
  std::vector<ViewBody> bodies;
  std::vector<State> states;  ///< ascending pressure, rest among them, at most 25
};

struct ReportView {
  std::vector<ViewSegment> segments;
  double tolerance_mm = 0;  ///< of the meshes
  std::string note;         ///< what was made coarser than asked; empty when nothing was
};

/// States are taken at even distances of what the eye sees: turning, bending, growing. Meshes are
/// as fine as 0.05 mm, or the design's tolerance where that is coarser, as long as all vertices in
/// all states stay below 110 000; otherwise coarser, up to 1 mm. Without curves only rest is shown.
/// Throws GeometryError, CannotDraw.
ReportView make_view(PreparedDesign& prepared, const ReportCurves* curves);

/// The meshes as a binary glTF file: a node for every body, a morph target for every state.
std::string view_glb(const ReportView& view);

}  // namespace latticast
