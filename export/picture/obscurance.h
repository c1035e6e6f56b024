// SPDX-License-Identifier: GPL-3.0-or-later
// Crevices are darker than open faces.
#pragma once

#include <vector>

#include "export/picture/rasteriser.h"

namespace latticast {

/// How much of the light from all round reaches a sample: less where other samples stand close
/// before its facet. After McGuire, Osman, Bukowski and Hennessy, "The Alchemy screen-space ambient
/// obscurance algorithm", HPG 2011. Neighbouring samples look in different directions, so that only
/// the mean over a pixel is smooth.
class Obscurance {
 public:
  /// What is farther than `radius`, in samples, does not count. A pixel has samples x samples of
  /// them.
  Obscurance(double radius, int samples);

  /// From 0 to 1. `normal` is the unit normal of the sample's facet as (right, down, away from the
  /// eye), turned towards the eye.
  double openness(const Layer& layer, int column, int row, const Point& normal) const;

 private:
  struct Step {
    int across;
    int along;
  };

  double radius_;
  int samples_;
  std::vector<std::vector<Step>> steps_;  // for each sample of a pixel, where it looks
};

}  // namespace latticast
