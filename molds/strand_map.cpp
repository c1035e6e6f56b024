// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/strand_map.h"

#include <algorithm>
#include <cmath>

namespace latticast {

StrandMap::StrandMap(const Pattern& strands, int cells, int rows, double margin_mm)
    : circumference_mm_(strands.circumference_mm),
      length_mm_(strands.length_mm),
      cells_(cells),
      rows_(rows),
      covered_(static_cast<std::size_t>(cells) * rows, 0) {
  for (const Strand& strand : strands.strands) paint(strand, margin_mm);
  for (int row = 0; row < rows; ++row) {
    const auto first = covered_.begin() + static_cast<std::ptrdiff_t>(row) * cells;
    full_.push_back(std::all_of(first, first + cells, [](char c) { return c != 0; }) ? 1 : 0);
  }
}

bool StrandMap::covers(int row, double u_mm) const {
  const double turns = u_mm / circumference_mm_;
  const auto cell = static_cast<int>((turns - std::floor(turns)) * cells_);
  return covered_[static_cast<std::size_t>(row) * cells_ + std::min(cell, cells_ - 1)] != 0;
}

// Between every second pair of crossings of a row's middle line the row is inside.
void StrandMap::paint(const Strand& strand, double margin_mm) {
  const double row_height = length_mm_ / rows_;
  std::vector<std::vector<double>> crossings(rows_);
  const std::vector<PlanePoint>& outline = strand.outline;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    PlanePoint low = outline[i];
    PlanePoint high = outline[(i + 1) % outline.size()];
    if (low.z > high.z) std::swap(low, high);
    const int first = std::max(0, static_cast<int>(std::ceil(low.z / row_height - 0.5)));
    for (int row = first; row < rows_ && row_z_mm(row) < high.z; ++row) {
      const double part = (row_z_mm(row) - low.z) / (high.z - low.z);
      crossings[row].push_back(std::lerp(low.u, high.u, part));
    }
  }
  for (int row = 0; row < rows_; ++row) {
    std::sort(crossings[row].begin(), crossings[row].end());
    for (std::size_t i = 0; i + 1 < crossings[row].size(); i += 2) {
      paint_row(row, crossings[row][i] - margin_mm, crossings[row][i + 1] + margin_mm);
    }
  }
}

void StrandMap::paint_row(int row, double from_mm, double to_mm) {
  const double cell_width = circumference_mm_ / cells_;
  const auto first = static_cast<std::int64_t>(std::floor(from_mm / cell_width));
  const auto last = std::min<std::int64_t>(
      static_cast<std::int64_t>(std::floor(to_mm / cell_width)), first + cells_ - 1);
  for (std::int64_t cell = first; cell <= last; ++cell) {
    const std::int64_t around = ((cell % cells_) + cells_) % cells_;
    covered_[static_cast<std::size_t>(row) * cells_ + around] = 1;
  }
}

}  // namespace latticast
