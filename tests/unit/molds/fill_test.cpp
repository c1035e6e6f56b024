// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/fill.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "molds/strand_map.h"
#include "tests/unit/geometry/solid/random_patterns.h"
#include "tests/unit/molds/lattice_molds.h"

namespace latticast {
namespace {

const std::vector<double> three_around{0.3, 2.4, 4.5};

FillPlan fill_of(const Segment& segment) {
  const Pattern strands = draw_lattice(segment, 0.005);
  return plan_fill(strands, {three_around, strands.circumference_mm / 3});
}

// A picture of the cavity, in which air rises from pixel to pixel.
class Picture {
 public:
  explicit Picture(const Pattern& strands)
      : rows_(static_cast<int>(strands.length_mm / pixel)),
        cells_(static_cast<int>(strands.circumference_mm / pixel)),
        circumference_(strands.circumference_mm),
        map_(strands, cells_, rows_, 0) {}

  static constexpr double pixel = 0.1;

  bool covers(int row, int cell) const {
    return row >= 0 && row < rows_ && map_.covers(row, (cell + 0.5) * circumference_ / cells_);
  }

  // Runs of covered pixels in a row from which no covered pixel above can be reached, sideways
  // included: (u of the middle, z).
  std::vector<PlanePoint> tops() const {
    std::vector<PlanePoint> found;
    std::vector<char> seen(static_cast<std::size_t>(rows_) * cells_, 0);
    for (int row = rows_ - 1; row >= 0; --row) {
      for (int cell = 0; cell < cells_; ++cell) {
        if (!covers(row, cell) || seen[index(row, cell)]) continue;
        int count = 0;
        if (is_top(row, cell, seen, count)) {
          found.push_back({(cell + 0.5 * count) * circumference_ / cells_, map_.row_z_mm(row)});
        }
      }
    }
    return found;
  }

 private:
  std::size_t index(int row, int cell) const {
    return static_cast<std::size_t>(row) * cells_ + cell;
  }

  bool is_top(int row, int cell, std::vector<char>& seen, int& count) const {
    std::queue<int> pending({cell});
    seen[index(row, cell)] = 1;
    bool top = true;
    for (; !pending.empty(); pending.pop()) {
      ++count;
      const int at = pending.front();
      for (const int side : {-1, 0, 1}) top = top && !covers(row + 1, wrapped(at + side));
      for (const int side : {-1, 1}) {
        const int next = wrapped(at + side);
        if (!covers(row, next) || seen[index(row, next)]) continue;
        seen[index(row, next)] = 1;
        pending.push(next);
      }
    }
    return top;
  }

  int wrapped(int cell) const { return ((cell % cells_) + cells_) % cells_; }

