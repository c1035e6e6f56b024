// SPDX-License-Identifier: GPL-3.0-or-later
// The stability atlas of drawing: random designs over lengths 1e-2 to 1e5 mm, 1 to 2000 strands,
// angles 0.01 to 179.99 degrees, tolerances 1e-1 to 1e-5 mm and width ratios to 1000 go through the
// design reader and become meshes, each of which is audited. Writes
//   drawing_summary  points by part and verdict
//   drawing_points   every point (CSV only)
//   drawing          one sentence
// Each design runs in a process of its own: a crash or an endless loop is a finding.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include <fmt/core.h>

#include "bench/study.h"
#include "design/read_design.h"
#include "geometry/mesh/weld.h"
#include "geometry/pattern/cannot_draw.h"
#include "geometry/solid/arrangement.h"
#include "geometry/solid/audit.h"
#include "geometry/solid/geometry_error.h"
#include "geometry/solid/tube_solids.h"
#include "tests/random_numbers.h"

namespace {

using namespace latticast;

constexpr int sample = 600;
constexpr unsigned seed = 20261124;
constexpr double limit_s = 20;
constexpr double most_pieces = 8000;  // of outline, which keeps a point below about a second

/// One design as text, and what it was drawn from.
struct Drawing {
  std::string text;
  double length_mm = 0;
  double tolerance_mm = 0;
  double angle_deg = 90;
  int strands = 0;
  double pieces = 0;  ///< of outline, roughly
};

std::string number(double value) {
  return fmt::format("{:.12g}", value);
}

double random_angle(testing::Random& dice) {
  if (dice.chance(0.2)) return 90;
  if (dice.chance(0.4)) {
    const double from_end = dice.log_between(0.01, 10);
    return dice.chance(0.5) ? from_end : 180 - from_end;
  }
  return dice.between(5, 175);
}

std::string widths_text(testing::Random& dice, int count, double widest) {
  if (!dice.chance(0.3) || count < 2) return number(widest);
  const double thin = widest / dice.log_between(1, 1000);
  return "{ from = " + number(thin) + ", to = " + number(widest) +
         (dice.chance(0.5) ? ", profile = \"cosine\" }" : ", profile = \"halves\" }");
}

/// Sectors around the tube at that tolerance (docs/geometry.md).
double sectors(double radius_mm, double tolerance_mm) {
  return std::max(12.0, 2 * std::numbers::pi * std::sqrt(radius_mm / (12 * tolerance_mm)));
}

std::string grid_text(testing::Random& dice, double middle_mm, Drawing& drawing) {
  const double angle = random_angle(dice);
  const int count = dice.chance(0.15)  ? 1
                    : dice.chance(0.2) ? static_cast<int>(dice.log_between(30, 2000))
                                       : dice.integer(2, 24);
  const double sine = std::sin(angle * std::numbers::pi / 180);
  const double around = 2 * std::numbers::pi * middle_mm;
  const double width = around * sine / count * dice.log_between(1e-3, 0.95);
  std::string text = "[[segment.lattice.grid]]\nangle = " + number(angle) +
                     "\ncount = " + std::to_string(count) +
                     "\nwidth = " + widths_text(dice, count, width) + "\n";
  if (dice.chance(0.2) && count <= 24) {
    const double arcs = dice.integer(1, 12);
    const double arc = dice.between(20, 300);
    const double half = arc * std::numbers::pi / 360;
    text +=
        "horseshoe = { radius = " + number(drawing.length_mm / (arcs * 2 * std::sin(half) * sine)) +
        ", arc = " + number(arc) + " }\n";
    drawing.pieces += count * arcs * 40;
  }
  const double turns =
      std::abs(drawing.length_mm / std::tan(angle * std::numbers::pi / 180)) / around;
  drawing.pieces += 2 * count * (1 + turns * sectors(middle_mm, drawing.tolerance_mm));
  drawing.angle_deg = angle;
  drawing.strands += count;
  return text;
}

Drawing draft(testing::Random& dice) {
  Drawing drawing;
  drawing.length_mm = dice.log_between(1e-2, 1e5);
  drawing.tolerance_mm = dice.log_between(1e-5, 1e-1);
  const double inner = drawing.length_mm * dice.log_between(1e-3, 10);
  const double wall = inner * dice.log_between(1e-3, 3);
  const double layer = (inner + wall) * dice.log_between(1e-3, 1);
  const double middle = inner + wall + 0.5 * layer;
  std::string text =
      "name = \"atlas\"\n[export]\ntolerance = " + number(drawing.tolerance_mm) +
      "\n[[segment]]\nlength = " + number(drawing.length_mm) +
      "\n[segment.liner]\ninner_radius = " + number(inner) + "\nthickness = " + number(wall) +
      "\nmaterial = \"ecoflex-00-50\"\n[segment.lattice]\nthickness = " + number(layer) +
      "\nmaterial = \"hei-cast-8400\"\n";
  const bool rings = dice.chance(0.6);
  if (rings) {
    const int count =
        dice.chance(0.1) ? static_cast<int>(dice.log_between(30, 2000)) : dice.integer(2, 24);
    text += "[segment.lattice.rings]\ncount = " + std::to_string(count) +
            "\nwidth = " + number(drawing.length_mm / count * dice.log_between(1e-3, 0.99)) + "\n";
    drawing.pieces += 2 * count * sectors(middle, drawing.tolerance_mm);
  }
  const int families = dice.integer(rings ? 0 : 1, 2);
  for (int i = 0; i < families; ++i) text += grid_text(dice, middle, drawing);
  drawing.text = text + "[load]\npressure = 0\n[make]\nlattice = true\n";
  return drawing;
}

/// Nine in ten are small enough to be drawn at once; the tenth may be large.
Drawing random_drawing(int index) {
  testing::Random dice(seed, index);
  const double most = dice.chance(0.1) ? 10 * most_pieces : most_pieces;
  Drawing drawing = draft(dice);
  while (drawing.pieces > most) drawing = draft(dice);
  return drawing;
}

std::string judge(const Solid& solid) {
  const Audit result = audit(weld(solid.mesh));
  if (!result.passes()) {
    return "wrong\taudit: " + std::string(name(result.findings.front().defect));
  }
  if (result.components != solid.pieces || result.genus != solid.genus) return "wrong\ttopology";
  const double apart = std::abs(result.volume_mm3 - solid.volume_mm3);
  if (!(apart <= solid.volume_bound_mm3)) return "wrong\tvolume";
  return "verified\tmesh";
}

/// "part <tab> verdict <tab> kind" for each part.
std::string examine(const Drawing& drawing) {
  const ReadResult read = read_design(drawing.text, built_in_materials());
  if (!read.ok()) {
    for (const Issue& issue : read.issues) {
      if (issue.rule.empty() || issue.key.empty()) return "design\twrong\tno reason\n";
    }
    return "design\trefused\t" + read.issues.front().key + ": " + read.issues.front().rule + "\n";
  }
  const Segment& segment = read.design.segments.front();
  const SolidOptions options{read.design.output.tolerance_mm};
  std::string text;
  for (const bool liner : {false, true}) {
    text += liner ? "liner\t" : "lattice\t";
    try {
      text += judge(liner ? liner_solid(segment, options) : lattice_solid(segment, options));
    } catch (const GeometryError& reason) {
      text += std::string("refused\t") + reason.what();
    } catch (const CannotDraw& reason) {
      text += std::string("refused\t") + reason.what();
    } catch (const std::exception& reason) {
      text += std::string("wrong\t") + reason.what();
    }
    std::replace(text.begin(), text.end(), '\n', ' ');
    std::replace(text.begin(), text.end(), '\v', '\n');
    text += '\v';
  }
  std::replace(text.begin(), text.end(), '\v', '\n');
  return text;
}

struct Counts {
  std::string part;
  std::array<int, 3> by_verdict{};  // verified, refused, wrong
};

}  // namespace

