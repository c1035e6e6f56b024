// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/check_command.h"

#include <algorithm>

#include "app/check_output.h"
#include "app/design_input.h"
#include "checks/check_design.h"

namespace latticast {
namespace {

bool has_error(const CheckFindings& findings) {
  return std::any_of(findings.begin(), findings.end(), [](const CheckFinding& finding) {
    return finding.severity == Severity::error;
  });
}

}  // namespace

ExitStatus run_check(const CheckArguments& arguments, const Console& console) {
  const auto materials = load_materials(arguments.materials, console);
  if (!materials) return ExitStatus::invalid;
  const auto design = load_design(arguments.files.front(), *materials, console);
  if (!design) return ExitStatus::invalid;
  const CheckFindings findings = check_design(*design);
  console.data(arguments.format == "json" ? check_json(design->name, findings)
                                          : check_table(findings));
  return has_error(findings) ? ExitStatus::check_failed : ExitStatus::done;
}

}  // namespace latticast
