// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/design_input.h"

#include <string>
#include <vector>

#include <fmt/core.h>

#include "design/issue.h"
#include "design/mesh_format.h"
#include "design/read_text_file.h"
#include "design/setting/setting.h"

namespace latticast {
namespace {

void report(const std::vector<Issue>& issues, const std::string& file, const Console& console) {
  for (const Issue& issue : issues) console.error(describe(issue, file));
  console.note(fmt::format("{} problem{} in {}; nothing was done", issues.size(),
                           issues.size() == 1 ? "" : "s", file));
}

// What is wrong with the format of a file that should hold a design; empty where nothing is.
std::string format_problem(const std::filesystem::path& file) {
  if (mesh_format_of(file)) {
    return "is a mesh, and a design (TOML) is wanted here: audit and check read meshes";
  }
  const std::string_view foreign = foreign_format_of(file);
  if (foreign.empty()) return {};
  return fmt::format("{} files are not read: meshes end in {}, and designs are TOML (.toml)",
                     foreign, mesh_suffixes());
}

// A file of a suffix that says nothing may be meant as a mesh, too.
bool may_be_no_design(const std::filesystem::path& file, const std::vector<Issue>& issues) {
  const std::string suffix = file.extension().string();
  const bool no_toml = issues.size() == 1 && issues.front().key.empty();
  return no_toml && !suffix.empty() && suffix != ".toml" && suffix != ".TOML";
}

// No text has a zero byte.
bool is_binary(std::string_view text) {
  return text.substr(0, 512).find('\0') != std::string_view::npos;
}

}  // namespace

std::optional<MaterialLibrary> load_materials(const std::filesystem::path& file,
                                              const Console& console) {
  MaterialLibrary materials = built_in_materials();
  if (file.empty()) return materials;
  const std::vector<Issue> issues = add_materials_file(file, materials);
  if (issues.empty()) return materials;
  report(issues, file.string(), console);
  return std::nullopt;
}

std::optional<Design> load_design(const DesignInput& input, const Console& console) {
  const auto materials = load_materials(input.materials, console);
  if (!materials) return std::nullopt;
  const bool is_piped = input.file == "-";
  const std::string name = is_piped ? "standard input" : input.file.string();
  if (const std::string problem = format_problem(input.file); !problem.empty()) {
    console.error(fmt::format("{}: {}", name, problem));
    return std::nullopt;
  }
  const std::string text = is_piped ? read_standard_input() : read_text_file(input.file);
  ReadResult result = read_design_with(text, input.settings, *materials);
  if (result.ok()) return std::move(result.design);
  if (may_be_no_design(input.file, result.issues)) {
    console.error(
        fmt::format("{}: is no design, which is TOML, and no mesh that is read: those end in {}",
                    name, mesh_suffixes()));
    if (is_binary(text)) return std::nullopt;
  }
  report(result.issues, name, console);
  return std::nullopt;
}

}  // namespace latticast
