// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tip_force_output.h"

#include <numbers>

#include "design/units.h"
#include "model/prediction.h"
#include "model/tip_force.h"

namespace latticast {

TipForceAnswer predict_tip_forces(const Design& design, const std::vector<double>& pressures_kpa) {
  TipForceAnswer answer;
  answer.numbers.columns = {"segment",      "pressure_kPa",    "force_N",
                            "tip_turn_deg", "base_moment_Nmm", "tip_height_mm"};
  for (std::size_t s = 0; s < design.segments.size(); ++s) {
    const PreparedSegment segment = prepare_segment(design.segments[s], design.model);
    for (const double pressure : segment_pressures_kpa(design, s, pressures_kpa)) {
      const auto force = blocked_tip_force(segment, pressure);
      if (force) {
        answer.numbers.rows.push_back({static_cast<double>(s + 1), pressure, force->force_n,
                                       degrees(force->tip_turn_rad), force->base_moment_nmm,
                                       force->tip_height_mm});
      } else {
        answer.complete = false;
        MissingRow& missing = answer.numbers.missing.emplace_back();
        missing.of = {{"segment", static_cast<double>(s + 1)}, {"pressure_kPa", pressure}};
        missing.reason =
            "the free segment has no stable equilibrium, or the one against the stop was not found";
      }
    }
  }
  return answer;
}

}  // namespace latticast
