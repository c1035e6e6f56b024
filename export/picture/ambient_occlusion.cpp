// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/picture/ambient_occlusion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "export/picture/vectors.h"

namespace latticast {
namespace {

constexpr int directions = 12;
constexpr double strength = 2.2;
constexpr double golden_section = 0.618034;  // turns that spread directions evenly
constexpr double flatness = 0.05;  // what a facet's neighbours may rise without darkening it

double depth_at(const Layer& layer, int column, int row) {
  if (column < 0 || row < 0 || column >= layer.width || row >= layer.height) {
    return std::numeric_limits<double>::infinity();
  }
  return layer.depth[static_cast<std::size_t>(row) * layer.width + column];
}

}  // namespace

AmbientOcclusion::AmbientOcclusion(double radius, int samples)
    : radius_(radius), samples_(samples) {
  const int places = samples * samples;
  for (int place = 0; place < places; ++place) {
    std::vector<Step>& steps = steps_.emplace_back();
    for (int i = 0; i < directions; ++i) {
      const double turn = 2 * std::numbers::pi * (i * golden_section + double(place) / places);
      const double distance = radius * (i + (place * 4 % places + 0.5) / places) / directions;
      steps.push_back({static_cast<int>(std::lround(distance * std::cos(turn))),
                       static_cast<int>(std::lround(distance * std::sin(turn)))});
    }
  }
}

double AmbientOcclusion::openness(const Layer& layer, int column, int row,
                                  const Point& normal) const {
  const double here = depth_at(layer, column, row);
  double sum = 0;
  for (const Step& step : steps_[column % samples_ + samples_ * (row % samples_)]) {
    const Point to{double(step.across), double(step.along),
                   depth_at(layer, column + step.across, row + step.along) - here};
    const double away = length(to);
    if (away == 0 || away > radius_) {
      continue;
    }
    const double fade = 1 - (away / radius_) * (away / radius_);
    sum += fade * std::max(0.0, dot(to, normal) / away - flatness);
  }
  return std::max(0.0, 1 - strength * sum / directions);
}

}  // namespace latticast
