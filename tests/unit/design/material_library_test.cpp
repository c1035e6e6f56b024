// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/material_library.h"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "design/file_error.h"

namespace latticast {
namespace {

double neo_hookean_mu(const Material& material) {
  return std::get<NeoHookean>(material.law).shear_modulus_mpa;
}

std::string all_of(const std::vector<Issue>& issues) {
  std::string all;
  for (const Issue& issue : issues) all += describe(issue, "\n");
  return all;
}

std::string text_of(const std::string& file) {
  std::ifstream stream(LATTICAST_SOURCE_DIR "/" + file);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

TEST(BuiltInMaterials, AreThoseOfTheDataFile) {
  MaterialLibrary from_file;
  EXPECT_EQ(all_of(add_materials(text_of("design/materials.toml"), from_file)), "");
  ASSERT_EQ(from_file.size(), built_in_materials().size());
  for (const auto& [name, material] : from_file) EXPECT_TRUE(built_in_materials().count(name));
}

TEST(BuiltInMaterials, StandInTheDocumentationWithTheirConstants) {
  std::stringstream page(text_of("docs/materials.md"));
  std::map<std::string, std::string> rows;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("| `")) rows[line.substr(3, line.find('`', 3) - 3)] = line;
  }
  for (const auto& [name, material] : built_in_materials()) {
    ASSERT_TRUE(rows.count(name)) << name;
    std::ostringstream constant;
    if (const auto* linear = std::get_if<Linear>(&material.law)) {
      constant << "E = " << linear->youngs_modulus_mpa << ", nu = " << linear->poisson_ratio;
    } else {
      constant << "mu = " << neo_hookean_mu(material);
    }
    EXPECT_NE(rows[name].find("| " + constant.str() + " |"), std::string::npos) << rows[name];
  }
}

TEST(BuiltInMaterials, EachSaysWhereItComesFrom) {
  EXPECT_GE(built_in_materials().size(), 6U);
  for (const auto& [name, material] : built_in_materials()) {
    EXPECT_EQ(material.name, name);
    EXPECT_GT(material.source.size(), 20U) << name;
    EXPECT_GT(material.note.size(), 20U) << name;
    if (material.modulus_low_factor) {
      EXPECT_LE(*material.modulus_low_factor, 1) << name;
      EXPECT_GE(material.modulus_high_factor.value(), 1) << name;
    }
  }
}

TEST(BuiltInMaterials, ThePaperAndTheTensileFitStandApart) {
  const Material& paper = built_in_materials().at("ecoflex-00-50");
  const Material& tensile = built_in_materials().at("ecoflex-00-50-tensile");
  EXPECT_EQ(neo_hookean_mu(paper), 0.08);
  EXPECT_EQ(neo_hookean_mu(tensile), 0.022);
  EXPECT_NE(paper.note.find("0.022"), std::string::npos);
  EXPECT_NE(paper.note.find("100 % modulus"), std::string::npos);
  // The paper's band reaches down to the tensile fit.
  EXPECT_NEAR(*paper.modulus_low_factor * 0.08, 0.022, 1e-12);
}

TEST(BuiltInMaterials, LatticeAndRodsLiner) {
  const auto& lattice = std::get<Linear>(built_in_materials().at("hei-cast-8400").law);
  EXPECT_EQ(lattice.youngs_modulus_mpa, 19.46);
  const auto& liner = std::get<Linear>(built_in_materials().at("ecoflex-00-50-linear").law);
  EXPECT_EQ(liner.youngs_modulus_mpa, 0.082);
  EXPECT_EQ(liner.poisson_ratio, 0.499);
}

TEST(BuiltInMaterials, HundredPercentModuliOfTheDataSheets) {
  // Nominal tensile stress of an incompressible neo-Hookean rubber: mu (s - 1/s^2), at s = 2.
  constexpr double mpa_per_psi = 0.00689475729;
  const std::pair<const char*, double> psi_at_100_percent[] = {{"ecoflex-00-30", 10},
                                                               {"dragon-skin-10", 22},
                                                               {"dragon-skin-20", 49},
                                                               {"dragon-skin-30", 86},
                                                               {"smooth-sil-950", 272}};
  for (const auto& [name, psi] : psi_at_100_percent) {
    const double stress_mpa = neo_hookean_mu(built_in_materials().at(name)) * (2 - 1.0 / 4);
    EXPECT_NEAR(stress_mpa / (psi * mpa_per_psi), 1, 1e-3) << name;
  }
  const Material& tensile = built_in_materials().at("ecoflex-00-50-tensile");
  const double upper = *tensile.modulus_high_factor * 0.022 * 1.75;
  EXPECT_NEAR(upper / (12 * mpa_per_psi), 1, 2e-3);
}

TEST(AddMaterials, ReadsEveryField) {
  MaterialLibrary library;
  const std::vector<Issue> issues = add_materials(R"(
[mine]
law = "gent"
mu = 0.03
jm = 55
max_strain = 2.5
elongation_at_break = 7
density = 1.1
modulus_band = [0.9, 1.25]
source = "own test"
note = "one batch"
)",
                                                  library);
  EXPECT_EQ(all_of(issues), "");
  const Material& mine = library.at("mine");
  EXPECT_EQ(mine.name, "mine");
  EXPECT_EQ(std::get<Gent>(mine.law).shear_modulus_mpa, 0.03);
  EXPECT_EQ(std::get<Gent>(mine.law).limit_jm, 55);
  EXPECT_EQ(mine.max_strain, 2.5);
  EXPECT_EQ(mine.elongation_at_break, 7);
  EXPECT_EQ(mine.density_g_per_cm3, 1.1);
  EXPECT_EQ(mine.modulus_low_factor, 0.9);
  EXPECT_EQ(mine.modulus_high_factor, 1.25);
  EXPECT_EQ(mine.source, "own test");
  EXPECT_EQ(mine.note, "one batch");
}

