// SPDX-License-Identifier: GPL-3.0-or-later
// The design under pressure: predicted shapes, and meshes fine enough to be moved by them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "design/design.h"
#include "export/picture/colour_ramp.h"
#include "export/picture/picture.h"
#include "geometry/solid/audit.h"
#include "geometry/solid/tube_solids.h"
#include "model/chain.h"
#include "model/shape/shape.h"

namespace latticast {

class PreparedResponses;

/// The chain's shape in one load case.
struct PreviewShape {
  std::string label;  ///< the case as file names write it: "20kPa", or "25_32kPa" for two segments
  std::string title;  ///< for people: "20 kPa", "25, 32 kPa"
  Shape shape;
  std::vector<State> states;  ///< one per segment
};

/// Shapes in the cases that [make] preview names, each case once. Throws NoEquilibrium,
/// UnsupportedDesign.
std::vector<PreviewShape> predict_preview(PreparedResponses& responses);

/// The coarsest tolerance at which the segment's layers stay layers in all of the shapes.
double coarsest_preview_mm(const Segment& segment, std::size_t number,
                           const std::vector<PreviewShape>& shapes);

/// How a segment's rest meshes must be cut so that they keep the tolerance in all of the shapes.
SolidOptions preview_options(const Design& design, std::size_t segment, double start_z_mm,
                             const std::vector<PreviewShape>& shapes);

/// Every vertex moved by the shape, as part of `segment`.
TriangleMesh moved_mesh(const TriangleMesh& rest, const Shape& shape, std::size_t segment);

/// How far `moved`, which is moved_mesh of the solid's, may be from the exactly moved true solid:
/// the rest mesh's own error, stretched, and how far the map bends away from the triangles between
/// its vertices, which is measured in the middle of every side. The volume's error is that of a
/// layer as thick all over the surface.
SolidError moved_error(const Solid& rest, const TriangleMesh& moved, const Shape& shape,
                       std::size_t segment);

/// A lattice or liner at rest and in every shape.
struct PreviewPart {
  SolidOptions options;  ///< that it was made with at last
  Solid rest;
  std::vector<Solid> moved;
  std::vector<Audit> audits;  ///< of the moved meshes, as files hold them
  std::vector<char> touches;  ///< 1: parts that are far from each other at rest meet, or the inner
                              ///< side of a bend is turned over; contact is not modelled
};

/// What makes it at rest, and what is called before each shape is made.
struct PreviewMaker {
  std::function<Solid(const SolidOptions& options)> rest;
  std::function<void(std::size_t shape)> begin = [](std::size_t) {};
};

/// Meshes that meet themselves only because their facets are flat are cut finer, three times at
/// most.
PreviewPart preview_part(const PreviewMaker& maker, std::size_t segment,
                         const SolidOptions& options, const std::vector<PreviewShape>& shapes);

/// A colour for every vertex of a part in every shape, by the strain of its material
/// (strand_strain.h): one scale for all shapes, so that colours can be compared.
struct StrainColours {
  std::vector<std::vector<Colour>> of_shape;  ///< a list for each shape
  std::vector<std::vector<double>> strains;   ///< likewise
  ColourRamp ramp;
};

/// Of a segment's lattice or liner, whose rest mesh was made with `options`. Throws
/// UnsupportedDesign as strand_field does.
StrainColours strain_colours(const Segment& segment, std::size_t number, bool is_liner,
                             const TriangleMesh& rest, const SolidOptions& options,
                             const std::vector<PreviewShape>& shapes);

/// A place in the row of shapes that the picture shows.
struct PicturePart {
  TriangleMesh mesh;
  std::size_t place = 0;  ///< 0 is the leftmost shape
  bool is_liner = false;
};

/// Draws the shapes side by side, seen square to the plane in which most of them bend; below each
/// its pressures, a scale bar, and on the first one the names of its segments, where there are
/// several.
Image preview_picture(const std::vector<PicturePart>& parts,
                      const std::vector<PreviewShape>& shapes,
                      const std::vector<Segment>& segments);

}  // namespace latticast
