// SPDX-License-Identifier: GPL-3.0-or-later
// Response of a chain of segments, each at its own pressure, under many load cases.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "design/design.h"
#include "model/equilibrium/response.h"

namespace latticast {

class Shape;

/// What a chain's segments do at the pressures that its load cases name.
struct ChainResponse {
  std::vector<LoadCase> cases;
  std::vector<std::vector<double>> pressures_kpa;  ///< of each segment: distinct, rising
  std::vector<Response> responses;                 ///< of each segment, at those pressures
};

/// Predicts every segment once for each of its distinct pressures, however many cases combine them;
/// equal horseshoe laws are built once. Segments do not act on each other: each is in equilibrium
/// under its own pressure, without weight or tip load. Throws std::invalid_argument for a case
/// without exactly one finite pressure per segment, and as prepare_segment does.
ChainResponse predict_chain(std::span<const Segment> segments, const ModelChoice& model,
                            std::span<const LoadCase> cases);

/// The response of one of the chain's segments at distinct, rising pressures in kPa.
using PredictSegment =
    std::function<Response(std::size_t segment, const std::vector<double>& pressures_kpa)>;

/// The same from the segments' responses, whoever solves them.
ChainResponse predict_chain(std::size_t segments, std::span<const LoadCase> cases,
                            const PredictSegment& predict_segment);

/// One segment's state in a case; empty where it has no equilibrium.
const std::optional<State>& state_in(const ChainResponse& chain, std::size_t load_case,
                                     std::size_t segment);

/// All segments' states in a case; empty where one of them has no equilibrium.
std::optional<std::vector<State>> states_in(const ChainResponse& chain, std::size_t load_case);

/// The chain's shape in a case; empty where a segment has no equilibrium.
std::optional<Shape> shape_in(const ChainResponse& chain, std::span<const Segment> segments,
                              std::size_t load_case);

}  // namespace latticast
