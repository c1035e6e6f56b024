// SPDX-License-Identifier: GPL-3.0-or-later
// Materials of a unit cell: those of the liner and of the lattice, of finite bulk modulus.
#pragma once

#include <string>
#include <vector>

#include "design/design.h"
#include "design/material/law.h"
#include "model/cell/cell_mesh.h"

namespace latticast {

/// Numbers of the materials.
inline constexpr std::int32_t cell_liner = 0;
inline constexpr std::int32_t cell_lattice = 1;

/// Why no unit cell is made of a segment's parts: "needs a liner of rubber, this one is linear".
/// Empty where one is.
std::string parts_problem(const Segment& segment);

/// The liner 1000 times as stiff against a change of volume as of shape, of which stiffness depends
/// by 2e-4; the lattice neo-Hookean, Poisson's ratio at most that of the liner.
std::vector<CellMaterial> cell_materials(const Law& liner, const Linear& lattice);

}  // namespace latticast
