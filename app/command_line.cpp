// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "app/console.h"
#include "design/nearest_name.h"

namespace latticast {
namespace {

constexpr const char* version_line = "latticast " LATTICAST_VERSION;

constexpr const char* short_help =
    "latticast predicts and makes lattice-reinforced pneumatic soft actuators.\n"
    "\n"
    "  latticast new twisting                    write a design to start from: twisting.toml\n"
    "  latticast predict twisting.toml           how it moves under pressure\n"
    "  latticast check twisting.toml             what would go wrong in making it\n"
    "  latticast build twisting.toml -o parts    its files: meshes, preview, report\n"
    "\n"
    "latticast --help lists all commands, latticast help COMMAND tells of one.\n";

// One argument for each time that the option is written: the next word is the next word.
template <class Values>
CLI::Option* add_list(CLI::App& command, const char* name, Values& values, const char* what) {
  return command.add_option(name, values, what)->allow_extra_args(false);
}

// An empty word is a forgotten one, as where a script's variable is empty.
CLI::Option* not_empty(CLI::Option* option) {
  return option->check(
      [](const std::string& word) {
        return word.empty() ? std::string("nothing is given; leave it out, or write a value") : "";
      },
      "");
}

CLI::Option* one_of(CLI::Option* option, const std::vector<std::string>& words) {
  return option->type_name(CLI::detail::join(words, "|"))
      ->check(CLI::IsMember(words).description(""));
}

void describe_design(CLI::App& command, CommandLine& typed) {
  not_empty(command.add_option("design", typed.design, "design file; - for standard input"))
      ->required()
      ->type_name("");
}

void describe_settings(CLI::App& command, CommandLine& typed) {
  not_empty(add_list(command, "--set", typed.settings,
                     "a value in place of the design's, as in segment.0.length=90;\n"
                     "may be repeated (docs/design-file.md, Paths)"))
      ->type_name("PATH=VALUE");
}

void describe_build(CLI::App& build, CommandLine& typed, const CommandWords& words) {
  describe_design(build, typed);
  not_empty(build.add_option("-o,--output", typed.folder,
                             "folder for the files, made if missing (default: this one)"))
      ->type_name("DIR");
  not_empty(add_list(build, "--only", typed.only, "these parts of [make] alone (default: all):"))
      ->description("these parts of [make] alone (default: all):\n" + words.products())
      ->type_name("PART,...")
      ->delimiter(',');
  describe_settings(build, typed);
  build.add_flag(
      "--dry-run", typed.dry_run,
      "print what would run, why the rest would not, and what it may take; make nothing");
  build.add_flag("--force", typed.force, "build although the checks find errors");
  build.add_flag("--times", typed.times, "write the time of every stage into the report");
  build.footer(
      "Example: only the printable lattice and the picture, 90 mm long\n"
      "  latticast build tube.toml -o parts --only lattice,preview --set segment.0.length=90");
}

void describe_predict(CLI::App& predict, CommandLine& typed, const CommandWords& /*words*/) {
  describe_design(predict, typed);
  not_empty(predict.add_option("--pressure", typed.pressure,
                               "one (30), a list (10,20,30) or FROM:TO:STEP (0:60:5)\n"
                               "(default: the design's [load])"))
      ->type_name("KPA");
  one_of(predict.add_option("--format", typed.format,
                            "of the answer (default: table; csv or json after the name of -o)"),
         {"table", "csv", "json"});
  not_empty(predict.add_option("-o,--output", typed.output,
                               "file for the answer (default: standard output)"))
      ->type_name("FILE");
  describe_settings(predict, typed);
  add_list(predict, "--hold", typed.hold,
           "what the mounting holds (tip: its place, by a stop; alone);\n"
           "prints the reaction (default: nothing)")
      ->type_name("twist,bend,stretch|tip")
      ->delimiter(',')
      ->check(CLI::IsMember({"twist", "bend", "stretch", "tip"}).description(""));
  one_of(predict.add_option("--shape", typed.shape,
                            "of the whole chain, a load case after the other (default: the\n"
                            "response of every segment)"),
         {"tip", "centre-line"});
  predict.add_flag("--kinds", typed.kinds,
                   "layered and calibrated section and unit cell side by side");
  predict.add_flag("--wall", typed.wall,
                   "bulging, strains and traction on the bond, by the unit cell");
  predict.add_flag("--times", typed.times, "the time of each solution, in csv and json");
  predict.footer(
      "Example: a softer wall under three pressures, as a file for a spreadsheet\n"
      "  latticast predict tube.toml --pressure 10,20,30 --set "
      "segment.0.liner.thickness=3 -o tube.csv");
}

void describe_check(CLI::App& check, CommandLine& typed, const CommandWords& /*words*/) {
  not_empty(add_list(check, "files", typed.files,
                     "a design file (- for standard input), mesh files, or both"))
      ->required()
      ->allow_extra_args(true)
      ->type_name("");
  one_of(check.add_option("--format", typed.format, "of the findings (default: table)"),
         {"table", "json"});
  describe_settings(check, typed);
  check.footer(
      "Example: a design, and a mesh that was repaired elsewhere\n"
      "  latticast check tube.toml repaired.stl --set printer.process=sla");
}

void describe_audit(CLI::App& audit, CommandLine& typed, const CommandWords& /*words*/) {
  not_empty(audit.add_option("files", typed.files, "mesh files"))->required()->type_name("");
  audit.footer("Example:\n  latticast audit parts/*.stl");
}

void describe_materials(CLI::App& materials, CommandLine& typed, const CommandWords& /*words*/) {
  not_empty(materials.add_option("name", typed.material, "material (default: all are listed)"))
      ->type_name("");
  materials.footer("Example:\n  latticast materials ecoflex-00-50");
}

void describe_new(CLI::App& fresh, CommandLine& typed, const CommandWords& words) {
  not_empty(fresh.add_option("kind", typed.kind, words.kinds()))->required()->type_name("");
  not_empty(fresh.add_option("file", typed.new_file,
                             "file to write, - for standard output (default: KIND.toml)"))
      ->type_name("");
  fresh.footer("Example:\n  latticast new bending gripper.toml");
}

struct Command {
  std::string_view name;
  const char* what;
  void (*describe)(CLI::App& command, CommandLine& typed, const CommandWords& words);
};

constexpr std::array<Command, 6> commands{{
    {"build", "Make everything that the design's [make] names", describe_build},
    {"predict", "Print the response to pressure", describe_predict},
    {"check", "Say what will go wrong before a part is printed or cast", describe_check},
    {"audit", "Prove that mesh files are closed, clean solids", describe_audit},
    {"materials", "List the materials, or show one", describe_materials},
    {"new", "Write a commented design to start from", describe_new},
}};

void describe_common(CLI::App& app, CommandLine& typed) {
  app.add_flag("-q,--quiet", typed.quiet, "no progress, no notes; errors are still shown");
  not_empty(app.add_option("--materials", typed.materials_file,
                           "TOML file with further materials (docs/materials.md)"))
      ->type_name("FILE");
}

const Command* command_named(std::string_view word) {
  const auto found = std::find_if(commands.begin(), commands.end(),
                                  [&](const Command& command) { return command.name == word; });
  return found == commands.end() ? nullptr : &*found;
}

// The first word that is no option.
std::optional<std::string> command_word(const std::vector<std::string>& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--materials") {
      ++i;
    } else if (!words[i].starts_with("-")) {
      return words[i];
    }
  }
  return std::nullopt;
}

