// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/check_command.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "app/check_output.h"
#include "app/design_input.h"
#include "checks/check_design.h"
#include "design/mesh_format.h"
#if LATTICAST_HAS_GEOMETRY
#include "checks/mesh_checks.h"
#include "design/file_error.h"
#include "export/mesh/mesh_file.h"
#endif

namespace latticast {
namespace {

struct Checked {
  CheckFindings findings;
  std::string design;  // its name; empty where there is none
  ExitStatus status = ExitStatus::done;
};

void add(CheckFindings more, Checked& checked) {
  std::move(more.begin(), more.end(), std::back_inserter(checked.findings));
}

#if LATTICAST_HAS_GEOMETRY
void check_mesh(const std::filesystem::path& file, const Console& console, Checked& checked) {
  try {
    add(mesh_checks(read_objects(file), file.string()), checked);
  } catch (const FileError& fault) {
    console.error(fault.what());
    checked.status = ExitStatus::file_error;
  }
}
#else
void check_mesh(const std::filesystem::path& file, const Console& console, Checked& checked) {
  console.error(file.string() +
                ": this program was built without meshes: configure with -DLATTICAST_GEOMETRY=ON");
  checked.status = ExitStatus::invalid;
}
#endif

}  // namespace

ExitStatus run_check(const CheckArguments& arguments, const Console& console) {
  if (std::count_if(arguments.files.begin(), arguments.files.end(), std::not_fn(mesh_format_of)) >
      1) {
    console.error("check takes one design at a time, beside any number of mesh files");
    return ExitStatus::invalid;
  }
  if (!arguments.settings.empty() &&
      std::all_of(arguments.files.begin(), arguments.files.end(), mesh_format_of)) {
    console.error("--set puts values into a design, and there is none among the files");
    return ExitStatus::invalid;
  }
  Checked checked;
  for (const std::filesystem::path& file : arguments.files) {
    if (mesh_format_of(file)) {
      check_mesh(file, console, checked);
      continue;
    }
    const auto design = load_design({file, arguments.settings, arguments.materials}, console);
    if (!design) return ExitStatus::invalid;
    checked.design = design->name;
    add(check_design(*design), checked);
  }
  console.data(arguments.format == "json" ? check_json(checked.design, checked.findings)
                                          : check_table(checked.findings));
  if (checked.status != ExitStatus::done) return checked.status;
  return has_error(checked.findings) ? ExitStatus::check_failed : ExitStatus::done;
}

}  // namespace latticast
