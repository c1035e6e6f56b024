// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/unit_cell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "design/units.h"
#include "model/cell/cell_materials.h"
#include "model/cell/drawn_cell.h"
#include "model/cell/strip_cell.h"
#include "model/numerics/small_matrix.h"

namespace latticast {
namespace {

constexpr int strip_levels = 2;
constexpr std::array<StripDivision, strip_levels + 1> divisions = {{
    {.strip = 1, .gap = 2, .ring = 1, .span = 1, .liner = 2, .lattice = 1, .grading = 1},
    {.strip = 1, .gap = 3, .ring = 1, .span = 2, .liner = 3, .lattice = 1, .grading = 1.6},
    {.strip = 2, .gap = 5, .ring = 2, .span = 3, .liner = 4, .lattice = 2, .grading = 2},
}};

// The finer mesh's error over the difference of both, docs/unit-cell.md#extrapolation.
constexpr std::array<double, strip_levels> extrapolation_of_strips = {0.75, 0.7};
// Of the difference between both meshes, by its extrapolation.
constexpr double doubtful_share = 1.0 / 3;

// That one path of states may ask for: about a minute's work at most.
constexpr int least_factorisations = 60;
constexpr int factorisations_by_unknowns = 800000;

// Of the largest part of a response, scaled, below which another is not judged.
constexpr double small_part = 0.02;

FoundCell strips_at(const StripTube& tube, std::size_t level) {
  return {std::make_shared<const UnitCell>(UnitCell{.coarse = strip_cell(tube, divisions[level]),
                                                    .fine = strip_cell(tube, divisions[level + 1]),
                                                    .extrapolation = extrapolation_of_strips[level],
                                                    .assumed = {}}),
          {}};
}

/// Coordinates that the cell leaves free, and what they are measured in.
struct FreeCoordinate {
  int number = 0;
  double unit = 1;
};

std::vector<FreeCoordinate> free_coordinates(const UnitCell& cell) {
  const double radius = cell.fine.inner_radius_mm;
  std::vector<FreeCoordinate> free = {{coordinate::elongation, 1},
                                      {coordinate::inner_growth, radius}};
  if (cell.twists) free.push_back({coordinate::twist, 1 / radius});
  if (cell.bends) free.push_back({coordinate::bend_1, 1 / radius});
  if (cell.bends) free.push_back({coordinate::bend_2, 1 / radius});
  return free;
}

/// Second derivatives by scaled coordinates, column after column.
std::vector<double> scaled_hessian(const SectionEnergy& energy,
                                   const std::vector<FreeCoordinate>& free) {
  const std::size_t n = free.size();
  std::vector<double> hessian(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      hessian[j * n + i] =
          energy.second(free[i].number, free[j].number) * free[i].unit * free[j].unit;
    }
  }
  return hessian;
}

/// The largest share of a part of the response that `change` is, small parts aside.
double largest_share(const std::vector<double>& response, const std::vector<double>& change) {
  double largest = 0;
  for (const double part : response) largest = std::max(largest, std::abs(part));
  double share = 0;
  for (std::size_t i = 0; i < response.size(); ++i) {
    if (std::abs(response[i]) < small_part * largest) continue;
    share = std::max(share, std::abs(change[i] / response[i]));
  }
  return share;
}

/// Bending is judged as a vector: its direction is nobody's axis.
void join_bending(std::vector<double>& parts) {
  const double second = parts.back();
  parts.pop_back();
  parts.back() = std::hypot(parts.back(), second);
}

bool is_rest(const Deformation& at) {
  return at.elongation == 0 && at.twist == 0 && at.inner_growth == 0 && at.bend_1 == 0 &&
         at.bend_2 == 0;
}

std::string text(double percent) {
  std::array<char, 20> written{};
  std::snprintf(written.data(), written.size(), "%.2g", percent);
  return written.data();
}

}  // namespace

double rest_error_percent(const UnitCell& cell) {
  const auto rest = UnitCellEnergy(cell).at({});
  if (!rest) return HUGE_VAL;
  const std::vector<FreeCoordinate> free = free_coordinates(cell);
  const std::size_t n = free.size();
  // The response r of H r = v, and its change -H^-1 dH r.
  std::vector<double> response(n);
  const double radius = cell.fine.inner_radius_mm;
  response[0] = pi * radius * radius;
  response[1] = 2 * pi * radius * free[1].unit;
  std::vector<double> stiffness = scaled_hessian(rest->energy, free);
  solve_in_place(stiffness, response);
  const std::vector<double> doubt = scaled_hessian(rest->doubt, free);
  std::vector<double> change(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) change[i] += doubt[j * n + i] * response[j];
  }
  stiffness = scaled_hessian(rest->energy, free);
  solve_in_place(stiffness, change);
  if (cell.bends) {
    join_bending(response);
    join_bending(change);
  }
  return 100 * largest_share(response, change);
}

FoundCell find_unit_cell(const Segment& segment, double error_percent) {
  std::string problem = parts_problem(segment);
  if (!problem.empty()) return {nullptr, std::move(problem)};
  const FoundStrips found = find_strips(segment);
  const int levels = found.tube ? strip_levels : drawn_levels;
  double reached = HUGE_VAL;
  for (int level = 0; level < levels; ++level) {
    FoundCell cell = found.tube ? strips_at(*found.tube, static_cast<std::size_t>(level))
                                : find_drawn_cell(segment, level);
    if (!cell.cell && level > 0) {
      cell.reason += ", and the coarser ones are within " + text(reached) + " %";
    }
    if (!cell.cell || error_percent == 0) return cell;
    reached = rest_error_percent(*cell.cell);
    if (reached <= error_percent) return cell;
  }
  return {nullptr, "is estimated to be within " + text(reached) + " % on its finest meshes, and " +
                       text(error_percent) + " are asked for"};
}

UnitCellEnergy::UnitCellEnergy(const UnitCell& cell, std::optional<int> most_factorisations)
    : coarse_(cell.coarse),
      fine_(cell.fine),
      extrapolation_(cell.extrapolation),
      most_factorisations_(most_factorisations.value_or(
          least_factorisations + factorisations_by_unknowns / std::max(1, cell.fine.unknowns))) {}

std::optional<ExtrapolatedEnergy> UnitCellEnergy::at(const Deformation& deformation) {
  // Rest is known, and every path begins there.
  if (exhausted() && !is_rest(deformation)) return std::nullopt;
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
