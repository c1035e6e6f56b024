// SPDX-License-Identifier: GPL-3.0-or-later
// Natural continuation of an arc's equilibrium from rest to a strain, for methods that can solve
// near a guess.
#pragma once

#include <functional>
#include <optional>

#include <Eigen/Dense>

namespace latticast {

/// The solution at a strain near a guess; empty when there is none.
using SolveNear =
    std::function<std::optional<Eigen::VectorXd>(double strain, const Eigen::VectorXd& guess)>;

/// Solutions from `rest`, which belongs to strain 0: eight steps at first, each guessed along the
/// line through the two before, halved when it fails and doubled when it does not. Empty when a
/// step of a thousandth of the way fails.
std::optional<Eigen::VectorXd> followed(const SolveNear& solve, const Eigen::VectorXd& rest,
                                        double strain);

}  // namespace latticast
