// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/rings.h"

#include <cmath>

namespace latticast {

double ring_pitch_mm(const Rings& rings, double segment_length_mm) {
  if (rings.pitch_mm) return *rings.pitch_mm;
  return (segment_length_mm - rings.width_mm) / (*rings.count - 1);
}

std::vector<double> ring_centres_mm(const Rings& rings, double segment_length_mm) {
  const double pitch = ring_pitch_mm(rings, segment_length_mm);
  const double first = rings.pitch_mm ? rings.first_centre_mm() : 0.5 * rings.width_mm;
  // A ring that ends on the segment's end up to rounding is on the segment.
  const double last = segment_length_mm * (1 + 1e-12) - 0.5 * rings.width_mm;
  const double room = std::floor((last - first) / pitch);
  const int count = rings.count ? *rings.count : (last < first ? 0 : static_cast<int>(room) + 1);
  std::vector<double> centres(count);
  for (int i = 0; i < count; ++i) centres[i] = first + i * pitch;
  return centres;
}

}  // namespace latticast
