// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes of links: the smallest repeated piece of a curved strand, as cut, with its modulus. Two
// links of equal shape have one force law.
#pragma once

#include <cmath>
#include <variant>

#include "model/law/horseshoe_shape.h"
#include "model/law/sinusoid_shape.h"

namespace latticast {

using LinkShape = std::variant<HorseshoeShape, SinusoidShape>;

/// Whether a number can be a size or a modulus: positive and finite.
inline bool is_size(double x) {
  return x > 0 && std::isfinite(x);
}

/// A total order of shapes to look them up by, NaN included: std::strong_order of their numbers.
struct LinkShapeOrder {
  bool operator()(const LinkShape& a, const LinkShape& b) const;
};

inline LinkDescription describe(const LinkShape& shape) {
  return std::visit(
      [](const auto& kind) {
        return LinkDescription{kind.name, kind.sizes()};
      },
      shape);
}

/// The description's name alone.
inline std::string_view path_name(const LinkShape& shape) {
  return std::visit([](const auto& kind) { return kind.name; }, shape);
}

}  // namespace latticast
