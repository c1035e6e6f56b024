// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/rings.h"

#include <random>

#include <gtest/gtest.h>

namespace latticast {
namespace {

Rings counted(int count, double width_mm) {
  return {count, std::nullopt, width_mm};
}

Rings pitched(double pitch_mm, double width_mm) {
  return {std::nullopt, pitch_mm, width_mm};
}

TEST(Rings, ByCountAreFlushWithBothEndsAndEven) {
  const std::vector<double> centres = ring_centres_mm(counted(8, 2), 85);
  ASSERT_EQ(centres.size(), 8U);
  EXPECT_DOUBLE_EQ(centres.front(), 1);
  EXPECT_DOUBLE_EQ(centres.back(), 84);
  for (std::size_t i = 1; i < centres.size(); ++i) {
    EXPECT_NEAR(centres[i] - centres[i - 1], 83.0 / 7, 1e-12);
  }
  EXPECT_DOUBLE_EQ(ring_pitch_mm(counted(8, 2), 85), 83.0 / 7);
}

TEST(Rings, TwoRingsSitOnTheEnds) {
  const std::vector<double> centres = ring_centres_mm(counted(2, 0.3), 1.1);
  ASSERT_EQ(centres.size(), 2U);
  EXPECT_DOUBLE_EQ(centres[0], 0.15);
  EXPECT_DOUBLE_EQ(centres[1], 0.95);
}

TEST(Rings, ByPitchStartHalfAPitchIn) {
  EXPECT_EQ(ring_centres_mm(pitched(10, 2), 85),
            (std::vector<double>{5, 15, 25, 35, 45, 55, 65, 75}));
  EXPECT_EQ(ring_pitch_mm(pitched(10, 2), 85), 10);
}

TEST(Rings, ByPitchKeepTheLastThatFitsExactly) {
  EXPECT_EQ(ring_centres_mm(pitched(10, 2), 76).size(), 8U);
  EXPECT_EQ(ring_centres_mm(pitched(10, 2), 76 - 1e-6).size(), 7U);
  // Neither the pitch nor the length is a binary number here: the last ring ends at 0.66 up to
  // rounding.
  EXPECT_EQ(ring_centres_mm(pitched(0.1, 0.02), 0.66).size(), 7U);
  EXPECT_EQ(ring_centres_mm(pitched(0.1, 0.02), 0.66 - 1e-9).size(), 6U);
}

TEST(Rings, NoneWhenTheFirstDoesNotFit) {
  EXPECT_EQ(ring_centres_mm(pitched(10, 2), 6).size(), 1U);
  EXPECT_TRUE(ring_centres_mm(pitched(10, 2), 5.999).empty());
  EXPECT_TRUE(ring_centres_mm(pitched(1000, 2), 5).empty());
}

Rings at_phase(double phase, double pitch_mm, double width_mm) {
  return {std::nullopt, pitch_mm, width_mm, phase};
}

TEST(Rings, AtAPhaseStartThatPartOfAPitchIn) {
  EXPECT_EQ(ring_centres_mm(at_phase(0.25, 10, 2), 45),
            (std::vector<double>{2.5, 12.5, 22.5, 32.5, 42.5}));
  EXPECT_EQ(ring_centres_mm(at_phase(0.5, 10, 2), 45), (std::vector<double>{5, 15, 25, 35}));
  EXPECT_EQ(ring_centres_mm(at_phase(0.9, 10, 2), 45), (std::vector<double>{9, 19, 29, 39}));
}

TEST(Rings, AtAPhaseThatAnEndCutsAreLeftOut) {
  EXPECT_EQ(ring_centres_mm(at_phase(0, 10, 2), 40), (std::vector<double>{10, 20, 30}));
  EXPECT_EQ(ring_centres_mm(at_phase(0.25, 10, 2), 43),
            (std::vector<double>{2.5, 12.5, 22.5, 32.5}));
  EXPECT_EQ(ring_centres_mm(at_phase(0.09, 10, 2), 25), (std::vector<double>{10.9, 20.9}));
  // Flush with the start up to rounding: 0.14 * 0.1 is more than half of 0.028, or less.
  EXPECT_EQ(ring_centres_mm(at_phase(0.14, 0.1, 0.028), 0.66).size(), 7U);
  EXPECT_EQ(ring_centres_mm(at_phase(0.14 - 1e-9, 0.1, 0.028), 0.66).size(), 6U);
}

TEST(Rings, AtAPhaseMayNotFitAShortSegment) {
  EXPECT_EQ(ring_centres_mm(at_phase(0.9, 10, 2), 10), (std::vector<double>{9}));
  EXPECT_TRUE(ring_centres_mm(at_phase(0.9, 10, 2), 9.999).empty());
  EXPECT_TRUE(ring_centres_mm(at_phase(0, 10, 2), 10.9).empty());
}

TEST(Rings, OfRandomSizesStayOnTheSegmentAndApart) {
  constexpr unsigned seed = 20240611;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> exponent(-3, 3);
  std::uniform_real_distribution<double> part(0.01, 0.99);
  for (int i = 0; i < 2000; ++i) {
    const double length = std::pow(10, exponent(random));
    const int count = 2 + static_cast<int>(random() % 30);
    const bool by_count = i % 2 == 0;
    const double width = part(random) * length / count;
    const Rings rings = by_count ? counted(count, width) : pitched(length / count, width);
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", case " << i << ": length " << length
                                    << ", count " << count << ", width " << width);
    const std::vector<double> centres = ring_centres_mm(rings, length);
    ASSERT_EQ(centres.size(), static_cast<std::size_t>(count));
    const double rounding = 1e-12 * length;
    ASSERT_GE(centres.front() - 0.5 * width, -rounding);
    ASSERT_LE(centres.back() + 0.5 * width, length + rounding);
    for (std::size_t k = 1; k < centres.size(); ++k) {
      ASSERT_GT(centres[k] - centres[k - 1], width);
      ASSERT_NEAR(centres[k] - centres[k - 1], ring_pitch_mm(rings, length), rounding);
    }
  }
}

}  // namespace
}  // namespace latticast
