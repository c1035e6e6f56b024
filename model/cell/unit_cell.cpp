// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/unit_cell.h"

#include <utility>

#include "model/cell/cell_materials.h"
#include "model/cell/drawn_cell.h"
#include "model/cell/strip_cell.h"

namespace latticast {
namespace {

constexpr StripDivision coarse_division = {
    .strip = 1, .gap = 2, .ring = 1, .span = 1, .liner = 2, .lattice = 1, .grading = 1};
constexpr StripDivision fine_division = {
    .strip = 1, .gap = 3, .ring = 1, .span = 2, .liner = 3, .lattice = 1, .grading = 1.6};

// The fine mesh's error over the difference of both, docs/unit-cell.md#extrapolation.
constexpr double extrapolation_of_strips = 0.75;
// Of the difference between both meshes, by its extrapolation.
constexpr double doubtful_share = 1.0 / 3;

}  // namespace

FoundCell find_unit_cell(const Segment& segment) {
  std::string problem = parts_problem(segment);
  if (!problem.empty()) return {nullptr, std::move(problem)};
  const FoundStrips found = find_strips(segment);
  if (!found.tube) return find_drawn_cell(segment);
  return {
      std::make_shared<const UnitCell>(UnitCell{.coarse = strip_cell(*found.tube, coarse_division),
                                                .fine = strip_cell(*found.tube, fine_division),
                                                .extrapolation = extrapolation_of_strips,
                                                .assumed = {}}),
      {}};
}

UnitCellEnergy::UnitCellEnergy(const UnitCell& cell)
    : coarse_(cell.coarse), fine_(cell.fine), extrapolation_(cell.extrapolation) {}

std::optional<ExtrapolatedEnergy> UnitCellEnergy::at(const Deformation& deformation) {
  const auto fine = fine_.at(deformation);
  if (!fine) return std::nullopt;
  buckled_ = !fine_.is_minimum();
  const auto coarse = coarse_.at(deformation);
  if (!coarse || buckled_) return std::nullopt;
  SectionEnergy change = *fine;
  change -= *coarse;
  change *= extrapolation_;
  ExtrapolatedEnergy result{*fine, change};
  result.energy += change;
  result.doubt *= -doubtful_share;
  return result;
}

}  // namespace latticast
