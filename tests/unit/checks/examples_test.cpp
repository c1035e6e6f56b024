// SPDX-License-Identifier: GPL-3.0-or-later
// The shipped examples: no errors, and nothing that the README beside the design does not explain.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "checks/check_design.h"
#include "design/material_library.h"
#include "design/read_design.h"

namespace latticast {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> examples() {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(LATTICAST_SOURCE_DIR) / "examples")) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  return files;
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Examples, HaveNoFindingThatTheirReadmeDoesNotExplain) {
  ASSERT_GE(examples().size(), 9U);
  for (const fs::path& file : examples()) {
    SCOPED_TRACE(file.string());
    const std::string readme = text_of(file.parent_path() / "README.md");
    const ReadResult read = read_design_file(file, built_in_materials());
    ASSERT_TRUE(read.ok());
    for (const CheckFinding& finding : check_design(read.design)) {
      EXPECT_NE(finding.severity, Severity::error) << finding.code << ": " << finding.message;
      EXPECT_NE(readme.find("`" + finding.code + "`"), std::string::npos)
          << finding.code << " (" << finding.part << "): " << finding.message;
    }
  }
}

}  // namespace
}  // namespace latticast
