// SPDX-License-Identifier: GPL-3.0-or-later
// `latticast audit`: the audit of mesh files.
#pragma once

#include <filesystem>
#include <vector>

#include "app/console.h"
#include "app/exit_status.h"

namespace latticast {

/// latticast audit FILE...: reads, welds and audits each file. A file that cannot be read does not
/// stop the others; the status then says file_error.
ExitStatus run_audit(const std::vector<std::filesystem::path>& files, const Console& console);

}  // namespace latticast
