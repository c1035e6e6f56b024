// SPDX-License-Identifier: GPL-3.0-or-later
// Findings of checks, for people and for programs.
#pragma once

#include <string>
#include <string_view>

#include "checks/check_finding.h"

namespace latticast {

/// Errors first, one paragraph a finding: severity and code, place, sentence, remedy; then how many
/// there are.
std::string check_table(const CheckFindings& findings);

/// {"design": NAME, "errors": n, "warnings": n, "notes": n, "findings": [{code, severity, segment,
/// part, theta_deg, z_mm, pressure_kPa, value, limit, unit, message, remedy}]}; what a finding does
/// not have is null, and so is the design where `design` is empty.
std::string check_json(std::string_view design, const CheckFindings& findings);

}  // namespace latticast
