// SPDX-License-Identifier: GPL-3.0-or-later
// Screen-space ambient occlusion: how open each place of a picture is to light from all sides, from
// its depths alone, by the Alchemy method [McGuire 2011].
#pragma once

#include <vector>

#include "export/picture/rasteriser.h"

namespace latticast {

/// How much of the light from all round reaches a sample: less where other samples stand close
/// before its facet. Neighbouring samples look in different directions, so that only
/// the mean over a pixel is smooth.
class AmbientOcclusion {
 public:
  /// What is farther than `radius`, in samples, does not count. A pixel has samples x samples of
  /// them.
  AmbientOcclusion(double radius, int samples);

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
