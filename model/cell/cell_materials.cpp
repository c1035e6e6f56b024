// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/cell_materials.h"

#include <algorithm>

namespace latticast {
namespace {

constexpr double bulk_by_shear = 1000;
constexpr double most_poisson_ratio = 0.4995;

}  // namespace

std::string parts_problem(const Segment& segment) {
  if (!segment.lattice) return "is that of a lattice, and there is none";
  if (!std::holds_alternative<Linear>(segment.lattice->material.law)) {
    return "knows strands of a linear material (E, nu), this one is a rubber";
  }
  if (std::holds_alternative<Linear>(segment.liner.material.law)) {
    return "needs a liner of rubber, this one is linear";
  }
  const auto& grids = segment.lattice->grids;
  const bool any =
      std::any_of(grids.begin(), grids.end(), [](const Grid& g) { return g.count() > 0; });
  return any ? "" : "knows lattices with strands, this one has none";
}

std::vector<CellMaterial> cell_materials(const Law& liner, const Linear& lattice) {
  const double poisson_ratio = std::min(lattice.poisson_ratio, most_poisson_ratio);
  const double modulus = lattice.youngs_modulus_mpa;
  return {
      {liner, bulk_by_shear * rest_shear_modulus_mpa(liner)},
      {NeoHookean{modulus / (2 * (1 + poisson_ratio))}, modulus / (3 * (1 - 2 * poisson_ratio))}};
}

}  // namespace latticast
