// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/plan.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "app/products.h"
#include "design/design.h"

namespace latticast {
namespace {

Design strips() {
  Design design;
  Segment& segment = design.segments.emplace_back();
  segment.length_mm = 85;
  segment.liner = {12, 4, {}};
  segment.lattice.emplace();
  segment.lattice->grids.push_back({.angle_deg = 36, .widths_mm = {2, 2}, .path = {}});
  design.make.lattice = true;
  return design;
}

const PlannedStage& planned(const Plan& plan, Stage stage) {
  return *std::find_if(plan.stages.begin(), plan.stages.end(),
                       [&](const PlannedStage& entry) { return entry.stage == stage; });
}

Make everything() {
  Make make;
  make.lattice = make.liner = make.flat_pattern = make.report = true;
  make.deck.emplace();
  make.preview.emplace();
  make.lattice_mold.emplace();
  make.liner_mold.emplace();
  return make;
}

TEST(Products, AreAskedForUntilTheyAreLeftOut) {
  std::set<std::string_view> names;
  for (const Product& product : products()) {
    EXPECT_FALSE(product.asked(Make{})) << name(product.stage);
    Make make = everything();
    EXPECT_TRUE(product.asked(make)) << name(product.stage);
    product.leave_out(make);
    EXPECT_FALSE(product.asked(make)) << name(product.stage);
    for (const Product& other : products()) {
      EXPECT_EQ(other.asked(make), other.stage != product.stage) << name(other.stage);
    }
    EXPECT_TRUE(names.insert(name(product.stage)).second);
    std::string key(product.key);  // [make] writes flat_pattern, the command line flat-pattern
    std::replace(key.begin(), key.end(), '_', '-');
    EXPECT_EQ(key, name(product.stage));
  }
}

TEST(Products, AreListedAsTheCommandLineTakesThem) {
  EXPECT_EQ(product_words(false),
            "lattice, liner, flat-pattern, preview, lattice-mold, liner-mold, molds, deck, report");
  EXPECT_EQ(product_words(true), "lattice, liner, flat-pattern, preview, molds, deck, report");
}

TEST(Plan, SaysWhyEachStageRunsOrNot) {
  Design design = strips();
  design.make.report = true;
  EXPECT_EQ(describe(plan_build(design, {"lattice"})),
            "skip  prediction     nothing that is made needs a deformed shape\n"
            "skip  horseshoe-law  nothing that is made needs a deformed shape\n"
            "skip  bending        nothing that is made needs a deformed shape\n"
            "run   lattice        [make] names lattice\n"
            "skip  liner          [make] does not name liner\n"
            "skip  flat-pattern   [make] does not name flat_pattern\n"
            "skip  preview        [make] does not name preview\n"
            "skip  lattice-mold   [make] does not name lattice_mold\n"
            "skip  liner-mold     [make] does not name liner_mold\n"
            "skip  deck           [make] does not name deck\n"
            "skip  report         left out by --only\n");
}

TEST(Plan, PredictsWhatIsShownUnderPressure) {
  Design design = strips();
  design.make.preview.emplace();
  Plan plan = plan_build(design, {});
  EXPECT_EQ(planned(plan, Stage::prediction).reason, "the preview shows the shape under pressure");
  EXPECT_EQ(planned(plan, Stage::bending).reason, "every section is symmetric about its axis");
  design.segments[0].lattice->grids[0].widths_mm = {2, 3};
  plan = plan_build(design, {});
  EXPECT_TRUE(plan.runs(Stage::bending));
  design.make.preview.reset();
  design.make.report = true;
  EXPECT_FALSE(plan_build(design, {}).runs(Stage::prediction)) << "a report without a load";
  design.load.push_back({{20}});
  EXPECT_EQ(planned(plan_build(design, {}), Stage::prediction).reason,
            "the report shows the response to pressure");
}

TEST(Plan, LeavesOutLatticesThatAreNotThere) {
  Design design = strips();
  design.make = everything();
  design.segments[0].lattice.reset();
  const Plan plan = plan_build(design, {});
  for (const Stage stage : {Stage::lattice, Stage::flat_pattern, Stage::lattice_mold}) {
    EXPECT_EQ(planned(plan, stage).reason, "no segment has a lattice") << name(stage);
  }
  EXPECT_TRUE(plan.runs(Stage::liner_mold));
}

std::string refusal(const Design& design, const std::vector<std::string>& only) {
  try {
    plan_build(design, only);
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return "";
}

TEST(Plan, RefusesPartsThatAreNoneOrNotAskedFor) {
  EXPECT_EQ(refusal(strips(), {"rings"}),
            "--only rings: no such part; parts are lattice, liner, flat-pattern, preview, "
            "lattice-mold, liner-mold, molds, deck, report");
  EXPECT_FALSE(refusal(strips(), {""}).empty());
  EXPECT_EQ(refusal(strips(), {"molds"}),
            "--only molds: the design's [make] does not ask for it; add it there first");
  Design design = strips();
  design.make.liner_mold.emplace();
  const Plan plan = plan_build(design, {"molds"});
  EXPECT_TRUE(plan.runs(Stage::liner_mold));
  EXPECT_FALSE(plan.runs(Stage::lattice_mold));
  EXPECT_TRUE(runs_any(plan, &Product::is_mold));
  EXPECT_FALSE(runs_any(plan, &Product::draws_lattice));
}

TEST(Plan, CanDoEverythingInAFullBuild) {
  Design design = strips();
  design.make = everything();
  EXPECT_TRUE(unavailable(plan_build(design, {})).empty());
}

}  // namespace
}  // namespace latticast
