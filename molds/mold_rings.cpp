// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/mold_rings.h"

#include <cstdint>
#include <numbers>

#include "geometry/solid/layered_solid.h"

namespace latticast {
namespace {

enum class RingSheet : std::uint8_t { whole, beside_socket, rim, openings };
constexpr unsigned beside_socket = only(RingSheet::beside_socket);
constexpr unsigned rim = only(RingSheet::rim);
constexpr unsigned opening = only(RingSheet::openings);

// From the plate's outer face towards the cavity: floor, socket, rim.
Pattern upside(const Pattern& pattern, bool upwards) {
  Pattern turned = pattern;
  if (!upwards) return turned;
  for (Strand& strand : turned.strands) {
    for (PlanePoint& p : strand.outline) p.z = pattern.length_mm - p.z;
    std::swap(strand.outline[1], strand.outline[3]);
  }
  return turned;
}

// Radial layers of an end plate, and on which sheets each is absent.
struct PlateLayers {
  std::vector<RadialLayer> layers;
  std::vector<unsigned> absent;

  Layers operator()(unsigned sheets) const {
    Layers material = 0;
    if (!has(sheets, RingSheet::whole)) return material;
    for (std::size_t i = 0; i < absent.size(); ++i) {
      if ((sheets & absent[i]) == 0) material |= only(i);
    }
    return material;
  }
};

// Socket, the plate up to the openings, the openings, the plate beyond them, the rim.
PlateLayers plate_layers(const EndPlate& plate, double inner, double shell) {
  PlateLayers plates;
  const auto add = [&](double to, unsigned where) {
    const double floor =
        plates.layers.empty() ? plate.hole_radius_mm : plates.layers.back().ceiling_mm;
    plates.layers.push_back({floor, to});
    plates.absent.push_back(where);
  };
  const bool has_socket = plate.core_radius_mm > 0;
  if (has_socket) add(inner, beside_socket | rim);
  if (!plate.openings_rad.empty()) {
    if (!has_socket || plate.opening_from_mm > inner) add(plate.opening_from_mm, rim);
    add(plate.opening_to_mm, rim | opening);
  }
  add(shell, rim);
  add(shell + plate.wall_mm, 0);
  return plates;
}

}  // namespace

Solid core_solid(const Core& core, double tolerance_mm) {
  const double length = core.to_mm - core.from_mm;
  const LayeredTube rod{.drawn_radius_mm = core.radius_mm,
                        .length_mm = length,
                        .start_z_mm = core.from_mm,
                        .sheets = {draw_sleeve(core.radius_mm, length)},
                        .filling = [](unsigned sheets) { return Layers{sheets}; },
                        .layers = {{0, core.radius_mm}},
                        .cuts_mm = {core.chamfer_mm, length - core.chamfer_mm}};
  Solid solid = layered_solid(rod, chamfer_tolerance_mm(tolerance_mm, core.radius_mm));
  for (const double end : {core.from_mm, core.to_mm}) {
    chamfer(solid, end, core.radius_mm, core.chamfer_mm);
  }
  return solid;
}

Solid end_plate_solid(const EndPlate& plate, double face_mm, bool upwards, double tolerance_mm) {
  const double slack = 0.5 * plate.clearance_mm;
  const double inner = plate.core_radius_mm + slack;
  const double shell = plate.shell_radius_mm + slack;
  const double plate_height = plate.floor_mm + plate.socket_mm;
  const double height = plate_height + plate.rim_mm;
  const double drawn = shell;
  const double around = 2 * std::numbers::pi * drawn;

  const Pattern all{around, height, {drawn_band(drawn, 0, height)}};
  const Pattern above_floor{around, height, {drawn_band(drawn, plate.floor_mm, height)}};
  const Pattern above_plate{around, height, {drawn_band(drawn, plate_height, height)}};
  Pattern openings{around, height, {}};
  for (const double middle : plate.openings_rad) {
    const double half = 0.5 * plate.opening_width_rad;
    openings.strands.push_back(drawn_window(drawn, middle - half, middle + half, 0, plate_height));
  }

  const PlateLayers plates = plate_layers(plate, inner, shell);
  LayeredTube tube{
      .drawn_radius_mm = drawn, .length_mm = height, .filling = plates, .layers = plates.layers};
  for (const Pattern& sheet : {all, above_floor, above_plate, openings}) {
    tube.sheets.push_back(upside(sheet, upwards));
  }
  tube.start_z_mm = upwards ? face_mm - plate.rim_mm : face_mm - plate_height;
  return layered_solid(tube, tolerance_mm);
}

}  // namespace latticast
