// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/liner_mold.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "design/units.h"
#include "molds/cannot_mold.h"
#include "molds/mold_rings.h"
#include "tests/unit/molds/apart.h"
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

// The paper's: rings of 2 mm, four columns, so that the lattice's volume is easily counted.
Segment reinforced() {
  Segment segment = tube(12, 4, 85);
  segment.lattice.emplace();
  segment.lattice->thickness_mm = 2;
  segment.lattice->rings.emplace();
  segment.lattice->rings->count = 8;
  segment.lattice->rings->width_mm = 2;
  Grid columns;
  columns.angle_deg = 90;
  columns.widths_mm = {2, 2, 2, 2};
  segment.lattice->grids = {columns};
  return segment;
}

double ring(double outer, double inner) {
  return pi * (outer * outer - inner * inner);
}

double shells_volume_mm3(const Mold& mold) {
  double sum = 0;
  for (const MoldPiece& piece : mold.pieces) {
    if (piece.name.starts_with("shell-")) sum += piece.solid.volume_mm3;
  }
  return sum;
}

const MoldPiece& piece_named(const Mold& mold, const std::string& name) {
  const auto found = std::find_if(mold.pieces.begin(), mold.pieces.end(),
                                  [&](const MoldPiece& piece) { return piece.name == name; });
  EXPECT_NE(found, mold.pieces.end()) << name;
  return *found;
}

// Windows of the cap; a closed liner's has a hole in its middle as well.
int cap_genus(LinerEnds ends) {
  return ends == LinerEnds::closed ? 4 : 3;
}

void expect_sound_mold(const Mold& mold, const LinerMoldOptions& options, double lift_mm) {
  const bool closed = options.ends == LinerEnds::closed;
  EXPECT_EQ(static_cast<int>(mold.pieces.size()), options.pieces + (closed ? 2 : 3));
  for (const MoldPiece& piece : mold.pieces) {
    SCOPED_TRACE(piece.name);
    expect_sound(piece.solid, piece.name == "cap" ? cap_genus(options.ends) : 0);
    EXPECT_EQ(piece.pulls_sideways, piece.name.starts_with("shell-"));
    EXPECT_FALSE(piece.use.empty());
  }
  expect_apart(mold, lift_mm);
}

// Shell, seams and grooves make a tube with a step at each flange.
void expect_complete(const Mold& mold, const LinerCavity& cavity, const LinerMoldOptions& options) {
  const double outside = cavity.flange_radius_mm + options.fit.wall_mm;
  const double height = cavity.height_mm;
  const double free = height - 2 * std::min(6.0, height / 4);
  const int grooves = free >= 24 ? 2 : free >= 9 ? 1 : 0;
  const double depth = std::min(1.5, options.fit.wall_mm / 3);
  const double tube = ring(outside, cavity.bore_radius_mm) * height -
                      2 * cavity.flange_mm * ring(cavity.flange_radius_mm, cavity.bore_radius_mm) -
                      grooves * 6 * ring(outside, outside - depth);
  const double seams = options.pieces * options.fit.clearance_mm / (2 * pi * cavity.bore_radius_mm);
  EXPECT_NEAR(shells_volume_mm3(mold), tube * (1 - seams), 1e-4 * tube);
}

TEST(LinerMold, OfTheTwistingActuatorIsSoundApartAndComplete) {
  const LinerMoldOptions options;
  const Mold mold = liner_mold(reinforced(), options);
  expect_sound_mold(mold, options, 0.01);
  EXPECT_NEAR(mold.cavity_mm3, ring(16, 12) * 85, 1e-9);
  // Shell from 16 to 21 mm, two grooves 6 mm wide and 1.5 mm deep, seams of 0.3 mm along the bore.
  const double shell = ring(21, 16) * 85 - 2 * ring(21, 19.5) * 6;
  EXPECT_NEAR(shells_volume_mm3(mold), shell * (1 - 0.6 / (2 * pi * 16)), 1e-5 * shell);
  // Core: 5 mm below, 4.7 mm above; two chamfers of 1 mm.
  const double frustum = pi / 3 * (144 + 12 * 11 + 121);
  EXPECT_NEAR(piece_named(mold, "core").solid.volume_mm3, pi * 144 * 92.7 + 2 * frustum, 1e-2);
  // Windows of a sixth of the turn each through the cap's 9 mm, from socket and wall to the bore.
  EXPECT_NEAR(
      piece_named(mold, "base").solid.volume_mm3 - piece_named(mold, "cap").solid.volume_mm3,
      ring(16, 12.95) * 9 / 2, 1e-2);
}

