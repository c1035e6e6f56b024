// SPDX-License-Identifier: GPL-3.0-or-later
// The command line as it was typed.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/exit_status.h"

namespace latticast {

/// What was typed, whichever parts this program was built with.
struct CommandLine {
  std::string command;  ///< "build", "predict", "check", "audit", "materials" or "new"
  bool quiet = false;
  std::string materials_file;
  std::string design;
  std::vector<std::string> settings;
  std::string folder = ".";
  std::vector<std::string> only;
  bool dry_run = false;
  bool force = false;
  bool times = false;
  std::optional<std::string> pressure;
  std::string format;
  std::vector<std::string> hold;
  bool kinds = false;
  bool wall = false;
  std::string shape;
  std::string output;
  std::vector<std::string> files;  ///< that are checked or audited
  std::string material;
  std::string kind;
  std::string new_file;
};

/// The words that help lists and that other parts of the program know; asked for when needed.
struct CommandWords {
  std::string (*products)();  ///< of --only
  std::string (*kinds)();     ///< of `new`
};

/// Reads the arguments of main(). Help, the version and what is typed wrongly are answered here:
/// the exit status that the program then ends with. Only the command that is typed is described to
/// the parser.
std::variant<CommandLine, ExitStatus> read_command_line(int argc, char** argv,
                                                        const CommandWords& words);

}  // namespace latticast
