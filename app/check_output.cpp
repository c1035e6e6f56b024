// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/check_output.h"

#include <algorithm>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace latticast {
namespace {

std::ptrdiff_t count(const CheckFindings& findings, Severity severity) {
  return std::count_if(findings.begin(), findings.end(),
                       [&](const CheckFinding& finding) { return finding.severity == severity; });
}

std::string place_text(const CheckFinding& finding) {
  std::string text;
  const auto add = [&](const std::string& words) { text += (text.empty() ? "" : ", ") + words; };
  if (finding.segment > 0) add(fmt::format("segment {}", finding.segment));
  if (!finding.part.empty()) add(finding.part);
  if (finding.place) {
    add(fmt::format("theta {:.1f} degrees, z {:.2f} mm", finding.place->theta_deg,
                    finding.place->z_mm));
  }
  if (finding.pressure_kpa) add(fmt::format("at {:.4g} kPa", *finding.pressure_kpa));
  return text;
}

nlohmann::ordered_json to_json(const std::optional<double>& number) {
  return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json to_json(const CheckFinding& finding) {
  const auto& place = finding.place;
  return {{"code", finding.code},
          {"severity", name(finding.severity)},
          {"segment", finding.segment},
          {"part", finding.part},
          {"theta_deg", to_json(place ? std::optional(place->theta_deg) : std::nullopt)},
          {"z_mm", to_json(place ? std::optional(place->z_mm) : std::nullopt)},
          {"pressure_kPa", to_json(finding.pressure_kpa)},
          {"value", to_json(finding.value)},
          {"limit", to_json(finding.limit)},
          {"unit", finding.unit},
          {"message", finding.message},
          {"remedy", finding.remedy}};
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
  return text + fmt::format("{}, {}, {}\n", number_of(count(findings, Severity::error), "error"),
                            number_of(count(findings, Severity::warning), "warning"),
                            number_of(count(findings, Severity::note), "note"));
}

std::string check_json(std::string_view design, const CheckFindings& findings) {
  nlohmann::ordered_json json;
  json["design"] =
      design.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(design);
  json["errors"] = count(findings, Severity::error);
  json["warnings"] = count(findings, Severity::warning);
  json["notes"] = count(findings, Severity::note);
  json["findings"] = nlohmann::ordered_json::array();
  for (const CheckFinding& finding : findings) json["findings"].push_back(to_json(finding));
  // Names of files may be any bytes.
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace latticast
