// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/build_command.h"

#include <fmt/core.h>

#include "app/build_checks.h"
#include "app/builder.h"
#include "app/design_input.h"
#include "app/interrupt.h"
#include "app/plan.h"
#include "geometry/pattern/drawing_problems.h"

namespace latticast {
namespace {

bool makes_anything(const Plan& plan) {
  return plan.runs(Stage::lattice) || plan.runs(Stage::liner) || plan.runs(Stage::preview) ||
         plan.runs(Stage::lattice_mold) || plan.runs(Stage::liner_mold) ||
         plan.runs(Stage::report) || plan.runs(Stage::flat_pattern);
}

bool draws_lattice(const Plan& plan) {
  return plan.runs(Stage::lattice) || plan.runs(Stage::preview) || plan.runs(Stage::lattice_mold) ||
         plan.runs(Stage::report) || plan.runs(Stage::flat_pattern);
}

}  // namespace

ExitStatus run_build(const BuildArguments& arguments, const Console& console) {
  const auto materials = load_materials(arguments.materials, console);
  if (!materials) return ExitStatus::invalid;
  const auto design = load_design(arguments.design, *materials, console);
  if (!design) return ExitStatus::invalid;
  const Plan plan = plan_build(*design, arguments.only);
  if (arguments.dry_run) console.data(describe(plan));

  const std::vector<std::string> missing = unavailable(plan);
  for (const std::string& line : missing) console.error(line);
  if (!missing.empty()) return ExitStatus::invalid;
  if (draws_lattice(plan)) require_drawable(design->segments);
  if (arguments.dry_run) return ExitStatus::done;
  if (!makes_anything(plan)) {
    console.note("nothing to make: name what you want under [make], for example lattice = true");
    return ExitStatus::done;
  }
  watch_for_interrupt();
  PreparedDesign prepared(*design);
  const CheckFindings findings = checks_before_build(prepared, plan);
  if (!may_build(findings, arguments.force, console)) return ExitStatus::check_failed;
  try {
    const BuildOrder order{*design, prepared, plan, findings, arguments.folder, arguments.times};
    console.data(build_parts(order, console));
  } catch (const AuditFailed& fault) {
    console.error(fault.what());
    return ExitStatus::check_failed;
  }
  console.note(fmt::format("files are in {}", arguments.folder.string()));
  return ExitStatus::done;
}

}  // namespace latticast
