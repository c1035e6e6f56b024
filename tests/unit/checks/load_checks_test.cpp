// SPDX-License-Identifier: GPL-3.0-or-later
// Checks under load beyond their two designs: remedies work, limits are inclusive, a shipped
// example has nothing worse than notes, and what is found agrees with the model's own answers.
#include "checks/load_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "checks/loaded_segment.h"
#include "checks/strand_stations.h"
#include "design/material_library.h"
#include "design/read_design.h"
#include "model/segment_response.h"
#include "model/shape/inflated_wall.h"
#include "tests/unit/checks/checked_designs.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

Design design_of(const Segment& segment, std::initializer_list<double> pressures_kpa) {
  Design design;
  design.name = "test";
  design.segments = {segment};
  for (const double pressure : pressures_kpa) design.load.push_back({{pressure}});
  return design;
}

const CheckFinding* find(const CheckFindings& findings, std::string_view code) {
  const auto found = std::find_if(findings.begin(), findings.end(),
                                  [&](const CheckFinding& entry) { return entry.code == code; });
  return found == findings.end() ? nullptr : &*found;
}

CheckFindings check(const Segment& segment, std::initializer_list<double> pressures_kpa) {
  return findings_under_load(design_of(segment, pressures_kpa));
}

TEST(LoadChecks, SayNothingWithoutALoad) {
  EXPECT_TRUE(check(paper_segment({9}), {}).empty());
}

TEST(LoadChecks, SayNothingAtRest) {
  EXPECT_TRUE(check(paper_segment({36}), {0}).empty());
}

// Every remedy that names a pressure is taken at its word.
TEST(LoadChecks, RemediesPass) {
  int taken = 0;
  for (const auto& folder :
       std::filesystem::directory_iterator(LATTICAST_SOURCE_DIR "/tests/checks")) {
    if (!std::filesystem::exists(folder.path() / "rejected.toml")) continue;  // a mesh
    const ReadResult read = read_design_file(folder.path() / "rejected.toml", built_in_materials());
    ASSERT_TRUE(read.ok()) << folder.path();
    const std::string code = folder.path().filename();
    const CheckFindings findings = findings_under_load(read.design);
    const CheckFinding* finding = find(findings, code);
    if (finding == nullptr) continue;  // not a check under load
    const std::size_t at = finding->remedy.find(" to ");
    if (finding->remedy.rfind("pressure ", 0) != 0) continue;
    ++taken;
    Design mended = read.design;
    mended.load = {{{std::strtod(finding->remedy.c_str() + at + 4, nullptr)}}};
    EXPECT_NE(mended.load[0].pressures_kpa[0], 0) << code;
    EXPECT_EQ(find(findings_under_load(mended), code), nullptr) << code << ": " << finding->remedy;
  }
  EXPECT_GE(taken, 12);
}

TEST(LoadChecks, GiveTheLimitPointOfTheModel) {
  const Segment bare = tube(12, 16, NeoHookean{0.08});
  const double limit = predict(bare, {}, std::array{100.0}).critical_points.at(0).pressure_kpa;
  const CheckFindings findings = check(bare, {30});
  const CheckFinding* finding = find(findings, "limit-point");
  ASSERT_NE(finding, nullptr);
  EXPECT_NEAR(*finding->pressure_kpa, limit, 1e-6 * limit);
  EXPECT_EQ(*finding->value, 30);
  // The margin is inclusive, to within rounding.
  EXPECT_EQ(find(check(bare, {limit / 1.25}), "limit-point-near"), nullptr);
  EXPECT_NE(find(check(bare, {limit / 1.25 * (1 + 1e-6)}), "limit-point-near"), nullptr);
}

TEST(LoadChecks, LookBetweenTheAskedPressuresAndRest) {
  // No state exists at the only asked pressure; the liner tears before.
  Segment bare = tube(12, 16, NeoHookean{0.08});
  bare.liner.material.elongation_at_break = 0.1;
  EXPECT_NE(find(check(bare, {30}), "liner-overstrained"), nullptr);
}

