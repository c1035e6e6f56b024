// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a part fits the printer's bed.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "checks/check_finding.h"

namespace latticast {

/// The bounding box of a part as it stands on the bed.
struct StandingSize {
  double width_mm = 0;
  double depth_mm = 0;
  double height_mm = 0;
};

/// exceeds-bed, for a part on a bed of width, depth and height; empty where it fits, perhaps after
/// a quarter turn about the vertical. Segment and remedy are left to the caller.
std::optional<CheckFinding> bed_finding(const std::string& part, const StandingSize& size,
                                        const std::array<double, 3>& bed_mm);

}  // namespace latticast
