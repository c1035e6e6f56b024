// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/joined.h"

namespace latticast {

std::string joined(const std::vector<std::string>& words, std::string_view between) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += between;
    text += words[i];
  }
  return text;
}

}  // namespace latticast
