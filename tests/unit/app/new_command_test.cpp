// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/new_command.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "checks/check_design.h"
#include "design/built_in_materials.h"
#include "design/file_error.h"
#include "design/material_library.h"
#include "design/read_design.h"
#include "model/prediction.h"

namespace latticast {
namespace {

struct Motion {
  double lengthening = 0;
  double twist_deg = 0;
  double bend_deg = 0;
};

Motion motion_of(const std::string& kind) {
  const ReadResult read = read_design(new_design(kind), built_in_materials());
  EXPECT_TRUE(read.ok()) << kind;
  const Design& design = read.design;
  const Prediction prediction = predict_design(design, {20}, {}, false);
  const State& state = *prediction.segments[0].response.states[0];
  return {state.stretch - 1, std::abs(twist_deg(state, design.segments[0])),
          bend_deg(state, design.segments[0])};
}

TEST(NewCommand, EveryKindMovesAsItSays) {
  const Motion twisting = motion_of("twisting");
  EXPECT_GT(twisting.twist_deg, 20);
  EXPECT_LT(twisting.bend_deg, 0.01);
  const Motion bending = motion_of("bending");
  EXPECT_GT(bending.bend_deg, 5);
  EXPECT_LT(bending.twist_deg, 0.01);
  const Motion elongation = motion_of("elongation");
  EXPECT_GT(elongation.lengthening, 0.02);
  EXPECT_LT(elongation.bend_deg + elongation.twist_deg, 0.01);
  const Motion superimposed = motion_of("superimposed");
  EXPECT_GT(superimposed.lengthening, 0.01);
  EXPECT_GT(superimposed.twist_deg, 1);
  EXPECT_GT(superimposed.bend_deg, 1);
}

TEST(NewCommand, EveryKindPassesTheChecks) {
  for (const std::string& kind : new_kinds()) {
    const ReadResult read = read_design(new_design(kind), built_in_materials());
    ASSERT_TRUE(read.ok()) << kind;
    EXPECT_EQ(read.design.name, kind);
    EXPECT_FALSE(has_error(check_design(read.design))) << kind;
  }
}

TEST(NewCommand, OverwritesNothing) {
  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / "latticast-new";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const std::filesystem::path file = folder / "mine.toml";
  EXPECT_EQ(run_new("bending", file, Console(true)), ExitStatus::done);
  EXPECT_THROW(run_new("twisting", file, Console(true)), FileError);
  std::ifstream stream(file);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  EXPECT_EQ(text, new_design("bending"));
  EXPECT_THROW(run_new("bending", folder / "no" / "folder.toml", Console(true)), FileError);
  EXPECT_THROW(run_new("bendin", folder / "other.toml", Console(true)), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(folder / "other.toml"));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace latticast
