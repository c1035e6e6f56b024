// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/law/link_shape.h"

#include <algorithm>
#include <compare>

#include "design/units.h"

namespace latticast {
namespace {

constexpr std::string_view name_of(const HorseshoeShape& /*shape*/) {
  return "horseshoe";
}

constexpr std::string_view name_of(const SinusoidShape& /*shape*/) {
  return "sinusoid";
}

LinkDescription description(const HorseshoeShape& shape) {
  return {name_of(shape),
          {{"radius_mm", shape.radius_mm},
           {"arc_deg", degrees(shape.arc_rad)},
           {"width_mm", shape.width_mm},
           {"thickness_mm", shape.thickness_mm},
           {"youngs_modulus_MPa", shape.youngs_modulus_mpa}}};
}

LinkDescription description(const SinusoidShape& shape) {
  return {name_of(shape),
          {{"amplitude_mm", shape.amplitude_mm},
           {"chord_mm", shape.chord_mm},
           {"width_mm", shape.width_mm},
           {"thickness_mm", shape.thickness_mm},
           {"youngs_modulus_MPa", shape.youngs_modulus_mpa}}};
}

}  // namespace

bool LinkShapeOrder::operator()(const LinkShape& a, const LinkShape& b) const {
  if (a.index() != b.index()) return a.index() < b.index();
  const std::vector<std::pair<std::string_view, double>> left = describe(a).sizes;
  const std::vector<std::pair<std::string_view, double>> right = describe(b).sizes;
  return std::ranges::lexicographical_compare(left, right, [](const auto& x, const auto& y) {
    return std::strong_order(x.second, y.second) < 0;
  });
}

std::string_view path_name(const LinkShape& shape) {
  return std::visit([](const auto& kind) { return name_of(kind); }, shape);
}

LinkDescription describe(const LinkShape& shape) {
  return std::visit([](const auto& kind) { return description(kind); }, shape);
}

}  // namespace latticast
