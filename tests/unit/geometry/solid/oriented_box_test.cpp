// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/oriented_box.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/geometry/solid/random_patterns.h"

namespace latticast {
namespace {

using Corners = std::array<Point, 3>;

constexpr double margin = 1e-12 * 5e3;  // no coordinate below is larger

OrientedBox box_around(const Corners& t) {
  return OrientedBox::around(t[0], t[1], t[2], margin);
}

double random_size(RandomNumbers& random) {
  return random.log_between(1e-9, 1e3);
}

Point moved(RandomNumbers& random, Point p, double by) {
  for (double& x : p) x += by * random.between(-1, 1);
  return p;
}

// Any triangle: a needle, a sliver, a speck far from the origin, all corners on a line or in one
// point.
Corners random_triangle(RandomNumbers& random, const Point& first) {
  Corners t{first, moved(random, first, random_size(random)), {}};
  const double part = random.between(0, 1);
  for (int i = 0; i < 3; ++i) t[2][i] = t[0][i] + part * (t[1][i] - t[0][i]);
  if (random.whole(0, 3) > 0) t[2] = moved(random, t[2], random_size(random));
  if (random.whole(0, 9) == 0) t[1] = t[0];
  return t;
}

Point random_place(RandomNumbers& random) {
  return moved(random, {0, 0, 0}, random_size(random));
}

bool holds(const OrientedBox& box, const Point& p) {
  for (int i = 0; i < 3; ++i) {
    double along = 0;
    for (int k = 0; k < 3; ++k) along += box.axes[i][k] * (p[k] - box.middle[k]);
    if (!(std::abs(along) <= box.half[i])) return false;
  }
  return true;
}

TEST(OrientedBox, HoldsWhatItIsAround) {
  constexpr std::uint64_t seed = 6101;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    RandomNumbers random(seed + i);
    const Corners s = random_triangle(random, random_place(random));
    const Corners t = random_triangle(random, random_place(random));
    for (const Point& corner : s) ASSERT_TRUE(holds(box_around(s), corner));
    const OrientedBox both = OrientedBox::around(box_around(s), box_around(t));
    for (const Point& corner : s) ASSERT_TRUE(holds(both, corner));
    for (const Point& corner : t) ASSERT_TRUE(holds(both, corner));
  }
}

TEST(OrientedBox, MayMeetWhatTouchesIt) {
  constexpr std::uint64_t seed = 6201;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    RandomNumbers random(seed + i);
    const Point common = random_place(random);
    const OrientedBox a = box_around(random_triangle(random, common));
    const OrientedBox b = box_around(random_triangle(random, common));
    const OrientedBox c = box_around(random_triangle(random, random_place(random)));
    ASSERT_TRUE(a.may_meet(b));
    ASSERT_TRUE(b.may_meet(a));
    ASSERT_TRUE(OrientedBox::around(a, c).may_meet(b));
    ASSERT_TRUE(b.may_meet(OrientedBox::around(c, a)));
  }
}

TEST(OrientedBox, IsAsThinAsItsTriangle) {
  constexpr std::uint64_t seed = 6301;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    RandomNumbers random(seed + i);
    // Slivers side by side, a width apart, in a random direction.
    Point along{};
    double length = 0;
    for (double& x : along) x = random.between(-1, 1);
    for (const double x : along) length += x * x;
    if (length < 0.1) continue;
    Point across{along[1], -along[0], 0};
    const double flat = std::hypot(across[0], across[1]);
    if (flat < 0.1) continue;
    const double width = random.log_between(1e-5, 0.1);
    for (double& x : across) x *= width / flat;
    const auto sliver = [&](double offset) {
      Corners t{};
      for (int k = 0; k < 3; ++k) {
        t[0][k] = offset * across[k];
        t[1][k] = t[0][k] + along[k];
        t[2][k] = t[0][k] + 0.4 * along[k] + across[k];
      }
      return box_around(t);
    };
    EXPECT_TRUE(sliver(0).may_meet(sliver(0.99)));
    EXPECT_FALSE(sliver(0).may_meet(sliver(1.01)));
    const OrientedBox two = OrientedBox::around(sliver(0), sliver(1.5));
    EXPECT_TRUE(two.may_meet(sliver(2.4)));
    EXPECT_FALSE(two.may_meet(sliver(2.6)));
  }
}

TEST(OrientedBox, OfAPointOrASpeckIsNotLost) {
  const auto at = [](double x) { return box_around({Point{x, 0, 0}, {x, 0, 0}, {x, 0, 0}}); };
  EXPECT_TRUE(at(0).may_meet(at(0)));
  EXPECT_TRUE(at(1).may_meet(at(1)));
  EXPECT_FALSE(at(1).may_meet(at(1.001)));
  const Corners speck{Point{0, 0, 0}, {5e-324, 0, 0}, {0, 5e-324, 5e-324}};
  EXPECT_TRUE(box_around(speck).may_meet(at(0)));
  EXPECT_TRUE(holds(box_around(speck), speck[1]));
}

}  // namespace
}  // namespace latticast
