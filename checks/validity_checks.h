// SPDX-License-Identifier: GPL-3.0-or-later
// Where the prediction itself is in doubt.
#pragma once

#include "checks/check_finding.h"
#include "checks/loaded_segment.h"

namespace latticast {

/// Adds the findings angle-out-of-range, rings-in-step, modulus-band.
void check_validity(const LoadedSegment& loaded, CheckFindings& findings);

}  // namespace latticast
