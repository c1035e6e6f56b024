// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/sinusoid_path.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "design/units.h"
#include "geometry/pattern/drawing_problems.h"
#include "geometry/pattern/strand_path.h"
#include "tests/unit/geometry/pattern/strand_outline.h"

namespace latticast {
namespace {

// Midpoints of a periodic function converge exponentially.
double half_wave_length(double amplitude, double chord) {
  constexpr int pieces = 4000;
  double length = 0;
  for (int i = 0; i < pieces; ++i) {
    const double slope = pi * amplitude / chord * std::cos((i + 0.5) * pi / pieces);
    length += std::hypot(1, slope) * chord / pieces;
  }
  return length;
}

// Chord coordinates of a point.
std::pair<double, double> along_and_across(const SinusoidStrand& strand, PlanePoint p) {
  const double turn = radians(strand.angle_deg);
  const double du = p.u - strand.start_u_mm;
  return {du * std::cos(turn) + p.z * std::sin(turn), du * std::sin(turn) - p.z * std::cos(turn)};
}

// To the wave's finely sampled chords.
double sampled_distance(const SinusoidStrand& strand, double along, double across) {
  const double chord = link_chord_mm(strand);
  const double amplitude = strand.shape.amplitude_mm;
  const auto at = [&](double s) { return amplitude * std::sin(pi * s / chord); };
  const double step = chord / 2000;
  double nearest = HUGE_VAL;
  for (double s = along - 2.5 * chord; s < along + 2.5 * chord; s += step) {
    const double run = step;
    const double rise = at(s + step) - at(s);
    const double part = std::clamp(
        ((along - s) * run + (across - at(s)) * rise) / (run * run + rise * rise), 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(along - s - part * run, across - at(s) - part * rise));
  }
  return nearest;
}

SinusoidStrand random_strand(std::mt19937_64& engine) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  SinusoidStrand strand{{between(0.3, 4), 0.5 * std::floor(between(6, 20))},
                        between(0, 30),
                        between(0, 1) < 0.4 ? 90 : between(30, 150),
                        1,
                        between(30, 60)};
  strand.width_mm =
      std::min(0.9 * link_chord_mm(strand), 2 * smallest_radius_mm(strand)) * between(0.05, 0.95);
  return strand;
}

TEST(SinusoidPath, SizesOfAWave) {
  const SinusoidStrand strand{{2, 8}, 0, 30, 1, 40};
  EXPECT_DOUBLE_EQ(link_chord_mm(strand), 5);  // 80 mm of strand, 16 half waves
  EXPECT_NEAR(link_length_mm(strand), half_wave_length(2, 5), 1e-12);
  EXPECT_NEAR(largest_slope_deg(strand), degrees(std::atan(pi * 2 / 5)), 1e-12);
  EXPECT_NEAR(smallest_radius_mm(strand), 25 / (pi * pi * 2), 1e-12);
  EXPECT_EQ(reach_mm(strand), 2);
  EXPECT_NEAR(gap_within_mm(strand), 2 * smallest_radius_mm(strand) - 1, 1e-12);
}

// Between curves at half the width on both sides there is width times length.
TEST(SinusoidPath, WholeHalfWavesHaveExactlyTheirArea) {
  for (const double amplitude : {0.2, 1.5, 4.0}) {
    for (const double flatness : {0.1, 0.003}) {
      const SinusoidStrand strand{{amplitude, 6}, 1, 90, amplitude > 2 ? 0.4 : 1.2, 48};
      const DrawnStrand drawn = draw_strand(strand, flatness);
      ASSERT_GE(drawn.links.size(), 12U);
      const double expected = strand.width_mm * half_wave_length(amplitude, 4);
      int whole = 0;
      for (const Strand& link : drawn.links) {
        if (link.outline.front().z < 5 || link.outline.front().z > 42) continue;
        EXPECT_NEAR(area(link) / expected, 1, 1e-12);
        ++whole;
      }
      EXPECT_GE(whole, 6);
      EXPECT_LE(drawn.error.distance_mm, flatness);
    }
  }
}

TEST(SinusoidPath, OutlinesFollowTheWave) {
  constexpr unsigned seed = 7007;
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  int inside = 0;
  int outside = 0;
  for (int trial = 0; trial < 25; ++trial) {
    const SinusoidStrand strand = random_strand(engine);
    SCOPED_TRACE(testing::Message()
                 << "seed " << seed << " trial " << trial << ": A " << strand.shape.amplitude_mm
                 << " waves " << strand.shape.waves << " angle " << strand.angle_deg << " w "
                 << strand.width_mm << " L " << strand.length_mm);
    const double flatness = 0.01 * strand.width_mm;
    const DrawnStrand drawn = draw_strand(strand, flatness);
    const double reach = strand.shape.amplitude_mm + strand.width_mm;
    for (int i = 0; i < 200; ++i) {
      const double z = (0.2 + 0.6 * unit(engine)) * strand.length_mm;
      const PlanePoint p{strand.start_u_mm + z / std::tan(radians(strand.angle_deg)) +
                             (2 * unit(engine) - 1) * reach / std::sin(radians(strand.angle_deg)),
                         z};
      const auto [along, across] = along_and_across(strand, p);
      const double depth = 0.5 * strand.width_mm - sampled_distance(strand, along, across);
      if (std::abs(depth) < 1.1 * flatness) continue;
      const bool drawn_there = std::any_of(drawn.links.begin(), drawn.links.end(),
                                           [&](const Strand& link) { return holds(link, p); });
      ASSERT_EQ(drawn_there, depth > 0) << p.u << " " << p.z;
      ++(drawn_there ? inside : outside);
    }
  }
  EXPECT_GT(inside, 500);
  EXPECT_GT(outside, 500);
}

TEST(SinusoidPath, EdgesKeepTheirCurvesAndParameters) {
  constexpr unsigned seed = 7008;
  std::mt19937_64 engine(seed);
  for (int trial = 0; trial < 10; ++trial) {
    SCOPED_TRACE(testing::Message() << "seed " << seed << " trial " << trial);
    const SinusoidStrand strand = random_strand(engine);
    const double flatness = 0.005 * strand.width_mm;
    const DrawnStrand drawn = draw_strand(strand, flatness);
    int on_waves = 0;
    for (const Strand& link : drawn.links) {
      ASSERT_EQ(link.traces.size(), link.outline.size());
      for (std::size_t i = 0; i < link.outline.size(); ++i) {
        const CurveRange& range = link.traces[i];
        if (range.curve == own_line) continue;
        const DrawnCurve& curve = link.curves[range.curve];
        on_waves += std::holds_alternative<SinusoidOffset>(curve.shape);
        const PlanePoint from = point_at(curve.shape, range.from);
        const PlanePoint to = point_at(curve.shape, range.to);
        const PlanePoint& a = link.outline[i];
        const PlanePoint& b = link.outline[(i + 1) % link.outline.size()];
        // A cut through a chord has the chord's share, where the curve is a little further on.
        EXPECT_LT(std::hypot(from.u - a.u, from.z - a.z), 3 * flatness);
        EXPECT_LT(std::hypot(to.u - b.u, to.z - b.z), 3 * flatness);
      }
    }
    EXPECT_GT(on_waves, 50);
  }
}

TEST(SinusoidPath, NeighbouringHalfWavesShareCorners) {
  const DrawnStrand drawn = draw_strand(SinusoidStrand{{1.5, 5}, 2, 63, 1, 40}, 0.01);
  std::multiset<std::pair<double, double>> corners;
  for (const Strand& link : drawn.links) {
    for (const PlanePoint& p : link.outline) {
      if (p.z > 1 && p.z < 39) corners.emplace(p.u, p.z);
    }
  }
  int shared = 0;
  for (const auto& corner : corners) shared += corners.count(corner) == 2;
  EXPECT_GE(shared, 2 * 2 * 8);  // both links of eight joints, two corners each
}

TEST(SinusoidPath, DistancesAgreeWithSampling) {
  constexpr unsigned seed = 7009;
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 60; ++trial) {
    const SinusoidStrand strand = random_strand(engine);
    SCOPED_TRACE(testing::Message() << "seed " << seed << " trial " << trial);
    const double along = 20 * unit(engine);
    const double across = 10 * (2 * unit(engine) - 1);
    EXPECT_NEAR(centre_line_distance_mm(strand, along, across),
                sampled_distance(strand, along, across), 1e-4 * strand.shape.amplitude_mm);
    const double spacing = 1 + 10 * unit(engine);
    const double turn = radians(strand.angle_deg);
    double least = HUGE_VAL;
    for (int i = 0; i < 400; ++i) {
      const double s = 2 * link_chord_mm(strand) * i / 400;
      const double t = strand.shape.amplitude_mm * std::sin(pi * s / link_chord_mm(strand));
      least = std::min(least, sampled_distance(strand, s - spacing * std::cos(turn),
                                               t - spacing * std::sin(turn)));
      if (trial > 10) break;
    }
    if (trial <= 10) {
      EXPECT_NEAR(centre_distance_mm(strand, spacing), least, 2e-3 * strand.shape.amplitude_mm);
    }
  }
}

