// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/read_design.h"

#include <fmt/core.h>

#include "design/read_segment.h"
#include "design/read_settings.h"
#include "design/read_text_file.h"
#include "design/table_reader.h"

namespace latticast {
namespace {

bool has_control_character(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte < 0x20 || byte == 0x7F) return true;
    // U+0080 to U+009F in UTF-8.
    const bool pair = byte == 0xC2 && i + 1 < text.size();
    if (pair && static_cast<unsigned char>(text[i + 1]) < 0xA0) return true;
  }
  return false;
}

std::string read_name(const Field& field) {
  std::string name = field.text().value_or("");
  if (!field.is_text()) return name;
  const std::string hint = R"(the name begins the files' names; write one as in "twisting-36")";
  if (name.empty() || name.size() > limits::name_bytes) {
    field.refuse(fmt::format("must have from 1 to {} bytes", limits::name_bytes), hint);
  } else if (name.find_first_of("/\\") != std::string::npos) {
    field.refuse("must not hold a path separator, / or \\", hint);
  } else if (has_control_character(name)) {
    field.refuse("must not hold control characters", hint);
  } else if (name[0] == '.' || name[0] == '-') {
    field.refuse("must not start with a point or a minus", hint);
  } else if (name.front() == ' ' || name.back() == ' ') {
    field.refuse("must not start or end with a space", hint);
  }
  return name;
}

Design read_tables(TableReader file, const MaterialLibrary& materials) {
  Design design;
  design.name = read_name(file.need("name", R"(name = "twisting-36")"));
  design.model = read_model(file.may("model"));
  const Field segments = file.need("segment", "a line [[segment]], with its keys below");
  design.segments = read_segments(segments, materials, design.model.columns);
  const Field load = file.may("load");
  design.load = read_load(load, design.segments.size());
  design.printer = read_printer(file.may("printer"));
  design.make = read_make(file.may("make"), design.segments, design.printer, load.present());
  design.output = read_export(file, design.segments);
  file.refuse_unknown_keys();
  return design;
}

}  // namespace

ReadResult read_design(std::string_view toml_text, const MaterialLibrary& materials) {
  const TomlText parsed = parse_toml(toml_text);
  if (!parsed.issues.empty()) return {{}, parsed.issues};
  Problems problems;
  ReadResult result;
  result.design = read_tables(root_table(parsed.root, problems), materials);
  result.issues = problems.in_file_order();
  return result;
}

ReadResult read_design_file(const std::filesystem::path& file, const MaterialLibrary& materials) {
  return read_design(read_text_file(file), materials);
}

}  // namespace latticast
