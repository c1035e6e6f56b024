// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace latticast {

/// The text of design/materials.toml as it was when the program was configured.
std::string_view built_in_materials_text();

}  // namespace latticast
