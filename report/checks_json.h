// SPDX-License-Identifier: GPL-3.0-or-later
// What the checks found, as the report's JSON has it.
#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace latticast {

struct CheckFinding;

/// {"errors": n, "warnings": n, "notes": n, "findings": [...]}, see checks/findings_json.h; null:
/// nothing was found.
nlohmann::ordered_json checks_json(const std::vector<CheckFinding>* findings);

}  // namespace latticast
