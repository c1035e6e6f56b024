// SPDX-License-Identifier: GPL-3.0-or-later
// Signals as an exception: SIGINT and SIGTERM end a build between two steps.
#pragma once

#include <stdexcept>

namespace latticast {

/// Thrown between steps after SIGINT or SIGTERM, so that everything unfinished is cleaned up.
/// what() says what is complete.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// From here on, SIGINT and SIGTERM ask the program to stop at the next stage; a second one ends
/// it.
void watch_for_interrupt();

/// Throws Interrupted when a signal has come.
void stop_if_interrupted();

}  // namespace latticast
