// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/audit_command.h"

#include <fmt/core.h>

#include "app/audit_output.h"
#include "design/file_error.h"
#include "export/mesh/mesh_file.h"
#include "geometry/mesh/weld.h"
#include "geometry/solid/audit.h"

namespace latticast {

ExitStatus run_audit(const std::vector<std::filesystem::path>& files, const Console& console) {
  bool all_read = true;
  bool all_pass = true;
  for (const std::filesystem::path& file : files) {
    try {
      const Audit result = audit(weld(read_mesh(file)));
      all_pass = all_pass && result.passes();
      console.data(result.passes()
                       ? fmt::format("pass {}: {}\n", file.string(), audit_summary(result))
                       : fmt::format("FAIL {}: {} triangles\n{}", file.string(), result.triangles,
                                     audit_findings(result)));
    } catch (const FileError& fault) {
      all_read = false;
      console.error(fault.what());
    }
  }
  if (!all_read) return ExitStatus::file_error;
  return all_pass ? ExitStatus::done : ExitStatus::check_failed;
}

}  // namespace latticast
