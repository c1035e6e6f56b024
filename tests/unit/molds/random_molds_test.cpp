// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever lattice is to be cast: a sound mold, or a refusal with a reason.
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>

#include "geometry/solid/arrangement.h"
#include "tests/unit/geometry/solid/random_patterns.h"
#include "tests/unit/molds/lattice_molds.h"

namespace latticast {
namespace {

constexpr std::uint64_t seed = 20261123;
constexpr int shards = 5;
constexpr int molds_per_shard = 60;

// Columns of arcs that close on the length, some of which touch their neighbours.
void add_horseshoes(RandomNumbers& random, Segment& segment) {
  const double angle = random.whole(0, 1) == 0 ? 90 : random.between(40, 140);
  const double arc = random.whole(0, 1) == 0 ? 180 : random.between(60, 200);
  const double along = segment.length_mm / std::sin(angle * std::numbers::pi / 180);
  const int count = random.whole(1, 6);
  const double share = 2 * std::numbers::pi * segment.lattice_mid_radius_mm() / count;
  const int arcs = static_cast<int>(std::ceil(along / share)) + random.whole(1, 4);
  const double radius = along / arcs / (2 * std::sin(0.5 * arc * std::numbers::pi / 180));
  const double width = random.between(0.1, 0.6) * std::min(radius, 0.3 * share);
  segment.lattice->grids = {
      {angle, std::vector<double>(count, width), Horseshoe{radius, arc, true}}};
}

Segment segment_to_cast(std::uint64_t number) {
  RandomNumbers random(number);
  Segment segment = random_segment(random);
  if (number % 3 == 0) add_horseshoes(random, segment);
  if (number % 5 == 0) {
    segment.lattice->fillet_mm = random.log_between(0.1, 0.5) * segment.lattice->thickness_mm;
  }
  return segment;
}

LatticeMoldOptions options_for(std::uint64_t number) {
  RandomNumbers random(number + 1000);
  LatticeMoldOptions options;
  options.fit.wall_mm = random.log_between(1.5, 8);
  options.fit.clearance_mm = random.log_between(0.05, 0.5);
  options.fit.tolerance_mm = random.log_between(0.01, 0.1);
  options.fit.growth = random.between(1, 1.03);
  if (random.whole(0, 1) == 0) options.pieces = random.whole(2, 8);
  return options;
}

class RandomMolds : public testing::TestWithParam<int> {};

TEST_P(RandomMolds, AreSoundOrRefusedWithAReason) {
  const std::uint64_t first = seed + static_cast<std::uint64_t>(GetParam() * molds_per_shard);
  int made = 0;
  std::map<std::string, int> refusals;
  for (int i = 0; i < molds_per_shard; ++i) {
    const std::uint64_t number = first + i;
    SCOPED_TRACE("seed " + std::to_string(number));
    try {
      const Mold mold = lattice_mold(segment_to_cast(number), options_for(number));
      ++made;
      expect_sound_mold(mold);
    } catch (const std::runtime_error& refusal) {
      const std::string reason = refusal.what();
      EXPECT_GT(reason.size(), 20U);
      ++refusals[reason.substr(0, 160)];
    }
  }
  std::printf("seeds from %llu: %d of %d made\n", static_cast<unsigned long long>(first), made,
              molds_per_shard);
  for (const auto& [reason, count] : refusals) std::printf("  %d: %s\n", count, reason.c_str());
  EXPECT_GE(made, molds_per_shard * 6 / 10) << "refusing everything proves nothing";
}

INSTANTIATE_TEST_SUITE_P(Shards, RandomMolds, testing::Range(0, shards));

}  // namespace
}  // namespace latticast
