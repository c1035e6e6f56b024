// SPDX-License-Identifier: GPL-3.0-or-later
// Step control of arc-length continuation: which steps count, and how long the next one is.
#pragma once

#include <optional>

#include "model/equilibrium/branch_state.h"

namespace latticast {

inline constexpr double first_step = 0.3;
inline constexpr double smallest_step = 1e-10;

/// How far a correction may move a point, against the step.
inline constexpr double greatest_contraction = 0.15;

struct BranchStep {
  BranchState state;
  double contraction = 0;  ///< the correction's length against the step's
  bool accepted = false;
};

/// Judges what a prediction `start` was corrected to. It counts when the contraction is at most
/// greatest_contraction, the tangent turns by at most 18 degrees, and the load does not seem to
/// turn back and forth in between.
BranchStep judged_step(const BranchState& here, const BranchPoint& start,
                       const std::optional<BranchState>& corrected, int size);

/// Length to try again with after a step that does not count: a tenth to a half.
double shortened(double length, double contraction);

/// Length of the step after one that counts: a half to four times, and at most what longest_step
/// allows. Contraction goes with the square of the length; 0.08 is aimed at.
double lengthened(double length, double contraction);

/// A branch may turn within a share of what it has come, however straight it seems: another one
/// runs beside it where stiff strands snap.
double longest_step(const BranchPoint& x, int size);

/// Whether a slope of equal sign at both ends of a step may change its sign in between, twice: the
/// quadratic through the end slopes and their mean over the step sinks to half of the lesser one.
bool slope_may_vanish(double start, double end, double mean);

}  // namespace latticast