ExitStatus refuse(const std::string& problem) {
  Console().error(problem);
  return ExitStatus::invalid;
}

ExitStatus refuse_command(const std::string& word) {
  std::vector<std::string> known{"help"};
  for (const Command& command : commands) known.emplace_back(command.name);
  return refuse(fmt::format("no command '{}': {}", word, name_hint(word, known, "commands")));
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

// Unknown options first: the words after them may stand in the wrong places for that reason.
std::string parse_problem(const CLI::App& app, const CLI::ParseError& fault) {
  const std::vector<std::string> extras = app.remaining(true);
  const auto chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  std::string problem;
  for (const std::string& word : extras) {
    if (!word.starts_with("-") || word == "-") continue;
    const std::string name = word.substr(0, word.find('='));
    problem += fmt::format("{}no option '{}': {}", problem.empty() ? "" : "; ", name,
                           name_hint(name, option_names(command), "options"));
  }
  if (!problem.empty()) return problem;
  problem = extras.empty() ? fault.what() : fmt::format("'{}' is one word too many", extras.back());
  return fmt::format("{}; latticast help{}{} tells what may be written", problem,
                     chosen.empty() ? "" : " ", chosen.empty() ? "" : command.get_name());
}

std::variant<CommandLine, ExitStatus> parse(std::vector<std::string> arguments,
                                            const Command* asked, const CommandWords& words) {
  CLI::App app{"Predicts and makes lattice-reinforced pneumatic soft actuators", "latticast"};
  CommandLine typed;
  app.set_version_flag("-V,--version", version_line);
  describe_common(app, typed);
  app.require_subcommand(1);
  app.fallthrough();
  app.footer("latticast help COMMAND tells of one command; docs/command-line.md of all.");
  for (const Command& command : commands) {
    if (asked != nullptr && asked != &command) continue;
    CLI::App* described = app.add_subcommand(std::string(command.name), command.what);
    if (asked == nullptr) continue;
    command.describe(*described, typed, words);
    describe_common(*described, typed);
  }
  try {
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
    app.parse(std::move(arguments));
  } catch (const CLI::Success& answer) {
    app.exit(answer);  // prints help or the version
    return ExitStatus::done;
  } catch (const CLI::ParseError& fault) {
    return refuse(parse_problem(app, fault));
  }
  typed.command = asked->name;
  return typed;
}

}  // namespace

std::variant<CommandLine, ExitStatus> read_command_line(int argc, char** argv,
                                                        const CommandWords& words) {
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  if (arguments.empty()) {
    std::fputs(short_help, stderr);
    return ExitStatus::invalid;
  }
  if (arguments.size() == 1 && (arguments[0] == "--version" || arguments[0] == "-V")) {
    std::puts(version_line);
    return ExitStatus::done;
  }
  if (arguments[0] == "help") {
    arguments.erase(arguments.begin());
    if (!arguments.empty() && arguments[0] == "help") arguments.clear();
    arguments.emplace_back("--help");
  }
  const std::optional<std::string> word = command_word(arguments);
  const Command* asked = word ? command_named(*word) : nullptr;
  if (word && asked == nullptr) return refuse_command(*word);
  return parse(std::move(arguments), asked, words);
}

}  // namespace latticast
