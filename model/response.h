// SPDX-License-Identifier: GPL-3.0-or-later
// How a segment answers to pressure: equilibrium states followed from rest, how good each one is,
// and where the branch ends (MODEL.md section 1).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "model/rods.h"
#include "model/section.h"
#include "spec/design.h"

namespace latticast {

/// Coordinates held at their rest value by the mounting; each one's reaction is then in the State.
struct Held {
  bool twist = false;    ///< k = 0: the reaction is the blocked torque
  bool stretch = false;  ///< lambda = 1: the reaction is the blocked force
  bool bend = false;     ///< kappa = 0: the reaction is the blocked moment
};

/// One equilibrium, with the numbers that say how far to trust it.
/// Scaled coordinates are (lambda, k R_o, kappa R_o, a/R_i); the energy unit is G A, the liner's
/// shear modulus at rest times the rubber's cross-section area.
struct State {
  double pressure_kpa = 0;
  double stretch = 1;           ///< lambda
  double twist_rad_per_mm = 0;  ///< k, per reference length, right-handed about +z; the paper's
                                ///< tau is k / lambda, the end rotation k L
  /// kappa at the segment's base, per reference length, by its components toward Theta = 0 and
  /// Theta = 90 degrees: that side lengthens, the tube bends the other way. Its direction turns
  /// along the segment with `frame_turn_rad_per_mm`, Z and Theta being those of the material.
  std::array<double, 2> bend_rad_per_mm{};
  double frame_turn_rad_per_mm = 0;
  double inner_radius_mm = 0;          ///< a
  double outer_radius_mm = 0;          ///< r(R_o)
  double torque_nmm = 0;               ///< dPi/dk, applied by the mounting; 0 when twist is free
  std::array<double, 2> moment_nmm{};  ///< dPi/dkappa by the same components, applied by the
                                       ///< mounting; 0 when bending is free
  double force_n = 0;              ///< dPi/dlambda, applied by the mounting; 0 when stretch is free
  double residual = 0;             ///< largest scaled entry of the free gradient, in units of
                                   ///< G A + |P| pi R_i^2
  double error_estimate = 0;       ///< largest error of a scaled coordinate: twice the gradient
                                   ///< under a finer quadrature, Newton residual included, and what
                                   ///< interpolated laws and rounding add, mapped by H^-1
  double smallest_eigenvalue = 0;  ///< of the scaled free Hessian, in units of G A
  bool stable = false;             ///< smallest_eigenvalue > 0
  double time_us = 0;              ///< solver time since the previous state
  int iterations = 0;              ///< Newton iterations since the previous state

  /// |kappa|: the far end of a segment of length L is turned by this times L.
  double bend_magnitude_rad_per_mm() const;

  /// Theta in [0, 2 pi) toward which the segment bends at its base, that of -kappa; 0 when
  /// straight.
  double bend_direction_rad() const;

  /// The same state in the coordinates of a section with the given first axis.
  Deformation deformation(double rest_inner_radius_mm, double axis_rad = 0) const;
};

enum class LimitKind {
  limit_point,  ///< the branch turns back: ballooning when P > 0; no equilibrium beyond on this
                ///< branch
  asymptote,    ///< the state grows without end as this pressure is approached, which at a
                ///< thousandfold growth is less than 1 % away; none beyond either
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
  bool all_unknowns = false;  ///< solves also for what symmetry keeps at zero (for checks)
};

enum class TurningQuantity { bend, twist };

/// A pressure at which an angle is largest or smallest while the branch goes on: below and above
/// it the same angle is met twice, so that an inverse P(angle) has two branches. Located to about
/// 1e-8.
struct TurningPoint {
  TurningQuantity quantity = TurningQuantity::bend;
  bool largest = true;  ///< in magnitude
  double pressure_kpa = 0;
  State state;
  std::string name;  ///< "bending angle is largest, 50.3 degrees, at 249.7 kPa: ..."
};

struct Response {
  std::vector<std::optional<State>> states;  ///< one per requested pressure, in the order asked;
                                             ///< empty where `status` says why there is none
  Status status = Status::ok;
  std::vector<LimitPoint> limit_points;  ///< met on the way; at most one end per sign of pressure
  std::vector<TurningPoint> turning_points;  ///< met on the way
  std::vector<std::string> solved;  ///< coordinates solved for: stretch, twist, bend-1, bend-2,
                                    ///< radius; the others are held or zero by symmetry
  HorseshoeLaws laws;               ///< of the horseshoe strands, with range and accuracy
  std::string message;              ///< empty when status is ok and no limit point was met
};

/// A segment with everything that does not depend on pressure: its symmetry settled, its horseshoe
/// laws built. Immutable: any number of predictions, on any number of threads, may share it.
struct PreparedSegment {
  double length_mm = 0;
  std::variant<Section, Rods> section;
};

/// Prepares a segment under the chosen column model, reusing `known` laws where they fit. Throws
/// UnsupportedDesign as prepare_section and prepare_rods do.
PreparedSegment prepare_segment(const Segment& segment, const ModelChoice& model,
                                const HorseshoeLaws& known = {});

/// The laws that a prepared segment uses.
HorseshoeLaws laws_of(const PreparedSegment& segment);

/// Follows the equilibrium from the rest state to every requested pressure (kPa; any order,
/// duplicates, zero and suction allowed) and never jumps to another branch: a step counts only if
/// its correction is small against it. A pressure beyond a limit point has no state; the others are
/// still given. With effective rods the equilibrium is unique
/// (model/rods.h). Equations: dPi/dq = 0 with Pi = stored energy - P pi (a^2 lambda - R_i^2),
/// closed ends. Throws std::invalid_argument for a pressure that is not finite, std::runtime_error
/// when the solver library cannot be set up.
Response predict(const PreparedSegment& segment, std::span<const double> pressures_kpa,
                 Held held = {}, const SolverOptions& options = {});

/// Prepares the segment and predicts.
Response predict(const Segment& segment, const ModelChoice& model,
                 std::span<const double> pressures_kpa, Held held = {},
                 const SolverOptions& options = {});

}  // namespace latticast
