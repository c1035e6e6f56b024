// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/horseshoe_strands.h"

#include <algorithm>
#include <numbers>
#include <string>
#include <variant>

namespace latticast {

double rest_shear_modulus(const Law& law) {
  if (const auto* rubber = std::get_if<NeoHookean>(&law)) return rubber->shear_modulus_mpa;
  if (const auto* rubber = std::get_if<Yeoh>(&law)) return 2 * rubber->c1_mpa;
  if (const auto* rubber = std::get_if<Gent>(&law)) return rubber->shear_modulus_mpa;
  throw UnsupportedDesign(
      "the liner has a linear law, which only axial columns under columns = \"rods\" can use; "
      "other "
      "sections need a rubber (neo-hookean, yeoh or gent)");
}

double strand_modulus_mpa(const Lattice& lattice) {
  if (const auto* linear = std::get_if<Linear>(&lattice.material.law)) {
    return linear->youngs_modulus_mpa;
  }
  throw UnsupportedDesign(
      "the lattice material is a rubber; strands need a linear material (E, nu)");
}

HorseshoeShape horseshoe_shape(const Segment& segment, const Grid& grid, double width_mm) {
  return {grid.horseshoe->radius_mm, grid.horseshoe->arc_deg * std::numbers::pi / 180, width_mm,
          segment.lattice->thickness_mm, strand_modulus_mpa(*segment.lattice)};
}

HorseshoeLaws build_laws(const Segment& segment, const HorseshoeLaws& known) {
  std::vector<HorseshoeShape> missing;
  HorseshoeLaws laws = known;
  for (const Grid& grid : segment.lattice->grids) {
    if (!grid.horseshoe) continue;
    for (const double width : grid.widths_mm) {
      const HorseshoeShape shape = horseshoe_shape(segment, grid, width);
      const bool have = std::any_of(known.begin(), known.end(),
                                    [&](const auto& law) { return law->shape() == shape; });
      if (!have && std::find(missing.begin(), missing.end(), shape) == missing.end()) {
        missing.push_back(shape);
      }
    }
  }
  try {
    const HorseshoeLaws built = horseshoe_laws(missing);
    laws.insert(laws.end(), built.begin(), built.end());
  } catch (const HorseshoeOutOfScope& reason) {
    throw UnsupportedDesign(std::string("a horseshoe strand cannot be predicted: ") +
                            reason.what());
  }
  return laws;
}

std::shared_ptr<const HorseshoeLaw> law_of(const HorseshoeLaws& laws, const HorseshoeShape& shape) {
  return *std::find_if(laws.begin(), laws.end(),
                       [&](const auto& law) { return law->shape() == shape; });
}

}  // namespace latticast
