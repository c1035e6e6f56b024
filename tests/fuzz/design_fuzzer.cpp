// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds bytes to the design reader. It must return issues or a design, and a design must keep the
// reader's promises; libFuzzer sees crashes, hangs and what the sanitizers find.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "design/material_library.h"
#include "design/read_design.h"

namespace {

using namespace latticast;

void require(bool promise) {
  if (!promise) std::abort();
}

void check(const Segment& segment) {
  require(segment.length_mm > 0 && std::isfinite(segment.length_mm));
  require(segment.liner.inner_radius_mm > 0 && segment.liner.thickness_mm > 0);
  if (!segment.lattice) return;
  for (const Grid& grid : segment.lattice->grids) {
    require(grid.angle_deg > 0 && grid.angle_deg < 180 && !grid.widths_mm.empty());
    for (const double width : grid.widths_mm) require(width > 0 && std::isfinite(width));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const MaterialLibrary materials = built_in_materials();
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const ReadResult result = read_design(text, materials);
  for (const Issue& issue : result.issues) require(!issue.rule.empty());
  if (!result.ok()) return 0;
  require(!result.design.segments.empty() && !result.design.name.empty());
  for (const Segment& segment : result.design.segments) check(segment);
  return 0;
}
