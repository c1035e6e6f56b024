// SPDX-License-Identifier: GPL-3.0-or-later
// What commands print, from made-up results.
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/answer_json.h"
#include "app/audit_output.h"
#include "app/check_output.h"
#include "app/number_rows.h"
#include "app/pressure_list.h"

namespace latticast {
namespace {

CheckFinding thin_strand() {
  CheckFinding finding = check_finding("strand-too-thin");
  finding.severity = Severity::warning;
  finding.segment = 2;
  finding.part = "grid 0 strand 3";
  finding.place = CheckPlace{45, 12.5};
  finding.value = 0.3;
  finding.limit = 0.8;
  finding.unit = "mm";
  finding.message = "is thin";
  finding.remedy = "width = 0.8";
  return finding;
}

CheckFinding limit_point() {
  CheckFinding finding = check_finding("limit-point");
  finding.severity = Severity::error;
  finding.segment = 1;
  finding.pressure_kpa = 43.25;
  finding.message = "balloons";
  return finding;
}

TEST(CheckOutput, PutsAFindingInOneLine) {
  EXPECT_EQ(check_line(thin_strand()),
            "strand-too-thin: segment 2, grid 0 strand 3, theta 45.0 degrees, z 12.50 mm: is thin; "
            "remedy: width = 0.8");
  EXPECT_EQ(check_line(limit_point()), "limit-point: segment 1, at 43.25 kPa: balloons");
}

TEST(CheckOutput, ListsErrorsFirstAndCounts) {
  EXPECT_EQ(check_table({thin_strand(), limit_point()}),
            "error limit-point\n"
            "  segment 1, at 43.25 kPa: balloons\n"
            "warning strand-too-thin\n"
            "  segment 2, grid 0 strand 3, theta 45.0 degrees, z 12.50 mm: is thin\n"
            "  remedy: width = 0.8\n"
            "1 error, 1 warning, 0 notes\n");
  EXPECT_EQ(check_table({}), "0 errors, 0 warnings, 0 notes\n");
}

TEST(CheckOutput, TellsProgramsWhatIsNotThere) {
  const auto read = nlohmann::json::parse(check_json("", {thin_strand(), limit_point()}));
  EXPECT_TRUE(read["design"].is_null());
  EXPECT_EQ(read["errors"], 1);
  EXPECT_EQ(read["notes"], 0);
  EXPECT_EQ(read["findings"][0]["theta_deg"], 45);
  EXPECT_EQ(read["findings"][0]["limit"], 0.8);
  EXPECT_TRUE(read["findings"][0]["pressure_kPa"].is_null());
  EXPECT_TRUE(read["findings"][1]["z_mm"].is_null());
  EXPECT_EQ(read["findings"][1]["severity"], "error");
  EXPECT_EQ(nlohmann::json::parse(check_json("tube", {}))["design"], "tube");
}

TEST(CheckOutput, TakesAnyBytesOfAFilesName) {
  CheckFinding finding = thin_strand();
  finding.part = "\xFF.stl";
  EXPECT_NO_THROW(nlohmann::json::parse(check_json("", {finding})));
}

TEST(AuditOutput, SumsUpAMeshThatPasses) {
  Audit audit;
  audit.triangles = 11870;
  audit.components = 1;
  audit.genus = 57;
  audit.volume_mm3 = 7174.512;
  EXPECT_EQ(audit_summary(audit), "closed, 1 piece, genus 57, 7174.51 mm3, 11870 triangles");
  audit.components = 2;
  EXPECT_EQ(audit_summary(audit), "closed, 2 pieces, genus 57, 7174.51 mm3, 11870 triangles");
  audit.searched_intersections = true;
  EXPECT_EQ(audit_findings(audit), "");
}

TEST(AuditOutput, ListsDefectsOfAKindTogether) {
  Audit audit;
  audit.searched_intersections = false;
  audit.findings = {{Defect::open_edge, {1, 2, 3}, 7},
                    {Defect::open_edge, {4, 5, 6}, 8},
                    {Defect::self_intersection, {0, 0, 0.5}, 9}};
  audit.counts[static_cast<std::size_t>(Defect::open_edge)] = 20;
  audit.counts[static_cast<std::size_t>(Defect::self_intersection)] = 1;
  EXPECT_EQ(audit_findings(audit),
            "  open edge: 20\n"
            "    at x 1, y 2, z 3 (triangle 7)\n"
            "    at x 4, y 5, z 6 (triangle 8)\n"
            "  self-intersection: 1\n"
            "    at x 0, y 0, z 0.5 (triangle 9)\n"
            "  self-intersections were not searched: not every coordinate is finite\n");
}

TEST(AuditOutput, SumsUpTheObjectsOfAFile) {
  Audit sound;
  sound.triangles = 12;
  sound.components = 1;
  sound.volume_mm3 = 6000;
  sound.highest = {10, 20, 30};
  const std::vector<MeshObject> objects{{"left", {}}, {"", {}}};
  EXPECT_EQ(audit_report("a.3mf", objects, {sound, sound}, {}),
            "pass a.3mf: 2 objects, closed, 2 pieces, genus 0, 12000 mm3, 24 triangles\n");
  PartOverlaps overlaps;
  overlaps.found = {{0, 1, 5, 3000, {7.5, 10, 15}}};
  EXPECT_EQ(audit_report("a.3mf", objects, {sound, sound}, overlaps),
            "pass a.3mf: 2 objects, closed, 2 pieces, genus 0, 12000 mm3, 24 triangles\n"
            "  note: \"left\" and object 2 overlap, 5 mm deep at x 7.5, y 10, z 15; about 3000 mm3 "
            "belong to both\n");
  Audit open = sound;
  open.searched_intersections = true;
  open.findings = {{Defect::open_edge, {1, 2, 3}, 7}};
  open.counts[static_cast<std::size_t>(Defect::open_edge)] = 3;
  EXPECT_EQ(audit_report("a.3mf", objects, {sound, open}, {}),
            "FAIL a.3mf: 2 objects, 24 triangles\n"
            "  object 2:\n"
            "  open edge: 3\n"
            "    at x 1, y 2, z 3 (triangle 7)\n");
}

TEST(PressureList, TakesOneAListOrARange) {
  EXPECT_EQ(parse_pressures_kpa("30"), (std::vector<double>{30}));
  EXPECT_EQ(parse_pressures_kpa("10,-2.5,10"), (std::vector<double>{10, -2.5, 10}));
  EXPECT_EQ(parse_pressures_kpa("0:60:20"), (std::vector<double>{0, 20, 40, 60}));
  EXPECT_EQ(parse_pressures_kpa("5:5:1"), (std::vector<double>{5}));
}

TEST(PressureList, SaysWhatIsWrongAndHowToWriteIt) {
  const auto refusal = [](std::string_view text) -> std::string {
    try {
      parse_pressures_kpa(text);
    } catch (const std::invalid_argument& fault) {
      return fault.what();
    }
    return "";
  };
  const std::string how =
      "; write one pressure in kPa (30), a list (10,20,30) or FROM:TO:STEP (0:60:5)";
  EXPECT_EQ(refusal("ten"), "--pressure ten: 'ten' is not a number" + how);
  EXPECT_EQ(refusal("10,"), "--pressure 10,: '' is not a number" + how);
  EXPECT_EQ(refusal("0:60"), "--pressure 0:60: a range has three parts" + how);
  EXPECT_EQ(refusal("0:60:-5"),
            "--pressure 0:60:-5: the step never leads from the first to the last pressure" + how);
  EXPECT_EQ(refusal("0:1:1e-9"), "--pressure 0:1:1e-9: more than 100000 pressures" + how);
  EXPECT_FALSE(refusal("1e9").empty());
  EXPECT_FALSE(refusal("nan").empty());
}

TEST(NumberRows, AlignColumnsAndKeepNumbersExact) {
  const NumberRows rows{{"case", "tip_mm"}, {{1, 0.1}, {12, -1e-9}}};
  EXPECT_EQ(rows_as_table(rows), "case  tip_mm\n   1   0.100\n  12   0.000\n");
  EXPECT_EQ(rows_as_csv(rows), "case,tip_mm\n1,0.1\n12,-1e-09\n");
  const auto read = nlohmann::json::parse(rows_json(Design(), "tip", rows));
  EXPECT_EQ(read["rows"][0]["case"], 1);
  EXPECT_EQ(read["rows"][1]["tip_mm"], -1e-9);
}

}  // namespace
}  // namespace latticast
