// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/materials_command.h"

#include <vector>

#include <fmt/core.h>

#include "app/design_input.h"
#include "design/nearest_name.h"
#include "design/text/written_number.h"

namespace latticast {
namespace {

std::string entry_text(const Material& material) {
  std::string text =
      fmt::format("{}\n  law                  {}\n", material.name, law_text(material.law));
  const auto add = [&](std::string_view label, const std::optional<double>& value, double factor,
                       std::string_view unit) {
    if (value) text += fmt::format("  {:<20} {} {}\n", label, written(*value * factor, 6), unit);
  };
  add("fitted to strain", material.max_strain, 100, "%");
  add("elongation at break", material.elongation_at_break, 100, "%");
  add("density", material.density_g_per_cm3, 1, "g/cm3");
  if (material.modulus_low_factor || material.modulus_high_factor) {
    text += fmt::format("  {:<20} {} to {} times the stated modulus\n", "modulus band",
                        written(material.modulus_low_factor.value_or(1), 6),
                        written(material.modulus_high_factor.value_or(1), 6));
  }
  text += fmt::format("  {:<20} {}\n", "source", material.source);
  if (!material.note.empty()) text += fmt::format("  {:<20} {}\n", "note", material.note);
  return text;
}

}  // namespace

ExitStatus run_materials(const std::string& name, const std::filesystem::path& materials_file,
                         const Console& console) {
  const auto library = load_materials(materials_file, console);
  if (!library) return ExitStatus::invalid;
  if (name.empty()) {
    for (const auto& [key, material] : *library) {
      console.data(fmt::format("{:<24} {}\n", key, law_text(material.law)));
    }
    return ExitStatus::done;
  }
  if (const auto entry = library->find(name); entry != library->end()) {
    console.data(entry_text(entry->second));
    return ExitStatus::done;
  }
  std::vector<std::string> known;
  for (const auto& entry : *library) known.push_back(entry.first);
  console.error(fmt::format("no material '{}': {}", name, name_hint(name, known, "materials")));
  return ExitStatus::invalid;
}

}  // namespace latticast
