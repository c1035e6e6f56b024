// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/build_checks.h"

#include <fmt/core.h>

#include "app/check_output.h"
#include "checks/check_design.h"
#include "checks/findings_json.h"

namespace latticast {
namespace {

Design narrowed(Design design, const Plan& plan) {
  Make& make = design.make;
  make.lattice = plan.runs(Stage::lattice);
  make.liner = plan.runs(Stage::liner);
  make.flat_pattern = plan.runs(Stage::flat_pattern);
  make.report = plan.runs(Stage::report);
  if (!plan.runs(Stage::preview)) make.preview.reset();
  if (!plan.runs(Stage::lattice_mold)) make.lattice_mold.reset();
  if (!plan.runs(Stage::liner_mold)) make.liner_mold.reset();
  return design;
}

}  // namespace

CheckFindings checks_before_build(PreparedDesign& prepared, const Plan& plan) {
  const Design& design = prepared.design;
  if (plan.runs(Stage::report)) return check_design(design, prepared);
  const bool molds = plan.runs(Stage::lattice_mold) || plan.runs(Stage::liner_mold);
  CheckScope scope;
  scope.printing = plan.runs(Stage::lattice) || plan.runs(Stage::liner) || molds;
  scope.casting = molds;
  scope.inflating = plan.runs(Stage::preview);
  return check_design(narrowed(design, plan), prepared, scope);
}

bool may_build(const CheckFindings& findings, bool force, const Console& console) {
  for (const CheckFinding& finding : findings) {
    if (finding.severity == Severity::error) console.error(check_line(finding));
  }
  const auto warnings = count_of(findings, Severity::warning);
  const auto notes = count_of(findings, Severity::note);
  if (warnings + notes > 0) {
    console.note(fmt::format("checks: {} and {}; latticast check shows them",
                             number_of(warnings, "warning"), number_of(notes, "note")));
  }
  if (!has_error(findings)) return true;
  if (force) {
    console.note("going on in spite of the errors, as --force says");
    return true;
  }
  console.error("nothing was made: mend the design, or build it as it is with --force");
  return false;
}

}  // namespace latticast
