// SPDX-License-Identifier: GPL-3.0-or-later
// A mold taken apart, for people who assemble it.
#pragma once

#include <vector>

#include "export/colour.h"
#include "export/picture/picture.h"
#include "molds/mold_piece.h"

namespace latticast {

/// The pieces moved apart the way they come off: shells along their pull directions, base and cap
/// along the axis, the core in its place; whatever else there is stands beside. Each has its name
/// on it.
Image exploded_picture(const Mold& mold);

/// A colour for each piece, there and in mesh files.
std::vector<Colour> piece_colours(const Mold& mold);

}  // namespace latticast
