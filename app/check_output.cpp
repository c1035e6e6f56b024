// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/check_output.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "checks/findings_json.h"
#include "design/text/written_number.h"

namespace latticast {
namespace {

std::string place_text(const CheckFinding& finding) {
  std::string text;
  const auto add = [&](const std::string& words) { text += (text.empty() ? "" : ", ") + words; };
  if (finding.segment > 0) add(fmt::format("segment {}", finding.segment));
  if (!finding.part.empty()) add(finding.part);
  if (finding.place) {
    add(fmt::format("theta {:.1f} degrees, z {:.2f} mm", finding.place->theta_deg,
                    finding.place->z_mm));
  }
  if (finding.pressure_kpa) add(fmt::format("at {} kPa", written(*finding.pressure_kpa, 4)));
  return text;
}

}  // namespace

std::string number_of(std::ptrdiff_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string check_line(const CheckFinding& finding) {
  std::string text = fmt::format("{}: {}: {}", finding.code, place_text(finding), finding.message);
  if (!finding.remedy.empty()) text += fmt::format("; remedy: {}", finding.remedy);
  return text;
}

std::string check_table(const CheckFindings& findings) {
  std::string text;
  for (const Severity severity : {Severity::error, Severity::warning, Severity::note}) {
    for (const CheckFinding& finding : findings) {
      if (finding.severity != severity) continue;
      text += fmt::format("{} {}\n  {}: {}\n", name(severity), finding.code, place_text(finding),
                          finding.message);
      if (!finding.remedy.empty()) text += fmt::format("  remedy: {}\n", finding.remedy);
    }
  }
  return text + fmt::format("{}, {}, {}\n", number_of(count_of(findings, Severity::error), "error"),
                            number_of(count_of(findings, Severity::warning), "warning"),
                            number_of(count_of(findings, Severity::note), "note"));
}

std::string check_json(std::string_view design, const CheckFindings& findings) {
  nlohmann::ordered_json json;
  json["design"] =
      design.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(design);
  add_findings(findings, json);
  // Names of files may be any bytes.
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace latticast
