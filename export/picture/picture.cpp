// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "design/text/written_number.h"
#include "export/picture/ambient_occlusion.h"
#include "export/picture/lettering.h"
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

std::array<double, 2> pixel_of(const View& view, const Point& place) {
  const Point on_screen = view.on_screen(place);
  return {on_screen[0] / samples, on_screen[1] / samples};
}

// Small enough that labels side by side keep apart, as far as that goes.
double letter_px(const std::vector<PictureLabel>& labels, const View& view, double usual) {
  double share = 1;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (labels[i].lines != labels[j].lines) continue;
      const auto a = pixel_of(view, labels[i].at_mm);
      const auto b = pixel_of(view, labels[j].at_mm);
      if (std::abs(a[1] - b[1]) > 2 * usual) continue;
      const double needed =
          0.5 * (width_px(labels[i].text, usual) + width_px(labels[j].text, usual)) + usual;
      share = std::min(share, std::abs(a[0] - b[0]) / needed);
    }
  }
  return usual * std::max(0.5, share);
}

// The largest of 1, 2, 5, 10, ... mm that is no longer than a fifth of the picture.
void draw_scale_bar(Image& image, double px_per_mm, double letter) {
  const double longest_mm = 0.2 * image.width / px_per_mm;
  const double decade = std::pow(10, std::floor(std::log10(longest_mm)));
  double mm = decade;
  for (const double times : {2.0, 5.0}) {
    if (times * decade <= longest_mm) mm = times * decade;
  }
  const double y = image.height - 1.2 * letter;
  const double left = 1.2 * letter;
  const double right = left + mm * px_per_mm;
  const Colour ink{0.2, 0.2, 0.2};
  const double thick = std::max(1.5, 0.12 * letter);
  draw_line(image, {left, y}, {right, y}, thick, ink);
  for (const double x : {left, right}) {
    draw_line(image, {x, y - 0.5 * letter}, {x, y + 0.5 * letter}, thick, ink);
  }
  const std::string text = written(mm, 6) + " mm";
  draw_text(
      image,
      {text, {right + 0.8 * letter + 0.5 * width_px(text, letter), y + 0.5 * letter}, letter, ink});
}

void draw_texts(Image& image, const View& view, const Camera& camera, const PictureText& text) {
  const double usual = std::min(image.width, image.height) / 50.0;
  const double letter = letter_px(text.labels, view, usual);
  for (const PictureLabel& label : text.labels) {
    auto at = pixel_of(view, label.at_mm);
    at[1] += label.lines * usual + 0.5 * letter;
    draw_text(image, {label.text, at, letter});
  }
  if (!text.scale_bar) return;
  const Point sideways = cross(camera.direction, camera.up);
  const Point right = (1 / std::sqrt(dot(sideways, sideways))) * sideways;
  const auto from = pixel_of(view, text.bar_at_mm);
  const auto to = pixel_of(view, text.bar_at_mm + right);
  const double px_per_mm = std::hypot(to[0] - from[0], to[1] - from[1]);
  if (px_per_mm > 0) draw_scale_bar(image, px_per_mm, usual);
}

}  // namespace

Image draw_picture(const std::vector<PictureObject>& objects, const Camera& camera,
                   const PictureOptions& options, const PictureText& text) {
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
  draw_texts(image, view, camera, text);
  return image;
}

}  // namespace latticast
