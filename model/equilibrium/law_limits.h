// SPDX-License-Identifier: GPL-3.0-or-later
// Ends of the laws that a section's energy is made of: a rubber's stretch limit, the range of a
// strand's law.
#pragma once

#include <optional>

#include "model/equilibrium/balance.h"

namespace latticast {

/// Whether a strand or the liner's rubber is where its law ends, to 1e-6. A rubber comes ever
/// closer to its stretch limit as the pressure rises, a path that costs more and more and says
/// nothing more.
bool at_law_end(const Balance& balance, const BranchPoint& x);

/// The length of a step from `from` in the direction `tangent`, `length` unless a strand would
/// leave its law's range: then nine tenths of the way there. A few such steps come to the end,
/// where halving would take dozens.
double length_within_laws(const Balance& balance, const BranchPoint& from,
                          const BranchPoint& tangent, double length);

}  // namespace latticast
