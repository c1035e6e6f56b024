// SPDX-License-Identifier: GPL-3.0-or-later
// Reading a design file: TOML text in, a typed Design or the complete list of its problems out.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "design/design.h"
#include "design/issue.h"
#include "design/material_library.h"
#include "design/toml_text.h"

namespace latticast {

/// `design` is meaningful only when `issues` is empty.
struct ReadResult {
  Design design;
  std::vector<Issue> issues;  ///< every problem found, in file order

  bool ok() const { return issues.empty(); }
};

/// Reads a design from TOML text; the grammar and its rules are in docs/design-file.md, the limits
/// of sizes and counts in design/limits.h. Never throws on bad input, whatever its bytes: a syntax
/// error is an issue too, and then the only one, because nothing after it can be trusted. Nothing
/// larger than the text itself is allocated before its size has been checked.
///
/// When there are no issues, every rule of docs/design-file.md holds for `design`: all numbers are
/// finite and within limits, every grid has one width per strand, strands of one family and rings
/// leave gaps, every load case has one pressure per segment, liner laws suit the column model.
ReadResult read_design(std::string_view toml_text, const MaterialLibrary& materials);

/// The same for text that was parsed before, as read or with values put in their places.
ReadResult read_design(const TomlText& parsed, const MaterialLibrary& materials);

/// Reads a design file. Throws FileError when the file cannot be read.
ReadResult read_design_file(const std::filesystem::path& file, const MaterialLibrary& materials);

}  // namespace latticast
