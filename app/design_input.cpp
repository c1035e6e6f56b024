// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/design_input.h"

#include <fstream>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "design/issue.h"
#include "design/mesh_format.h"
#include "design/read_design.h"

namespace latticast {
namespace {

void report(const std::vector<Issue>& issues, const std::filesystem::path& file,
            const Console& console) {
  for (const Issue& issue : issues) console.error(describe(issue, file.string()));
  console.note(fmt::format("{} problem{} in {}; nothing was done", issues.size(),
                           issues.size() == 1 ? "" : "s", file.string()));
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
bool is_binary(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string start(512, ' ');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  return start.find('\0') != std::string::npos;
}

}  // namespace

std::optional<MaterialLibrary> load_materials(const std::optional<std::filesystem::path>& file,
                                              const Console& console) {
  MaterialLibrary materials = built_in_materials();
  if (!file) return materials;
  const std::vector<Issue> issues = add_materials_file(*file, materials);
  if (issues.empty()) return materials;
  report(issues, *file, console);
  return std::nullopt;
}

std::optional<Design> load_design(const std::filesystem::path& file,
                                  const MaterialLibrary& materials, const Console& console) {
  if (const std::string problem = format_problem(file); !problem.empty()) {
    console.error(fmt::format("{}: {}", file.string(), problem));
    return std::nullopt;
  }
  ReadResult result = read_design_file(file, materials);
  if (result.ok()) return std::move(result.design);
  if (may_be_no_design(file, result.issues)) {
    console.error(
        fmt::format("{}: is no design, which is TOML, and no mesh that is read: those end in {}",
                    file.string(), mesh_suffixes()));
    if (is_binary(file)) return std::nullopt;
  }
  report(result.issues, file, console);
  return std::nullopt;
}

}  // namespace latticast
