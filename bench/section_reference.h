// SPDX-License-Identifier: GPL-3.0-or-later
// Reference equilibrium of a section in extended precision, written apart from the model's energy
// (docs/model.md#energy, docs/bending.md#distributed-columns).
#pragma once

#include "model/equilibrium/balance.h"

namespace latticast {

/// Scaled coordinates of an equilibrium, and how far the last correction still moved them.
struct SectionReference {
  BranchPoint x{};
  double last_step = 0;
};

/// The equilibrium near x at its pressure: gradients in long double (forward differentiation of
/// F written as a matrix, 64 Gauss points in R, 96 directions around the tube), corrections by the
/// model's stiffness, until they no longer shrink. A horseshoe's force is the law's own: an error
/// of the law is not seen. Throws std::invalid_argument for a liner that is not neo-Hookean.
SectionReference section_reference(const Balance& balance, const BranchPoint& x);

/// Where a state lies in scaled coordinates.
BranchPoint scaled(const Balance& balance, const State& state);

/// Largest difference of a scaled coordinate.
double largest_error(const Balance& balance, const BranchPoint& a, const BranchPoint& b);

}  // namespace latticast
