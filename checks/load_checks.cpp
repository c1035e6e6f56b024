// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/load_checks.h"

#include <stdexcept>

#include "checks/bulging_checks.h"
#include "checks/contact_checks.h"
#include "checks/loaded_segment.h"
#include "checks/stability_checks.h"
#include "checks/strain_checks.h"
#include "checks/validity_checks.h"
#include "design/unsupported_design.h"
#include "model/law/force_table.h"

namespace latticast {
namespace {

CheckFinding not_predictable(std::size_t index, const char* reason) {
  CheckFinding finding = check_finding("not-predictable");
  finding.segment = static_cast<int>(index) + 1;
  finding.message = std::string("nothing under load could be checked: ") + reason;
  finding.remedy = "change what the model does not cover, or check the part by a test";
  return finding;
}

}  // namespace

CheckFindings load_checks(PreparedResponses& responses) {
  const Design& design = responses.design();
  CheckFindings findings;
  if (design.load.empty()) return findings;
  for (std::size_t i = 0; i < design.segments.size(); ++i) {
    try {
      const LoadedSegment loaded = load_segment(responses, i);
      check_stability(loaded, findings);
      check_bulging(loaded, findings);
      check_strains(loaded, findings);
      check_contact(loaded, findings);
      check_validity(loaded, findings);
    } catch (const UnsupportedDesign& reason) {
      findings.push_back(not_predictable(i, reason.what()));
    } catch (const LawNotSolved& reason) {
      findings.push_back(not_predictable(i, reason.what()));
    }
  }
  return findings;
}

}  // namespace latticast
