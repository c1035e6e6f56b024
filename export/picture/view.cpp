// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/picture/view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

#include "export/picture/vectors.h"

namespace latticast {
namespace {

using namespace vectors;

Point unit(const Point& a) {
  const double size = length(a);
  if (!(size > 0) || !std::isfinite(size)) {
    throw std::invalid_argument("a camera needs a direction, and an up that is not parallel to it");
  }
  return (1 / size) * a;
}

Point right_of(const Camera& camera) {
  const Point right = cross(unit(camera.direction), unit(camera.up));
  return unit(length(right) > 1e-9 ? right : Point{0, 0, 0});
}

struct Box {
  Point low{1e300, 1e300, 1e300};
  Point high{-1e300, -1e300, -1e300};

  void include(const Point& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  bool is_empty() const { return low[0] > high[0]; }
  Point centre() const { return 0.5 * (low + high); }
};

/// The smallest box around all finite vertices after `place` has moved them.
template <class Place>
Box box_of(const std::vector<PictureObject>& objects, Place place) {
  Box box;
  for (const PictureObject& object : objects) {
    for (const Point& vertex : object.mesh.vertices) {
      const Point p = vertex + object.offset_mm;
      if (is_finite(p)) {
        box.include(place(p));
      }
    }
  }
  return box;
}

}  // namespace

View::View(const std::vector<PictureObject>& objects, const Camera& camera,
           const PictureOptions& options, int samples)
    : forward_(unit(camera.direction)), right_(right_of(camera)), down_(cross(forward_, right_)) {
  fit_centre(objects, camera.perspective_deg);
  fit_frame(objects, options, samples);
}

Point View::turned(const Point& direction) const {
  return {dot(right_, direction), dot(down_, direction), dot(forward_, direction)};
}

Point View::on_screen(const Point& point) const {
  return scale_ * projected(point) + shift_;
}

// The depth is divided like x and y, which keeps planes plane.
Point View::projected(const Point& point) const {
  const Point p = turned(point - centre_);
  return (1 / (1 + nearness_ * p[2])) * p;
}

void View::fit_centre(const std::vector<PictureObject>& objects, double perspective_deg) {
  const Box box = box_of(objects, [](const Point& p) { return p; });
  if (box.is_empty()) {
    return;
  }
  centre_ = box.centre();
  const double radius = length(box.high - centre_);
  if (radius > 0) {
    nearness_ = std::sin(perspective_deg * std::numbers::pi / 360) / radius;
  }
}

void View::fit_frame(const std::vector<PictureObject>& objects, const PictureOptions& options,
                     int samples) {
  const Box box = box_of(objects, [this](const Point& p) { return projected(p); });
  if (box.is_empty()) {
    return;
  }
  const double border = options.margin * std::min(options.width, options.height);
  const double across = std::max(box.high[0] - box.low[0], 1e-12);
  const double along = std::max(box.high[1] - box.low[1], 1e-12);
  scale_ = samples *
           std::min((options.width - 2 * border) / across, (options.height - 2 * border) / along);
  const Point middle{0.5 * samples * options.width, 0.5 * samples * options.height, 0};
  shift_ = middle - scale_ * box.centre();
}

}  // namespace latticast
