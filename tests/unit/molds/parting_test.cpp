// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/parting.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "design/units.h"
#include "tests/unit/molds/lattice_molds.h"

namespace latticast {
namespace {

constexpr CastLayer layer{16, 18};

Parting straight_parting(int pieces, double first_seam_rad, double length = 85) {
  return {pieces, first_seam_rad, 17, {{0, 0}, {0, length}}};
}

TEST(Parting, KnowsThePieceOfEveryPlace) {
  const Parting parting = straight_parting(4, 0.1);
  EXPECT_EQ(piece_at(parting, {17 * 0.11, 40}), 0);
  EXPECT_EQ(piece_at(parting, {17 * 0.09, 40}), 3);
  EXPECT_EQ(piece_at(parting, {17 * (0.11 + 6 * pi), 40}), 0);
  EXPECT_EQ(piece_at(parting, {-17 * pi / 2, 40}), 2);
  EXPECT_NEAR(pull_rad(parting, 0), 0.1 + pi / 4, 1e-15);
}

// A column of 2 whose far side stands at the angle phi from the pull, square to the section.
TEST(Undercut, IsDepthTimesTangentForThinLayers) {
  const CastLayer thin{17 - 0.005, 17 + 0.005};
  const double phi = 0.6;
  const Parting parting = straight_parting(4, -pi / 4);  // piece 0 is pulled along Theta = 0
  const double side = 17 * phi;
  const Pattern column{2 * pi * 17, 85, {{{{side - 2, 0}, {side, 0}, {side, 85}, {side - 2, 85}}}}};
  const Undercut worst = worst_undercut(undercut_map(column, parting, thin));
  EXPECT_NEAR(worst.undercut_mm, 0.01 * std::tan(phi), 1e-5);
  EXPECT_NEAR(worst.strand_width_mm, 2, 1e-12);
  EXPECT_NEAR(worst.strain, worst.undercut_mm / 2, 1e-15);
  EXPECT_EQ(worst.piece, 0);
}

// The corner of a land at 16 mm and phi, moved along the pull by t, is at sqrt(16^2 + t^2 + 32 t
// cos phi); where that is 18 it has come around by what it overlapped.
TEST(Undercut, IsTheWayOutOfAThickLayer) {
  for (const double phi : {0.1, 0.5, 1.0, pi / 2}) {
    const double t = -16 * std::cos(phi) + std::sqrt(18.0 * 18 - 256 * std::pow(std::sin(phi), 2));
    const double reached = std::atan2(16 * std::sin(phi), 16 * std::cos(phi) + t);
    const double side = 17 * phi - 1e-9;
    const Pattern column{
        2 * pi * 17, 85, {{{{side - 2, 0}, {side, 0}, {side, 85}, {side - 2, 85}}}}};
    const Parting halves = straight_parting(2, -pi / 2);
    const Undercut worst = worst_undercut(undercut_map(column, halves, layer));
    EXPECT_NEAR(worst.around_mm, 17 * (phi - reached), 1e-6);
  }
}

TEST(Undercut, RingsDoNotCatch) {
  const Pattern rings = draw_lattice(ringed_segment(), 0.005);
  EXPECT_TRUE(undercut_map(rings, straight_parting(2, 0), layer).empty());
}

TEST(Undercut, StripsCatchSquareToThemselves) {
  // Every strip meets every angle somewhere along the tube.
  Segment segment = twisting_segment();
  segment.lattice->rings.reset();
  const Pattern strips = draw_lattice(segment, 0.005);
  const Undercut worst =
      worst_undercut(undercut_map(strips, straight_parting(6, 0.2), layer, 0.01));
  const double phi = pi / 6;
  const double around = 17 * (phi - std::asin(16.0 / 18 * std::sin(phi)));
  EXPECT_NEAR(worst.undercut_mm, around * std::sin(36 * pi / 180), 2e-3);
  EXPECT_NEAR(worst.strand_width_mm, 2, 1e-9);
}

// Is a point of the plane inside of a strand's outline, or of a copy of it?
bool covers(const Pattern& strands, double u, double z) {
  for (const Strand& strand : strands.strands) {
    const auto [left, right] =
        std::minmax_element(strand.outline.begin(), strand.outline.end(),
                            [](const auto& a, const auto& b) { return a.u < b.u; });
    const double period = strands.circumference_mm;
    const auto last = static_cast<int>(std::floor((right->u - u) / period));
    for (auto turn = static_cast<int>(std::ceil((left->u - u) / period)); turn <= last; ++turn) {
      const double x = u + turn * period;
      bool inside = false;
      for (std::size_t i = 0; i < strand.outline.size(); ++i) {
        const PlanePoint& a = strand.outline[i];
        const PlanePoint& b = strand.outline[(i + 1) % strand.outline.size()];
        if ((a.z > z) == (b.z > z)) continue;
        if (a.u + (z - a.z) / (b.z - a.z) * (b.u - a.u) > x) inside = !inside;
      }
      if (inside) return true;
    }
  }
  return false;
}

// One height of the layer as cells around: what the strands cover.
std::vector<char> row_at(const Pattern& strands, double z, int cells) {
  std::vector<char> row(cells);
  for (int i = 0; i < cells; ++i) {
    row[i] = covers(strands, (i + 0.5) * strands.circumference_mm / cells, z) ? 1 : 0;
  }
  return row;
}

// Moves all lands of one height out along their piece's pull in small steps and looks how far
// around, beyond the strand's side, any of them comes while it is still inside of the layer. Worst
// by piece.
std::vector<double> swept_overlap(const Pattern& strands, const Parting& parting, double z) {
  constexpr int cells = 1200;
  const std::vector<char> row = row_at(strands, z, cells);
  const double cell_rad = 2 * pi / cells;
  std::vector<double> worst(parting.pieces, 0.0);
  for (int i = 0; i < cells; ++i) {
    if (row[i]) continue;
    const double theta = (i + 0.5) * cell_rad;
    const int piece = piece_at(parting, {17 * theta, z});
    const double phi = std::remainder(theta - pull_rad(parting, piece), 2 * pi);
    for (const double radius : {16.0, 17.0}) {
      double covered = 0;  // cells of strand that the point has passed and still is in
      double last = pull_rad(parting, piece) + phi;
      for (int step = 1; step < 120; ++step) {
        const double t = 0.1 * step;
        const double across = radius * std::sin(phi);
        const double out = radius * std::cos(phi) + t;
        if (std::hypot(across, out) > 18) break;
        const double now = pull_rad(parting, piece) + std::atan2(across, out);
        const double turns = now / (2 * pi);
        const auto cell =
            std::min(cells - 1, static_cast<int>((turns - std::floor(turns)) * cells));
        covered = row[cell] ? covered + std::abs(now - last) : 0;
        last = now;
        worst[piece] = std::max(worst[piece], 17 * covered);
      }
    }
  }
  return worst;
}

void expect_sweep_within_map(const Segment& segment, int pieces) {
  const Pattern strands = draw_lattice(segment, 0.005);
  PartingWish wish;
  wish.pieces = pieces;
  const Parting parting = choose_parting(strands, wish, layer);
  std::vector<double> stated(pieces, 0.0);
  for (const Undercut& u : undercut_map(strands, parting, layer)) {
    stated[u.piece] = std::max(stated[u.piece], u.around_mm);
  }
  std::vector<double> swept(pieces, 0.0);
  for (int i = 0; i < 9; ++i) {
    const double z = (i + 0.4) * segment.length_mm / 9;
    const std::vector<double> here = swept_overlap(strands, parting, z);
    for (int k = 0; k < pieces; ++k) swept[k] = std::max(swept[k], here[k]);
  }
  // A cell around, and a step of the sweep, and the spacing of the map.
  for (int k = 0; k < pieces; ++k) EXPECT_LE(swept[k], stated[k] + 0.1) << "piece " << k;
  // The statement is no more than it must be; lands of halves pass strands wholly and come out.
  if (pieces == 2) return;
  const double most_stated = *std::max_element(stated.begin(), stated.end());
  EXPECT_GE(*std::max_element(swept.begin(), swept.end()), 0.6 * most_stated - 0.1);
}

TEST(Undercut, BoundsWhatSweepingAPieceOutShows) {
  for (const int pieces : {2, 3, 5, 8}) {
    SCOPED_TRACE(pieces);
    expect_sweep_within_map(twisting_segment(), pieces);
    expect_sweep_within_map(bending_segment(), pieces);
    expect_sweep_within_map(column_segment(7, 3), pieces);
  }
}

TEST(ChooseParting, TakesNoMorePiecesThanTheStrainNeeds) {
  const Pattern strands = draw_lattice(twisting_segment(), 0.005);
  int last = 12;
  for (const double allowed : {0.2, 0.4, 1.0, 5.0}) {
    PartingWish wish;
    wish.allowed_strain = allowed;
    const Parting parting = choose_parting(strands, wish, layer);
    EXPECT_LE(worst_undercut(undercut_map(strands, parting, layer)).strain, allowed);
    EXPECT_LE(parting.pieces, last);
    last = parting.pieces;
    if (parting.pieces == 2) continue;
    wish.pieces = parting.pieces - 1;
    const Parting fewer = choose_parting(strands, wish, layer);
    EXPECT_GT(worst_undercut(undercut_map(strands, fewer, layer)).strain, allowed);
  }
  EXPECT_EQ(last, 2);
}

TEST(ChooseParting, KeepsSeamsOffColumnsThatItCanAvoid) {
  for (const int pieces : {2, 3, 4, 6}) {
    const Pattern strands = draw_lattice(column_segment(6, 2), 0.005);
    PartingWish wish;
    wish.pieces = pieces;
    const Parting parting = choose_parting(strands, wish, layer);
    for (int k = 0; k < pieces; ++k) {
      for (int i = 0; i < 85; ++i) {
        const double z = i + 0.5;
        const double u = 17 * seam_rad(parting, k) + seam_offset_mm(parting, z);
        EXPECT_FALSE(covers(strands, u, z)) << pieces << " pieces, z = " << z;
      }
    }
  }
}

TEST(ChooseParting, HalvesPassTheCoreWithinTheClearance) {
  PartingWish wish;
  wish.pieces = 2;
  const Parting parting = choose_parting(draw_lattice(twisting_segment(), 0.005), wish, layer);
  double reach = 0;
  for (const PlanePoint& p : parting.seam) reach = std::max(reach, std::abs(p.u));
  EXPECT_GT(reach, 0.5);
  EXPECT_LT(16 * (1 - std::cos(reach / 17)), 0.15);
}

}  // namespace
}  // namespace latticast
