// SPDX-License-Identifier: GPL-3.0-or-later
// Events on a branch of equilibria between two of its states: limit point, bifurcation, closed
// bore, asymptote; and landing short of a limit point.
#pragma once

#include <functional>
#include <optional>

#include "model/equilibrium/branch_state.h"
#include "model/equilibrium/limit_point.h"

namespace latticast {

/// `corrected` with everything but the plane bound.
using CorrectInPlane =
    std::function<std::optional<BranchState>(const BranchPoint& start, const BranchPoint& normal)>;

/// A scaled coordinate, whose order is 1, that has grown without end.
inline constexpr double endless_growth = 1e3;

/// a/R_i - 1, always the last free coordinate, of a bore that counts as closed; the energy does not
/// know of contact.
inline constexpr double closed_bore = -0.999;

/// Where to look for the limit point between `here` and an equilibrium past it: the eigenvalue is
/// nearly linear in arc length.
BranchPoint limit_point_guess(const BranchState& here, const BranchState& beyond);

/// The limit point between two states, by a search along the branch for where the pressure stops
/// rising: for energies whose Hessian is not good to the digits that locate_limit_point() takes
/// differences of. Its pressure is good to 1e-6; its error is that of the energy, by `finer_at`.
std::optional<CriticalState> limit_point_between(const EquilibriumEquations& equations,
                                                 const BranchState& here, const BranchState& beyond,
                                                 const CorrectInPlane& correct);

/// Whether `x` lies between two states of the branch, with a tenth of the step to spare: anything
/// else belongs to another branch.
bool lies_between(const BranchPoint& x, const BranchState& here, const BranchState& beyond);

/// Whether the branch runs along the chord from `here` to a limit point, the load rising, stability
/// as here. Where stiff strands lock, it may leave the chord for much higher loads, and what lies
/// behind is where another branch has its least load.
bool is_connected(const BranchState& here, const BranchPoint& limit, int size,
                  const CorrectInPlane& correct);

/// The load at which an eigenvalue changes sign without the branch turning back. Empty when it
/// cannot be pinned down to 1e-12 of the load: the step has come to another branch.
std::optional<CriticalState> bifurcation_between(const BranchState& here, const BranchState& beyond,
                                                 int size, const CorrectInPlane& correct);

/// The equilibrium with the bore closed, from a start whose bore is.
std::optional<BranchState> closed_from(const BranchPoint& start, int size,
                                       const CorrectInPlane& correct);

/// Start for closed_from, between an open state and one past closure.
BranchPoint closure_guess(const BranchState& here, const BranchState& beyond, int size);

/// Error of a closed state's load, relative, by the residual under finer equations.
double closure_error(const BranchState& closed, const BalanceAt& finer, int size);

/// A soft tube can widen without end while the load tends to a bound (a neo-Hookean tube of held
/// length does); there is no limit point to find then. The bound is taken to be the load of the
/// present state; pressure_error says how far the load still rises.
CriticalState asymptote_at(const BranchState& here, int size);

/// The equilibrium at `load`, short of a known limit point. Near it the state goes with the square
/// root of the load that is left, which predicts far better than the tangent. Empty when the branch
/// does not lead there.
std::optional<BranchState> landed_before(const BranchState& here, const BranchPoint& limit,
                                         double load, int size, const CorrectInPlane& correct);

}  // namespace latticast
