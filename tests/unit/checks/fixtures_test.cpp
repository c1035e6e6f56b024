// SPDX-License-Identifier: GPL-3.0-or-later
// Every check has a design, or a mesh file, that it must reject for its reason and one, barely
// good, that it must accept: tests/checks/CODE/rejected.toml (or .obj, .stl, .3mf) and
// accepted.toml.
#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "checks/check_design.h"
#include "checks/mesh_checks.h"
#include "design/material_library.h"
#include "design/read_design.h"
#include "export/mesh/mesh_file.h"

namespace latticast {
namespace {

// The file of that name, whatever its kind.
std::filesystem::path fixture(std::string_view code, const char* name) {
  const auto folder = std::filesystem::path(LATTICAST_SOURCE_DIR) / "tests/checks" / code;
  for (const char* ending : {".toml", ".obj", ".stl", ".3mf"}) {
    const std::filesystem::path file = folder / (std::string(name) + ending);
    if (std::filesystem::exists(file)) return file;
  }
  ADD_FAILURE() << "no file " << name << " in " << folder;
  return {};
}

CheckFindings findings_of(const std::filesystem::path& file) {
  if (file.empty()) return {};
  if (file.extension() != ".toml") return mesh_checks(read_objects(file), file.filename().string());
  const ReadResult read = read_design_file(file, built_in_materials());
  for (const Issue& issue : read.issues) ADD_FAILURE() << describe(issue, file.string());
  return read.ok() ? check_design(read.design) : CheckFindings{};
}

bool has(const CheckFindings& findings, std::string_view code) {
  return std::any_of(findings.begin(), findings.end(),
                     [&](const CheckFinding& finding) { return finding.code == code; });
}

class Check : public testing::TestWithParam<CheckCode> {};

TEST_P(Check, RejectsTheBadDesign) {
  const std::string_view code = GetParam().code;
  EXPECT_TRUE(has(findings_of(fixture(code, "rejected")), code));
}

TEST_P(Check, AcceptsTheJustGoodDesign) {
  const std::string_view code = GetParam().code;
  for (const CheckFinding& finding : findings_of(fixture(code, "accepted"))) {
    EXPECT_NE(finding.severity, Severity::error) << finding.code << ": " << finding.message;
    EXPECT_NE(finding.code, code) << finding.message;
  }
}

TEST_P(Check, SaysWhatIsWrongAndWhatToDo) {
  const std::string_view code = GetParam().code;
  for (const CheckFinding& finding : findings_of(fixture(code, "rejected"))) {
    if (finding.code != code) continue;
    EXPECT_EQ(finding.severity, GetParam().severity);
    EXPECT_FALSE(finding.message.empty());
    EXPECT_FALSE(finding.remedy.empty());
  }
}

std::string test_name(const testing::TestParamInfo<CheckCode>& info) {
  std::string name(info.param.code);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Codes, Check, testing::ValuesIn(all_check_codes()), test_name);

}  // namespace
}  // namespace latticast
