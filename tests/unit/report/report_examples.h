// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "design/material_library.h"
#include "design/read_design.h"

namespace latticast {

inline Design example(const std::string& file) {
  const auto path = std::filesystem::path(LATTICAST_SOURCE_DIR) / "examples" / file;
  const ReadResult read = read_design_file(path, built_in_materials());
  if (!read.ok()) throw std::runtime_error(path.string() + " cannot be read");
  return read.design;
}

inline const std::vector<std::string> example_files = {
    "twisting/twisting.toml",       "bending/bending.toml",
    "elongation/elongation.toml",   "superimposed/superimposed.toml",
    "manipulator/manipulator.toml", "climbing_robot/climbing_robot.toml"};

}  // namespace latticast
