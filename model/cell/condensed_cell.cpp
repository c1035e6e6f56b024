// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/condensed_cell.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "model/cell/cell_assembly.h"

namespace latticast {
namespace {

constexpr int most_newton_steps = 10;
constexpr int most_cuts = 8;

// A correction of a node by the bore's radius whose square, which is what Newton's method leaves,
// is little enough to stay.
constexpr double final_correction = 3e-5;

// Deformations, scaled, that are one: the derivatives follow from one to the other by a series.
constexpr double same_place = 1e-7;
// Two that are far enough apart for their slopes' difference to tell a curvature.
constexpr double apart = 0.02;
constexpr double most_extrapolation = 2;  // by a difference of slopes

/// The tube's strains, then the bore's growth.
constexpr std::size_t coordinates = 5;
using Coordinates = std::array<double, coordinates>;
constexpr std::size_t bore = 4;

/// Numbers of a Deformation's coordinates in this order, and their signs: lambda + kappa . r has
/// kappa = (-Omega_2, Omega_1).
constexpr std::array<std::size_t, coordinates> place_of = {
    coordinate::elongation, coordinate::twist, coordinate::bend_2, coordinate::bend_1,
    coordinate::inner_growth};
constexpr Coordinates sign_of = {1, 1, 1, -1, 1};

using Vector = std::vector<double>;

double product(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

void add(Vector& to, double factor, const Vector& vector) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += factor * vector[i];
}

/// A place on the cell's path.
struct CellState {
  Coordinates at{};
  Vector unknowns;
  double pressure_mpa = 0;  // that holds the cavity's volume
  std::vector<ElementPressure> element_pressures;
  double correction = 0;  // of the last Newton step
  SectionEnergy energy;
  // How the state follows the coordinates.
  std::array<Vector, coordinates> slopes;
  Coordinates pressure_slopes{};
};

/// The cavity's volume that the coordinates ask for, with its derivatives.
struct AskedVolume {
  double value = 0;
  Coordinates slope{};
  double by_bore_twice = 0;
  double by_bore_and_stretch = 0;
};

}  // namespace

struct CondensedCell::Solver {
  Solver(CellMesh mesh, double passing) : assembly(std::move(mesh)), passing_correction(passing) {
    const auto n = static_cast<std::size_t>(assembly.mesh().unknowns);
    here.unknowns.assign(n, 0);
    for (Vector& slope : here.slopes) slope.assign(n, 0);
    if (assembly.assemble(here.unknowns, {}, 0, {}, cell)) rest_volume_mm3 = cell.volume_mm3;
    here.element_pressures = cell.pressures;
  }

  CellAssembly assembly;
  double passing_correction;
  AssembledCell cell;
  Vector columns;
  double rest_volume_mm3 = 1;
  CellState here;
  std::optional<CellState> before;  // some way back on the path
  std::optional<CellState> rest;
  bool started = false;
  int inner_negative = 0;
  int factorisations = 0;

  double radius() const { return assembly.mesh().inner_radius_mm; }

  double distance(const Coordinates& a, const Coordinates& b) const {
    const double r = radius();
    const Coordinates scale = {1, r, r, r, 1 / r};
    double sum = 0;
    for (std::size_t i = 0; i < coordinates; ++i) sum += std::pow(scale[i] * (a[i] - b[i]), 2);
    return std::sqrt(sum);
  }

  AskedVolume asked_volume(const Coordinates& q) const {
    const double stretch = 1 + q[0];
    const double a = 1 + q[bore] / radius();
    const double v = rest_volume_mm3;
    return {.value = v * a * a * stretch,
            .slope = {v * a * a, 0, 0, 0, 2 * v * a * stretch / radius()},
            .by_bore_twice = 2 * v * stretch / (radius() * radius()),
            .by_bore_and_stretch = 2 * v * a / radius()};
  }

