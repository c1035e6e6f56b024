// SPDX-License-Identifier: GPL-3.0-or-later
// Segments cut into pieces, each predicted on its own and put together again.
#include "model/chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "model/segment_response.h"
#include "model/shape/shape.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

const std::array<Point, 4> wall = {{{12, 0, 0.01}, {0, 17, 0.3}, {-15, 4, 0.999}, {3, -13, 0.62}}};

/// The state of one piece that begins at `from_mm` of a segment: there its columns stand turned by
/// omega from_mm against the piece's own Theta = 0.
State state_of_piece(PreparedSegment whole, double from_mm, double length_mm, double pressure_kpa) {
  auto& section = std::get<Section>(whole.section);
  section.axis_rad += section.frame_turn_rad_per_mm * from_mm;
  whole.length_mm = length_mm;
  return predict(whole, std::vector<double>{pressure_kpa}).states[0].value();
}

void expect_cuts_change_nothing(const Segment& segment, const std::vector<double>& lengths,
                                double pressure_kpa) {
  const PreparedSegment prepared = prepare_segment(segment, {});
  const State whole = predict(prepared, std::vector<double>{pressure_kpa}).states[0].value();
  std::vector<Segment> pieces;
  std::vector<State> states;
  double from = 0;
  for (const double length : lengths) {
    pieces.push_back(segment);
    pieces.back().length_mm = length;
    states.push_back(state_of_piece(prepared, from, length, pressure_kpa));
    from += length;
  }
  const Shape one(std::vector{segment}, std::vector{whole});
  const Shape many(pieces, states);
  for (const Point& p : wall) {
    const Point rest = {p[0], p[1], p[2] * segment.length_mm};
    const Point expected = one.moved(rest);
    const Point found = many.moved(rest);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-10);
  }
  const Frame a = one.tip();
  const Frame b = many.tip();
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(a.origin[i], b.origin[i], 1e-10);
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(a.rotation[i][j], b.rotation[i][j], 1e-11);
  }
}

/// No rings: their share of the layer would depend on the length. Bent, bent and twisted by a
/// second family, and helical.
std::vector<Segment> bending_segments() {
  Segment plain = columns(halves(8, 4, 2));
  Segment twisted = columns({2, 4, 3.5, 2.5, 3}, 90);
  twisted.lattice->grids.push_back(grid(50, 6, 0.8));
  Segment helical = columns({2, 4, 3.5, 2.5, 3}, 65);
  std::vector<Segment> all = {plain, twisted, helical};
  for (Segment& segment : all) segment.lattice->rings.reset();
  return all;
}

TEST(Chain, EqualPiecesEqualOneSegment) {
  for (const Segment& segment : bending_segments()) {
    for (int n = 2; n <= 7; ++n) {
      expect_cuts_change_nothing(segment, std::vector<double>(n, segment.length_mm / n), 12);
    }
  }
}

TEST(Chain, RandomCutsChangeNothing) {
  std::printf("seed 71\n");
  Random random(71);
  for (const Segment& segment : bending_segments()) {
    for (int trial = 0; trial < 10; ++trial) {
      std::vector<double> cuts = {0, segment.length_mm};
      const int count = random.integer(1, 6);
      for (int i = 0; i < count; ++i) cuts.push_back(random.between(0, segment.length_mm));
      std::sort(cuts.begin(), cuts.end());
      std::vector<double> lengths;
      for (std::size_t i = 1; i < cuts.size(); ++i) lengths.push_back(cuts[i] - cuts[i - 1]);
      expect_cuts_change_nothing(segment, lengths, 12);
    }
  }
}

/// Rings of given pitch that fit every piece; and designs alone, whose columns have turned by whole
/// places at each cut, so that a later piece has the same widths in another order.
TEST(Chain, PiecesAsDesignsEqualOneSegment) {
  const int strands = 5;
  const std::vector<double> widths = {2, 4, 3.5, 2.5, 3};
  Segment whole = columns(widths, 65);
  const double middle = whole.lattice_mid_radius_mm();
  const double place = 2 * pi / strands * middle * std::tan(65 * degree);  // height of one place
  for (int n = 2; n <= 7; ++n) {
    whole.length_mm = n * place;
    whole.lattice->rings = Rings{std::nullopt, place / 4, 1.5};
    const State state = predict(whole, {}, std::vector<double>{20}).states[0].value();
    EXPECT_GT(state.bend_magnitude_rad_per_mm(), 1e-4);
    EXPECT_GT(std::abs(state.twist_rad_per_mm), 1e-4);
    std::vector<Segment> pieces;
    std::vector<State> states;
    for (int i = 0; i < n; ++i) {
      Segment piece = whole;
      piece.length_mm = place;
      std::vector<double>& turned = piece.lattice->grids[0].widths_mm;
      std::rotate(turned.begin(), turned.end() - i % strands, turned.end());
      pieces.push_back(piece);
      states.push_back(predict(piece, {}, std::vector<double>{20}).states[0].value());
    }
    const Frame a = Shape(std::vector{whole}, std::vector{state}).tip();
    const Frame b = Shape(pieces, states).tip();
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(a.origin[i], b.origin[i], 1e-10) << n;
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(a.rotation[i][j], b.rotation[i][j], 1e-11);
    }
  }
}

