// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/check_finding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace latticast {
namespace {

constexpr double rounding = 1e-9;  // relative; far below what any machine resolves

constexpr std::array codes = {
    CheckCode{"strand-too-thin", Severity::error,
              "a strand is narrower than the printer's least wall, at its inner or outer radius"},
};

}  // namespace

std::string_view name(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "";
}

std::span<const CheckCode> all_check_codes() {
  return codes;
}

CheckFinding check_finding(std::string_view code) {
  const auto known = std::find_if(codes.begin(), codes.end(),
                                  [&](const CheckCode& entry) { return entry.code == code; });
  if (known == codes.end()) throw std::logic_error("no check code " + std::string(code));
  CheckFinding finding;
  finding.code = known->code;
  finding.severity = known->severity;
  return finding;
}

bool clearly_below(double value, double limit) {
  return value < limit - rounding * std::abs(limit);
}

bool clearly_above(double value, double limit) {
  return value > limit + rounding * std::abs(limit);
}

}  // namespace latticast
