// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever happens to a design file, reading it ends with issues or with a design that keeps every
// rule. The rules are checked here anew, from the typed design alone.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "design/read_design.h"
#include "tests/unit/design/example_design.h"

namespace latticast {
namespace {

constexpr unsigned seed = 20240611;

bool is_length(double mm) {
  return mm >= 1e-3 && mm <= 1e5;
}
bool is_pressure(double kpa) {
  return std::abs(kpa) <= 1e5;
}

void expect_rules_of(const Material& material, bool for_lattice) {
  if (const auto* linear = std::get_if<Linear>(&material.law)) {
    EXPECT_TRUE(linear->youngs_modulus_mpa > 0 && linear->youngs_modulus_mpa <= 1e6);
    EXPECT_TRUE(linear->poisson_ratio >= 0 && linear->poisson_ratio <= 0.5);
  } else {
    EXPECT_FALSE(for_lattice);
  }
  if (const auto* rubber = std::get_if<NeoHookean>(&material.law)) {
    EXPECT_TRUE(rubber->shear_modulus_mpa > 0 && rubber->shear_modulus_mpa <= 1e6);
  }
  if (const auto* rubber = std::get_if<Yeoh>(&material.law)) {
    EXPECT_TRUE(rubber->c1_mpa > 0 && std::isfinite(rubber->c2_mpa + rubber->c3_mpa));
  }
  if (const auto* rubber = std::get_if<Gent>(&material.law)) {
    EXPECT_TRUE(rubber->shear_modulus_mpa > 0 && rubber->limit_jm > 0);
    EXPECT_TRUE(std::isfinite(rubber->limit_jm));
  }
}

void expect_rules_of(const Rings& rings, double length_mm) {
  EXPECT_NE(rings.count.has_value(), rings.pitch_mm.has_value());
  EXPECT_TRUE(is_length(rings.width_mm));
  if (rings.count) {
    EXPECT_TRUE(*rings.count >= 2 && *rings.count <= 10000);
    EXPECT_LT(*rings.count * rings.width_mm, length_mm);
  }
  if (rings.pitch_mm) {
    EXPECT_GT(*rings.pitch_mm, rings.width_mm);
    EXPECT_TRUE(rings.phase >= 0 && rings.phase < 1);
    EXPECT_LE(rings.first_centre_mm() + rings.width_mm / 2, length_mm);
    EXPECT_LE(length_mm / *rings.pitch_mm, 10000);
  }
}

void expect_rules_of(const Grid& grid, const Segment& segment) {
  EXPECT_TRUE(grid.angle_deg > 0 && grid.angle_deg < 180);
  ASSERT_TRUE(grid.count() >= 1 && grid.count() <= 10000);
  const double alpha = grid.angle_deg * std::numbers::pi / 180;
  const double share =
      2 * std::numbers::pi * segment.lattice_mid_radius_mm() * std::sin(alpha) / grid.count();
  for (int j = 0; j < grid.count(); ++j) {
    EXPECT_TRUE(is_length(grid.widths_mm[j]));
    const double next = grid.widths_mm[(j + 1) % grid.count()];
    EXPECT_LT((grid.widths_mm[j] + next) / 2, share);
  }
  if (const auto* sinusoid = std::get_if<Sinusoid>(&grid.path)) {
    EXPECT_TRUE(is_length(sinusoid->amplitude_mm));
    EXPECT_TRUE(sinusoid->waves >= 0.5 && sinusoid->waves <= 5000);
  }
  if (const auto* horseshoe = std::get_if<Horseshoe>(&grid.path)) {
    EXPECT_TRUE(is_length(horseshoe->radius_mm));
    EXPECT_TRUE(horseshoe->arc_deg >= 20 && horseshoe->arc_deg <= 300);
  }
}

void expect_rules_of(const Segment& segment, const Design& design) {
  EXPECT_TRUE(is_length(segment.length_mm));
  EXPECT_TRUE(is_length(segment.liner.inner_radius_mm));
  EXPECT_TRUE(is_length(segment.liner.thickness_mm));
  expect_rules_of(segment.liner.material, false);
  const bool linear_liner = std::holds_alternative<Linear>(segment.liner.material.law);
  EXPECT_EQ(linear_liner, design.model.columns == ColumnModel::rods);
  EXPECT_LT(design.output.tolerance_mm, segment.liner.thickness_mm);
  if (!segment.lattice) return;
  EXPECT_TRUE(is_length(segment.lattice->thickness_mm));
  EXPECT_LT(design.output.tolerance_mm, segment.lattice->thickness_mm);
  const double fillet = segment.lattice->fillet_mm;
  EXPECT_TRUE(fillet == 0 || (is_length(fillet) && fillet < segment.lattice_mid_radius_mm() &&
                              fillet > design.output.tolerance_mm));
  EXPECT_TRUE(segment.lattice->rings || !segment.lattice->grids.empty());
  expect_rules_of(segment.lattice->material, true);
  if (segment.lattice->rings) expect_rules_of(*segment.lattice->rings, segment.length_mm);
  for (const Grid& grid : segment.lattice->grids) expect_rules_of(grid, segment);
}

void expect_rules_of(const Design& design) {
  EXPECT_TRUE(!design.name.empty() && design.name.size() <= 100);
  EXPECT_EQ(design.name.find_first_of("/\\\n\t"), std::string::npos);
  EXPECT_TRUE(design.name[0] != '.' && design.name[0] != '-');
  ASSERT_TRUE(!design.segments.empty() && design.segments.size() <= 100);
  EXPECT_TRUE(design.output.tolerance_mm >= 1e-5 && design.output.tolerance_mm <= 1);
  EXPECT_TRUE(!design.output.formats.empty() && design.output.formats.size() <= 5);
  for (const Segment& segment : design.segments) expect_rules_of(segment, design);
  for (const LoadCase& load : design.load) {
    EXPECT_EQ(load.pressures_kpa.size(), design.segments.size());
    for (const double pressure : load.pressures_kpa) EXPECT_TRUE(is_pressure(pressure));
  }
  if (design.make.preview) {
    EXPECT_FALSE(design.make.preview->cases.empty());
    for (const LoadCase& load : design.make.preview->cases) {
      EXPECT_EQ(load.pressures_kpa.size(), design.segments.size());
      for (const double p : load.pressures_kpa) EXPECT_TRUE(is_pressure(p));
    }
  }
  if (design.make.lattice_mold) {
    EXPECT_TRUE(is_length(design.make.lattice_mold->wall_mm));
    EXPECT_LT(fit_clearance_mm(design.printer), design.make.lattice_mold->wall_mm);
  }
  if (design.make.liner_mold) {
    EXPECT_TRUE(is_length(design.make.liner_mold->wall_mm));
    EXPECT_LT(fit_clearance_mm(design.printer), design.make.liner_mold->wall_mm);
    EXPECT_TRUE(design.make.liner_mold->pieces >= 2 && design.make.liner_mold->pieces <= 100);
  }
  if (design.printer.bed_mm) {
    for (const double side : *design.printer.bed_mm) EXPECT_TRUE(is_length(side));
  }
}

void expect_well_formed(const std::vector<Issue>& issues, std::string_view text) {
  const int lines = 1 + static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  int before = 0;
  for (const Issue& issue : issues) {
    EXPECT_TRUE(issue.line >= before && issue.line <= lines) << describe(issue, "mutant");
    EXPECT_FALSE(issue.rule.empty() || issue.hint.empty()) << describe(issue, "mutant");
    const std::string shown = describe(issue, "mutant");
    EXPECT_EQ(shown.find_first_of("\n\r\x1b"), std::string::npos) << shown;
    before = issue.line;
  }
}

class Mutator {
 public:
  std::string mutated(std::string text) {
    const int edits = pick(1, 3);
    for (int i = 0; i < edits && !text.empty(); ++i) mutate(text);
    return text;
  }

