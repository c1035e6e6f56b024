// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/report_data.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "model/shape/shape.h"
#include "prepared/prepared_responses.h"
#include "tests/unit/report/report_examples.h"

namespace latticast {
namespace {

using nlohmann::json;

ReportData report_of(const Design& design) {
  ReportData data;
  data.design = &design;
  data.program_version = "1.2.3";
  PreparedResponses responses(design);
  if (!design.load.empty()) data.curves = predict_curves(responses);
  data.times = {{"lattice", 0.25}};
  return data;
}

Design load_up_to(Design design, double highest_kpa) {
  design.load.clear();
  for (int i = 0; i <= 4; ++i) {
    design.load.push_back({std::vector<double>(design.segments.size(), highest_kpa * i / 4)});
  }
  return design;
}

TEST(ReportCurves, HoldTheAskedStatesAsPredictGivesThem) {
  for (const std::string& file : example_files) {
    SCOPED_TRACE(file);
    const Design design = example(file);
    PreparedResponses responses(design);
    const ReportCurves curves = predict_curves(responses);
    const Prediction asked = predict_design(design, {}, {}, false);
    ASSERT_EQ(curves.segments.size(), design.segments.size());
    for (std::size_t s = 0; s < design.segments.size(); ++s) {
      const ResponseCurve& curve = curves.segments[s];
      const std::vector<double>& pressures = curve.prediction.pressures_kpa;
      ASSERT_EQ(curve.asked.size(), pressures.size());
      EXPECT_TRUE(std::is_sorted(pressures.begin(), pressures.end()));
      EXPECT_EQ(std::adjacent_find(pressures.begin(), pressures.end()), pressures.end());
      EXPECT_GE(pressures.size(), 33U);
      EXPECT_EQ(static_cast<std::size_t>(std::count(curve.asked.begin(), curve.asked.end(), true)),
                asked.segments[s].pressures_kpa.size());
      for (std::size_t i = 0; i < asked.segments[s].pressures_kpa.size(); ++i) {
        const double pressure = asked.segments[s].pressures_kpa[i];
        const auto at = std::find(pressures.begin(), pressures.end(), pressure);
        ASSERT_NE(at, pressures.end());
        const auto& drawn = curve.prediction.response.states[at - pressures.begin()];
        const auto& state = asked.segments[s].response.states[i];
        ASSERT_TRUE(drawn && state);
        EXPECT_NEAR(drawn->stretch, state->stretch, 1e-9);
        EXPECT_NEAR(twist_deg(*drawn, design.segments[s]), twist_deg(*state, design.segments[s]),
                    1e-6);
      }
    }
  }
}

TEST(ReportCurves, RunUpToTheLimitPoint) {
  const Design design = load_up_to(example("twisting/twisting.toml"), 1000);
  const ReportData data = report_of(design);
  const ResponseCurve& curve = data.curves->segments[0];
  ASSERT_EQ(curve.prediction.response.critical_points.size(), 1U);
  const double limit = curve.prediction.response.critical_points[0].pressure_kpa;
  ASSERT_LT(limit, 1000);
  const double last = curve.states().back().pressure_kpa;
  EXPECT_LT(last, limit);
  EXPECT_GT(last, limit * (1 - 1e-4));
  const json read = json::parse(report_json(data, false));
  EXPECT_DOUBLE_EQ(read["prediction"]["segments"][0]["stable_to_kPa"], last);
  EXPECT_EQ(read["prediction"]["segments"][0]["stable_from_kPa"], 0);
  EXPECT_EQ(read["prediction"]["chain"]["cases"][4]["exists"], false);
}

TEST(ReportCurves, CoverSuctionAndPressure) {
  Design design = example("twisting/twisting.toml");
  design.load = {{{-5}}, {{20}}};
  const ReportData data = report_of(design);
  const json read = json::parse(report_json(data, false))["prediction"]["segments"][0];
  EXPECT_EQ(read["curve"].front()["pressure_kPa"], -5);
  EXPECT_EQ(read["curve"].back()["pressure_kPa"], 20);
  EXPECT_EQ(read["stable_from_kPa"], -5);
  EXPECT_EQ(read["stable_to_kPa"], 20);
}

TEST(ReportJson, HoldsTheDesignAndItsResponse) {
  const Design design = example("climbing_robot/climbing_robot.toml");
  const ReportData data = report_of(design);
  const json read = json::parse(report_json(data, false));
  EXPECT_EQ(read["schema"], "latticast-report");
  EXPECT_EQ(read["schema_version"], 1);
  EXPECT_EQ(read["program_version"], "1.2.3");
  ASSERT_EQ(read["design"]["segments"].size(), design.segments.size());
  EXPECT_FALSE(read.contains("times"));
  EXPECT_EQ(json::parse(report_json(data, true))["times"][0]["seconds"], 0.25);
  ASSERT_EQ(read["prediction"]["chain"]["cases"].size(), design.load.size());
  for (std::size_t i = 0; i < design.load.size(); ++i) {
    const json& at = read["prediction"]["chain"]["cases"][i];
    const auto shape = shape_in(data.curves->chain, design.segments, i);
    ASSERT_TRUE(shape);
    EXPECT_EQ(at["pressures_kPa"].get<std::vector<double>>(), design.load[i].pressures_kpa);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(at["tip_mm"][k], shape->tip().origin[k], 1e-6);
    EXPECT_NEAR(at["centre_line_mm"].back()[2], shape->tip().origin[2], 1e-6);
  }
}

TEST(ReportJson, NamesTheRingsPhaseWhereItIsNotTheUsualOne) {
  Design design = example("elongation/elongation.toml");
  design.load.clear();
  const auto rings_of = [&] {
    const json read = json::parse(report_json(report_of(design), false));
    return read["design"]["segments"][0]["lattice"]["rings"];
  };
  design.segments[0].lattice->rings = Rings{std::nullopt, 10.0, 2};
  EXPECT_FALSE(rings_of().contains("phase"));
  design.segments[0].lattice->rings->phase = 0.25;
  EXPECT_EQ(rings_of()["phase"], 0.25);
}

TEST(ReportJson, IsTheSameInEveryRun) {
  const Design design = example("bending/bending.toml");
  EXPECT_EQ(report_json(report_of(design), false), report_json(report_of(design), false));
  EXPECT_EQ(response_csv(report_of(design)), response_csv(report_of(design)));
}

TEST(ReportJson, SaysWhyThereIsNoPrediction) {
  Design design = example("twisting/twisting.toml");
  design.load.clear();
  ReportData data = report_of(design);
  data.curves_missing = "no load";
  const json read = json::parse(report_json(data, false));
  EXPECT_TRUE(read["prediction"].is_null());
  EXPECT_EQ(read["prediction_missing"], "no load");
  EXPECT_EQ(response_csv(data), "");
}

TEST(ReportJson, NamesEachMaterialOnce) {
  const Design design = example("manipulator/manipulator.toml");
  const json read = json::parse(report_json(report_of(design), false));
  std::vector<std::string> names;
  for (const json& material : read["materials"]) names.push_back(material["name"]);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
  EXPECT_GE(names.size(), 2U);
}

TEST(ReportPiece, WeighsWhatItsMaterialsDensitySays) {
  Material silicone;
  ReportPiece piece;
  piece.volume_mm3 = 2500;
  EXPECT_FALSE(mass_g(piece));  // what the printer prints
  piece.material = &silicone;
  EXPECT_FALSE(mass_g(piece));  // a density that nobody states is not guessed
  silicone.density_g_per_cm3 = 1.07;
  EXPECT_DOUBLE_EQ(mass_g(piece).value(), 2.675);
}

TEST(ResponseCsv, HasARowForEveryStateOfTheCurve) {
  const Design design = example("bending/bending.toml");
  const ReportData data = report_of(design);
  std::istringstream lines(response_csv(data));
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  const auto columns = std::count(line.begin(), line.end(), ',');
  EXPECT_EQ(line.find("time"), std::string::npos);
  const std::vector<State> states = data.curves->segments[0].states();
  for (const State& state : states) {
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns);
    EXPECT_EQ(std::stod(line.substr(2)), state.pressure_kpa);
  }
  EXPECT_FALSE(std::getline(lines, line));
}

}  // namespace
}  // namespace latticast
