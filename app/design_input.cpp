// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/design_input.h"

#include <vector>

#include <fmt/core.h>

#include "design/issue.h"
#include "design/read_design.h"

namespace latticast {
namespace {

void report(const std::vector<Issue>& issues, const std::filesystem::path& file,
            const Console& console) {
  for (const Issue& issue : issues) console.error(describe(issue, file.string()));
  console.note(fmt::format("{} problem{} in {}; nothing was done", issues.size(),
                           issues.size() == 1 ? "" : "s", file.string()));
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
  ReadResult result = read_design_file(file, materials);
  if (result.ok()) return std::move(result.design);
  report(result.issues, file, console);
  return std::nullopt;
}

}  // namespace latticast
