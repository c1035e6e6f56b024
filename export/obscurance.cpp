// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/obscurance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "export/vectors.h"

namespace latticast {
namespace {

using namespace vectors;

constexpr int directions = 12;
constexpr double strength = 2.2;
constexpr double golden_section = 0.618034;  // turns that spread directions evenly
constexpr double flatness = 0.05;  // what a facet's own neighbours may rise without counting

double depth_at(const Layer& layer, int column, int row) {
  if (column < 0 || row < 0 || column >= layer.width || row >= layer.height) {
    return std::numeric_limits<double>::infinity();
  }
  return layer.depth[static_cast<std::size_t>(row) * layer.width + column];
}

}  // namespace

double openness(const Layer& layer, int column, int row, const Point& normal, double radius,
                int samples) {
  const double here = depth_at(layer, column, row);
  const int count = samples * samples;
  const int place = column % samples + samples * (row % samples);
  double sum = 0;
  for (int i = 0; i < directions; ++i) {
    const double turn = 2 * std::numbers::pi * (i * golden_section + double(place) / count);
    const double distance = radius * (i + (place * 4 % count + 0.5) / count) / directions;
    const int across = static_cast<int>(std::lround(distance * std::cos(turn)));
    const int along = static_cast<int>(std::lround(distance * std::sin(turn)));
    const Point to{double(across), double(along),
                   depth_at(layer, column + across, row + along) - here};
    const double away = length(to);
    if (away == 0 || away > radius) {
      continue;
    }
    const double fade = 1 - (away / radius) * (away / radius);
    sum += fade * std::max(0.0, dot(to, normal) / away - flatness);
  }
  return std::max(0.0, 1 - strength * sum / directions);
}

}  // namespace latticast