TEST(ChainResponse, ComposesPredictedFrames) {
  const std::vector<Segment> segments = bending_segments();
  std::vector<LoadCase> cases;
  for (const double first : {12.0, 0.0, 6.0}) {
    for (const double second : {5.0, 12.0}) cases.push_back({{first, second, 9}});
  }
  const ChainResponse chain = predict_chain(segments, {}, cases);
  EXPECT_EQ(chain.pressures_kpa[0], (std::vector<double>{0, 6, 12}));
  EXPECT_EQ(chain.pressures_kpa[2], std::vector<double>{9});
  for (std::size_t c = 0; c < cases.size(); ++c) {
    Frame expected;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto response = predict(segments[i], {}, std::vector{cases[c].pressures_kpa[i]});
      expected = composed(expected, frame_along(*response.states[0], segments[i].length_mm));
    }
    const Frame tip = shape_in(chain, segments, c).value().tip();
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(tip.origin[i], expected.origin[i], 1e-8);
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(tip.rotation[i][j], expected.rotation[i][j], 1e-10);
    }
  }
}

TEST(ChainResponse, CasesBeyondALimitAreEmptyAloneAndTheSegmentIsKnown) {
  const std::vector<Segment> segments = {paper_segment({36}), paper_segment({60})};
  const std::vector<LoadCase> cases = {{{20, 20}}, {{500, 20}}, {{20, 20}}};
  const ChainResponse chain = predict_chain(segments, {}, cases);
  EXPECT_TRUE(shape_in(chain, segments, 0));
  EXPECT_FALSE(shape_in(chain, segments, 1));
  EXPECT_FALSE(state_in(chain, 1, 0));
  EXPECT_TRUE(state_in(chain, 1, 1));
  EXPECT_TRUE(states_in(chain, 2));
  EXPECT_EQ(chain.responses[0].status, Status::no_equilibrium);
  EXPECT_EQ(chain.responses[1].status, Status::ok);
}

TEST(ChainResponse, SegmentsShareLawsAndAnswerAsAlone) {
  const std::vector<Segment> segments = {columns(halves(8, 4, 2)), columns(halves(8, 2, 3)),
                                         paper_segment({36}), columns(halves(8, 4, 2)),
                                         columns({2, 4, 3, 3, 4}, 60)};
  const std::vector<LoadCase> cases = {{{10, 20, 30, 20, 15}}, {{5, 5, 5, 5, 5}}};
  const ChainResponse chain = predict_chain(segments, {}, cases);
  EXPECT_EQ(chain.responses[0].laws, chain.responses[3].laws);
  EXPECT_EQ(chain.responses[1].laws[0], chain.responses[0].laws[1]);  // the one of 2 mm
  EXPECT_TRUE(chain.responses[2].laws.empty());
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const Response alone = predict(segments[s], {}, chain.pressures_kpa[s]);
    EXPECT_EQ(chain.responses[s].laws.size(), alone.laws.size());
    for (std::size_t i = 0; i < alone.states.size(); ++i) {
      EXPECT_EQ(chain.responses[s].states[i]->stretch, alone.states[i]->stretch);
      EXPECT_EQ(chain.responses[s].states[i]->bend_rad_per_mm, alone.states[i]->bend_rad_per_mm);
      EXPECT_EQ(chain.responses[s].states[i]->twist_rad_per_mm, alone.states[i]->twist_rad_per_mm);
    }
  }
}

TEST(ChainResponse, CasesMustFitTheChain) {
  const std::vector<Segment> segments = {paper_segment({36}), paper_segment({60})};
  const auto predicted = [&](const LoadCase& load) {
    return predict_chain(segments, {}, std::vector{load});
  };
  EXPECT_THROW(predicted({{20}}), std::invalid_argument);
  EXPECT_THROW(predicted({{20, 20, 20}}), std::invalid_argument);
  EXPECT_THROW(predicted({{20, std::nan("")}}), std::invalid_argument);
  EXPECT_TRUE(predict_chain(segments, {}, {}).cases.empty());
}

}  // namespace
}  // namespace latticast::testing
