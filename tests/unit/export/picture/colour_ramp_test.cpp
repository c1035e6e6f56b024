// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/picture/colour_ramp.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace latticast {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

Triple product(const Matrix& m, const Triple& v) {
  Triple p{};
  for (int i = 0; i < 3; ++i) p[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return p;
}

Triple linear(const ByteColour& colour) {
  Triple rgb{};
  for (int i = 0; i < 3; ++i) {
    const double c = colour[i] / 255.0;
    rgb[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return rgb;
}

// OKLab as defined, forwards; the ramp goes backwards.
Triple oklab(const Triple& rgb) {
  constexpr Matrix cones{{{0.4122214708, 0.5363325363, 0.0514459929},
                          {0.2119034982, 0.6806995451, 0.1073969566},
                          {0.0883024619, 0.2817188376, 0.6299787005}}};
  constexpr Matrix opponents{{{0.2104542553, 0.7936177850, -0.0040720468},
                              {1.9779984951, -2.4285922050, 0.4505937099},
                              {0.0259040371, 0.7827717662, -0.8086757660}}};
  Triple lms = product(cones, rgb);
  for (double& c : lms) c = std::cbrt(c);
  return product(opponents, lms);
}

double apart(const Triple& a, const Triple& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

constexpr ColourRamp both{-1, 1, 0.2};

TEST(ColourRamp, GrowsDarkerFromZeroToEitherEnd) {
  for (const double direction : {-1.0, 1.0}) {
    double before = oklab(linear(colour_of(both, 0)))[0];
    EXPECT_GT(before, 0.94);
    for (int i = 1; i <= 100; ++i) {
      const double lightness = oklab(linear(colour_of(both, direction * i / 100)))[0];
      EXPECT_LT(lightness, before) << direction * i;
      before = lightness;
    }
    EXPECT_LT(before, 0.43);
  }
}

// 8 bits move a colour by up to 0.004.
TEST(ColourRamp, StepsAreEven) {
  for (const double direction : {-1.0, 1.0}) {
    double shortest = 1;
    double longest = 0;
    for (int i = 0; i < 10; ++i) {
      const double step = apart(oklab(linear(colour_of(both, direction * i / 10))),
                                oklab(linear(colour_of(both, direction * (i + 1) / 10))));
      shortest = std::min(shortest, step);
      longest = std::max(longest, step);
    }
    EXPECT_GT(shortest, 0.05);
    // The step around the corner of the arm is its chord.
    EXPECT_LT(longest, 1.15 * shortest);
  }
}

TEST(ColourRamp, NothingIsCutOffByTheGamut) {
  for (int i = -200; i <= 200; ++i) {
    const Triple here = oklab(linear(colour_of(both, i / 200.0)));
    const Triple next = oklab(linear(colour_of(both, (i + 0.5) / 200.0)));
    EXPECT_LT(apart(here, next), 0.008) << i;
    for (const std::uint8_t channel : colour_of(both, i / 200.0)) {
      EXPECT_GT(channel, 0) << i;
      EXPECT_LT(channel, 255) << i;
    }
  }
}

// G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, IEEE Trans. Vis. Comput. Graph. 15 (2009),
// full severity.
TEST(ColourRamp, ColourBlindViewersTellTensionFromCompression) {
  constexpr Matrix red_blind{{{0.152286, 1.052583, -0.204868},
                              {0.114503, 0.786281, 0.099216},
                              {-0.003882, -0.048116, 1.051998}}};
  constexpr Matrix green_blind{{{0.367322, 0.860646, -0.227968},
                                {0.280085, 0.672501, 0.047413},
                                {-0.011820, 0.042940, 0.968881}}};
  constexpr Matrix blue_blind{{{1.255528, -0.076749, -0.178779},
                               {-0.078411, 0.930809, 0.147602},
                               {0.004733, 0.691367, 0.303900}}};
  for (const Matrix& viewer : {red_blind, green_blind, blue_blind}) {
    for (const double strain : {0.4, 0.7, 1.0}) {
      Triple pulled = product(viewer, linear(colour_of(both, strain)));
      Triple pushed = product(viewer, linear(colour_of(both, -strain)));
      for (double& c : pulled) c = std::clamp(c, 0.0, 1.0);
      for (double& c : pushed) c = std::clamp(c, 0.0, 1.0);
      // Ten times what is just noticeable.
      EXPECT_GT(apart(oklab(pulled), oklab(pushed)), 0.1) << strain;
    }
  }
}

TEST(ColourRamp, EndsAtARoundNumber) {
  const ColourRamp pulled = strain_ramp(-1e-4, 0.137);
  EXPECT_EQ(pulled.low, 0);
  EXPECT_NEAR(pulled.high, 0.15, 1e-12);
  EXPECT_NEAR(pulled.step, 0.05, 1e-12);
  const ColourRamp mixed = strain_ramp(-0.3, 0.08);
  EXPECT_NEAR(mixed.high, 0.3, 1e-12);
  EXPECT_EQ(mixed.low, -mixed.high);
  EXPECT_NEAR(mixed.step, 0.1, 1e-12);
  const ColourRamp exact = strain_ramp(0, 0.5);
  EXPECT_NEAR(exact.high, 0.5, 1e-12);
  EXPECT_NEAR(strain_ramp(0, 0.5000001).high, 0.6, 1e-12);
}

TEST(ColourRamp, LegendRunsFromEndToEnd) {
  const ColourRamp ramp = strain_ramp(-0.3, 0.08);
  const std::vector<LegendEntry> entries = legend(ramp);
  ASSERT_EQ(entries.size(), 7U);
  EXPECT_EQ(entries.front().strain, ramp.low);
  EXPECT_EQ(entries[3].strain, 0);
  EXPECT_EQ(entries.back().strain, ramp.high);
  EXPECT_EQ(entries.back().colour, colour_of(ramp, 12));
  EXPECT_EQ(entries.front().colour, colour_of(ramp, -12));
}

TEST(ColourRamp, TakesNumbersThatAreNone) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  constexpr double endless = std::numeric_limits<double>::infinity();
  for (const ColourRamp& ramp :
       {strain_ramp(none, none), strain_ramp(0, 0), strain_ramp(0, endless)}) {
    EXPECT_EQ(ramp.low, 0);
    EXPECT_NEAR(ramp.high, 1e-6, 1e-18);
    EXPECT_EQ(colour_of(ramp, none), (ByteColour{128, 128, 128}));
    EXPECT_EQ(colour_of(ramp, -1), colour_of(ramp, 0));
  }
}

}  // namespace
}  // namespace latticast
