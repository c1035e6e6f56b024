// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/horseshoe/horseshoe_strands.h"

#include <numbers>
#include <set>
#include <string>
#include <variant>

#include "design/units.h"

namespace latticast {

double strand_modulus_mpa(const Lattice& lattice) {
  if (const auto* linear = std::get_if<Linear>(&lattice.material.law)) {
    return linear->youngs_modulus_mpa;
  }
  throw UnsupportedDesign(
      "the lattice material is a rubber; strands need a linear material (E, nu)");
}

std::optional<HorseshoeShape> link_shape(const Segment& segment, const Grid& grid,
                                         double width_mm) {
  const auto* path = std::get_if<Horseshoe>(&grid.path);
  if (path == nullptr) return std::nullopt;
  return HorseshoeShape{path->radius_mm, radians(path->arc_deg), width_mm,
                        segment.lattice->thickness_mm, strand_modulus_mpa(*segment.lattice)};
}

std::vector<HorseshoeShape> link_shapes(const Segment& segment) {
  std::vector<HorseshoeShape> shapes;
  if (!segment.lattice) return shapes;
  std::set<HorseshoeShape, HorseshoeShapeOrder> met;
  for (const Grid& grid : segment.lattice->grids) {
    for (const double width : grid.widths_mm) {
      const auto shape = link_shape(segment, grid, width);
      if (!shape) break;
      if (met.insert(*shape).second) shapes.push_back(*shape);
    }
  }
  return shapes;
}

LawsByShape build_laws(const Segment& segment, const HorseshoeLaws& known) {
  LawsByShape laws;
  for (const auto& law : known) laws.emplace(law->shape(), law);
  std::vector<HorseshoeShape> missing = link_shapes(segment);
  std::erase_if(missing, [&](const HorseshoeShape& shape) { return laws.contains(shape); });
  try {
    for (const auto& law : horseshoe_laws(missing)) laws.emplace(law->shape(), law);
  } catch (const HorseshoeOutOfScope& reason) {
    throw UnsupportedDesign(std::string("a horseshoe strand cannot be predicted: ") +
                            reason.what());
  }
  return laws;
}

HorseshoeLaws known_laws(const LawsByShape& laws, const Segment& segment) {
  HorseshoeLaws known;
  for (const HorseshoeShape& shape : link_shapes(segment)) {
    const auto found = laws.find(shape);
    if (found != laws.end()) known.push_back(found->second);
  }
  return known;
}

}  // namespace latticast
