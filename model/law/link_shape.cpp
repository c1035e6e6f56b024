// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/law/link_shape.h"

#include <algorithm>
#include <compare>

namespace latticast {

bool LinkShapeOrder::operator()(const LinkShape& a, const LinkShape& b) const {
  if (a.index() != b.index()) return a.index() < b.index();
  const LinkSizes left = describe(a).sizes;
  const LinkSizes right = describe(b).sizes;
  return std::ranges::lexicographical_compare(left, right, [](const auto& x, const auto& y) {
    return std::strong_order(x.second, y.second) < 0;
  });
}

}  // namespace latticast
