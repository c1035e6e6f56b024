// SPDX-License-Identifier: GPL-3.0-or-later
// Error of the mesh in a file against the solid that it stands for.
#pragma once

#include <string>

#include "geometry/solid/audit.h"
#include "geometry/solid/solid_error.h"

namespace latticast {

struct Solid;

/// How far the solid in a file may be from what it stands for: the mesh's own error, and what
/// rounding to float32 added. The file's audit tells how much volume that took or gave; of a solid
/// of unknown volume (0) it is taken to be that of a layer as thick all over the surface.
SolidError error_of_file(const Solid& solid, const Audit& written);

/// "within 0.0093 mm of the drawn surface, volume to 0.02 mm3".
std::string describe(const SolidError& error);

}  // namespace latticast
