// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/read_design.h"

#include "design/read_name.h"
#include "design/read_segment.h"
#include "design/read_settings.h"
#include "design/read_text_file.h"
#include "design/table_reader.h"

namespace latticast {
namespace {

Design read_tables(TableReader file, const MaterialLibrary& materials) {
  Design design;
  design.name = read_design_name(file.need("name", R"(name = "twisting-36")"));
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
  return read_design(parse_toml(toml_text), materials);
}

ReadResult read_design(const TomlText& parsed, const MaterialLibrary& materials) {
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
