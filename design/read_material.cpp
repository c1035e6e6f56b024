// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/read_material.h"

#include <variant>

#include <fmt/core.h>

#include "design/nearest_name.h"

namespace latticast {
namespace {

constexpr std::string_view inline_hint =
    R"(write a material's name, or a table as in { law = "neo-hookean", mu = 0.08 })";

/// The law of that name with its constants still to be read; empty when absent or refused.
template <class... Laws>
std::optional<Law> law_called(const Field& field, const std::variant<Laws...>*) {
  const Word<std::optional<Law>> words[] = {{Laws::name, Laws{}}...};
  return field.word_or(std::optional<Law>(), words);
}

/// Counts the constants of all laws as known keys.
template <class... Laws>
void allow_every_constant(TableReader& table, const std::variant<Laws...>*) {
  const auto allow = [&table](const auto& keys) {
    for (const auto& key : keys) table.may(key.key);
  };
  (allow(Laws::keys), ...);
}

template <class L>
void read_constant(TableReader& table, const LawKey<L>& key, L& law) {
  const bool optional = key.example.empty();
  const Field field = optional ? table.may(key.key) : table.need(key.key, key.example);
  if (const auto* number = std::get_if<double L::*>(&key.member)) {
    law.** number = optional ? field.number_or(law.**number, key.range) : field.number(key.range);
  } else {
    law.*std::get<std::vector<double> L::*>(key.member) =
        field.numbers(1, most_law_terms, key.range);
  }
}

std::optional<Law> read_law(TableReader& table) {
  constexpr const Law* any = nullptr;
  std::optional<Law> law = law_called(table.need("law", R"(law = "neo-hookean")"), any);
  if (!law) {
    // Without its law nobody can say which constants belong: blame the law alone.
    allow_every_constant(table, any);
    return std::nullopt;
  }
  const auto read = [&table]<class L>(L& chosen) {
    for (const LawKey<L>& key : L::keys) read_constant(table, key, chosen);
  };
  std::visit(read, *law);
  if (const std::string fault = law_fault(*law); !fault.empty()) {
    table.table().refuse(fault, "compare the constants and their signs with their source");
  }
  return law;
}

void read_modulus_band(const Field& field, Material& material) {
  const std::vector<Field> ends = field.items(
      2, 2, "write the lowest and highest known modulus as factors of the stated one: [0.8, 1.2]");
  if (ends.empty()) return;
  material.modulus_low_factor = ends[0].optional_number(limits::modulus_low);
  material.modulus_high_factor = ends[1].optional_number(limits::modulus_high);
}

std::optional<Material> read_entry(const std::string& name, TableReader table, bool needs_source) {
  const std::optional<Law> law = read_law(table);
  Material material;
  material.name = name;
  material.law = law.value_or(Law());
  material.max_strain = table.may("max_strain").optional_number(limits::strain);
  material.elongation_at_break = table.may("elongation_at_break").optional_number(limits::strain);
  material.density_g_per_cm3 = table.may("density").optional_number(limits::density);
  material.shrinkage = table.may("shrinkage").optional_number(limits::shrinkage);
  read_modulus_band(table.may("modulus_band"), material);
  const Field source =
      needs_source ? table.need("source", R"(source = "own tensile test")") : table.may("source");
  material.source = source.text().value_or("");
  if (needs_source && source.is_text() && material.source.empty()) {
    source.refuse("must say where the constants come from", "name a paper, data sheet or test");
  }
  material.note = table.may("note").text().value_or("");
  table.refuse_unknown_keys();
  return law ? std::optional(material) : std::nullopt;
}

std::vector<std::string> names_of(const MaterialLibrary& library) {
  std::vector<std::string> names;
  for (const auto& [name, material] : library) names.push_back(name);
  return names;
}

}  // namespace

std::optional<Material> read_library_entry(const std::string& name, const Field& field) {
  constexpr std::string_view hint = "write [NAME] on a line of its own, and the constants below it";
  return read_entry(name, field.as_table(hint), true);
}

std::optional<Material> read_material(const Field& field, const MaterialLibrary& library) {
  if (field.is_table()) return read_entry("inline", field.as_table(inline_hint), false);
  if (field.present() && !field.is_text()) {
    field.refuse("must be a material's name or an inline table", std::string(inline_hint));
    return std::nullopt;
  }
  const std::optional<std::string> name = field.text();
  if (!name) return std::nullopt;
  const auto found = library.find(*name);
  if (found != library.end()) return found->second;
  field.refuse("is not in the materials library", name_hint(*name, names_of(library), "materials"));
  return std::nullopt;
}

}  // namespace latticast
