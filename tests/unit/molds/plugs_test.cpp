// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/plugs.h"

#include "design/units.h"
#include "tests/unit/molds/sound_solid.h"

namespace latticast {
namespace {

Segment tube(double inner_mm, double thickness_mm, double length_mm) {
  Segment segment;
  segment.length_mm = length_mm;
  segment.liner.inner_radius_mm = inner_mm;
  segment.liner.thickness_mm = thickness_mm;
  return segment;
}

TEST(Plugs, CloseThePapersLiner) {
  const std::vector<MoldPiece> plugs = end_plugs(tube(12, 4, 85), {});
  ASSERT_EQ(plugs.size(), 2U);
  EXPECT_EQ(plugs[0].name, "plug-inlet");
  EXPECT_EQ(plugs[1].name, "plug");
  expect_sound(plugs[0].solid, 1);
  expect_sound(plugs[1].solid, 0);
  // Shaft 12.24 mm x 10 with a chamfer of 1 mm, flange 16 mm x 3, bore 2 mm x 13.
  const double r = 12.24;
  const double frustum = pi / 3 * (r * r + r * (r - 1) + (r - 1) * (r - 1));
  const double whole = pi * r * r * 9 + frustum + pi * 256 * 3;
  EXPECT_NEAR(plugs[1].solid.volume_mm3, whole, 1e-2);
  EXPECT_NEAR(plugs[0].solid.volume_mm3, whole - pi * 4 * 13, 1e-2);
  EXPECT_NE(plugs[0].use.find("4 mm"), std::string::npos);
  for (const Point& p : plugs[1].solid.mesh.vertices) {
    EXPECT_TRUE(p[2] > -1e-9 && p[2] < 13 + 1e-9);
    if (p[2] > 12.9) {
      EXPECT_LT(std::hypot(p[0], p[1]), 11.26);
    }
  }
}

TEST(Plugs, AClosedLinerNeedsOne) {
  PlugOptions options;
  options.closed_end = true;
  const std::vector<MoldPiece> plugs = end_plugs(tube(12, 4, 85), options);
  ASSERT_EQ(plugs.size(), 1U);
  EXPECT_EQ(plugs[0].name, "plug-inlet");
}

TEST(Plugs, AreSoundForAnyLiner) {
  for (const double inner : {0.05, 1.0, 4.0, 200.0}) {
    for (const double thickness : {0.05, 40.0}) {
      for (const double length : {0.1, 1000.0}) {
        SCOPED_TRACE(testing::Message() << inner << ", " << thickness << ", " << length);
        const auto plugs = end_plugs(tube(inner, thickness, length), {});
        expect_sound(plugs[0].solid, 1);
        expect_sound(plugs[1].solid, 0);
        double widest = 0;
        for (const Point& p : plugs[1].solid.mesh.vertices) {
          widest = std::max(widest, std::hypot(p[0], p[1]));
        }
        EXPECT_GT(widest, 1.02 * inner + 1.49);
        EXPECT_GT(widest, inner + thickness - 0.01);
      }
    }
  }
}

}  // namespace
}  // namespace latticast
