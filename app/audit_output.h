// SPDX-License-Identifier: GPL-3.0-or-later
// What an audit found, for people.
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh/mesh_object.h"
#include "geometry/solid/audit.h"
#include "geometry/solid/part_overlap.h"

namespace latticast {

/// "closed, 1 piece, genus 57, 7174.51 mm3, 11870 triangles", for a mesh that passes.
std::string audit_summary(const Audit& audit);

/// Each kind of defect with its number and the first places, a line each, indented; empty for a
/// mesh that passes.
std::string audit_findings(const Audit& audit);

/// What `latticast audit` says of a file: that it passes, with the sums over its objects, or what
/// is wrong with which object; then notes, an indented line each: parts that overlap, and a size
/// that tells of another unit.
std::string audit_report(const std::string& file, const std::vector<MeshObject>& objects,
                         const std::vector<Audit>& audits, const PartOverlaps& overlaps);

}  // namespace latticast
