// SPDX-License-Identifier: GPL-3.0-or-later
// Findings of checks, for people and for programs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "checks/check_finding.h"

namespace latticast {

/// "1 error", "2 errors".
std::string number_of(std::ptrdiff_t count, const char* what);

/// Code, place, sentence and remedy of a finding in one line.
std::string check_line(const CheckFinding& finding);

/// Errors first, one paragraph a finding: severity and code, place, sentence, remedy; then how many
/// there are.
std::string check_table(const CheckFindings& findings);

/// {"design": NAME, "errors": n, "warnings": n, "notes": n, "findings": [{code, severity, segment,
/// part, theta_deg, z_mm, pressure_kPa, value, limit, unit, message, remedy}]}; what a finding does
/// not have is null, and so is the design where `design` is empty.
std::string check_json(std::string_view design, const CheckFindings& findings);

}  // namespace latticast