  int rows_;
  int cells_;
  double circumference_;
  StrandMap map_;
};

void expect_vents_at_all_tops(const Segment& segment) {
  const Pattern strands = draw_lattice(segment, 0.005);
  const FillPlan plan = fill_of(segment);
  for (const PlanePoint& top : Picture(strands).tops()) {
    const auto near = [&](const Bore& vent) {
      const double beside = std::remainder(vent.middle.u - top.u, strands.circumference_mm);
      // A plateau has its vents somewhere along it.
      return std::abs(vent.middle.z - top.z) < 3 && std::abs(beside) < strands.circumference_mm / 3;
    };
    EXPECT_TRUE(std::any_of(plan.vents.begin(), plan.vents.end(), near))
        << "no vent near u = " << top.u << ", z = " << top.z;
  }
}

TEST(Fill, NoHighPointIsWithoutAVent) {
  Segment strips = twisting_segment();
  strips.lattice->rings.reset();
  Segment loops = column_segment();
  loops.length_mm = 60;
  loops.lattice->grids = {{90, std::vector<double>(4, 1.5), Horseshoe{6, 240, true}}};
  Segment slanted = superimposed_segment();
  slanted.lattice->rings.reset();
  for (const Segment& segment : {twisting_segment(), bending_segment(), superimposed_segment(),
                                 column_segment(), strips, ringed_segment(), slanted}) {
    expect_vents_at_all_tops(segment);
  }
}

TEST(Fill, NoHighPointOfARandomLatticeIsWithoutAVent) {
  constexpr std::uint64_t seed = 314;
  std::printf("seeds from %llu\n", static_cast<unsigned long long>(seed));
  for (std::uint64_t number = seed; number < seed + 40; ++number) {
    SCOPED_TRACE("seed " + std::to_string(number));
    RandomNumbers random(number);
    expect_vents_at_all_tops(random_segment(random));
  }
}

TEST(Fill, CountsCavitiesAndTheirHighPoints) {
  const FillPlan joined = fill_of(twisting_segment());
  EXPECT_EQ(joined.cavities, 1);
  EXPECT_EQ(joined.sprues.size(), 1U);
  EXPECT_EQ(joined.high_points.size(), 1U);  // the highest ring's upper side
  EXPECT_EQ(joined.vents.size(), 3U);

  const FillPlan columns = fill_of(column_segment(6));
  EXPECT_EQ(columns.cavities, 6);
  EXPECT_EQ(columns.sprues.size(), 6U);
  EXPECT_EQ(columns.high_points.size(), 6U);
  EXPECT_EQ(columns.vents.size(), 6U);

  const FillPlan rings = fill_of(ringed_segment());
  EXPECT_EQ(rings.cavities, 8);
  EXPECT_EQ(rings.high_points.size(), 8U);
  EXPECT_EQ(rings.vents.size(), 24U);

  // Two families of strips that cross between the ends: every end is a high point of its own.
  Segment crossed = twisting_segment();
  crossed.lattice->rings.reset();
  crossed.lattice->grids = {{50, std::vector<double>(3, 2.0), StraightPath{}},
                            {130, std::vector<double>(3, 2.0), StraightPath{}}};
  const FillPlan ends = fill_of(crossed);
  EXPECT_EQ(ends.cavities, 1);
  EXPECT_EQ(ends.sprues.size(), 1U);
}

// A hand-made arch: it rises to a top between two feet, beside a higher mast.
TEST(Fill, FindsAnArchBesideAMast) {
  const Pattern arch{100,
                     50,
                     {{{{10, 0}, {14, 0}, {20, 26}, {26, 0}, {30, 0}, {20, 40}}},
                      {{{5, 2}, {60, 2}, {60, 6}, {5, 6}}},
                      {{{50, 0}, {54, 0}, {54, 48}, {50, 48}}}}};
  const FillPlan plan = plan_fill(arch, {three_around, 30});
  ASSERT_EQ(plan.high_points.size(), 2U);
  EXPECT_EQ(plan.cavities, 1);
  std::vector<double> heights{plan.high_points[0].z, plan.high_points[1].z};
  std::sort(heights.begin(), heights.end());
  EXPECT_NEAR(heights[0], 40, 1e-3);
  EXPECT_NEAR(heights[1], 48, 1e-3);
  // The foot's corners at z = 0 tie; any of them is a lowest place.
  ASSERT_EQ(plan.sprues.size(), 1U);
  EXPECT_LT(plan.sprues[0].middle.z, 4.5);
}

// Seen from the bore's middle, the strand reaches at least as far as the bore in every direction.
TEST(Fill, BoresStayInsideTheStrands) {
  for (const Segment& segment : {twisting_segment(), bending_segment(), column_segment()}) {
    const Pattern strands = draw_lattice(segment, 0.005);
    const FillPlan plan = fill_of(segment);
    const int cells = 4000;
    const int rows = 4000;
    const StrandMap map(strands, cells, rows, 0);
    std::vector<Bore> bores = plan.vents;
    bores.insert(bores.end(), plan.sprues.begin(), plan.sprues.end());
    for (const Bore& bore : bores) {
      EXPECT_GE(bore.radius_mm, 0.3);
      for (int i = 0; i < 24; ++i) {
        const double angle = i * std::numbers::pi / 12;
        const double u = bore.middle.u + 0.97 * bore.radius_mm * std::cos(angle);
        const double z = bore.middle.z + 0.97 * bore.radius_mm * std::sin(angle);
        EXPECT_TRUE(map.covers(static_cast<int>(z / strands.length_mm * rows), u))
            << "u = " << u << ", z = " << z;
      }
    }
  }
}

}  // namespace
}  // namespace latticast
