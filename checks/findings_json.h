// SPDX-License-Identifier: GPL-3.0-or-later
// Findings of checks as JSON, in whichever library's JSON type the caller has: an ordered object
// that initializer lists make.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>

#include "checks/check_finding.h"

namespace latticast {

/// How many findings are of this severity.
inline std::ptrdiff_t count_of(const CheckFindings& findings, Severity severity) {
  return std::count_if(findings.begin(), findings.end(),
                       [&](const CheckFinding& finding) { return finding.severity == severity; });
}

/// {code, severity, segment, part, theta_deg, z_mm, pressure_kPa, value, limit, unit, message,
/// remedy}; what the finding does not have is null.
template <class Json>
Json finding_json(const CheckFinding& finding) {
  const auto number = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
  };
  const auto& place = finding.place;
  return {{"code", finding.code},
          {"severity", name(finding.severity)},
          {"segment", finding.segment},
          {"part", finding.part},
          {"theta_deg", number(place ? std::optional(place->theta_deg) : std::nullopt)},
          {"z_mm", number(place ? std::optional(place->z_mm) : std::nullopt)},
          {"pressure_kPa", number(finding.pressure_kpa)},
          {"value", number(finding.value)},
          {"limit", number(finding.limit)},
          {"unit", finding.unit},
          {"message", finding.message},
          {"remedy", finding.remedy}};
}

/// Adds {"errors": n, "warnings": n, "notes": n, "findings": [...]} to an object.
template <class Json>
void add_findings(const CheckFindings& findings, Json& object) {
  object["errors"] = count_of(findings, Severity::error);
  object["warnings"] = count_of(findings, Severity::warning);
  object["notes"] = count_of(findings, Severity::note);
  object["findings"] = Json::array();
  for (const CheckFinding& finding : findings) {
    object["findings"].push_back(finding_json<Json>(finding));
  }
}

}  // namespace latticast
