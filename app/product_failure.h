// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps one product of a build, or a whole command, from being made.
#pragma once

#include <string>

#include "app/exit_status.h"

namespace latticast {

struct Failure {
  ExitStatus status = ExitStatus::unexpected;
  std::string text;
};

/// The failure that the exception being handled stands for: of drawing, meshing, molds,
/// equilibrium, the audit, or of what this version does not predict. Any other, which concerns the
/// whole run, is thrown on. Call it in a handler.
Failure product_failure();

}  // namespace latticast