  /// One Newton step from `state` at its coordinates, for the nodes and the pressure; the slopes
  /// and the energy's derivatives with it. With L = W - P (V - T), T the volume asked for, the
  /// condensed gradient is dL/dq where the step leads, the Hessian L_qq + L_qz dz/dq, z the nodes
  /// and P.
  bool newton_step(CellState& state) {
    const Coordinates& q = state.at;
    if (!assembly.assemble(state.unknowns, {q[0], q[1], q[2], q[3]}, state.pressure_mpa,
                           state.element_pressures, cell)) {
      return false;
    }
    SparseSolver& matrix = assembly.matrix();
    ++factorisations;
    if (!matrix.factor()) return false;
    const AskedVolume asked = asked_volume(q);
    solve_columns();
    const std::size_t n = cell.residual.size();
    const auto pushed = std::span<const double>(columns).subspan(n, n);
    const double yielding = product(cell.volume_slope, pushed);
    // Of the nodes' energy at the volume asked for.
    inner_negative = matrix.negative_pivots() - (yielding > 0 ? 0 : 1);
    const double missing = asked.value - cell.volume_mm3;
    Vector step(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(n));
    const double pressure_step = (missing + product(cell.volume_slope, step)) / yielding;
    state.correction = 0;
    for (std::size_t i = 0; i < n; ++i) {
      step[i] = pressure_step * pushed[i] - step[i];
      state.correction = std::max(state.correction, std::abs(step[i]) / radius());
    }

    Coordinates direct = asked.slope;  // -d2L/dq dP
    for (std::size_t j = 0; j < tube_strains; ++j) direct[j] -= cell.volume_by_strain[j];
    for (std::size_t j = 0; j < coordinates; ++j) {
      Vector& slope = state.slopes[j];
      double needed = direct[j];
      slope.assign(n, 0);
      if (j < tube_strains) {
        const auto mixed = std::span<const double>(columns).subspan((2 + j) * n, n);
        slope.assign(mixed.begin(), mixed.end());
        needed += product(cell.volume_slope, slope);
      }
      state.pressure_slopes[j] = needed / yielding;
      for (std::size_t i = 0; i < n; ++i) {
        slope[i] = state.pressure_slopes[j] * pushed[i] - slope[i];
      }
    }
    condense(state, asked, step, direct, pressure_step);
    add(state.unknowns, 1, step);
    state.element_pressures = assembly.pressures_after(step, cell);
    state.pressure_mpa += pressure_step;
    return std::isfinite(state.correction);
  }

  /// What the residual, the volume's slope and the tube's strains do to the nodes, one after the
  /// other.
  void solve_columns() {
    columns.clear();
    columns.insert(columns.end(), cell.residual.begin(), cell.residual.end());
    columns.insert(columns.end(), cell.volume_slope.begin(), cell.volume_slope.end());
    for (const Vector& mixed : cell.mixed) {
      columns.insert(columns.end(), mixed.begin(), mixed.end());
    }
    assembly.matrix().solve(columns);
  }

  void condense(CellState& state, const AskedVolume& asked, const Vector& step,
                const Coordinates& direct, double pressure_step) const {
    const double per_mm = assembly.mesh().per_mm;
    const double p = state.pressure_mpa;
    SectionEnergy& energy = state.energy;
    energy.value = per_mm * (cell.energy - p * (cell.volume_mm3 - asked.value));
    for (std::size_t i = 0; i < coordinates; ++i) {
      double slope = p * asked.slope[i] + direct[i] * pressure_step;
      if (i < tube_strains) slope += cell.by_strain[i] + product(cell.mixed[i], step);
      energy.gradient[place_of[i]] = sign_of[i] * per_mm * slope;
      for (std::size_t j = i; j < coordinates; ++j) {
        double second = direct[i] * state.pressure_slopes[j];
        if (j < tube_strains) second += cell.strain_curvature[i * tube_strains + j];
        if (i < tube_strains) second += product(cell.mixed[i], state.slopes[j]);
        if (j == bore && i == 0) second += p * asked.by_bore_and_stretch;
        if (j == bore && i == bore) second += p * asked.by_bore_twice;
        energy.set_second(place_of[i], place_of[j], sign_of[i] * sign_of[j] * per_mm * second);
      }
    }
  }

  /// The state near `q` that the path leads to: to second order along the way it came.
  CellState predicted(const CellState& from, const Coordinates& q) const {
    CellState state = from;
    state.at = q;
    double bend = 0;
    if (before) {
      double along = 0;
      double square = 0;
      for (std::size_t i = 0; i < coordinates; ++i) {
        const double scale = distance({}, unit(i));
        const double back = scale * (from.at[i] - before->at[i]);
        along += back * scale * (q[i] - from.at[i]);
        square += back * back;
      }
      const double share = square > 0 ? along / square : 0;
      if (std::abs(share) < most_extrapolation) bend = 0.5 * share;
    }
    for (std::size_t e = 0; e < state.element_pressures.size() && bend != 0; ++e) {
      for (std::size_t p = 0; p < state.element_pressures[e].size(); ++p) {
        state.element_pressures[e][p] +=
            2 * bend * (from.element_pressures[e][p] - before->element_pressures[e][p]);
      }
    }
    for (std::size_t j = 0; j < coordinates; ++j) {
      const double by = q[j] - from.at[j];
      if (by == 0) continue;
      add(state.unknowns, by * (1 + bend), from.slopes[j]);
      state.pressure_mpa += by * (1 + bend) * from.pressure_slopes[j];
      if (bend == 0) continue;
      add(state.unknowns, -by * bend, before->slopes[j]);
      state.pressure_mpa -= by * bend * before->pressure_slopes[j];
    }
    return state;
  }

