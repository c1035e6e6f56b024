// SPDX-License-Identifier: GPL-3.0-or-later
// Error estimate of an equilibrium state, by the residual of a finer quadrature
// (docs/model.md#how-it-is-solved-and-how-good-a-state-is).
#pragma once

#include "model/equilibrium/balance.h"

namespace latticast {

/// Largest error of a scaled coordinate: twice the finer quadrature's residual, since that one is
/// not exact either, and what else is in doubt, both mapped by the inverse of the tangent
/// stiffness; and the rounding of the coordinate itself. Infinite where the finer quadrature finds
/// that the state cannot exist.
double state_error(const Balance& balance, const BranchPoint& x, const BalanceAt& at);

}  // namespace latticast
