// SPDX-License-Identifier: GPL-3.0-or-later
// The files of report/page, built into the library.
#pragma once

#include <string_view>

namespace latticast {

/// The files of report/page as the build put them into this library. Each lives as long as the
/// program.
struct PageAssets {
  std::string_view page;    ///< page.html, with the places named {{so}}
  std::string_view style;   ///< style.css
  std::string_view script;  ///< the page's plain scripts, one after the other
  std::string_view
      viewer;  ///< the bundled 3-D view with its library's licence; empty when left out
  std::string_view
      policy;  ///< hashes of the page's scripts, as its Content-Security-Policy has them
};

PageAssets page_assets();

}  // namespace latticast
