// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mold_picture.h"

#include <algorithm>
#include <cmath>

namespace latticast {
namespace {

constexpr Colour core_colour{0.93, 0.86, 0.76};
constexpr Colour plate_colour{0.55, 0.60, 0.66};
constexpr Colour other_colour{0.80, 0.55, 0.30};
constexpr Colour shell_colours[] = {{0.16, 0.36, 0.62}, {0.32, 0.53, 0.76}};

struct Extent {
  double radius_mm = 0;
  double low_mm = HUGE_VAL;
  double high_mm = -HUGE_VAL;
};

Extent extent(const Mold& mold) {
  Extent found;
  for (const MoldPiece& piece : mold.pieces) {
    for (const Point& p : piece.solid.mesh.vertices) {
      found.radius_mm = std::max(found.radius_mm, std::hypot(p[0], p[1]));
      found.low_mm = std::min(found.low_mm, p[2]);
      found.high_mm = std::max(found.high_mm, p[2]);
    }
  }
  return found;
}

}  // namespace

Image exploded_picture(const Mold& mold) {
  const Extent whole = extent(mold);
  const double apart = 0.7 * whole.radius_mm;
  const double lift = 0.25 * (whole.high_mm - whole.low_mm);
  // A pattern stands where the core will stand afterwards.
  const auto inside = std::find_if(
      mold.pieces.begin(), mold.pieces.end(),
      [](const MoldPiece& piece) { return piece.name == "pattern" || piece.name == "core"; });
  std::vector<PictureObject> objects;
  int shells = 0;
  int others = 0;
  for (const MoldPiece& piece : mold.pieces) {
    PictureObject object{piece.solid.mesh, other_colour, {0, 0, 0}, 1};
    if (piece.pulls_sideways) {
      object.colour = shell_colours[shells++ % 2];
      object.offset_mm = {apart * std::cos(piece.pull_rad), apart * std::sin(piece.pull_rad), 0};
    } else if (inside != mold.pieces.end() && &piece == &*inside) {
      object.colour = core_colour;
    } else if (piece.name.starts_with("base") || piece.name.starts_with("cap")) {
      object.colour = plate_colour;
      object.offset_mm[2] = piece.name.starts_with("base") ? -lift : lift;
    } else {
      object.offset_mm[1] = 3 * whole.radius_mm + 1.5 * whole.radius_mm * others++;
    }
    objects.push_back(std::move(object));
  }
  return draw_picture(objects, {{-1, 0.35, -0.5}, {0, 0, 1}, 10});
}

}  // namespace latticast
