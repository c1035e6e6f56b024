// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/section/mirror_places.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

/// Every place tried, every pair of strands compared.
std::vector<bool> places_one_by_one(const std::vector<double>& widths) {
  const int n = static_cast<int>(widths.size());
  std::vector<bool> places(n, true);
  for (int place = 0; place < n; ++place) {
    for (int j = 0; j < n; ++j) {
      if (widths[j] != widths[(place + n - j) % n]) places[place] = false;
    }
  }
  return places;
}

TEST(MirrorPlaces, ByHand) {
  EXPECT_TRUE(mirror_places({}).empty());
  EXPECT_EQ(mirror_places(std::vector{2.0}), std::vector{true});
  EXPECT_EQ(mirror_places(std::vector{2.0, 3.0}), (std::vector{true, false}));
  // Through the strands 0 and 2, which differ, and through no gap.
  EXPECT_EQ(mirror_places(std::vector{1.0, 2.0, 3.0, 2.0}),
            (std::vector{true, false, false, false}));
  // Halves: through both gaps between unlike strands, which are one plane.
  EXPECT_EQ(mirror_places(std::vector{2.0, 2.0, 3.0, 3.0}),
            (std::vector{false, true, false, false}));
  EXPECT_EQ(mirror_places(std::vector(5, 2.0)), std::vector(5, true));
  EXPECT_EQ(mirror_places(std::vector{1.0, 2.0, 4.0}), std::vector(3, false));
  EXPECT_EQ(mirror_places(std::vector{1.0, std::nan(""), 1.0}), std::vector(3, false));
}

TEST(MirrorPlaces, AreThoseFoundOneByOne) {
  constexpr unsigned seed = 20260;
  Random random(seed);
  int mirrored = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    // Few kinds of width, and repeats of a short list, so that partial matches abound.
    const int kinds = random.integer(1, 3);
    std::vector<double> part(random.integer(1, 9));
    for (double& width : part) width = random.integer(1, kinds);
    std::vector<double> widths;
    for (int copies = random.integer(1, 4); copies > 0; --copies) {
      widths.insert(widths.end(), part.begin(), part.end());
    }
    if (random.chance(0.3)) widths.back() = 2;
    const std::vector<bool> found = mirror_places(widths);
    ASSERT_EQ(found, places_one_by_one(widths)) << "seed " << seed << ", trial " << trial;
    for (const bool place : found) mirrored += place ? 1 : 0;
  }
  EXPECT_GT(mirrored, 1000);
}

}  // namespace
}  // namespace latticast::testing
