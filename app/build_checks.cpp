// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/build_checks.h"

#include <fmt/core.h>

#include "app/check_output.h"
#include "app/products.h"
#include "checks/check_design.h"
#include "checks/findings_json.h"
#include "design/design.h"
#include "prepared/prepared_design.h"

namespace latticast {
namespace {

Design narrowed(Design design, const Plan& plan) {
  for (const Product& product : products()) {
    if (!plan.runs(product.stage)) product.leave_out(design.make);
  }
  return design;
}

}  // namespace

CheckFindings checks_before_build(PreparedDesign& prepared, const Plan& plan) {
  const Design& design = prepared.design;
  if (plan.runs(Stage::report)) return check_design(design, prepared);
  CheckScope scope;
  scope.printing = runs_any(plan, &Product::is_printed);
  scope.casting = runs_any(plan, &Product::is_mold);
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
