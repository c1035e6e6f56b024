// SPDX-License-Identifier: GPL-3.0-or-later
// sRGB colour, of pictures and mesh files.
#pragma once

namespace latticast {

/// sRGB, each from 0 to 1.
struct Colour {
  double red = 0;
  double green = 0;
  double blue = 0;
};

}  // namespace latticast
