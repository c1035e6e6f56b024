// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/material_library.h"

#include <stdexcept>

#include "design/built_in_materials.h"
#include "design/read_material.h"
#include "design/read_text_file.h"
#include "design/text/printable.h"

namespace latticast {
namespace {

void check_entry_name(const std::string& name, const Field& entry) {
  if (name.empty() || name.size() > limits::name_bytes) {
    entry.refuse("a material's name must have from 1 to 100 bytes", "choose another name");
  }
  if (first_unprintable(name) != Unprintable::none) {
    entry.refuse("a material's name must not hold control characters or such as cannot be seen",
                 "choose another name");
  }
  if (name == "inline") {
    entry.refuse("\"inline\" is what a material without a name is called", "choose another name");
  }
}

MaterialLibrary read_built_in_materials() {
  MaterialLibrary library;
  const std::vector<Issue> issues = add_materials(built_in_materials_text(), library);
  if (!issues.empty()) throw std::logic_error(describe(issues.front(), "design/materials.toml"));
  return library;
}

}  // namespace

const MaterialLibrary& built_in_materials() {
  static const MaterialLibrary library = read_built_in_materials();
  return library;
}

std::vector<Issue> add_materials(std::string_view toml_text, MaterialLibrary& library) {
  const TomlText parsed = parse_toml(toml_text);
  if (!parsed.issues.empty()) return parsed.issues;
  Problems problems;
  MaterialLibrary added;
  for (const auto& [name, field] : root_table(parsed.root, problems).entries()) {
    check_entry_name(name, field);
    if (const auto material = read_library_entry(name, field)) added.emplace(name, *material);
  }
  std::vector<Issue> issues = problems.in_file_order();
  if (issues.empty()) {
    // What merge leaves behind in `library` is what has been replaced.
    added.merge(library);
    library.swap(added);
  }
  return issues;
}

std::vector<Issue> add_materials_file(const std::filesystem::path& file, MaterialLibrary& library) {
  return add_materials(read_text_file(file), library);
}

}  // namespace latticast
