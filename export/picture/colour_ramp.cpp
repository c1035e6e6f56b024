// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/picture/colour_ramp.h"

#include <algorithm>
#include <cmath>

namespace latticast {
namespace {

constexpr double least_magnitude = 1e-6;
constexpr double noticed_compression = 0.01;
constexpr double most_steps = 5;  // from 0 to an end
constexpr ByteColour grey{128, 128, 128};

// Lightness, green to red, blue to yellow.
using OkLab = std::array<double, 3>;
// From strain 0 to the end, over one colour in between.
using Arm = std::array<OkLab, 3>;

constexpr OkLab pale{0.95, -0.001, 0.012};
constexpr Arm tension{pale, OkLab{0.74, 0.068, 0.128}, OkLab{0.42, 0.110, 0.059}};
constexpr Arm compression{pale, OkLab{0.72, -0.052, -0.091}, OkLab{0.40, -0.010, -0.115}};

double distance(const OkLab& a, const OkLab& b) {
  return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

OkLab between(const OkLab& a, const OkLab& b, double share) {
  return {std::lerp(a[0], b[0], share), std::lerp(a[1], b[1], share), std::lerp(a[2], b[2], share)};
}

// By length along the arm, so that steps are even.
OkLab along(const Arm& arm, double share) {
  const double first = distance(arm[0], arm[1]);
  const double second = distance(arm[1], arm[2]);
  const double length = share * (first + second);
  if (length <= first) return between(arm[0], arm[1], length / first);
  return between(arm[1], arm[2], std::min(1.0, (length - first) / second));
}

std::uint8_t encoded(double linear) {
  const double clamped = std::clamp(linear, 0.0, 1.0);
  const double value =
      clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * std::pow(clamped, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * value));
}

double cubed(double x) {
  return x * x * x;
}

// The published inverse of OKLab's definition, to linear sRGB.
ByteColour to_srgb(const OkLab& lab) {
  const double l = cubed(lab[0] + 0.3963377774 * lab[1] + 0.2158037573 * lab[2]);
  const double m = cubed(lab[0] - 0.1055613458 * lab[1] - 0.0638541728 * lab[2]);
  const double s = cubed(lab[0] - 0.0894841775 * lab[1] - 1.2914855480 * lab[2]);
  return {encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

// At most `most_steps` of it reach as far as `magnitude`.
double round_step(double magnitude) {
  const double least = magnitude / most_steps;
  const double decade = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * decade >= least * (1 - 1e-9)) return factor * decade;
  }
  return 10 * decade;
}

}  // namespace

ColourRamp strain_ramp(double least, double largest) {
  double magnitude = least_magnitude;
  for (const double end : {std::abs(least), std::abs(largest)}) {
    if (std::isfinite(end)) magnitude = std::max(magnitude, end);
  }
  ColourRamp ramp;
  ramp.step = round_step(magnitude);
  ramp.high = ramp.step * std::ceil(magnitude / ramp.step * (1 - 1e-9));
  ramp.low = least < -noticed_compression * magnitude ? -ramp.high : 0;
  return ramp;
}

ByteColour colour_of(const ColourRamp& ramp, double strain) {
  if (std::isnan(strain)) return grey;
  const double share = std::clamp(strain, ramp.low, ramp.high) / ramp.high;
  return to_srgb(share < 0 ? along(compression, -share) : along(tension, share));
}

std::vector<LegendEntry> legend(const ColourRamp& ramp) {
  std::vector<LegendEntry> entries;
  const auto first = std::lround(ramp.low / ramp.step);
  const auto last = std::lround(ramp.high / ramp.step);
  for (auto i = first; i <= last; ++i) {
    const double strain = static_cast<double>(i) * ramp.step;
    entries.push_back({strain, colour_of(ramp, strain)});
  }
  return entries;
}

}  // namespace latticast
