// SPDX-License-Identifier: GPL-3.0-or-later
// What can be checked on a mesh file, whoever made it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "checks/check_finding.h"
#include "geometry/mesh/mesh_object.h"
#include "geometry/solid/audit.h"

namespace latticast {

/// Of a common desktop printer; a file does not say which printer it is for.
inline constexpr std::array<double, 3> usual_bed_mm = {220, 220, 250};

/// What a curved wall may be thinner than the least wall, relative, before it is found thin: chords
/// of n to the turn take 1 - cos(pi/n) off, which is less from n = 23 on.
inline constexpr double chord_allowance = 0.01;

/// A file whose longest side is below this is smaller than what is printed.
inline constexpr double least_usual_size_mm = 1;

/// What a file may have in mind whose objects are that small together: how large they are in mm, in
/// metres and in inches. Empty for others, and where a coordinate is not finite.
std::string unit_hint(const std::vector<Audit>& objects);

/// Object by object: a finding for every kind of defect that the audit counts, with how many there
/// are and where the first is; where there are no defects, mesh-thin-wall for the thinnest wall
/// that is below the least one of melted plastic (lattice_use.h), and enclosed-void for every body
/// that faces inwards inside another; exceeds-bed as a warning, z being up. Then mesh-too-small
/// where there is a unit_hint, and parts-overlap for each of the first ten pairs of objects that
/// claim the same room. `name` is the file's, and every finding's part, followed by the object's
/// where there are several.
CheckFindings mesh_checks(const std::vector<MeshObject>& objects, const std::string& name);

/// Of a file with one object.
CheckFindings mesh_checks(TriangleMesh mesh, const std::string& name);

}  // namespace latticast
