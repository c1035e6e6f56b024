// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh renderer: pictures for papers and READMEs, drawn without a window system.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "export/colour.h"
#include "export/picture/png_file.h"
#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

/// A mesh as it is to be shown. Both sides of its triangles are drawn.
struct PictureObject {
  TriangleMesh mesh;
  Colour colour = usual_colour;
  Point offset_mm{0, 0, 0};  ///< added to every vertex: places objects side by side
  double opacity = 1;  ///< below 1, what lies behind the object's nearest surface shines through
};

/// Looks along `direction`; the frame is fitted to all objects.
struct Camera {
  Point direction{-1, 0, 0};   ///< from the eye into the scene, any length
  Point up{0, 0, 1};           ///< shown upward as far as `direction` allows
  double perspective_deg = 0;  ///< angle of view across the scene's sphere, 0 (orthographic) to 90
};

struct PictureOptions {
  int width = 1200;  ///< pixels, up to 16384
  int height = 800;
  double margin = 0.05;      ///< free border, as a fraction of the smaller side
  bool transparent = false;  ///< background: transparent instead of white
};

/// A text at a place of the scene, `lines` of its own height below it (above where negative).
struct PictureLabel {
  std::string text;
  Point at_mm{};
  double lines = 0;
};

/// What is written over a picture. Letters are as high as 1/50 of its smaller side, and smaller,
/// down to half of that, where the labels of one row would meet.
struct PictureText {
  std::vector<PictureLabel> labels;
  bool scale_bar = false;  ///< in the lower left corner, for what stands at `bar_at_mm`
  Point bar_at_mm{};
};

/// Draws the objects: z-buffer, 3 x 3 samples a pixel, facet normals under two lights that turn
/// with the camera, crevices darkened by depth. Transparent objects show their nearest surface
/// only, each laid over the opaque ones in the order given. The image depends on the arguments
/// alone. Triangles with a coordinate that is not finite are left out; no objects give an empty
/// background. Throws std::invalid_argument for a zero direction, an `up` parallel to it, or sizes
/// out of range.
Image draw_picture(const std::vector<PictureObject>& objects, const Camera& camera,
                   const PictureOptions& options = {}, const PictureText& text = {});

}  // namespace latticast
