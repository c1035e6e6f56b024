// SPDX-License-Identifier: GPL-3.0-or-later
// The command line as it was typed.
#pragma once

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
  std::string folder = ".";
  std::vector<std::string> only;
  bool dry_run = false;
  bool force = false;
  bool times = false;
  std::string pressure;
  std::string format = "table";
  std::vector<std::string> hold;
  bool kinds = false;
  std::string shape;
  std::vector<std::string> mesh_files;
  std::vector<std::string> checked_files;
  std::string check_format = "table";
  std::string material;
  std::string kind;
  std::string new_file;
};

/// The words that help lists and that other parts of the program know.
struct CommandWords {
  std::string products;  ///< of --only
  std::string kinds;     ///< of `new`
};

/// Reads the arguments of main(). Help, the version and what is typed wrongly are answered here:
/// the exit status that the program then ends with.
std::variant<CommandLine, ExitStatus> read_command_line(int argc, char** argv,
                                                        const CommandWords& words);

}  // namespace latticast
