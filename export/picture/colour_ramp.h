// SPDX-License-Identifier: GPL-3.0-or-later
// Diverging colour map for strains: equal steps look equally large in Oklab [Ottosson 2020].
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace latticast {

/// sRGB, 8 bits each: red, green, blue.
using ByteColour = std::array<std::uint8_t, 3>;

/// Colours from `low` to `high`, pale at 0: through orange to dark red for tension, through blue to
/// dark blue for compression. Even to the eye: equal steps of strain are equal distances in OKLab
/// (B. Ottosson, 2020), and lightness falls steadily from 0 to either end, so that the order
/// survives in print without colours; red-blind, green-blind and blue-blind viewers tell both ends
/// apart.
struct ColourRamp {
  double low = 0;   ///< 0 (tension only), or -high
  double high = 0;  ///< > 0
  double step = 0;  ///< between the numbers of the legend, 1, 2 or 5 times a power of ten
};

/// A strain and its colour.
struct LegendEntry {
  double strain = 0;
  ByteColour colour{};
};

/// The ramp for strains from `least` to `largest`, its end a multiple of `step` that is not below
/// either. Both directions are shown when compression exceeds a hundredth of the largest magnitude;
/// otherwise strains below 0 have the colour of 0. Strains of less than 1e-6, and numbers that are
/// none, give a ramp from 0 to 1e-6.
ColourRamp strain_ramp(double least, double largest);

/// Beyond an end, the end's colour; a medium grey for a number that is none.
ByteColour colour_of(const ColourRamp& ramp, double strain);

/// From low to high, a step apart.
std::vector<LegendEntry> legend(const ColourRamp& ramp);

}  // namespace latticast
