// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/bed_check.h"

#include <algorithm>

#include <fmt/core.h>

#include "design/text/written_number.h"

namespace latticast {

// The larger side is compared with the bed's larger one: either lies along the other after a
// quarter turn.
std::optional<CheckFinding> bed_finding(const std::string& part, const StandingSize& size,
                                        const std::array<double, 3>& bed_mm) {
  const auto [short_side, long_side] = std::minmax(size.width_mm, size.depth_mm);
  const auto [short_bed, long_bed] = std::minmax(bed_mm[0], bed_mm[1]);
  CheckFinding finding = check_finding("exceeds-bed");
  finding.part = part;
  finding.unit = "mm";
  const auto exceeds = [&](double value, double limit) {
    if (!clearly_above(value, limit)) return false;
    finding.value = value;
    finding.limit = limit;
    return true;
  };
  if (!exceeds(size.height_mm, bed_mm[2]) && !exceeds(long_side, long_bed) &&
      !exceeds(short_side, short_bed)) {
    return std::nullopt;
  }
  finding.message = fmt::format(
      "is {} x {} x {} mm, standing on its end; the printer takes {} x {} x "
      "{} mm",
      written(size.width_mm, 4), written(size.depth_mm, 4), written(size.height_mm, 4),
      written(bed_mm[0], 4), written(bed_mm[1], 4), written(bed_mm[2], 4));
  return finding;
}

}  // namespace latticast
