// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>

namespace latticast {

/// Thrown between stages after SIGINT or SIGTERM, so that everything unfinished is cleaned up.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted; nothing was changed"; }
};

/// From here on, SIGINT and SIGTERM ask the program to stop at the next stage; a second one ends
/// it.
void watch_for_interrupt();

/// Throws Interrupted when a signal has come.
void stop_if_interrupted();

}  // namespace latticast