TEST(LoadChecks, TakeEverySegmentAtItsOwnPressures) {
  Segment tearing = paper_segment({36});
  tearing.liner.material.elongation_at_break = 0.2;
  Design design = design_of(tearing, {});
  design.segments.push_back(tearing);
  design.load = {{{5, 40}}, {{10, 0}}};
  const CheckFindings findings = findings_under_load(design);
  const CheckFinding* finding = find(findings, "liner-overstrained");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->segment, 2);
  EXPECT_EQ(finding->part, "liner");
}

TEST(LoadChecks, KeepTheEndsOfALoadOfThousands) {
  Design design = design_of(paper_segment({36}), {});
  for (int i = 0; i <= 3000; ++i) design.load.push_back({{-4 + 0.01 * i}});
  PreparedResponses responses(design);
  const LoadedSegment loaded = load_segment(responses, 0);
  EXPECT_LE(loaded.pressures_kpa.size(), 64U + 14);
  EXPECT_EQ(loaded.pressures_kpa.front(), -4);
  EXPECT_EQ(loaded.pressures_kpa.back(), 26);
  EXPECT_EQ(loaded.states().size(), loaded.pressures_kpa.size());
  EXPECT_EQ(loaded.response.states.size(), loaded.pressures_kpa.size() + 2);
}

TEST(LoadChecks, FindThePressureAtWhichALimitIsReached) {
  Segment tearing = paper_segment({36});
  tearing.liner.material.elongation_at_break = 0.3;
  const CheckFindings findings = check(tearing, {60});
  const CheckFinding* finding = find(findings, "liner-overstrained");
  ASSERT_NE(finding, nullptr);
  const State state = *predict(tearing, {}, std::array{*finding->pressure_kpa}).states[0];
  const double strain = std::max(wall_stretch(tearing, state, 12, 0).largest_principal(),
                                 wall_stretch(tearing, state, 16, 0).largest_principal()) -
                        1;
  EXPECT_GE(strain, 0.3);
  EXPECT_LT(strain, 0.303);
}

// A strip's strain by its end points: the distance of two points of a strand, moved.
TEST(LoadChecks, StrainStrandsAsTheirPointsMove) {
  const Segment segment = paper_segment({36});
  const State state = *predict(segment, {}, std::array{40.0}).states[0];
  const double angle = 36 * degree;
  for (const double radius : {16.0, 17.0, 18.0}) {
    const WallStretch at = wall_stretch(segment, state, radius, 0);
    const double short_way = 1e-6;
    const double turn =
        short_way * std::cos(angle) / radius + state.twist_rad_per_mm * short_way * std::sin(angle);
    const double along = state.stretch * short_way * std::sin(angle);
    EXPECT_NEAR(at.along(angle), std::hypot(at.radius_mm * turn, along) / short_way, 1e-9);
    EXPECT_NEAR(std::tan(at.turned_rad(angle)), along / (at.radius_mm * turn), 1e-9);
  }
}

// Arcs of more than a half circle come nearest to the next but one: two circles 2 c apart.
TEST(LoadChecks, SeeAnArcTouchTheNextButOne) {
  const double radius = 85 / (16 * 2 * std::sin(110 * degree));
  const double width = 4 * radius * std::sin(110 * degree) - 2 * radius - 0.2;
  const Segment segment = columns(std::vector<double>(4, width), 90, {radius, 220, true});
  const CheckFindings findings = check(segment, {-60});
  const CheckFinding* finding = find(findings, "strands-touch-inflated");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->part, "grid 1");
  const double at = *finding->pressure_kpa;
  EXPECT_LT(at, 0);
  EXPECT_EQ(find(check(segment, {0.98 * at}), "strands-touch-inflated"), nullptr);
  EXPECT_NE(find(check(segment, {1.02 * at}), "strands-touch-inflated"), nullptr);

  const State state = *predict(segment, {}, std::array{at}).states[0];
  const double length = radius * 220 * degree;
  const double chord =
      2 * radius * std::sin(110 * degree) * wall_stretch(segment, state, 17, 0).along(90 * degree);
  double half = 110 * degree;  // of the present arc, whose chord is length sin(half) / half
  for (int i = 0; i < 60; ++i) {
    const double slope = length * (half * std::cos(half) - std::sin(half)) / (half * half);
    half -= (length * std::sin(half) / half - chord) / slope;
  }
  EXPECT_NEAR(2 * chord - length / half - width, 0, 0.002);
  EXPECT_GT(length / half, width);  // each arc by itself is open
}