TEST(SinusoidPath, StretchedWavesKeepTheirLength) {
  SinusoidStrand strand{{2, 6}, 0, 70, 1, 40};
  const double length = link_length_mm(strand);
  for (const double stretch : {0.7, 1.0, 1.1}) {
    SinusoidStrand longer = strand;
    longer.length_mm *= stretch;
    longer.shape = stretched(strand, stretch);
    EXPECT_EQ(longer.shape.waves, 6);
    EXPECT_NEAR(link_length_mm(longer) / length, 1, 1e-9);
  }
  EXPECT_NEAR(stretched(strand, 1.0).amplitude_mm, 2, 1e-9);
  EXPECT_LT(stretched(strand, 10.0).amplitude_mm, 4);  // kept a little wavy, however far
}

Segment columns(const Sinusoid& path, double width_mm, int count = 8, double angle_deg = 90,
                double radius_mm = 12) {
  Segment segment;
  segment.length_mm = 60;
  segment.liner = {radius_mm, 4, {}};
  segment.lattice.emplace();
  segment.lattice->thickness_mm = 2;
  segment.lattice->grids = {{angle_deg, std::vector<double>(count, width_mm), path}};
  return segment;
}

double number_after(const std::string& text, const std::string& mark) {
  return std::stod(text.substr(text.find(mark) + mark.size()));
}

