// SPDX-License-Identifier: GPL-3.0-or-later
// Strains against what the materials bear and their laws were fitted to.
#pragma once

#include "checks/check_finding.h"
#include "checks/loaded_segment.h"

namespace latticast {

/// Adds the findings strand-overstrained, strand-law-exceeded, liner-overstrained,
/// liner-law-exceeded, fibre-lock.
void check_strains(const LoadedSegment& loaded, CheckFindings& findings);

}  // namespace latticast
