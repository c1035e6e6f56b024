// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/mold_rings.h"

#include "design/units.h"
#include "tests/unit/molds/sound_solid.h"

namespace latticast {
namespace {

TEST(Core, IsARodWithChamferedRims) {
  const Solid core = core_solid({12, -5, 95, 1}, 0.01);
  expect_sound(core, 0);
  // Two cone frusta of height 1 on a cylinder of height 98.
  const double frustum = pi / 3 * (144 + 12 * 11 + 121);
  EXPECT_NEAR(core.volume_mm3, pi * 144 * 98 + 2 * frustum, 1e-6 * core.volume_mm3);
  double lowest = 0;
  double highest = 0;
  for (const Point& p : core.mesh.vertices) {
    lowest = std::min(lowest, p[2]);
    highest = std::max(highest, p[2]);
    if (std::abs(p[2] - 45) > 49.999) {
      EXPECT_LE(std::hypot(p[0], p[1]), 11.02);
    }
  }
  EXPECT_NEAR(lowest, -5, 1e-9);
  EXPECT_NEAR(highest, 95, 1e-9);
}

TEST(Core, KeepsItsChamfersWhereFacetsMayBeCoarse) {
  for (const double radius : {0.1, 1.0, 1.4, 2.0, 5.0}) {
    SCOPED_TRACE(radius);
    const double chamfer = 0.25 * radius;
    const Solid core = core_solid({radius, -5, 20, chamfer}, 0.01);
    expect_sound(core, 0);
    double widest = 0;
    for (const Point& p : core.mesh.vertices) {
      if (p[2] > 19.999) widest = std::max(widest, std::hypot(p[0], p[1]));
    }
    EXPECT_NEAR(widest, radius - chamfer, 0.005 * radius);
  }
}

TEST(EndPlate, HoldsCoreAndShell) {
  EndPlate plate;
  plate.core_radius_mm = 12;
  plate.shell_radius_mm = 21;
  plate.clearance_mm = 0.3;
  const Solid base = end_plate_solid(plate, 0, false, 0.01);
  expect_sound(base, 0);
  const double inner = 12.15;
  const double shell = 21.15;
  const double outer = 26.15;
  EXPECT_NEAR(base.volume_mm3, pi * (outer * outer * 15 - shell * shell * 6 - inner * inner * 5),
              1e-6 * base.volume_mm3);
  const Solid cap = end_plate_solid(plate, 85, true, 0.01);
  expect_sound(cap, 0);
  EXPECT_NEAR(cap.volume_mm3, base.volume_mm3, 1e-6 * base.volume_mm3);
  for (const Point& p : base.mesh.vertices) EXPECT_TRUE(p[2] >= -9 - 1e-9 && p[2] <= 6 + 1e-9);
  for (const Point& p : cap.mesh.vertices) EXPECT_TRUE(p[2] >= 79 - 1e-9 && p[2] <= 94 + 1e-9);
}

TEST(EndPlate, OpensForPouring) {
  EndPlate plate;
  plate.core_radius_mm = 12;
  plate.shell_radius_mm = 21;
  plate.opening_from_mm = 12.5;
  plate.opening_to_mm = 15.5;
  plate.openings_rad = {0.5, 2.5, 4.5};
  plate.opening_width_rad = 0.6;
  expect_sound(end_plate_solid(plate, 85, true, 0.01), 3);
  plate.core_radius_mm = 0;
  plate.opening_from_mm = 4;
  expect_sound(end_plate_solid(plate, 85, true, 0.01), 3);
}

}  // namespace
}  // namespace latticast
