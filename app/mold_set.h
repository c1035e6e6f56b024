// SPDX-License-Identifier: GPL-3.0-or-later
// The molds that a design asks for, segment by segment.
#pragma once

#include <string>
#include <vector>

#include "molds/mold_piece.h"

namespace latticast {

struct Design;
struct Material;
struct Plan;
struct PreparedDesign;

/// A mold with its place in the design, ready to be written.
struct PlannedMold {
  std::size_t segment = 0;
  std::string kind;  ///< "lattice-mold" or "liner-mold": part of every file's name
  Mold mold;
  std::string procedure;  ///< Markdown: bill of pieces, assembly, pouring, demolding
};

/// Makes the molds that the plan runs. Throws CannotMold (also for pieces that exceed the printer's
/// bed), CannotDraw, GeometryError.
std::vector<PlannedMold> plan_molds(PreparedDesign& prepared, const Plan& plan);

/// What is cast in a mold; null for a flexible mold, whose rubber is the workshop's choice.
const Material* poured_material(const Design& design, const PlannedMold& planned);

}  // namespace latticast
