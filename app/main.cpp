// SPDX-License-Identifier: GPL-3.0-or-later
// The command line: what is typed, which command runs, and what the exit status says.
#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/ranges.h>

#include "app/check_command.h"
#include "app/console.h"
#include "app/exit_status.h"
#include "app/materials_command.h"
#include "app/new_command.h"
#include "app/products.h"
#include "design/file_error.h"
#include "design/nearest_name.h"
#include "design/unsupported_design.h"
#if LATTICAST_HAS_PREDICT
#include "app/predict_command.h"
#endif
#if LATTICAST_HAS_GEOMETRY
#include "app/audit_command.h"
#include "app/build_command.h"
#include "app/interrupt.h"
#include "geometry/pattern/pattern.h"
#include "geometry/solid/arrangement.h"
#if LATTICAST_HAS_MOLDS
#include "molds/cannot_mold.h"
#endif
#if LATTICAST_HAS_PREDICT
#include "report/preview.h"
#endif
#endif

namespace latticast {
namespace {

// What was typed, whichever parts this program was built with.
struct CommandLine {
  bool quiet = false;
  std::string materials_file;
  std::string design;
  std::string folder = ".";
  std::vector<std::string> only;
  bool dry_run = false;
  bool force = false;
  bool times = false;
  std::string pressure;
  std::string format = "table";
  std::vector<std::string> hold;
  std::string shape;
  std::vector<std::string> mesh_files;
  std::vector<std::string> checked_files;
  std::string check_format = "table";
  std::string material;
  std::string kind;
  std::string new_file;
};

std::optional<std::filesystem::path> materials_path(const CommandLine& typed) {
  if (typed.materials_file.empty()) return std::nullopt;
  return typed.materials_file;
}

void describe_build(CLI::App& app, CommandLine& typed) {
  CLI::App* build = app.add_subcommand("build", "Make everything that the design's [make] names");
  build->add_option("design", typed.design, "design file")->required();
  build->add_option("-o,--output", typed.folder, "folder for the files; made if missing");
  build->add_option("--only", typed.only, "parts to make: " + product_words(true))->delimiter(',');
  build->add_flag("--force", typed.force, "build although the checks find errors");
  build->add_flag("--times", typed.times, "write the time of every stage into the report's JSON");
  build->add_flag("--dry-run", typed.dry_run, "print what would run, and why the rest would not");
}

void describe_predict(CLI::App& app, CommandLine& typed) {
  CLI::App* predict = app.add_subcommand("predict", "Print the response to pressure");
  predict->add_option("design", typed.design, "design file")->required();
  predict->add_option("--pressure", typed.pressure,
                      "kPa: one, a list (10,20,30) or FROM:TO:STEP; otherwise the design's [load]");
  predict->add_option("--format", typed.format, "table, csv or json")
      ->check(CLI::IsMember({"table", "csv", "json"}));
  predict
      ->add_option("--hold", typed.hold,
                   "what the mounting holds (tip: its place, by a stop); prints the reaction")
      ->delimiter(',')
      ->check(CLI::IsMember({"twist", "bend", "stretch", "tip"}));
  predict->add_option("--shape", typed.shape, "of the whole chain, a load case after the other")
      ->check(CLI::IsMember({"tip", "centre-line"}));
}

void describe_new(CLI::App& app, CommandLine& typed) {
  CLI::App* fresh = app.add_subcommand("new", "Write a commented design to start from");
  fresh->add_option("kind", typed.kind, fmt::format("{}", fmt::join(new_kinds(), ", ")))
      ->required();
  fresh->add_option("file", typed.new_file, "file to write, KIND.toml when not given");
}

void describe_commands(CLI::App& app, CommandLine& typed) {
  app.set_version_flag("--version", "latticast " LATTICAST_VERSION);
  app.add_flag("-q,--quiet", typed.quiet, "no progress, no notes; errors are still shown");
  app.add_option("--materials", typed.materials_file, "TOML file with further materials");
  app.require_subcommand(1);
  app.fallthrough();
  describe_build(app, typed);
  describe_predict(app, typed);
  CLI::App* check =
      app.add_subcommand("check", "Say what will go wrong before a part is printed or cast");
  check->add_option("files", typed.checked_files, "a design file, mesh files, or both")->required();
  check->add_option("--format", typed.check_format, "table or json")
      ->check(CLI::IsMember({"table", "json"}));
  CLI::App* audit = app.add_subcommand("audit", "Prove that mesh files are closed, clean solids");
  audit->add_option("files", typed.mesh_files, "mesh files")->required();
  CLI::App* materials = app.add_subcommand("materials", "List the materials, or show one");
  materials->add_option("name", typed.material, "material");
  describe_new(app, typed);
}

[[maybe_unused]] ExitStatus left_out(const Console& console, std::string_view command,
                                     std::string_view option, std::string_view packages) {
  console.error(
      fmt::format("this program was built without '{}': configure with -D{}=ON (needs {}) and "
                  "build again",
                  command, option, packages));
  return ExitStatus::invalid;
}

ExitStatus run_command(const CLI::App& app, const CommandLine& typed, const Console& console) {
  if (app.got_subcommand("materials")) {
    return run_materials(typed.material, materials_path(typed), console);
  }
  if (app.got_subcommand("new")) return run_new(typed.kind, typed.new_file, console);
  if (app.got_subcommand("check")) {
    return run_check({{typed.checked_files.begin(), typed.checked_files.end()},
                      materials_path(typed),
                      typed.check_format},
                     console);
  }
  if (app.got_subcommand("predict")) {
#if LATTICAST_HAS_PREDICT
    return run_predict({typed.design, materials_path(typed), typed.pressure, typed.format,
                        typed.hold, typed.shape},
                       console);
#else
    return left_out(console, "predict", "LATTICAST_PREDICT", "SUNDIALS");
#endif
  }
#if LATTICAST_HAS_GEOMETRY
  if (app.got_subcommand("audit")) {
    return run_audit({typed.mesh_files.begin(), typed.mesh_files.end()}, console);
  }
  return run_build({typed.design, materials_path(typed), typed.folder, typed.only, typed.dry_run,
                    typed.force, typed.times},
                   console);
#else
  return left_out(console, app.got_subcommand("audit") ? "audit" : "build", "LATTICAST_GEOMETRY",
                  "CGAL, libpng, expat, libzip and tinygltf");
#endif
}

// Every typed error of the libraries has its exit status here.
ExitStatus run_guarded(const CLI::App& app, const CommandLine& typed, const Console& console) {
  try {
    return run_command(app, typed, console);
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
  CLI::App app{"Predicts and makes lattice-reinforced pneumatic soft actuators", "latticast"};
  CommandLine typed;
  describe_commands(app, typed);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& fault) {
    // CLI11 prints help and version (status 0) and its messages; ours is the status for the rest.
    return app.exit(fault) == 0 ? 0 : static_cast<int>(ExitStatus::invalid);
  }
  return static_cast<int>(run_guarded(app, typed, Console(typed.quiet)));
}

}  // namespace
}  // namespace latticast

int main(int argc, char** argv) {
  try {
    return latticast::run_main(argc, argv);
  } catch (const std::exception& fault) {
    // Not one of the errors that commands know: memory ran out, or the program is wrong.
    std::fputs("error: unexpected: ", stderr);
    std::fputs(fault.what(), stderr);
    std::fputs("\n", stderr);
    return static_cast<int>(latticast::ExitStatus::unexpected);
  }
}
