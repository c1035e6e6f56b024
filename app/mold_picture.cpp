// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mold_picture.h"

#include <algorithm>
#include <cmath>

namespace latticast {
namespace {

constexpr Colour core_colour = liner_colour;
constexpr Colour plate_colour{0.55, 0.60, 0.66};
constexpr Colour other_colour{0.80, 0.55, 0.30};
constexpr Colour shell_colours[] = {lattice_colour, {0.32, 0.53, 0.76}};

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

// A pattern stands where the core will stand afterwards.
const MoldPiece* inner_piece(const Mold& mold) {
  const auto inside = std::find_if(
      mold.pieces.begin(), mold.pieces.end(),
      [](const MoldPiece& piece) { return piece.name == "pattern" || piece.name == "core"; });
  return inside == mold.pieces.end() ? nullptr : &*inside;
}

bool is_plate(const MoldPiece& piece) {
  return piece.name.starts_with("base") || piece.name.starts_with("cap");
}

Point label_place(const PictureObject& object) {
  Point low = object.mesh.vertices.front();
  Point high = low;
  for (const Point& p : object.mesh.vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  constexpr double share_of_height = 0.85;  // other pieces stand before lower places
  return {0.5 * (low[0] + high[0]) + object.offset_mm[0],
          0.5 * (low[1] + high[1]) + object.offset_mm[1],
          std::lerp(low[2], high[2], share_of_height) + object.offset_mm[2]};
}

}  // namespace

std::vector<Colour> piece_colours(const Mold& mold) {
  const MoldPiece* inside = inner_piece(mold);
  std::vector<Colour> colours;
  int shells = 0;
  for (const MoldPiece& piece : mold.pieces) {
    Colour colour = is_plate(piece) ? plate_colour : other_colour;
    if (&piece == inside) colour = core_colour;
    if (piece.pulls_sideways) colour = shell_colours[shells++ % 2];
    colours.push_back(colour);
  }
  return colours;
}

Image exploded_picture(const Mold& mold) {
  const Extent whole = extent(mold);
  const double apart = 0.7 * whole.radius_mm;
  const double lift = 0.25 * (whole.high_mm - whole.low_mm);
  const MoldPiece* inside = inner_piece(mold);
  const std::vector<Colour> colours = piece_colours(mold);
  std::vector<PictureObject> objects;
  PictureText text{.labels = {}, .scale_bar = true, .bar_at_mm = {}};
  int others = 0;
  for (std::size_t i = 0; i < mold.pieces.size(); ++i) {
    const MoldPiece& piece = mold.pieces[i];
    PictureObject object{piece.solid.mesh, colours[i], {0, 0, 0}, 1};
    if (piece.pulls_sideways) {
      object.offset_mm = {apart * std::cos(piece.pull_rad), apart * std::sin(piece.pull_rad), 0};
    } else if (is_plate(piece)) {
      object.offset_mm[2] = piece.name.starts_with("base") ? -lift : lift;
    } else if (&piece != inside) {
      object.offset_mm[1] = 3 * whole.radius_mm + 1.5 * whole.radius_mm * others++;
    }
    text.labels.push_back({mold.pieces[i].name, label_place(object), 0});
    objects.push_back(std::move(object));
  }
  return draw_picture(objects, {{-1, 0.35, -0.5}, {0, 0, 1}, 10}, {}, text);
}

}  // namespace latticast
