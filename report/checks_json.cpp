// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/checks_json.h"

#include <nlohmann/json.hpp>

#include "checks/findings_json.h"

namespace latticast {

nlohmann::ordered_json checks_json(const std::vector<CheckFinding>* findings) {
  const CheckFindings none;
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  add_findings(findings ? *findings : none, json);
  return json;
}

}  // namespace latticast