TEST(AddMaterials, ReplacesByNameAndKeepsTheOthers) {
  MaterialLibrary library = built_in_materials();
  const std::vector<Issue> issues = add_materials(
      "[ecoflex-00-50]\nlaw = \"neo-hookean\"\nmu = 0.05\nsource = \"own test\"\n", library);
  EXPECT_EQ(all_of(issues), "");
  EXPECT_EQ(library.size(), built_in_materials().size());
  EXPECT_EQ(neo_hookean_mu(library.at("ecoflex-00-50")), 0.05);
  EXPECT_FALSE(library.at("ecoflex-00-50").density_g_per_cm3);
  EXPECT_EQ(neo_hookean_mu(library.at("dragon-skin-30")), 0.339);
}

TEST(AddMaterials, AnyProblemLeavesTheLibraryAsItWas) {
  MaterialLibrary library = built_in_materials();
  const std::vector<Issue> issues = add_materials(R"([good]
law = "linear"
E = 3
source = "own test"
[bad]
law = "linear"
E = -3
density = 0
modulus_band = [1.2, 0.8]
elongation = 3
[empty]
[inline]
law = "neo-hookean"
mu = 0.1
source = ""
[""]
law = "neo-hookean"
mu = 0.1
source = "own test"
)",
                                                  library);
  const std::pair<int, const char*> expected[] = {{5, "bad.source"},
                                                  {7, "bad.E"},
                                                  {8, "bad.density"},
                                                  {9, "bad.modulus_band[0]"},
                                                  {9, "bad.modulus_band[1]"},
                                                  {10, "bad.elongation"},
                                                  {11, "empty.law"},
                                                  {11, "empty.source"},
                                                  {12, "inline"},
                                                  {15, "inline.source"},
                                                  {16, "\"\""}};
  ASSERT_EQ(issues.size(), std::size(expected)) << all_of(issues);
  for (std::size_t i = 0; i < issues.size(); ++i) {
    EXPECT_EQ(issues[i].line, expected[i].first) << all_of(issues);
    EXPECT_EQ(issues[i].key, expected[i].second) << all_of(issues);
  }
  EXPECT_EQ(library.size(), built_in_materials().size());
  EXPECT_FALSE(library.count("good"));
}

TEST(AddMaterials, AnEntryThatIsNoTable) {
  MaterialLibrary library;
  const std::vector<Issue> issues = add_materials("mine = 3\n", library);
  ASSERT_EQ(issues.size(), 1U) << all_of(issues);
  EXPECT_EQ(issues[0].key, "mine");
}

TEST(AddMaterialsFile, ThrowsWhenItCannotBeRead) {
  MaterialLibrary library;
  EXPECT_THROW(add_materials_file("/latticast-no-such-folder/a.toml", library), FileError);
}

}  // namespace
}  // namespace latticast
