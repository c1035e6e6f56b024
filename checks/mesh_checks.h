// SPDX-License-Identifier: GPL-3.0-or-later
// What can be checked on a mesh file, whoever made it.
#pragma once

#include <array>
#include <string>

#include "checks/check_finding.h"
#include "geometry/mesh/triangle_mesh.h"

namespace latticast {

/// Of a common desktop printer; a file does not say which printer it is for.
inline constexpr std::array<double, 3> usual_bed_mm = {220, 220, 250};

/// A finding for every kind of defect that the audit counts, with how many there are and where the
/// first is; enclosed-void for every body that faces inwards inside another, where there are no
/// defects; exceeds-bed as a warning, z being up. `name` is the file's, and every finding's part.
CheckFindings mesh_checks(const TriangleMesh& mesh, const std::string& name);

}  // namespace latticast