TEST(LinerMold, EveryShellPieceSlidesOutAlongItsPull) {
  for (const int pieces : {2, 3, 8}) {
    LinerMoldOptions options;
    options.pieces = pieces;
    const Mold mold = liner_mold(reinforced(), options);
    // The casting with its core, less wide by the stated undercut and the facets' errors.
    Mold parting;
    parting.pieces.push_back({"casting", core_solid({16 - 0.035, 1, 84, 0.5}, 0.01), ""});
    for (const MoldPiece& piece : mold.pieces) {
      if (piece.pulls_sideways) parting.pieces.push_back(piece);
    }
    for (std::size_t moved = 1; moved < parting.pieces.size(); ++moved) {
      for (const double step : {0.02, 0.1, 0.5, 2.0, 10.0, 50.0}) {
        SCOPED_TRACE(testing::Message() << moved << " of " << pieces << ", " << step << " mm out");
        Mold opened = parting;
        MoldPiece& piece = opened.pieces[moved];
        for (Point& p : piece.solid.mesh.vertices) {
          p[0] += step * std::cos(piece.pull_rad);
          p[1] += step * std::sin(piece.pull_rad);
        }
        expect_apart(opened, 0);
      }
    }
  }
}

TEST(LinerMold, StatesTheUndercutOfHalfShells) {
  const auto undercut = [](const std::string& note) {
    return note.find("0.011 mm behind") != std::string::npos;
  };
  // Tips 0.75 - 0.15 mm past the middle of a bore of 16 mm: 16 (1 - cos(0.6 / 16)).
  LinerMoldOptions options;
  const std::vector<std::string> halves = liner_mold(reinforced(), options).notes;
  EXPECT_EQ(std::count_if(halves.begin(), halves.end(), undercut), 1);
  options.pieces = 3;
  EXPECT_TRUE(liner_mold(reinforced(), options).notes.empty());
}

TEST(LinerMold, ClosedEndHasItsCoreOnTheBase) {
  LinerMoldOptions options;
  options.ends = LinerEnds::closed;
  const Mold mold = liner_mold(tube(12, 4, 85), options);
  expect_sound_mold(mold, options, 0.01);
  EXPECT_NEAR(mold.cavity_mm3, ring(16, 12) * 81 + pi * 256 * 4, 1e-9);
  double highest = 0;
  for (const Point& p : piece_named(mold, "base").solid.mesh.vertices) {
    highest = std::max(highest, p[2]);
  }
  EXPECT_NEAR(highest, 81, 1e-9);
}

TEST(LinerMold, FlangesReachOverTheLattice) {
  LinerMoldOptions options;
  options.ends = LinerEnds::flanged;
  options.pieces = 3;
  const Mold mold = liner_mold(reinforced(), options);
  expect_sound_mold(mold, options, 0.01);
  EXPECT_NEAR(mold.cavity_mm3, ring(16, 12) * 85 + ring(18, 12) * 4, 1e-9);
  const double shell = ring(23, 18) * 89 + ring(18, 16) * 85 - 2 * ring(23, 21.5) * 6;
  EXPECT_NEAR(shells_volume_mm3(mold), shell * (1 - 0.9 / (2 * pi * 16)), 1e-5 * shell);
}

TEST(LinerMold, KeyedTakesTheFinishedLattice) {
  LinerMoldOptions options;
  options.keyed = true;
  const Mold mold = liner_mold(reinforced(), options);
  expect_sound_mold(mold, options, 0.01);
  // Eight rings of 2 mm, and four columns of 2 mm at R = 17 on the 69 mm between them.
  const double lattice = ring(18, 16) * (16 + 69 * 8 / (2 * pi * 17));
  EXPECT_NEAR(mold.cavity_mm3, ring(18.15, 12) * 85 - lattice, 0.2);
  Mold filled = mold;
  filled.pieces.push_back({"lattice", lattice_solid(reinforced(), {}), ""});
  expect_apart(filled, 0.01);
}

TEST(LinerMold, GrowthScalesTheCavity) {
  LinerMoldOptions options;
  options.fit.growth = 1.05;
  const Mold grown = liner_mold(reinforced(), options);
  expect_sound_mold(grown, options, 0.01);
  EXPECT_NEAR(grown.cavity_mm3, 1.05 * 1.05 * 1.05 * ring(16, 12) * 85, 1e-6);
  EXPECT_NE(grown.notes.at(0).find("5 % larger"), std::string::npos);
  options.keyed = true;
  const LinerCavity keyed = liner_cavity(reinforced(), options);
  EXPECT_DOUBLE_EQ(keyed.core_radius_mm, 12.6);
  EXPECT_DOUBLE_EQ(keyed.bore_radius_mm, 18.15);
  EXPECT_DOUBLE_EQ(keyed.height_mm, 85);
}

