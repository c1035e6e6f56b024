// SPDX-License-Identifier: GPL-3.0-or-later
// Words in a row, for messages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace latticast {

/// The words one after another, `between` between each two; empty for none.
std::string joined(const std::vector<std::string>& words, std::string_view between);

}  // namespace latticast
