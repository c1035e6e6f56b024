// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/read_material.h"

#include <array>

#include <fmt/format.h>

#include "design/nearest_name.h"

namespace latticast {
namespace {

enum class LawKind { unknown, linear, neo_hookean, yeoh, gent };

constexpr Word<LawKind> law_words[] = {{"linear", LawKind::linear},
                                       {"neo-hookean", LawKind::neo_hookean},
                                       {"yeoh", LawKind::yeoh},
                                       {"gent", LawKind::gent}};
constexpr std::string_view inline_hint =
    R"(write a material's name, or a table as in { law = "neo-hookean", mu = 0.08 })";

Law read_linear(TableReader& table) {
  return Linear{.youngs_modulus_mpa = table.need("E", "E = 19.46").number(limits::modulus),
                .poisson_ratio = table.may("nu").number_or(0.5, limits::poisson_ratio)};
}

Law read_neo_hookean(TableReader& table) {
  return NeoHookean{.shear_modulus_mpa = table.need("mu", "mu = 0.08").number(limits::modulus)};
}

Law read_yeoh(TableReader& table) {
  return Yeoh{.c1_mpa = table.need("c1", "c1 = 0.04").number(limits::modulus),
              .c2_mpa = table.may("c2").number_or(0, limits::stiffening),
              .c3_mpa = table.may("c3").number_or(0, limits::stiffening)};
}

Law read_gent(TableReader& table) {
  return Gent{.shear_modulus_mpa = table.need("mu", "mu = 0.08").number(limits::modulus),
              .limit_jm = table.need("jm", "jm = 60").number(limits::gent_limit)};
}

std::optional<Law> read_law(TableReader& table) {
  switch (table.need("law", R"(law = "neo-hookean")").word_or(LawKind::unknown, law_words)) {
    case LawKind::linear:
      return read_linear(table);
    case LawKind::neo_hookean:
      return read_neo_hookean(table);
    case LawKind::yeoh:
      return read_yeoh(table);
    case LawKind::gent:
      return read_gent(table);
    case LawKind::unknown:
      break;
  }
  // Without its law nobody can say which constants belong: blame the law alone.
  for (const char* constant : {"E", "nu", "mu", "c1", "c2", "c3", "jm"}) table.may(constant);
  return std::nullopt;
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

std::string_view law_name(const Law& law) {
  constexpr std::array<std::string_view, 4> names = {"linear", "neo-hookean", "yeoh", "gent"};
  return names[law.index()];
}

}  // namespace latticast
