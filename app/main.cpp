// SPDX-License-Identifier: GPL-3.0-or-later
// Which command runs, and what the exit status says.
#include <cstdio>
#include <stdexcept>
#include <string>

#include <fmt/core.h>

#include "app/check_command.h"
#include "app/command_line.h"
#include "app/console.h"
#include "app/design_input.h"
#include "app/exit_status.h"
#include "app/materials_command.h"
#include "app/new_command.h"
#include "app/products.h"
#include "app/standard_streams.h"
#include "design/file_error.h"
#include "design/joined.h"
#include "design/unsupported_design.h"
#if LATTICAST_HAS_PREDICT
#include "app/predict_command.h"
#endif
#if LATTICAST_HAS_GEOMETRY
#include "app/audit_command.h"
#include "app/build_command.h"
#include "app/interrupt.h"
#include "app/product_failure.h"
#endif

namespace latticast {
namespace {

[[maybe_unused]] DesignInput design_input(const CommandLine& typed) {
  return {typed.design, typed.settings, typed.materials_file};
}

[[maybe_unused]] ExitStatus left_out(const Console& console, std::string_view command,
                                     std::string_view option, std::string_view packages) {
  console.error(
      fmt::format("this program was built without '{}': configure with -D{}=ON (needs {}) and "
                  "build again",
                  command, option, packages));
  return ExitStatus::invalid;
}

ExitStatus run_command(const CommandLine& typed, const Console& console) {
  if (typed.command == "materials") {
    return run_materials(typed.material, typed.materials_file, console);
  }
  if (typed.command == "new") return run_new(typed.kind, typed.new_file, console);
  if (typed.command == "check") {
    return run_check({{typed.files.begin(), typed.files.end()},
                      typed.settings,
                      typed.materials_file,
                      typed.format},
                     console);
  }
  if (typed.command == "predict") {
#if LATTICAST_HAS_PREDICT
    return run_predict({design_input(typed), typed.pressure, typed.format, typed.hold, typed.shape,
                        typed.kinds, typed.wall, typed.times, typed.output},
                       console);
#else
    return left_out(console, "predict", "LATTICAST_PREDICT", "SUNDIALS");
#endif
  }
#if LATTICAST_HAS_GEOMETRY
  if (typed.command == "audit") {
    return run_audit({typed.files.begin(), typed.files.end()}, console);
  }
  return run_build(
      {design_input(typed), typed.folder, typed.only, typed.dry_run, typed.force, typed.times},
      console);
#else
  return left_out(console, typed.command, "LATTICAST_GEOMETRY",
                  "CGAL, libpng, expat, libzip and tinygltf");
#endif
}

// Every typed error of the libraries has its exit status here.
ExitStatus run_guarded(const CommandLine& typed, const Console& console) {
  try {
#if LATTICAST_HAS_GEOMETRY
    try {
      return run_command(typed, console);
    } catch (const std::exception&) {
      const Failure failure = product_failure();
      console.error(failure.text);
      return failure.status;
    }
#else
    return run_command(typed, console);
#endif
  } catch (const FileError& fault) {
    console.error(fault.what());
    return ExitStatus::file_error;
  } catch (const UnsupportedDesign& fault) {
    console.error(fault.what());
    return ExitStatus::invalid;
#if LATTICAST_HAS_GEOMETRY
  } catch (const Interrupted& fault) {
    console.error(fault.what());
    return ExitStatus::interrupted;
#endif
  } catch (const std::invalid_argument& fault) {
    console.error(fault.what());
    return ExitStatus::invalid;
  }
}

int run_main(int argc, char** argv) {
  const CommandWords words{[] { return product_words(true); },
                           [] { return joined(new_kinds(), ", "); }};
  const auto read = read_command_line(argc, argv, words);
  if (const auto* status = std::get_if<ExitStatus>(&read)) return static_cast<int>(*status);
  const auto& typed = std::get<CommandLine>(read);
  return static_cast<int>(run_guarded(typed, Console(typed.quiet)));
}

// Whatever came of the run: who cannot read the answer has none.
int with_output_checked(int status) {
  const std::string lost = lost_output();
  if (lost.empty()) return status;
  std::fputs(("error: " + lost + "\n").c_str(), stderr);
  return static_cast<int>(ExitStatus::file_error);
}

}  // namespace
}  // namespace latticast

int main(int argc, char** argv) {
  latticast::guard_standard_streams();
  try {
    return latticast::with_output_checked(latticast::run_main(argc, argv));
  } catch (const std::exception& fault) {
    // Not one of the errors that commands know: memory ran out, or the program is wrong.
    std::fputs("error: unexpected: ", stderr);
    std::fputs(fault.what(), stderr);
    std::fputs("\n", stderr);
    return latticast::with_output_checked(static_cast<int>(latticast::ExitStatus::unexpected));
  }
}
