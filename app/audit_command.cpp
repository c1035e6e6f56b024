// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/audit_command.h"

#include <algorithm>

#include "app/audit_output.h"
#include "design/file_error.h"
#include "export/mesh/mesh_file.h"
#include "geometry/mesh/weld.h"
#include "geometry/solid/audit.h"
#include "geometry/solid/part_overlap.h"

namespace latticast {

namespace {

struct AuditedObjects {
  std::vector<Audit> audits;  ///< one for each object
  PartOverlaps overlaps;
};

AuditedObjects audited(const std::vector<MeshObject>& objects) {
  AuditedObjects result;
  std::vector<bool> sound;
  for (const MeshObject& object : objects) {
    result.audits.push_back(audit(weld(object.mesh)));
    sound.push_back(result.audits.back().passes());
  }
  result.overlaps = overlapping_parts(objects, sound);
  return result;
}

}  // namespace

ExitStatus run_audit(const std::vector<std::filesystem::path>& files, const Console& console) {
  bool all_read = true;
  bool all_pass = true;
  for (const std::filesystem::path& file : files) {
    try {
      const std::vector<MeshObject> objects = read_objects(file);
      const AuditedObjects result = audited(objects);
      all_pass = all_pass && std::all_of(result.audits.begin(), result.audits.end(),
                                         [](const Audit& audit) { return audit.passes(); });
      console.data(audit_report(file.string(), objects, result.audits, result.overlaps));
    } catch (const FileError& fault) {
      all_read = false;
      console.error(fault.what());
    }
  }
  if (!all_read) return ExitStatus::file_error;
  return all_pass ? ExitStatus::done : ExitStatus::check_failed;
}

}  // namespace latticast
