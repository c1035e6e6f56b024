// SPDX-License-Identifier: GPL-3.0-or-later
// Graded one-dimensional grids, of which meshes of strips and rings are products.
#pragma once

#include <vector>

namespace latticast {

/// Appends ends of `count` elements from the last one to `to`, each a constant factor longer than
/// the one before, the last one `grading` times as long as the first. `ends` must not be empty.
void append_steps(std::vector<double>& ends, double to, int count, double grading);

/// The same with symmetric steps: the ones in the middle are `grading` times as long as the first
/// and the last.
void append_graded(std::vector<double>& ends, double to, int count, double grading);

/// Element ends with their middles: what the nodes of quadratic elements stand on.
std::vector<double> with_middles(const std::vector<double>& ends);

}  // namespace latticast