// Arcs to one side meet their neighbours in joints; beyond a half circle they cross there.
TEST(LoadChecks, SeeOneSidedArcsCrossBeyondAHalfCircle) {
  const double half = 87 * degree;
  const double radius = 85 / (16 * 2 * std::sin(half));
  const Segment segment = columns(std::vector<double>(4, 0.5), 90, {radius, 174, false});
  const CheckFindings findings = check(segment, {-60});
  const CheckFinding* finding = find(findings, "strands-touch-inflated");
  ASSERT_NE(finding, nullptr);
  const double at = *finding->pressure_kpa;
  EXPECT_LT(at, 0);
  EXPECT_EQ(find(check(segment, {0.98 * at}), "strands-touch-inflated"), nullptr);
  // A half circle's chord is its length times 2 / pi.
  const State state = *predict(segment, {}, std::array{at}).states[0];
  const double chord =
      2 * radius * std::sin(half) * wall_stretch(segment, state, 17, 0).along(90 * degree);
  EXPECT_NEAR(chord / (2 * radius * half), 2 / pi, 2e-3);
}

TEST(LoadChecks, KnowBothSidesOfABend) {
  const Segment segment = columns(halves(16, 4, 2));
  const State state = *predict(segment, {}, std::array{40.0}).states[0];
  const double side = lengthened_side_rad(state);
  const WallStretch longer = wall_stretch(segment, state, 16, side);
  const WallStretch shorter = wall_stretch(segment, state, 16, side + pi);
  EXPECT_NEAR(0.5 * (longer.axial + shorter.axial), state.stretch, 1e-12);
  EXPECT_NEAR(longer.axial - shorter.axial,
              2 * longer.radius_mm * state.bend_magnitude_rad_per_mm(), 1e-12);
  // The tube bends toward the wide columns, which are strands 0 to 7: they are the shortened ones.
  const auto stations = strand_stations(segment, segment.lattice->grids[0], state);
  ASSERT_EQ(stations.size(), 16U);
  for (const StrandStation& station : stations) {
    const WallStretch at = wall_stretch(segment, state, 17, station.theta_rad);
    if (station.strand != 0 && station.strand != 7 && station.strand != 8 && station.strand != 15) {
      EXPECT_EQ(at.axial < state.stretch, station.width_mm == 4) << station.strand;
    }
  }
}

TEST(LoadChecks, NameAGentRubberNearItsLimit) {
  Segment segment = paper_segment({36});
  segment.liner.material.law = Gent{0.08, 1.5};
  const CheckFindings findings = check(segment, {200});
  const CheckFinding* finding = find(findings, "liner-law-exceeded");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->unit, "of Jm");
  EXPECT_GT(*finding->value, 0.9);
  segment.liner.material.law = Gent{0.08, 50};
  EXPECT_EQ(find(check(segment, {60}), "liner-law-exceeded"), nullptr);
}

/// Columns with a wave of 10.625 mm.
Segment ringed_columns(double pitch_mm, double phase) {
  Segment segment = columns(std::vector<double>(16, 2.0));
  segment.lattice->rings = Rings{std::nullopt, pitch_mm, 2, phase};
  return segment;
}

TEST(LoadChecks, NameThePlaceOfRingsInStepWithTheWaves) {
  constexpr double wave = 10.625;
  struct Place {
    double pitch_in_waves;
    double phase;
    const char* text;
  };
  for (const Place& place :
       {Place{1, 0.5, "first at 0.00 of a wave and the last at 0.00"},
        Place{1, 0.25, "first at 0.25 of a wave and the last at 0.25"},
        Place{0.5, 0.5, "first at 0.25 of a wave"}, Place{2, 0.45, "first at 0.40 of a wave"},
        Place{1.01, 0.25, "first at 0.25 of a wave and the last at 0.32"}}) {
    SCOPED_TRACE(place.text);
    const CheckFindings findings =
        check(ringed_columns(place.pitch_in_waves * wave, place.phase), {20});
    const CheckFinding* finding = find(findings, "rings-in-step");
    ASSERT_NE(finding, nullptr);
    EXPECT_EQ(finding->part, "grid 1");
    EXPECT_NE(finding->message.find(place.text), std::string::npos) << finding->message;
  }
  EXPECT_EQ(find(check(ringed_columns(1.25 * wave, 0.5), {20}), "rings-in-step"), nullptr);
  EXPECT_EQ(find(check(ringed_columns(0.24 * wave, 0.5), {20}), "rings-in-step"), nullptr);
  Segment drifting = ringed_columns(1.019 * wave, 0.5);
  drifting.length_mm *= 2;
  EXPECT_EQ(find(check(drifting, {20}), "rings-in-step"), nullptr);
}

