// SPDX-License-Identifier: GPL-3.0-or-later
// Standard input, output and error as a program should find and leave them.
#pragma once

#include <string>

namespace latticast {

/// Call first. A standard stream that was closed gets a place that nothing goes into or comes from,
/// so that the next file that is opened does not become it. A closed pipe, and a limit on the size
/// of files, make a write fail instead of ending the program.
void guard_standard_streams();

/// Call last. What standard output and error did not take of what was written to them, one line
/// with the reason where it is known; empty where all arrived.
std::string lost_output();

}  // namespace latticast
