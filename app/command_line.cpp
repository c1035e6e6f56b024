// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include <CLI/CLI.hpp>

namespace latticast {
namespace {

void describe_build(CLI::App& app, CommandLine& typed, const std::string& products) {
  CLI::App* build = app.add_subcommand("build", "Make everything that the design's [make] names");
  build->add_option("design", typed.design, "design file")->required();
  build->add_option("-o,--output", typed.folder, "folder for the files; made if missing");
  build->add_option("--only", typed.only, "parts to make: " + products)->delimiter(',');
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
  predict->add_flag("--kinds", typed.kinds,
                    "layered and calibrated section and unit cell side by side, with their times");
}

void describe_new(CLI::App& app, CommandLine& typed, const std::string& kinds) {
  CLI::App* fresh = app.add_subcommand("new", "Write a commented design to start from");
  fresh->add_option("kind", typed.kind, kinds)->required();
  fresh->add_option("file", typed.new_file, "file to write, KIND.toml when not given");
}

void describe_commands(CLI::App& app, CommandLine& typed, const CommandWords& words) {
  app.set_version_flag("--version", "latticast " LATTICAST_VERSION);
  app.add_flag("-q,--quiet", typed.quiet, "no progress, no notes; errors are still shown");
  app.add_option("--materials", typed.materials_file, "TOML file with further materials");
  app.require_subcommand(1);
  app.fallthrough();
  describe_build(app, typed, words.products);
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
  describe_new(app, typed, words.kinds);
}

}  // namespace

std::variant<CommandLine, ExitStatus> read_command_line(int argc, char** argv,
                                                        const CommandWords& words) {
  CLI::App app{"Predicts and makes lattice-reinforced pneumatic soft actuators", "latticast"};
  CommandLine typed;
  describe_commands(app, typed, words);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& fault) {
    // CLI11 prints help and version (status 0) and its messages; ours is the status for the rest.
    return app.exit(fault) == 0 ? ExitStatus::done : ExitStatus::invalid;
  }
  typed.command = app.get_subcommands().front()->get_name();
  return typed;
}

}  // namespace latticast