int main(int count, char** arguments) {
  const std::filesystem::path folder = study_folder(count, arguments);
  std::array<Counts, 3> counts = {{{"design", {}}, {"lattice", {}}, {"liner", {}}}};
  StudyTable points("drawing_points",
                    {"index", "length (mm)", "tolerance (mm)", "angle (degrees)", "strands", "part",
                     "verdict", "kind", "time (s)", "memory (MB)"});
  for (int i = 0; i < sample; ++i) {
    const Drawing drawing = random_drawing(i);
    const Cost cost = in_own_process([&] { return examine(drawing); }, limit_s);
    std::istringstream lines(cost.finished ? cost.result : "lattice\twrong\tno end, or a crash\n");
    for (std::string line; std::getline(lines, line);) {
      const std::size_t first = line.find('\t');
      const std::size_t second = line.find('\t', first + 1);
      const std::string part = line.substr(0, first);
      const std::string verdict = line.substr(first + 1, second - first - 1);
      std::string kind = line.substr(second + 1);
      std::replace(kind.begin(), kind.end(), ',', ';');
      points.add({static_cast<double>(i), drawing.length_mm, drawing.tolerance_mm,
                  drawing.angle_deg, static_cast<double>(drawing.strands), part, verdict, kind,
                  cost.seconds, cost.memory_mb});
      for (Counts& counted : counts) {
        if (counted.part != part) continue;
        ++counted.by_verdict[verdict == "verified" ? 0 : verdict == "refused" ? 1 : 2];
      }
    }
  }
  StudyTable summary("drawing_summary",
                     {"part", "points", "sound meshes", "refused by name", "wrong"});
  std::array<int, 3> all{};
  for (const Counts& counted : counts) {
    const auto& n = counted.by_verdict;
    for (int v = 0; v < 3; ++v) all[v] += n[v];
    summary.add({counted.part, static_cast<double>(n[0] + n[1] + n[2]), static_cast<double>(n[0]),
                 static_cast<double>(n[1]), static_cast<double>(n[2])});
  }
  summary.add({std::string("all"), static_cast<double>(all[0] + all[1] + all[2]),
               static_cast<double>(all[0]), static_cast<double>(all[1]),
               static_cast<double>(all[2])});
  summary.write(folder);
  points.write(folder, false);
  write_sentence(folder, "drawing",
                 fmt::format("Drawing: {} points, {} sound meshes, {} refused by name, {} wrong.",
                             all[0] + all[1] + all[2], all[0], all[1], all[2]));
  return 0;
}