  static Coordinates unit(std::size_t i) {
    Coordinates axis{};
    axis[i] = 1;
    return axis;
  }

  std::optional<CellState> corrected(CellState state, double goal) {
    double last = 0.5;
    for (int i = 0; i < most_newton_steps; ++i) {
      if (!newton_step(state) || state.correction > 2 * last) return std::nullopt;
      if (state.correction <= goal) return state;
      last = state.correction;
    }
    return std::nullopt;
  }

  void move_to(CellState state) {
    if (distance(state.at, here.at) > apart) before = std::move(here);
    here = std::move(state);
  }

  /// Where every path begins, and may begin again.
  bool go_to_rest() {
    if (!rest) {
      rest = corrected(here, final_correction);
      if (!rest) return false;
    }
    here = *rest;
    before.reset();
    inner_negative = 0;
    return true;
  }

  bool advance(const Coordinates& q) {
    if (!started && !go_to_rest()) return false;
    started = true;
    const CellState start = here;
    const std::optional<CellState> start_before = before;
    double length = 1;
    double reached = 0;
    for (int cuts = 0; cuts <= most_cuts;) {
      const double next = std::min(1.0, reached + length);
      Coordinates at = q;
      for (std::size_t i = 0; i < coordinates && next < 1; ++i) {
        at[i] = start.at[i] + next * (q[i] - start.at[i]);
      }
      if (auto state = corrected(predicted(here, at), passing_correction)) {
        move_to(std::move(*state));
        reached = next;
        if (reached == 1) return true;
      } else {
        length *= 0.5;
        ++cuts;
      }
    }
    here = start;
    before = start_before;
    return false;
  }

  /// The energy a little beside here: derivatives of third order are left out.
  SectionEnergy beside(const Coordinates& q) const {
    SectionEnergy energy = here.energy;
    for (std::size_t i = 0; i < coordinates; ++i) {
      const double by = sign_of[i] * (q[i] - here.at[i]);
      energy.value += by * here.energy.gradient[place_of[i]];
      for (std::size_t j = 0; j < coordinates; ++j) {
        const double slope = by * here.energy.second(place_of[i], place_of[j]);
        energy.gradient[place_of[j]] += slope;
        energy.value += 0.5 * slope * sign_of[j] * (q[j] - here.at[j]);
      }
    }
    return energy;
  }

  std::optional<SectionEnergy> at(const Coordinates& q) {
    if (q == Coordinates{}) {
      started = go_to_rest();
      return started ? std::optional(here.energy) : std::nullopt;
    }
    const bool near = started && distance(q, here.at) < same_place;
    if (near && here.correction <= final_correction) return beside(q);
    if (!advance(q)) return std::nullopt;
    return here.energy;
  }
};

CondensedCell::CondensedCell(CellMesh mesh, double passing_correction)
    : solver_(std::make_unique<Solver>(std::move(mesh), passing_correction)) {}
CondensedCell::~CondensedCell() = default;
CondensedCell::CondensedCell(CondensedCell&&) noexcept = default;
CondensedCell& CondensedCell::operator=(CondensedCell&&) noexcept = default;

std::optional<SectionEnergy> CondensedCell::at(const Deformation& deformation) {
  return solver_->at({deformation.elongation, deformation.twist, deformation.bend_2,
                      -deformation.bend_1, deformation.inner_growth});
}

std::vector<std::array<double, 3>> CondensedCell::displacements() const {
  const CellMesh& mesh = solver_->assembly.mesh();
  std::vector<std::array<double, 3>> moved(mesh.nodes.size());
  for (std::size_t n = 0; n < moved.size(); ++n) {
    for (std::size_t i = 0; i < 3; ++i) {
      const NodeUnknown& unknown = mesh.nodes[n].unknown[i];
      if (unknown.number >= 0) moved[n][i] = unknown.sign * solver_->here.unknowns[unknown.number];
    }
  }
  return moved;
}

std::array<double, 4> CondensedCell::tube_strain() const {
  const Coordinates& at = solver_->here.at;
  return {at[0], at[1], at[2], at[3]};
}

int CondensedCell::factorisations() const {
  return solver_->factorisations;
}

bool CondensedCell::is_minimum() const {
  return solver_->inner_negative == 0;
}

}  // namespace latticast
