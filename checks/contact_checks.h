// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that touch or fold in the inflated shape.
#pragma once

#include "checks/check_finding.h"
#include "checks/loaded_segment.h"

namespace latticast {

/// Adds the findings strands-touch-inflated, folds.
void check_contact(const LoadedSegment& loaded, CheckFindings& findings);

}  // namespace latticast
