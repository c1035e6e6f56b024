// SPDX-License-Identifier: GPL-3.0-or-later
// `latticast audit`: the audit of mesh files.
#pragma once

#include <filesystem>
#include <vector>

#include "app/console.h"
#include "app/exit_status.h"

namespace latticast {

/// latticast audit FILE...: reads each file, and welds and audits its objects one by one; parts
/// that overlap are told, and are no failure. A file that cannot be read does not
/// stop the others; the status then says file_error.
ExitStatus run_audit(const std::vector<std::filesystem::path>& files, const Console& console);

}  // namespace latticast
