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

/// Of lattices and liners, in pictures and mesh files.
inline constexpr Colour lattice_colour{0.16, 0.36, 0.62};
inline constexpr Colour liner_colour{0.93, 0.86, 0.76};

/// Of a part that has no other.
inline constexpr Colour usual_colour{0.60, 0.62, 0.66};

}  // namespace latticast
