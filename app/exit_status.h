// SPDX-License-Identifier: GPL-3.0-or-later
// The exit statuses of the program.
#pragma once

namespace latticast {

/// What the program's exit status says; scripts rely on it (docs/command-line.md).
enum class ExitStatus {
  done = 0,
  check_failed = 1,  ///< the design or the mesh was checked and fails
  invalid = 2,  ///< the command line or the design file is invalid, or asks for what is not there
  no_equilibrium = 3,  ///< at a requested pressure
  file_error = 4,      ///< a file could not be read or written
  unexpected = 70,     ///< memory ran out, or the program is wrong; nothing was left half done
  interrupted = 130,   ///< stopped by a signal; nothing was left half done
};

}  // namespace latticast
