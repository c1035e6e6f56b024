// SPDX-License-Identifier: GPL-3.0-or-later
// Design files as a stranger might write them: sizes over decades, angles that invite trouble, and
// now and then a mistake.
#pragma once

#include <cstdint>
#include <string>

namespace latticast {

struct DesignText {
  std::string text;
  std::string mistake;  ///< what makes the design impossible; empty: nothing was meant to
};

/// The same number gives the same text on every machine.
DesignText random_design_text(std::uint64_t seed);

}  // namespace latticast
