// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/report_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "checks/check_design.h"
#include "checks/check_finding.h"
#include "model/shape/shape.h"
#include "prepared/prepared_design.h"
#include "report/view_json.h"
#include "tests/unit/report/report_examples.h"

namespace latticast {
namespace {

using nlohmann::json;
using Quaternion = std::array<double, 4>;  // x, y, z, w

Point turned(const Quaternion& q, const Point& p) {
  // p + 2 v x (v x p + w p)
  const auto cross = [](const Point& a, const Point& b) -> Point {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const Point v{q[0], q[1], q[2]};
  Point inner = cross(v, p);
  for (int i = 0; i < 3; ++i) inner[i] += q[3] * p[i];
  const Point outer = cross(v, inner);
  return {p[0] + 2 * outer[0], p[1] + 2 * outer[1], p[2] + 2 * outer[2]};
}

Point placed(const json& end, const Point& p) {
  const Point inner = turned(end["quaternion"].get<Quaternion>(), p);
  const auto origin = end["origin_mm"].get<Point>();
  return {origin[0] + inner[0], origin[1] + inner[1], origin[2] + inner[2]};
}

// A body's vertices in a state of its segment; poses leave rest out.
const std::vector<Point>& pose_in(const ViewSegment& segment, const ViewBody& body,
                                  std::size_t state) {
  std::size_t pose = 0;
  for (std::size_t i = 0; i < state; ++i) pose += segment.states[i].pressure_kpa != 0;
  return segment.states[state].pressure_kpa == 0 ? body.rest.vertices : body.poses[pose];
}

TEST(ReportView, ShowsRestAndBothEndsOfTheLoad) {
  for (const std::string& file : example_files) {
    SCOPED_TRACE(file);
    const Design design = example(file);
    PreparedDesign prepared(design);
    const ReportCurves curves = predict_curves(prepared.responses);
    const ReportView view = make_view(prepared, &curves);
    ASSERT_EQ(view.segments.size(), design.segments.size());
    for (std::size_t s = 0; s < view.segments.size(); ++s) {
      const std::vector<State>& states = view.segments[s].states;
      const std::vector<State> all = curves.segments[s].states();
      EXPECT_EQ(states.front().pressure_kpa, all.front().pressure_kpa);
      EXPECT_EQ(states.back().pressure_kpa, all.back().pressure_kpa);
      EXPECT_LE(states.size(), 27U);
      EXPECT_GE(states.size(), 4U);
      EXPECT_EQ(std::count_if(states.begin(), states.end(),
                              [](const State& state) { return state.pressure_kpa == 0; }),
                1);
      for (const ViewBody& body : view.segments[s].bodies) {
        EXPECT_EQ(body.poses.size() + 1, states.size());
      }
    }
  }
}

// What a viewer does: it chains the ends of the segments below, and puts a segment's own pose
// there.
TEST(ReportView, SegmentsPlacedByTheirEndsMakeTheChain) {
  const Design design = example("climbing_robot/climbing_robot.toml");
  PreparedDesign prepared(design);
  const ReportCurves curves = predict_curves(prepared.responses);
  const ReportView view = make_view(prepared, &curves);
  const json read = json::parse(view_json(view, design, {}));
  std::vector<State> states;
  std::vector<std::size_t> chosen;
  for (std::size_t s = 0; s < view.segments.size(); ++s) {
    // Another state in each segment.
    chosen.push_back((s + 2) % view.segments[s].states.size());
    states.push_back(view.segments[s].states[chosen[s]]);
  }
  const Shape shape(design.segments, states);
  double begin_mm = 0;
  for (std::size_t s = 0; s < view.segments.size(); ++s) {
    for (const ViewBody& body : view.segments[s].bodies) {
      const std::vector<Point>& pose = pose_in(view.segments[s], body, chosen[s]);
      for (std::size_t v = 0; v < pose.size(); v += 97) {
        Point at = pose[v];
        for (std::size_t below = s; below-- > 0;) {
          at = placed(read["segments"][below]["states"][chosen[below]]["end"], at);
        }
        Point rest = body.rest.vertices[v];
        rest[2] += begin_mm;
        const Point expected = shape.moved(rest, s);
        for (int i = 0; i < 3; ++i) ASSERT_NEAR(at[i], expected[i], 1e-9);
      }
    }
    begin_mm += design.segments[s].length_mm;
  }
}

TEST(ReportView, PinsEveryFindingThatHasAPlace) {
  const Design design = example("twisting/twisting.toml");
  PreparedDesign prepared(design);
  const ReportCurves curves = predict_curves(prepared.responses);
  const ReportView view = make_view(prepared, &curves);
  CheckFindings findings(3);
  findings[1].segment = 1;
  findings[1].place = CheckPlace{90, 40};
  findings[2].segment = 1;
  const json read = json::parse(view_json(view, design, findings));
  ASSERT_EQ(read["markers"].size(), 1U);
  const json& marker = read["markers"][0];
  EXPECT_EQ(marker["finding"], 1);
  const std::vector<State>& states = view.segments[0].states;
  ASSERT_EQ(marker["positions_mm"].size(), states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto at = marker["positions_mm"][i].get<Point>();
    EXPECT_NEAR(std::hypot(at[0], at[1]), states[i].outer_radius_mm, 1e-9);
    EXPECT_NEAR(at[2], 40 * states[i].stretch, 1e-9);
    const double turn = std::numbers::pi / 2 + 40 * states[i].twist_rad_per_mm;
    EXPECT_NEAR(std::remainder(std::atan2(at[1], at[0]) - turn, 2 * std::numbers::pi), 0, 1e-9);
  }
}

TEST(ReportView, StaysSmallForALargeLattice) {
  Design design = example("twisting/twisting.toml");
  Lattice& lattice = *design.segments[0].lattice;
  lattice.rings->count = 30;
  lattice.rings->width_mm = 0.8;
  lattice.grids[0].widths_mm.assign(20, 0.8);
  design.output.tolerance_mm = 1e-4;
  PreparedDesign prepared(design);
  const ReportCurves curves = predict_curves(prepared.responses);
  const ReportView view = make_view(prepared, &curves);
  EXPECT_GE(view.tolerance_mm, 0.05);
  EXPECT_EQ(view.note.empty(), view.tolerance_mm == 0.05);
  std::size_t vertices = 0;
  for (const ViewBody& body : view.segments[0].bodies) {
    vertices += body.rest.vertices.size() * (body.poses.size() + 1);
  }
  EXPECT_TRUE(vertices <= 110000 || view.tolerance_mm > 0.5) << vertices;
}

TEST(ReportView, ShowsRestAloneWithoutALoad) {
  const Design design = example("twisting/twisting.toml");
  PreparedDesign prepared(design);
  const ReportView view = make_view(prepared, nullptr);
  ASSERT_EQ(view.segments[0].states.size(), 1U);
  EXPECT_EQ(view.segments[0].states[0].pressure_kpa, 0);
  const json end = json::parse(view_json(view, design, {}))["segments"][0]["states"][0]["end"];
  EXPECT_DOUBLE_EQ(end["origin_mm"][2], 85);
  EXPECT_DOUBLE_EQ(end["quaternion"][3], 1);
}

}  // namespace
}  // namespace latticast
