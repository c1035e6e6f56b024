// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "export/picture/ambient_occlusion.h"
#include "export/picture/rasteriser.h"
#include "export/picture/vectors.h"
#include "export/picture/view.h"

namespace latticast {
namespace {

using namespace vectors;

constexpr int samples = 3;  // each way in a pixel
constexpr int largest_size = 16384;

/// What a facet looks like, in the camera's directions and linear light.
struct Facet {
  Point normal;
  Point colour;
  double opacity = 1;
};

double to_linear(double c) {
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double to_srgb(double c) {
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

/// A large light above the viewer's left shoulder, a weak one from the lower right, and light from
/// all round that is a little stronger from above.
double light_on(const Point& normal) {
  constexpr Point key{-0.591, -0.493, -0.640};
  constexpr Point fill{0.855, 0.252, -0.453};
  const auto soft = [&](const Point& light) {
    const double wrapped = (dot(normal, light) + 0.15) / 1.15;
    return std::max(0.0, wrapped);
  };
  return 0.92 * soft(key) + 0.20 * soft(fill) + 0.13 - 0.06 * normal[1];
}

/// Draws one object; its facets are appended to `facets` and known by their place there.
void draw_object(Layer& layer, const PictureObject& object, const View& view,
                 std::vector<Facet>& facets) {
  const Point base{to_linear(object.colour.red), to_linear(object.colour.green),
                   to_linear(object.colour.blue)};
  for (const Triangle& triangle : object.mesh.triangles) {
    std::array<Point, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = object.mesh.vertices[triangle[i]] + object.offset_mm;
    }
    if (!std::all_of(corners.begin(), corners.end(), is_finite)) {
      continue;
    }
    Point normal = view.turned(cross(corners[1] - corners[0], corners[2] - corners[0]));
    const double size = length(normal);
    if (!(size > 0)) {
      continue;
    }
    normal = ((normal[2] > 0 ? -1 : 1) / size) * normal;
    for (Point& corner : corners) {
      corner = view.on_screen(corner);
    }
    draw_triangle(layer, corners, static_cast<std::uint32_t>(facets.size()));
    facets.push_back({normal, light_on(normal) * base, object.opacity});
  }
}

/// Colour times opacity, and opacity: what has been laid over each other so far.
struct Paint {
  Point colour{0, 0, 0};
  double opacity = 0;

  void lay(const Point& over, double cover) {
    colour = cover * over + (1 - cover) * colour;
    opacity = cover + (1 - cover) * opacity;
  }
};

/// The layers of a scene: opaque objects in one, each transparent object in its own.
class Scene {
 public:
  Scene(const std::vector<PictureObject>& objects, const View& view, const PictureOptions& options)
      : opaque_(samples * options.width, samples * options.height),
        occlusion_(0.025 * samples * std::min(options.width, options.height), samples) {
    for (const PictureObject& object : objects) {
      if (object.opacity >= 1) {
        draw_object(opaque_, object, view, facets_);
      }
    }
    for (const PictureObject& object : objects) {
      if (object.opacity >= 1) {
        continue;
      }
      transparent_.emplace_back(opaque_.width, opaque_.height);
      draw_object(transparent_.back(), object, view, facets_);
    }
  }

  Paint sample(int column, int row) const {
    const std::size_t at = static_cast<std::size_t>(row) * opaque_.width + column;
    Paint paint;
    if (opaque_.facet[at] != Layer::none) {
      const Facet& facet = facets_[opaque_.facet[at]];
      const double light = occlusion_.openness(opaque_, column, row, facet.normal);
      paint.lay(light * facet.colour, 1);
    }
    for (const Layer& layer : transparent_) {
      if (layer.depth[at] >= opaque_.depth[at]) {
        continue;
      }
      const Facet& facet = facets_[layer.facet[at]];
      // Seen at a slant, a wall is thicker.
      const double slant = 1 + facet.normal[2];
      paint.lay(facet.colour, facet.opacity + (1 - facet.opacity) * slant * slant * slant);
    }
    return paint;
  }

 private:
  Layer opaque_;
  std::vector<Layer> transparent_;
  std::vector<Facet> facets_;
  AmbientOcclusion occlusion_;
};

Paint pixel(const Scene& scene, int column, int row) {
  Paint sum;
  for (int i = 0; i < samples * samples; ++i) {
    const Paint paint = scene.sample(samples * column + i % samples, samples * row + i / samples);
    sum.colour = sum.colour + paint.colour;
    sum.opacity += paint.opacity;
  }
  const double share = 1.0 / (samples * samples);
  return {share * sum.colour, share * sum.opacity};
}

void require_valid(const Camera& camera, const PictureOptions& options) {
  const auto fits = [](int size) { return size >= 1 && size <= largest_size; };
  if (!fits(options.width) || !fits(options.height) ||
      !(options.margin >= 0 && options.margin < 0.5) ||
      !(camera.perspective_deg >= 0 && camera.perspective_deg <= 90)) {
    throw std::invalid_argument("a picture whose size, margin or perspective is out of range");
  }
}

std::uint8_t byte_of(double fraction) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(fraction, 0.0, 1.0)));
}

}  // namespace

Image draw_picture(const std::vector<PictureObject>& objects, const Camera& camera,
                   const PictureOptions& options) {
  require_valid(camera, options);
  const View view(objects, camera, options, samples);
  const Scene scene(objects, view, options);
  Image image{options.width, options.height, {}};
  image.rgba.reserve(std::size_t{4} * options.width * options.height);
  for (int row = 0; row < options.height; ++row) {
    for (int column = 0; column < options.width; ++column) {
      Paint paint = pixel(scene, column, row);
      if (!options.transparent) {
        paint.colour = paint.colour + (1 - paint.opacity) * Point{1, 1, 1};
        paint.opacity = 1;
      }
      const double opacity = std::max(paint.opacity, 1e-9);
      for (const double c : paint.colour) {
        image.rgba.push_back(byte_of(to_srgb(c / opacity)));
      }
      image.rgba.push_back(byte_of(paint.opacity));
    }
  }
  return image;
}

}  // namespace latticast
