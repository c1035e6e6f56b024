// SPDX-License-Identifier: GPL-3.0-or-later
// Raster of the unrolled plane: which cells the strands cover.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/pattern/pattern.h"

namespace latticast {

/// Cells around times rows along the tube. A cell is covered when a strand passes its row's middle
/// line nearer than `margin_mm` along u.
class StrandMap {
 public:
  StrandMap(const Pattern& strands, int cells, int rows, double margin_mm);

  int rows() const { return rows_; }
  double row_z_mm(int row) const { return (row + 0.5) * length_mm_ / rows_; }
  bool covers(int row, double u_mm) const;
  /// Strands run all the way around here: no seam can avoid them.
  bool is_full(int row) const { return full_[row] != 0; }

 private:
  void paint(const Strand& strand, double margin_mm);
  void paint_row(int row, double from_mm, double to_mm);

  double circumference_mm_ = 0;
  double length_mm_ = 0;
  int cells_ = 0;
  int rows_ = 0;
  std::vector<char> covered_;
  std::vector<char> full_;
};

}  // namespace latticast
