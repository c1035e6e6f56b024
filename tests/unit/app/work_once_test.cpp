// SPDX-License-Identifier: GPL-3.0-or-later
// In one build, each lattice is drawn and united, each section prepared and solved once per
// argument. The linker sends every call of the counted functions through here (option --wrap), so
// that nothing in the program has to count, and nothing can pass by.
#include <cstdio>
#include <filesystem>
#include <map>
#include <span>
#include <sstream>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "app/build_command.h"
#include "geometry/pattern/pattern.h"
#include "geometry/solid/region.h"
#include "model/section/section_reading.h"
#include "model/segment_response.h"

namespace latticast {
namespace {

// Calls of each function by what they were given.
std::map<std::string, std::map<std::string, int>> calls;

class Text {
 public:
  Text() { text_ << std::hexfloat; }
  template <class Value>
  Text& operator<<(const Value& value) {
    text_ << value << ' ';
    return *this;
  }
  std::string str() const { return text_.str(); }

 private:
  std::ostringstream text_;
};

double first_constant(const Law& law) {
  return std::visit(
      [](const auto& any) {
        using Any = std::decay_t<decltype(any)>;
        if constexpr (requires { any.shear_modulus_mpa; })
          return any.shear_modulus_mpa;
        else if constexpr (requires { any.youngs_modulus_mpa; })
          return any.youngs_modulus_mpa;
        else if constexpr (requires { any.c1_mpa; })
          return any.c1_mpa;
        else
          return static_cast<double>(sizeof(Any));
      },
      law);
}

std::string text_of(const Segment& segment) {
  Text text;
  text << segment.length_mm << segment.liner.inner_radius_mm << segment.liner.thickness_mm
       << first_constant(segment.liner.material.law);
  if (!segment.lattice) return text.str();
  const Lattice& lattice = *segment.lattice;
  text << lattice.thickness_mm << lattice.fillet_mm << first_constant(lattice.material.law);
  if (lattice.rings) text << lattice.rings->count.value_or(0) << lattice.rings->width_mm;
  for (const Grid& grid : lattice.grids) {
    text << grid.angle_deg;
    for (const double width : grid.widths_mm) text << width;
  }
  return text.str();
}

std::string text_of(const Pattern& pattern) {
  Text text;
  text << pattern.circumference_mm << pattern.length_mm << pattern.strands.size();
  for (const Strand& strand : pattern.strands) {
    double sum = 0;
    for (const PlanePoint& p : strand.outline) sum += 3 * p.u + p.z;
    text << strand.outline.size() << sum;
  }
  return text.str();
}

std::string text_of(const PlaneGrid& grid) {
  return (Text() << grid.sectors << grid.sector_steps << grid.length_steps << grid.u_step_mm
                 << grid.z_step_mm)
      .str();
}

}  // namespace

// The names are the linker's: what the compiler calls these functions.
#define COUNTED(name) asm("__wrap_" name)
#define ORIGINAL(name) asm("__real_" name)
#define DRAW "_ZN9latticast12draw_latticeERKNS_7SegmentEd"
#define UNITE "_ZN9latticast5uniteENS_7PatternERKNS_9PlaneGridESt4spanIKiLm18446744073709551615EEd"
#define CLOSE "_ZN9latticast14closed_patternENS_7PatternERKNS_9PlaneGridEd"
#define PREPARE                                                                                    \
  "_ZN9latticast15prepare_sectionERKNS_7SegmentERKNS_11ModelChoiceERKSt6vectorISt10shared_ptrIKNS" \
  "_9StrandLawEESaISA_EE"
#define SOLVE                                                                                     \
  "_ZN9latticast7predictERKNS_15PreparedSegmentESt4spanIKdLm18446744073709551615EENS_4HeldERKNS_" \
  "13SolverOptionsE"

Pattern original_draw(const Segment&, double) ORIGINAL(DRAW);
Pattern counted_draw(const Segment&, double) COUNTED(DRAW);
Pattern counted_draw(const Segment& segment, double flatness_mm) {
  ++calls["draw"][text_of(segment)];  // the twisting design has no curves: any flatness is the same
  return original_draw(segment, flatness_mm);
}

Region original_unite(Pattern, const PlaneGrid&, std::span<const std::int32_t>, double)
    ORIGINAL(UNITE);
Region counted_unite(Pattern, const PlaneGrid&, std::span<const std::int32_t>, double)
    COUNTED(UNITE);
Region counted_unite(Pattern pattern, const PlaneGrid& grid, std::span<const std::int32_t> cuts,
                     double closing_mm) {
  Text text;
  text << text_of(pattern) << text_of(grid) << closing_mm;
  for (const std::int32_t cut : cuts) text << cut;
  ++calls["unite"][text.str()];
  return original_unite(std::move(pattern), grid, cuts, closing_mm);
}

Pattern original_close(Pattern, const PlaneGrid&, double) ORIGINAL(CLOSE);
Pattern counted_close(Pattern, const PlaneGrid&, double) COUNTED(CLOSE);
Pattern counted_close(Pattern pattern, const PlaneGrid& grid, double closing_mm) {
  // A single strand is no lattice: a mold's base and cap begin with the same band.
  if (pattern.strands.size() > 1) {
    ++calls["close"][(Text() << text_of(pattern) << text_of(grid) << closing_mm).str()];
  }
  return original_close(std::move(pattern), grid, closing_mm);
}

Section original_prepare(const Segment&, const ModelChoice&, const StrandLaws&) ORIGINAL(PREPARE);
Section counted_prepare(const Segment&, const ModelChoice&, const StrandLaws&) COUNTED(PREPARE);
Section counted_prepare(const Segment& segment, const ModelChoice& model, const StrandLaws& known) {
  ++calls["prepare"][text_of(segment)];
  return original_prepare(segment, model, known);
}

Response original_solve(const PreparedSegment&, std::span<const double>, Held, const SolverOptions&)
    ORIGINAL(SOLVE);
Response counted_solve(const PreparedSegment&, std::span<const double>, Held, const SolverOptions&)
    COUNTED(SOLVE);
Response counted_solve(const PreparedSegment& segment, std::span<const double> pressures_kpa,
                       Held held, const SolverOptions& options) {
  Text text;  // prepared once, so that the address tells the segment
  text << &segment << held.twist << held.stretch << held.bend;
  for (const double pressure : pressures_kpa) text << pressure;
  ++calls["solve"][text.str()];
  return original_solve(segment, pressures_kpa, held, options);
}

namespace {

TEST(Build, DrawsUnitesPreparesAndSolvesOncePerArgument) {
  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / "latticast-work-once";
  std::filesystem::remove_all(folder);
  std::FILE* nowhere = std::fopen("/dev/null", "w");
  ASSERT_NE(nowhere, nullptr);
  const ExitStatus status =
      run_build({.design = {LATTICAST_SOURCE_DIR "/tests/end_to_end/everything.toml", {}, {}},
                 .folder = folder,
                 .only = {}},
                Console(true, nowhere));
  std::fclose(nowhere);
  ASSERT_EQ(status, ExitStatus::done);
  EXPECT_TRUE(std::filesystem::exists(folder / "everything-report.html"));
  EXPECT_TRUE(std::filesystem::exists(folder / "everything-liner-mold.md"));
  std::filesystem::remove_all(folder);

  for (const char* what : {"draw", "unite", "close", "prepare", "solve"}) {
    EXPECT_FALSE(calls[what].empty()) << what << " was not counted: has its signature changed?";
    for (const auto& [argument, times] : calls[what]) {
      EXPECT_EQ(times, 1) << what << " of " << argument.substr(0, 200);
    }
  }
  // The lattice; and its rings and its grid alone, for the size of its meshes.
  EXPECT_EQ(calls["draw"].size(), 3U);
}

}  // namespace
}  // namespace latticast