TEST(SinusoidPath, FoldsAreRefusedWithValuesThatWork) {
  const Sinusoid path{3, 12};
  const std::vector<std::string> problems = drawing_problems(columns(path, 1));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].find("lattice.grid[0].sinusoid"), std::string::npos) << problems[0];
  EXPECT_NE(problems[0].find("folds over itself"), std::string::npos) << problems[0];
  const double waves = number_after(problems[0], "mm: ");
  const double amplitude = number_after(problems[0], "or amplitude ");
  const double width = number_after(problems[0], "width below ");
  EXPECT_TRUE(drawing_problems(columns({3, waves}, 1)).empty());
  EXPECT_TRUE(drawing_problems(columns({amplitude, 12}, 1)).empty());
  EXPECT_TRUE(drawing_problems(columns(path, 0.999 * width)).empty());
}

TEST(SinusoidPath, PartedStrandsAreRefusedAndOverlapsNamed) {
  const std::vector<std::string> parted = drawing_problems(columns({42, 4}, 1, 1, 20, 80));
  ASSERT_EQ(parted.size(), 1U);
  EXPECT_NE(parted[0].find("parts it"), std::string::npos) << parted[0];
  const double amplitude = number_after(parted[0], "; amplitude ");
  EXPECT_TRUE(drawing_problems(columns({amplitude, 4}, 1, 1, 20, 80)).empty());

  const std::vector<std::string> overlap = overlapping_neighbours(columns({4, 4}, 2, 60));
  ASSERT_EQ(overlap.size(), 1U);
  EXPECT_NE(overlap[0].find("overlaps strand 2"), std::string::npos) << overlap[0];
  const int fewer = static_cast<int>(number_after(overlap[0], "count "));
  EXPECT_TRUE(overlapping_neighbours(columns({4, 4}, 2, fewer)).empty());
  EXPECT_FALSE(overlapping_neighbours(columns({4, 4}, 2, fewer + 1)).empty());
}

}  // namespace
}  // namespace latticast
