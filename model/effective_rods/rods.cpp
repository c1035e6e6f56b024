// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/effective_rods/rods.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "design/units.h"
#include "model/strand/links.h"

namespace latticast {
namespace {

constexpr int most_descent_steps = 200;

struct Pull {
  double energy_n = 0;  // integral of the force over the strain
  double force_n = 0;
  double slope_n = 0;
  double error_n = 0;  // of the force, its laws being interpolated
};

std::optional<Pull> pull(const EffectiveRod& rod, double strain) {
  Pull sum{0.5 * rod.straight_stiffness_n * strain * strain, rod.straight_stiffness_n * strain,
           rod.straight_stiffness_n};
  for (const auto& [law, count] : rod.columns) {
    const auto arc = law->at(strain);
    if (!arc) return std::nullopt;
    sum.energy_n += count * arc->energy_nmm / law->rest_chord_mm();
    sum.force_n += count * arc->force_n;
    sum.slope_n += count * arc->slope_n;
    sum.error_n += count * arc->error * std::abs(arc->force_n);
  }
  return sum;
}

/// The convex function, its gradient and Hessian by (e0, kappa R_m).
struct Balanced {
  double energy = 0;
  std::array<double, 2> gradient{};
  double stretch_stretch = 0;
  double stretch_bend = 0;
  double bend_bend = 0;
  double error_n = 0;  // of either entry of the gradient
};

/// E_s pi (R_m^4 - R_i^4)/4 as it stands in the second equation, by kappa R_m.
double liner_bending(const Rods& rods) {
  return rods.bending_stiffness_nmm2() / (rods.liner_outer_radius_mm * rods.arm_mm);
}

std::optional<Balanced> balance(const Rods& rods, const RodsLoad& load, double stretch,
                                double bend) {
  const auto above = pull(rods.halves[0], stretch + bend);
  const auto below = pull(rods.halves[1], stretch - bend);
  if (!above || !below) return std::nullopt;
  const double axial = rods.axial_stiffness_n();
  const double bending = liner_bending(rods);
  const double push = load.pressure_mpa * rods.bore_area_mm2() + load.force_n;
  const double moment = load.moment_nmm / rods.arm_mm;
  return Balanced{0.5 * axial * stretch * stretch + 0.5 * bending * bend * bend + above->energy_n +
                      below->energy_n - push * stretch - moment * bend,
                  {axial * stretch + above->force_n + below->force_n - push,
                   bending * bend + above->force_n - below->force_n - moment},
                  axial + above->slope_n + below->slope_n,
                  above->slope_n - below->slope_n,
                  bending + above->slope_n + below->slope_n,
                  above->error_n + below->error_n};
}

/// H^-1 b over the coordinates that are not held.
std::array<double, 2> solved(const Balanced& at, const RodsLoad& load,
                             const std::array<double, 2>& b) {
  if (load.hold_stretch && load.hold_bend) return {0, 0};
  if (load.hold_stretch) return {0, b[1] / at.bend_bend};
  if (load.hold_bend) return {b[0] / at.stretch_stretch, 0};
  const double determinant = at.stretch_stretch * at.bend_bend - at.stretch_bend * at.stretch_bend;
  return {(b[0] * at.bend_bend - b[1] * at.stretch_bend) / determinant,
          (b[1] * at.stretch_stretch - b[0] * at.stretch_bend) / determinant};
}

/// What interpolated laws and rounding may do to e0 and kappa R_m, whatever their signs.
double error_of(const Balanced& at, const RodsLoad& load, double push) {
  const double doubt = at.error_n + 4 * std::numeric_limits<double>::epsilon() * std::abs(push);
  double largest = 0;
  for (const std::array<double, 2>& side : {std::array{doubt, doubt}, std::array{doubt, -doubt}}) {
    for (const double x : solved(at, load, side)) largest = std::max(largest, std::abs(x));
  }
  return largest;
}

double smallest_eigenvalue(const Balanced& at, const RodsLoad& load, double unit) {
  if (load.hold_stretch && load.hold_bend) return std::numeric_limits<double>::infinity();
  if (load.hold_stretch) return at.bend_bend / unit;
  if (load.hold_bend) return at.stretch_stretch / unit;
  const double mean = 0.5 * (at.stretch_stretch + at.bend_bend);
  const double half = 0.5 * (at.stretch_stretch - at.bend_bend);
  return (mean - std::hypot(half, at.stretch_bend)) / unit;
}

void add_columns(const Segment& segment, const Grid& grid, const LawsByShape& laws, Rods& rods) {
  const int n = grid.count();
  for (int j = 0; j < n; ++j) {
    EffectiveRod& rod = rods.halves[2 * j < n ? 0 : 1];
    const double width = grid.widths_mm[j];
    const auto link = link_shape(segment, grid, width);
    if (!link) {
      rod.straight_stiffness_n +=
          strand_modulus_mpa(*segment.lattice) * width * segment.lattice->thickness_mm;
      continue;
    }
    const auto& law = laws.at(*link);
    const auto same = std::find_if(rod.columns.begin(), rod.columns.end(),
                                   [&](const auto& column) { return column.law == law; });
    same == rod.columns.end() ? rod.columns.push_back({law, 1}) : void(++same->count);
  }
}

/// Where damped Newton steps have come to.
struct Descent {
  Balanced at;
  double stretch = 0;
  double bend = 0;
  double last_step = 0;
  int iterations = 0;
};

/// Shortens a Newton step until the energy falls by enough. False when nothing would be left of it.
bool take_step(const Rods& rods, const RodsLoad& load, const std::array<double, 2>& step,
               Descent& descent) {
  const double promise = step[0] * descent.at.gradient[0] + step[1] * descent.at.gradient[1];
  descent.last_step = std::max(std::abs(step[0]), std::abs(step[1]));
  for (double length = 1; length * descent.last_step >= 1e-12 || length == 1; length *= 0.5) {
    const double stretch = descent.stretch + length * step[0];
    const double bend = descent.bend + length * step[1];
    const auto next = balance(rods, load, stretch, bend);
    // Within rounding the energy no longer tells; a full Newton step does no harm there.
    if (next &&
        (descent.last_step < 1e-6 || next->energy <= descent.at.energy + 1e-4 * length * promise)) {
      descent.at = *next;
      descent.stretch = stretch;
      descent.bend = bend;
      return true;
    }
  }
  return false;
}

/// The energy's minimum from rest, by Newton's method with a line search.
std::optional<Descent> minimum(const Rods& rods, const RodsLoad& load) {
  Descent descent{.at = *balance(rods, load, 0, 0)};
  while (descent.iterations < most_descent_steps) {
    const auto step = solved(descent.at, load, {-descent.at.gradient[0], -descent.at.gradient[1]});
    if (!take_step(rods, load, step, descent)) return std::nullopt;
    ++descent.iterations;
    if (descent.last_step <= 1e-13) return descent;
  }
  return std::nullopt;
}

}  // namespace

double Rods::axial_stiffness_n() const {
  return youngs_modulus_mpa * pi *
         (liner_outer_radius_mm * liner_outer_radius_mm - inner_radius_mm * inner_radius_mm);
}

double Rods::bending_stiffness_nmm2() const {
  return youngs_modulus_mpa * pi *
         (std::pow(liner_outer_radius_mm, 4) - std::pow(inner_radius_mm, 4)) / 4;
}

double Rods::bore_area_mm2() const {
  return pi * inner_radius_mm * inner_radius_mm;
}

Rods prepare_rods(const Segment& segment, const StrandLaws& known) {
  Rods rods;
  rods.inner_radius_mm = segment.inner_radius_mm();
  rods.liner_outer_radius_mm = segment.liner_outer_radius_mm();
  rods.outer_radius_mm = segment.outer_radius_mm();
  rods.youngs_modulus_mpa = 3 * rest_shear_modulus_mpa(segment.liner.material.law);
  const double inside = rods.liner_outer_radius_mm;
  const double outside = rods.outer_radius_mm;
  // (2/3)(R_o^3 - R_m^3)/(R_o^2 - R_m^2), with the common factor taken out.
  rods.arm_mm =
      2.0 / 3 * (outside * outside + outside * inside + inside * inside) / (outside + inside);
  if (!segment.lattice) return rods;
  const LawsByShape laws = build_laws(segment, known);
  for (std::size_t i = 0; i < segment.lattice->grids.size(); ++i) {
    const Grid& grid = segment.lattice->grids[i];
    if (grid.count() > 0 && grid.angle_deg != 90) {
      throw UnsupportedDesign(grid_name(i) +
                              " is tilted; columns = \"rods\" takes axial columns (angle = 90) "
                              "only: use \"distributed\"");
    }
    add_columns(segment, grid, laws, rods);
  }
  return rods;
}

StrandLaws laws_of(const Rods& rods) {
  StrandLaws laws;
  for (const EffectiveRod& half : rods.halves) {
    for (const auto& column : half.columns) {
      if (std::find(laws.begin(), laws.end(), column.law) == laws.end()) {
        laws.push_back(column.law);
      }
    }
  }
  return laws;
}

std::optional<RodsState> rods_equilibrium(const Rods& rods, const RodsLoad& load,
                                          RodsRefusal* why) {
  if (why != nullptr) *why = RodsRefusal::law_range;
  const auto found = minimum(rods, load);
  if (!found) return std::nullopt;
  const auto& [at, stretch, bend, last_step, iterations] = *found;
  if (!(1 + stretch - std::abs(bend) * rods.outer_radius_mm / rods.liner_outer_radius_mm > 0)) {
    if (why != nullptr) *why = RodsRefusal::no_length;
    return std::nullopt;
  }
  const double unit = rods.axial_stiffness_n();
  RodsState state;
  state.iterations = iterations;
  state.elongation = stretch;
  state.error = last_step + (error_of(at, load, load.pressure_mpa * rods.bore_area_mm2()) +
                             std::numeric_limits<double>::epsilon() * (1 + std::abs(stretch)));
  state.bend_rad_per_mm = bend / rods.liner_outer_radius_mm;
  if (load.hold_stretch) state.force_n = at.gradient[0];
  if (load.hold_bend) state.moment_nmm = at.gradient[1] * rods.arm_mm;
  if (!load.hold_stretch) state.residual = std::abs(at.gradient[0]) / unit;
  if (!load.hold_bend) state.residual = std::max(state.residual, std::abs(at.gradient[1]) / unit);
  state.smallest_eigenvalue = smallest_eigenvalue(at, load, unit);
  const auto slope = solved(at, load, {rods.bore_area_mm2(), 0});
  state.elongation_per_mpa = slope[0];
  state.bend_rad_per_mm_per_mpa = slope[1] / rods.liner_outer_radius_mm;
  return state;
}

}  // namespace latticast
