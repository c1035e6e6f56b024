// SPDX-License-Identifier: GPL-3.0-or-later
// Texts from outside as a terminal, a list of files or a page may show them.
#pragma once

#include <string>
#include <string_view>

namespace latticast {

/// A character that shows nothing itself but changes how what is around it shows, found in UTF-8.
enum class Unprintable {
  none,
  control,  ///< U+0000 to U+001F, U+007F to U+009F
  hidden,   ///< turns the direction of writing, breaks a line or has no width: U+061C, U+200B,
            ///< U+200E, U+200F, U+2028 to U+202E, U+2060 to U+2069, U+FEFF
};

/// The first of them in a text.
Unprintable first_unprintable(std::string_view text);

/// Each of them written as JSON does, \u001b, but for those in `kept`. Bytes that are no UTF-8
/// stay.
std::string printable(std::string_view text, std::string_view kept = {});

}  // namespace latticast