 private:
  int pick(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
  std::size_t place(const std::string& text) { return pick(0, static_cast<int>(text.size()) - 1); }

  void mutate(std::string& text) {
    switch (pick(0, 6)) {
      case 0:
        text[place(text)] = static_cast<char>(pick(0, 255));
        break;
      case 1:
        text.erase(place(text), pick(1, 30));
        break;
      case 2:
        if (pick(0, 9) == 0) text.resize(place(text));
        break;
      case 3:
        swap_lines(text);
        break;
      case 4:
        text.insert(place(text), 1, "0123456789.-[]{}\"'=,#\n"[pick(0, 21)]);
        break;
      default:
        change_number(text);
        break;
    }
  }

  void swap_lines(std::string& text) {
    std::vector<std::string> lines(1);
    for (const char c : text) {
      lines.back() += c;
      if (c == '\n') lines.emplace_back();
    }
    const int last = static_cast<int>(lines.size()) - 1;
    std::swap(lines[pick(0, last)], lines[pick(0, last)]);
    text.clear();
    for (const std::string& line : lines) text += line;
  }

  /// Most mutants should get past the syntax, to the rules.
  void change_number(std::string& text) {
    const char* numbers[] = {"0",   "-1",  "1",     "2",   "3",    "7",    "20",         "90",
                             "179", "1e9", "1e-9",  "nan", "-inf", "0.01", "1000000000", "true",
                             "1.5", "12",  "\"x\"", "[1]", "{}",   "60",   "0.9",        "45"};
    const std::size_t at = text.find_first_of("0123456789", place(text));
    if (at == std::string::npos) return;
    const std::size_t end = std::min(text.find_first_not_of("0123456789.", at), text.size());
    text.replace(at, end - at, numbers[pick(0, static_cast<int>(std::size(numbers)) - 1)]);
  }

  std::mt19937 random_{seed};
};

TEST(MutatedDesigns, EndInIssuesOrInADesignThatKeepsTheRules) {
  std::cout << "seed " << seed << '\n';
  Mutator mutator;
  int accepted = 0;
  int syntax_errors = 0;
  int broken_rules = 0;
  for (int i = 0; i < 4000; ++i) {
    const std::string text = mutator.mutated(std::string(whole_grammar));
    SCOPED_TRACE("mutant " + std::to_string(i));
    const ReadResult result = read_design(text, built_in_materials());
    expect_well_formed(result.issues, text);
    if (result.ok()) {
      expect_rules_of(result.design);
      ++accepted;
    } else if (result.issues[0].rule.find("valid TOML") != std::string::npos) {
      ++syntax_errors;
    } else {
      ++broken_rules;
    }
    if (HasFailure()) FAIL() << text;
  }
  std::cout << accepted << " accepted, " << syntax_errors << " syntax errors, " << broken_rules
            << " broken rules\n";
  // Each way out must have been taken often, or this test tests nothing.
  EXPECT_GT(accepted, 200);
  EXPECT_GT(syntax_errors, 200);
  EXPECT_GT(broken_rules, 200);
}

}  // namespace
}  // namespace latticast
