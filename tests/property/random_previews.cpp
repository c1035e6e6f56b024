// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/property/random_previews.h"

#include <algorithm>
#include <exception>

#include <fmt/core.h>

#include "design/read_design.h"
#include "geometry/mesh/weld.h"
#include "geometry/solid/audit.h"
#include "geometry/solid/lattice_drawing.h"
#include "geometry/solid/tube_solids.h"
#include "prepared/prepared_responses.h"
#include "report/preview.h"
#include "tests/property/random_design_text.h"

namespace latticast {
namespace {

constexpr double highest_kpa = 100;
constexpr double shares[] = {0.2, 0.4, 0.6, 0.8, 0.95};

double end_kpa(const Design& design, PreparedResponses& responses) {
  double end = highest_kpa;
  for (std::size_t s = 0; s < design.segments.size(); ++s) {
    for (const CriticalPoint& point : responses.response(s, {highest_kpa}).critical_points) {
      if (point.pressure_kpa > 0 && point.kind != CriticalKind::bifurcation) {
        end = std::min(end, point.pressure_kpa);
      }
    }
  }
  return end;
}

std::string verdict(const Audit& result, const Solid& rest) {
  std::string text;
  for (std::size_t d = 0; d < result.counts.size(); ++d) {
    const auto defect = static_cast<Defect>(d);
    if (result.count(defect) > 0) text += fmt::format(" {} {}", result.count(defect), name(defect));
  }
  if (result.components != rest.pieces || result.genus != rest.genus) {
    text += fmt::format(" {} pieces and genus {} for {} and {}", result.components, result.genus,
                        rest.pieces, rest.genus);
  }
  return text;
}

void move_all(const Design& design, const std::vector<PreviewShape>& shapes, PreviewTrial& trial) {
  double start = 0;
  for (std::size_t s = 0; s < design.segments.size(); ++s) {
    LatticeDrawing drawing(design.segments[s], design.output.tolerance_mm);
    const auto rest = [&](const SolidOptions& options) { return lattice_solid(drawing, options); };
    const PreviewPart part =
        preview_part({rest}, s, preview_options(design, s, start, shapes), shapes);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      ++trial.meshes;
      const std::string found = verdict(part.audits[i], part.rest);
      if (found.empty() || part.touches[i] != 0) continue;
      trial.faults.push_back(fmt::format("segment {} at {}, {} triangles, bent {} rad:{}", s + 1,
                                         shapes[i].label, part.rest.mesh.triangles.size(),
                                         shapes[i].shape.bend_rad(s), found));
    }
    start += design.segments[s].length_mm;
  }
}

}  // namespace

PreviewTrial try_previews(std::uint64_t seed) {
  const DesignText text = random_design_text(seed);
  PreviewTrial trial;
  trial.design = text.text;
  ReadResult read = read_design(text.text, built_in_materials());
  if (!read.ok() || !text.mistake.empty()) return trial;
  Design& design = read.design;
  try {
    PreparedResponses responses(design);
    const double end = end_kpa(design, responses);
    design.make.preview.emplace();
    for (const double share : shares) {
      design.make.preview->cases.push_back(
          {std::vector<double>(design.segments.size(), share * end)});
    }
    move_all(design, predict_preview(responses), trial);
    trial.drawn = true;
  } catch (const std::exception& refused) {
    trial.refusal = refused.what();
  }
  return trial;
}

}  // namespace latticast
