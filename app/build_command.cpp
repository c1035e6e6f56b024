// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/build_command.h"

#include <algorithm>

#include <fmt/core.h>

#include "app/build_checks.h"
#include "app/builder.h"
#include "app/interrupt.h"
#include "app/mesh_plan.h"
#include "app/plan.h"
#include "app/products.h"
#include "files/staging_folder.h"
#include "geometry/pattern/drawing_problems.h"
#include "prepared/prepared_design.h"

namespace latticast {
ExitStatus run_build(const BuildArguments& arguments, const Console& console) {
  const auto design = load_design(arguments.design, console);
  if (!design) return ExitStatus::invalid;
  const Plan plan = plan_build(*design, arguments.only);
  if (arguments.dry_run) console.data(describe(plan));

  const std::vector<std::string> missing = unavailable(plan);
  for (const std::string& line : missing) console.error(line);
  if (!missing.empty()) return ExitStatus::invalid;
  if (runs_any(plan, &Product::draws_lattice)) require_drawable(design->segments);
  PreparedDesign prepared(*design);
  const MeshPlan meshes = plan_meshes(prepared, plan);
  if (arguments.dry_run) console.data(describe(meshes));
  require_possible(meshes, design->output.tolerance_mm);
  if (arguments.dry_run) return ExitStatus::done;
  const auto runs = [&](const Product& product) { return plan.runs(product.stage); };
  if (std::none_of(products().begin(), products().end(), runs)) {
    console.note("nothing to make: name what you want under [make], for example lattice = true");
    return ExitStatus::done;
  }
  clear_left_overs(arguments.folder);
  watch_for_interrupt();
  const CheckFindings findings = checks_before_build(prepared, plan);
  if (!may_build(findings, arguments.force, console)) return ExitStatus::check_failed;
  const BuildOrder order{*design, prepared, plan, findings, arguments.folder, arguments.times};
  const BuildResult built = build_parts(order, console);
  console.data(built.files);
  for (const Failure& failure : built.failures) console.error(failure.text);
  if (!built.files.empty()) {
    console.note(fmt::format("{}files are in {}", built.failures.empty() ? "" : "all other ",
                             arguments.folder.string()));
  }
  return built.failures.empty() ? ExitStatus::done : built.failures.front().status;
}

}  // namespace latticast