TEST(LinerMold, ThinThickShortLongNarrowAndWide) {
  struct Case {
    double inner, thickness, length, clearance, wall;
    LinerEnds ends;
    int pieces;
  };
  const Case cases[] = {{12, 0.05, 85, 0.3, 5, LinerEnds::open, 2},
                        {12, 0.05, 85, 0.3, 5, LinerEnds::closed, 2},
                        {12, 40, 85, 0.3, 5, LinerEnds::open, 4},
                        {12, 4, 0.1, 0.3, 5, LinerEnds::open, 2},
                        {12, 0.05, 0.1, 0.3, 5, LinerEnds::closed, 2},
                        {12, 4, 1000, 0.3, 5, LinerEnds::open, 2},
                        {1, 1, 20, 0.3, 5, LinerEnds::open, 2},
                        {1, 0.05, 20, 0.15, 1, LinerEnds::closed, 2},
                        {200, 5, 300, 0.3, 8, LinerEnds::open, 8},
                        {200, 5, 300, 0.3, 8, LinerEnds::closed, 100},
                        {12, 4, 85, 0.001, 5, LinerEnds::open, 2},
                        {12, 4, 85, 4.9, 5, LinerEnds::open, 2},
                        {12, 0.05, 85, 12, 20, LinerEnds::open, 2},
                        {12, 0.05, 30, 0.0499, 0.05, LinerEnds::open, 3}};
  for (const Case& c : cases) {
    SCOPED_TRACE(testing::Message() << c.inner << ", " << c.thickness << ", " << c.length << ", "
                                    << c.clearance << ", " << c.wall << ", " << c.pieces);
    LinerMoldOptions options;
    options.fit.clearance_mm = c.clearance;
    options.fit.wall_mm = c.wall;
    options.ends = c.ends;
    options.pieces = c.pieces;
    const Segment segment = tube(c.inner, c.thickness, c.length);
    const Mold mold = liner_mold(segment, options);
    expect_sound_mold(mold, options, 0.01);
    expect_complete(mold, liner_cavity(segment, options), options);
  }
}

std::string refusal(const Segment& segment, const LinerMoldOptions& options) {
  try {
    liner_mold(segment, options);
  } catch (const CannotMold& refused) {
    return refused.what();
  }
  return "";
}

TEST(LinerMold, RefusesWithAReason) {
  const auto expect = [](const Segment& segment, const LinerMoldOptions& options,
                         const std::string& part) {
    const std::string reason = refusal(segment, options);
    EXPECT_NE(reason.find(part), std::string::npos) << reason;
  };
  LinerMoldOptions one_piece;
  one_piece.pieces = 1;
  expect(reinforced(), one_piece, "two pieces or more");
  LinerMoldOptions loose;
  loose.fit.clearance_mm = 5;
  expect(reinforced(), loose, "not more than the clearance");
  LinerMoldOptions no_gap;
  no_gap.fit.clearance_mm = 0;
  expect(reinforced(), no_gap, "must be positive");
  LinerMoldOptions flanged;
  flanged.ends = LinerEnds::flanged;
  expect(tube(12, 4, 85), flanged, "flanges needs a lattice");
  flanged.keyed = true;
  expect(reinforced(), flanged, "between flanges");
  LinerMoldOptions keyed;
  keyed.keyed = true;
  expect(tube(12, 4, 85), keyed, "keyed mold needs a lattice");
  keyed.fit.growth = 1.34;
  expect(reinforced(), keyed, "leaves no liner");
  LinerMoldOptions closed;
  closed.ends = LinerEnds::closed;
  expect(tube(12, 4, 4), closed, "longer segment or open ends");
  LinerMoldOptions slivers;
  slivers.pieces = 100;
  expect(tube(1, 1, 20), slivers, "use fewer pieces");
}

TEST(LinerMold, RandomOnesAreSoundOrRefused) {
  constexpr unsigned seed = 20240607;
  std::mt19937 random(seed);
  const auto pick = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution(0.0, 1.0)(random));
  };
  int made = 0;
  for (int i = 0; i < 100; ++i) {
    Segment segment = tube(pick(1, 200), pick(0.05, 40), pick(0.1, 1000));
    segment.lattice.emplace();
    segment.lattice->thickness_mm = pick(0.1, 10);
    segment.lattice->rings.emplace();
    segment.lattice->rings->count = 2;
    segment.lattice->rings->width_mm = segment.length_mm / 5;
    LinerMoldOptions options;
    options.fit.clearance_mm = pick(0.05, 3);
    options.fit.wall_mm = pick(0.3, 20);
    options.fit.growth = pick(0.97, 1.1);
    options.ends = static_cast<LinerEnds>(std::uniform_int_distribution(0, 2)(random));
    options.keyed = std::uniform_int_distribution(0, 3)(random) == 0;
    options.pieces = static_cast<int>(pick(2, 20));
    SCOPED_TRACE(testing::Message()
                 << "seed " << seed << ", mold " << i << ": R_i " << segment.inner_radius_mm()
                 << ", liner " << segment.liner.thickness_mm << ", length " << segment.length_mm
                 << ", lattice " << segment.lattice->thickness_mm << ", clearance "
                 << options.fit.clearance_mm << ", wall " << options.fit.wall_mm << ", growth "
                 << options.fit.growth << ", ends " << static_cast<int>(options.ends) << ", keyed "
                 << options.keyed << ", pieces " << options.pieces);
    try {
      const Mold mold = liner_mold(segment, options);
      expect_sound_mold(mold, options, 0.01);
      expect_complete(mold, liner_cavity(segment, options), options);
      ++made;
    } catch (const CannotMold& refused) {
      EXPECT_GT(std::string(refused.what()).size(), 40U);
    }
  }
  EXPECT_GT(made, 60);
}

}  // namespace
}  // namespace latticast
