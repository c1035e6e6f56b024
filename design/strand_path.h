// SPDX-License-Identifier: GPL-3.0-or-later
// Strand paths: the line that a strand follows along its chord line. How each is drawn is in
// geometry/pattern/strand_path.h, its force law in model/law/link_shape.h.
#pragma once

#include <variant>

#include "design/horseshoe.h"
#include "design/path_description.h"
#include "design/sinusoid.h"
#include "design/straight_path.h"

namespace latticast {

/// The chord line first; the curved ones have a key in the design file.
using StrandPath = std::variant<StraightPath, Horseshoe, Sinusoid>;

/// Whether the centre line leaves the chord line, so that the strand bends when it is pulled.
inline bool is_curved(const StrandPath& path) {
  return !std::holds_alternative<StraightPath>(path);
}

inline PathDescription describe(const StrandPath& path) {
  return std::visit([](const auto& kind) { return kind.description(); }, path);
}

/// The path of a strand that is `factor` times as large.
inline StrandPath scaled(const StrandPath& path, double factor) {
  return std::visit([&](const auto& kind) { return StrandPath(kind.scaled(factor)); }, path);
}

}  // namespace latticast