TEST(LoadChecks, SayHowRingsGetOutOfStep) {
  const CheckFindings findings = check(ringed_columns(10.625, 0.5), {20});
  const CheckFinding* finding = find(findings, "rings-in-step");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->remedy,
            "rings.pitch = 11.95 spreads them over the waves; rings.pitch = 10.625, phase = 0.25 "
            "puts them on the bulges");
  EXPECT_EQ(find(check(ringed_columns(11.95, 0.5), {20}), "rings-in-step"), nullptr);
  const CheckFindings on_bulges = check(ringed_columns(10.625, 0.25), {20});
  EXPECT_NE(find(on_bulges, "rings-in-step")->message.find("first at 0.25"), std::string::npos);
}

TEST(LoadChecks, CarryTheBandToNoEquilibrium) {
  Segment bare = tube(12, 16, NeoHookean{0.08});
  bare.liner.material.modulus_low_factor = 0.5;
  const CheckFindings findings = check(bare, {10});
  const CheckFinding* finding = find(findings, "modulus-band");
  ASSERT_NE(finding, nullptr);
  EXPECT_NE(finding->message.find("no equilibrium"), std::string::npos) << finding->message;
}

TEST(LoadChecks, CoverEffectiveRods) {
  Segment segment = columns(halves(16, 3, 2), 90, {3.5, 170, true});
  segment.liner.material.law = Linear{0.082, 0.499};
  segment.liner.material.elongation_at_break = 0.2;
  Design design = design_of(segment, {80});
  design.model.columns = ColumnModel::rods;
  const CheckFindings findings = findings_under_load(design);
  EXPECT_NE(find(findings, "liner-overstrained"), nullptr);
  EXPECT_EQ(find(findings, "not-predictable"), nullptr);
}

TEST(LoadChecks, SurviveRandomDesigns) {
  constexpr unsigned seed = 20240611;
  Random random(seed);
  for (int i = 0; i < 60; ++i) {
    Segment segment = tube(random.log_between(3, 30), 0, NeoHookean{random.log_between(0.01, 1)});
    segment.liner.thickness_mm = random.between(0.05, 0.5) * segment.liner.inner_radius_mm;
    Lattice lattice;
    lattice.thickness_mm = random.between(0.05, 0.3) * segment.liner.inner_radius_mm;
    lattice.material.law = Linear{random.log_between(1, 1000), 0.5};
    if (random.chance(0.8)) lattice.rings = Rings{random.integer(2, 30), std::nullopt, 1};
    const double around = 2 * pi * segment.liner_outer_radius_mm();
    if (random.chance(0.8)) {
      const double angle = random.between(5, 175);
      const int count = random.integer(1, 12);
      const double width = random.between(0.05, 0.8) * around * std::sin(angle * degree) / count;
      lattice.grids.push_back(grid(angle, count, width));
    }
    segment.lattice = lattice;
    const double modulus = std::get<NeoHookean>(segment.liner.material.law).shear_modulus_mpa;
    const double pressure = 1000 * modulus * random.between(-0.5, 1.5);
    for (const CheckFinding& finding : check(segment, {pressure})) {
      EXPECT_FALSE(finding.message.empty()) << "seed " << seed << ", " << i;
      EXPECT_FALSE(finding.remedy.empty()) << "seed " << seed << ", " << i;
      EXPECT_EQ(finding.message.find("nan"), std::string::npos) << finding.message;
      EXPECT_FALSE(std::isnan(finding.value.value_or(0))) << finding.code;
      EXPECT_TRUE(std::isfinite(finding.limit.value_or(0))) << finding.code;
    }
  }
}

}  // namespace
}  // namespace latticast::testing
