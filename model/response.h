// SPDX-License-Identifier: GPL-3.0-or-later
// How a segment answers to pressure: equilibrium states followed from rest, how good each one is,
// and where the branch ends (MODEL.md section 1).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/section.h"
#include "spec/design.h"

namespace latticast {

/// Coordinates held at their rest value by the mounting; each one's reaction is then in the State.
struct Held {
  bool twist = false;    ///< k = 0: the reaction is the blocked torque
  bool stretch = false;  ///< lambda = 1: the reaction is the blocked force
};

/// One equilibrium, with the numbers that say how far to trust it.
/// Scaled coordinates are (lambda, k R_o, a/R_i); the energy unit is G A, the liner's shear modulus
/// at rest times the rubber's cross-section area.
struct State {
  double pressure_kpa = 0;
  double stretch = 1;              ///< lambda
  double twist_rad_per_mm = 0;     ///< k, per reference length, right-handed about +z; the paper's
                                   ///< tau is k / lambda, the end rotation k L
  double inner_radius_mm = 0;      ///< a
  double outer_radius_mm = 0;      ///< r(R_o)
  double torque_nmm = 0;           ///< dPi/dk, applied by the mounting; 0 when twist is free
  double force_n = 0;              ///< dPi/dlambda, applied by the mounting; 0 when stretch is free
  double residual = 0;             ///< largest scaled entry of the free gradient, in units of
                                   ///< G A + |P| pi R_i^2
  double error_estimate = 0;       ///< largest error of a scaled coordinate: the gradient under a
                                   ///< finer quadrature, Newton residual included, mapped by H^-1
  double smallest_eigenvalue = 0;  ///< of the scaled free Hessian, in units of G A
  bool stable = false;             ///< smallest_eigenvalue > 0
  double time_us = 0;              ///< solver time since the previous state
  int iterations = 0;              ///< Newton iterations since the previous state

  /// The same state in the section's own coordinates.
  Deformation deformation(double rest_inner_radius_mm) const {
    return {stretch - 1, twist_rad_per_mm, inner_radius_mm - rest_inner_radius_mm};
  }
};

enum class LimitKind {
  limit_point,  ///< the branch turns back: ballooning when P > 0; no equilibrium beyond on this
                ///< branch
  asymptote,    ///< the state grows without end as this pressure is approached; none beyond either
  closure,      ///< suction has closed the bore to R_i / 1000; contact is not modelled
  bifurcation   ///< the branch goes on, its states beyond are unstable
};

/// A pressure at which the branch ends or loses stability. Limit points and bifurcations, where an
/// eigenvalue of the Hessian passes through zero, are located to about 1e-10 relative; an asymptote
/// is the pressure at a thousandfold growth.
struct LimitPoint {
  LimitKind kind = LimitKind::limit_point;
  double pressure_kpa = 0;
  State state;  ///< there; its error_estimate is the pressure's relative error
  std::string
      name;  ///< "limit point (ballooning) at 47.3 kPa: no equilibrium above it on this branch"
};

enum class Status {
  ok,              ///< every requested state is there
  no_equilibrium,  ///< some pressure lies beyond the branch's end
  not_converged    ///< the path could not be followed to some pressure; the message says where it
                   ///< stopped
};

struct SolverOptions {
  double error_goal =
      1e-11;                 ///< quadrature is refined until a state's error estimate is below this
  int fixed_quadrature = 0;  ///< points per integral; 0: chosen by error_goal
  int most_steps = 2000;     ///< continuation steps in each direction of pressure
};

struct Response {
  std::vector<std::optional<State>> states;  ///< one per requested pressure, in the order asked;
                                             ///< empty where `status` says why there is none
  Status status = Status::ok;
  std::vector<LimitPoint> limit_points;  ///< met on the way; at most one end per sign of pressure
  std::string message;                   ///< empty when status is ok and no limit point was met
};

/// Follows the equilibrium from the rest state to every requested pressure (kPa; any order,
/// duplicates, zero and suction allowed) and never jumps to another branch: a step counts only if
/// its correction is small against it. A pressure beyond a limit point has no state; the others are
/// still given. Equations: dPi/dq = 0 with Pi = stored energy - P pi (a^2 lambda - R_i^2), closed
/// ends. Throws UnsupportedDesign as prepare_section does, std::invalid_argument for a pressure
/// that is not finite, std::runtime_error when the solver library cannot be set up.
Response predict(const Segment& segment, const ModelChoice& model,
                 std::span<const double> pressures_kpa, Held held = {},
                 const SolverOptions& options = {});

}  // namespace latticast
