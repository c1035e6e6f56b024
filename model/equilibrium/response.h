// SPDX-License-Identifier: GPL-3.0-or-later
// Response of a segment: the states at the pressures asked for, and what the branch met on the way.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/equilibrium/state.h"
#include "model/law/strand_law.h"

namespace latticast {

enum class CriticalKind {
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
struct CriticalPoint {
  CriticalKind kind = CriticalKind::limit_point;
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

enum class AngleKind { bend, twist };

/// A pressure at which an angle is largest or smallest while the branch goes on: below and above
/// it the same angle is met twice, so that an inverse P(angle) has two branches. Located to about
/// 1e-8.
struct AngleExtremum {
  AngleKind quantity = AngleKind::bend;
  bool largest = true;  ///< in magnitude
  double pressure_kpa = 0;
  State state;
  std::string name;  ///< "bending angle is largest, 50.3 degrees, at 249.7 kPa: ..."
};

struct Response {
  std::vector<std::optional<State>> states;  ///< one per requested pressure, in the order asked;
                                             ///< empty where `status` says why there is none
  Status status = Status::ok;
  std::vector<CriticalPoint>
      critical_points;  ///< met on the way; at most one end per sign of pressure
  std::vector<AngleExtremum> angle_extrema;  ///< met on the way
  std::vector<std::string> solved;  ///< coordinates solved for: stretch, twist, bend-1, bend-2,
                                    ///< radius; the others are held or zero by symmetry
  StrandLaws laws;                  ///< of the curved strands, with range and accuracy
  std::string message;              ///< empty when status is ok and no limit point was met
};

}  // namespace latticast
