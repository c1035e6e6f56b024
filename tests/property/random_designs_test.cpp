// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever design is asked for, `build` either delivers every file, proved sound, or says why a
// product is missing and delivers the others, sound likewise.
#include <cmath>
#include <map>
#include <new>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "app/build_command.h"
#include "design/read_design.h"
#include "export/mesh/mesh_file.h"
#include "geometry/mesh/weld.h"
#include "geometry/solid/audit.h"
#include "geometry/solid/lattice_drawing.h"
#include "geometry/solid/tube_solids.h"
#include "prepared/prepared_responses.h"
#include "report/preview.h"
#include "tests/property/random_design_text.h"
#include "tests/unit/export/test_folder.h"

namespace latticast {
namespace {

constexpr std::uint64_t seed = 20240917;
constexpr int shards = 6;
constexpr int designs_per_shard = 60;

struct Outcome {
  bool delivered = false;
  std::string reason;  // what the program said, when it delivered nothing
};

class Devnull {
 public:
  Devnull() : file_(std::fopen("/dev/null", "w")) {}
  ~Devnull() { std::fclose(file_); }
  Devnull(const Devnull&) = delete;
  Devnull& operator=(const Devnull&) = delete;
  std::FILE* file() const { return file_; }

 private:
  std::FILE* file_;
};

Outcome build(const std::filesystem::path& design, const std::filesystem::path& folder) {
  const Devnull nowhere;
  BuildArguments arguments;
  arguments.design.file = design;
  arguments.folder = folder;
  arguments.force = true;  // whether a printer can make it is not asked here
  testing::internal::CaptureStderr();
  Outcome outcome;
  try {
    outcome.delivered = run_build(arguments, Console(true, nowhere.file())) == ExitStatus::done;
  } catch (const std::bad_alloc&) {
    ADD_FAILURE() << "out of memory";
  } catch (const std::exception& refusal) {
    outcome.reason = refusal.what();
  }
  outcome.reason += testing::internal::GetCapturedStderr();
  return outcome;
}

std::string part_name(const Design& design, std::size_t s, const std::string& part) {
  if (design.segments.size() == 1) return design.name + "-" + part;
  return design.name + "-segment-" + std::to_string(s + 1) + "-" + part;
}

// What a file must hold; a volume of 0 leaves it open.
struct Expected {
  std::string stem;
  int components = 0;
  int genus = 0;
  double volume_mm3 = 0;
};

double start_of_segment(const Design& design, std::size_t s) {
  double start = 0;
  for (std::size_t i = 0; i < s; ++i) start += design.segments[i].length_mm;
  return start;
}

void add_rest_parts(const Design& design, std::size_t s, std::vector<Expected>& parts) {
  const Segment& segment = design.segments[s];
  const Solid lattice =
      lattice_solid(segment, {design.output.tolerance_mm, start_of_segment(design, s), 0, 1});
  parts.push_back(
      {part_name(design, s, "lattice"), lattice.pieces, lattice.genus, lattice.volume_mm3});
  if (!design.make.liner) return;
  const double outer = segment.liner_outer_radius_mm();
  const double inner = segment.inner_radius_mm();
  const double volume = std::numbers::pi * (outer * outer - inner * inner) * segment.length_mm;
  parts.push_back({part_name(design, s, "liner"), 1, 1, volume});
}

void add_preview_parts(const Design& design, std::vector<Expected>& parts) {
  if (!design.make.preview) return;
  PreparedResponses responses(design);
  const std::vector<PreviewShape> shapes = predict_preview(responses);
  for (std::size_t s = 0; s < design.segments.size(); ++s) {
    // Finer sectors may open a gap of a grid step that coarser ones closed.
    LatticeDrawing drawing(design.segments[s], design.output.tolerance_mm);
    const auto rest = [&](const SolidOptions& options) { return lattice_solid(drawing, options); };
    const Solid lattice =
        preview_part({rest}, s, preview_options(design, s, start_of_segment(design, s), shapes),
                     shapes)
            .rest;
    for (const PreviewShape& shape : shapes) {
      const std::string stem = part_name(design, s, "preview-" + shape.label + "-");
      parts.push_back({stem + "lattice", lattice.pieces, lattice.genus, 0});
      parts.push_back({stem + "liner", 1, 1, 0});
    }
  }
}

std::vector<Expected> expected_parts(const Design& design) {
  std::vector<Expected> parts;
  for (std::size_t s = 0; s < design.segments.size(); ++s) add_rest_parts(design, s, parts);
  add_preview_parts(design, parts);
  return parts;
}

void expect_sound(const std::filesystem::path& file, const Expected& expected) {
  SCOPED_TRACE(file.filename().string());
  ASSERT_TRUE(std::filesystem::exists(file));
  const Audit result = audit(weld(read_mesh(file)));
  EXPECT_TRUE(result.passes());
  EXPECT_EQ(result.components, expected.components);
  EXPECT_EQ(result.genus, expected.genus);
  EXPECT_GT(result.volume_mm3, 0);
  if (expected.volume_mm3 == 0) return;
  double farthest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    farthest = std::max({farthest, std::abs(result.lowest[axis]), std::abs(result.highest[axis])});
  }
  // Float32 moves every vertex by half of its last digit at most.
  EXPECT_NEAR(result.volume_mm3, expected.volume_mm3,
              result.area_mm2 * farthest * 0x1p-23 + 1e-9 * expected.volume_mm3);
}

void expect_all_files(const Design& design, const TestFolder& folder) {
  std::size_t files = design.make.preview ? 1 : 0;  // the picture
  for (const Expected& part : expected_parts(design)) {
    for (const MeshFormat format : design.output.formats) {
      const std::string file = part.stem + std::string(extension(format));
      ASSERT_NO_FATAL_FAILURE(expect_sound(folder / file, part));
      ++files;
    }
  }
  EXPECT_EQ(folder.names().size(), files);
  if (design.make.preview) {
    EXPECT_TRUE(std::filesystem::exists(folder / (design.name + "-preview.png")));
  }
}

// What the shard's designs came to.
struct Tally {
  int delivered = 0;
  int mistakes = 0;
  std::map<std::string, int> reasons;
};

void expect_refused_well(const DesignText& design, const Outcome& outcome, const TestFolder& folder,
                         Tally& tally) {
  EXPECT_GT(outcome.reason.size(), 20U) << "refused without a reason: " << outcome.reason;
  EXPECT_EQ(outcome.reason.find("fails its audit"), std::string::npos) << outcome.reason;
  for (const std::string& name : folder.names()) {
    if (name.ends_with(".png")) continue;
    EXPECT_TRUE(audit(weld(read_mesh(folder / name))).passes()) << name;
  }
  const std::size_t line = outcome.reason.find('\n');
  if (design.mistake.empty()) {
    ++tally.reasons[outcome.reason.substr(0, line)];
  } else {
    ++tally.reasons["mistake: " + design.mistake];
  }
}

void try_design(std::uint64_t number, Tally& tally) {
  const DesignText design = random_design_text(number);
  SCOPED_TRACE("seed " + std::to_string(number) + ":\n" + design.text);
  const TestFolder input;
  const TestFolder output;
  put_bytes(input / "design.toml", design.text);
  const Outcome outcome = build(input / "design.toml", output.path());
  tally.mistakes += !design.mistake.empty();
  if (!outcome.delivered) {
    expect_refused_well(design, outcome, output, tally);
    return;
  }
  ++tally.delivered;
  EXPECT_EQ(design.mistake, "") << "delivered all the same";
  const ReadResult read = read_design(design.text, built_in_materials());
  ASSERT_TRUE(read.ok());
  expect_all_files(read.design, output);
}

class RandomDesigns : public testing::TestWithParam<int> {};

TEST_P(RandomDesigns, AreDeliveredSoundOrRefusedWithAReason) {
  Tally tally;
  const std::uint64_t first = seed + static_cast<std::uint64_t>(GetParam() * designs_per_shard);
  for (int i = 0; i < designs_per_shard; ++i) try_design(first + i, tally);
  std::printf("seeds from %llu: %d of %d delivered; %d were written with a mistake\n",
              static_cast<unsigned long long>(first), tally.delivered, designs_per_shard,
              tally.mistakes);
  for (const auto& [reason, count] : tally.reasons) {
    std::printf("  refused %d: %.160s\n", count, reason.c_str());
  }
  EXPECT_GE(tally.delivered, designs_per_shard * 6 / 10) << "refusing everything proves nothing";
}

INSTANTIATE_TEST_SUITE_P(Shards, RandomDesigns, testing::Range(0, shards));

}  // namespace
}  // namespace latticast
