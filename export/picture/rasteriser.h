// SPDX-License-Identifier: GPL-3.0-or-later
// Z-buffer rasteriser: which facet each sample of a picture shows.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

/// Samples in rows from the top. Where nothing was drawn the depth is infinite and the facet
/// `none`.
struct Layer {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  Layer(int samples_wide, int samples_high)
      : width(samples_wide),
        height(samples_high),
        depth(static_cast<std::size_t>(width) * height, std::numeric_limits<float>::infinity()),
        facet(depth.size(), none) {}

  int width = 0;
  int height = 0;
  std::vector<float> depth;  ///< grows away from the eye
  std::vector<std::uint32_t> facet;
};

/// Draws a triangle over whatever lies behind it. Corners are (x, y, depth) with x and y in samples
/// from the layer's upper left corner, sample centres at half numbers; depth must be linear over
/// the screen. Either orientation is drawn; parts outside the layer are cut off; a triangle without
/// area draws nothing. Precondition: finite coordinates.
void draw_triangle(Layer& layer, const std::array<Point, 3>& corners, std::uint32_t facet);

}  // namespace latticast
