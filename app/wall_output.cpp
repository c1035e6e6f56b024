// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/wall_output.h"

#include <variant>

#include "app/answer_json.h"
#include "design/units.h"
#include "design/unsupported_design.h"
#include "model/cell/cell_wall.h"
#include "model/prediction.h"
#include "model/segment_response.h"

namespace latticast {
namespace {

const UnitCell& cell_of(const PreparedSegment& segment) {
  if (segment.cell) return *segment.cell;
  throw UnsupportedDesign(
      "--wall shows the wall as its unit cell has it, and this segment is predicted without one" +
      (segment.not_calibrated.empty() ? "; write kind = \"unit-cell\" under [model]"
                                      : ": " + segment.not_calibrated));
}

}  // namespace

NumberRows predict_walls(const Design& design, const std::vector<double>& pressures_kpa) {
  NumberRows numbers;
  numbers.columns = {"segment",      "pressure_kPa",   "bulge_mm",     "lattice_strain",
                     "liner_strain", "bond_shear_kPa", "bond_pull_kPa"};
  PreparedSegments prepared(design.model);
  for (std::size_t s = 0; s < design.segments.size(); ++s) {
    const PreparedSegment& segment = prepared.prepare(design.segments[s]);
    CellWalls walls(cell_of(segment));
    const Section& section = std::get<Section>(segment.section);
    const std::vector<double> pressures = segment_pressures_kpa(design, s, pressures_kpa);
    const Response response = predict(segment, pressures);
    for (std::size_t i = 0; i < pressures.size(); ++i) {
      const double number = static_cast<double>(s + 1);
      std::optional<CellWall> wall;
      if (const auto& state = response.states[i]) {
        wall = walls.at(state->deformation(section.inner_radius_mm, section.axis_rad));
      }
      if (!wall) {
        numbers.missing.push_back({{{"segment", number}, {"pressure_kPa", pressures[i]}},
                                   response.states[i] ? "the cell cannot be followed"
                                                      : reason_of(response, pressures[i])});
        continue;
      }
      numbers.rows.push_back({number, pressures[i], wall->bulge_mm, wall->lattice_strain,
                              wall->liner_strain, kpa_from_mpa(wall->bond_shear_mpa),
                              kpa_from_mpa(wall->bond_pull_mpa)});
    }
  }
  return numbers;
}

}  // namespace latticast
