// SPDX-License-Identifier: GPL-3.0-or-later
// Which command runs, and what the exit status says.
#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "app/check_command.h"
#include "app/command_line.h"
#include "app/console.h"
#include "app/exit_status.h"
#include "app/materials_command.h"
#include "app/new_command.h"
#include "app/products.h"
#include "app/standard_streams.h"
#include "design/file_error.h"
#include "design/joined.h"
#include "design/nearest_name.h"
#include "design/unsupported_design.h"
#if LATTICAST_HAS_PREDICT
#include "app/predict_command.h"
#endif
#if LATTICAST_HAS_GEOMETRY
#include "app/audit_command.h"
#include "app/build_command.h"
#include "app/interrupt.h"
#include "geometry/pattern/cannot_draw.h"
#include "geometry/solid/geometry_error.h"
#if LATTICAST_HAS_MOLDS
#include "molds/cannot_mold.h"
#endif
#if LATTICAST_HAS_PREDICT
#include "report/no_equilibrium.h"
#endif
#endif

namespace latticast {
namespace {

std::optional<std::filesystem::path> materials_path(const CommandLine& typed) {
  if (typed.materials_file.empty()) return std::nullopt;
  return typed.materials_file;
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
    return run_materials(typed.material, materials_path(typed), console);
  }
  if (typed.command == "new") return run_new(typed.kind, typed.new_file, console);
  if (typed.command == "check") {
    return run_check({{typed.checked_files.begin(), typed.checked_files.end()},
                      materials_path(typed),
                      typed.check_format},
                     console);
  }
  if (typed.command == "predict") {
#if LATTICAST_HAS_PREDICT
    return run_predict({typed.design, materials_path(typed), typed.pressure, typed.format,
                        typed.hold, typed.shape, typed.kinds},
                       console);
#else
    return left_out(console, "predict", "LATTICAST_PREDICT", "SUNDIALS");
#endif
  }
#if LATTICAST_HAS_GEOMETRY
  if (typed.command == "audit") {
    return run_audit({typed.mesh_files.begin(), typed.mesh_files.end()}, console);
  }
  return run_build({typed.design, materials_path(typed), typed.folder, typed.only, typed.dry_run,
                    typed.force, typed.times},
                   console);
#else
  return left_out(console, typed.command, "LATTICAST_GEOMETRY",
                  "CGAL, libpng, expat, libzip and tinygltf");
#endif
}

// Every typed error of the libraries has its exit status here.
ExitStatus run_guarded(const CommandLine& typed, const Console& console) {
  try {
    return run_command(typed, console);
  } catch (const FileError& fault) {
    console.error(fault.what());
    return ExitStatus::file_error;
  } catch (const UnsupportedDesign& fault) {
    console.error(fault.what());
    return ExitStatus::invalid;
#if LATTICAST_HAS_GEOMETRY
  } catch (const CannotDraw& fault) {
    console.error(fault.what());
    return ExitStatus::invalid;
  } catch (const GeometryError& fault) {
    console.error(fault.what());
    return ExitStatus::check_failed;
  } catch (const Interrupted& fault) {
    console.error(fault.what());
    return ExitStatus::interrupted;
#if LATTICAST_HAS_MOLDS
  } catch (const CannotMold& fault) {
    console.error(fault.what());
    return ExitStatus::invalid;
#endif
#if LATTICAST_HAS_PREDICT
  } catch (const NoEquilibrium& fault) {
    console.error(fault.what());
    return ExitStatus::no_equilibrium;
#endif
#endif
  } catch (const std::invalid_argument& fault) {
    console.error(fault.what());
    return ExitStatus::invalid;
  }
}

// CLI11 only says that a command is missing; a mistyped one deserves the nearest name.
std::optional<std::string> mistyped_command(int argc, char** argv) {
  const std::vector<std::string> known{"build", "predict", "check", "audit", "materials", "new"};
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--materials") ++i;
    if (word.starts_with("-")) continue;
    if (std::find(known.begin(), known.end(), word) != known.end()) return std::nullopt;
    return fmt::format("no command '{}': {}", word, name_hint(word, known, "commands"));
  }
  return std::nullopt;
}

int run_main(int argc, char** argv) {
  if (const auto problem = mistyped_command(argc, argv)) {
    Console().error(*problem);
    return static_cast<int>(ExitStatus::invalid);
  }
  const CommandWords words{product_words(true), joined(new_kinds(), ", ")};
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
