// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/chain.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/segment_response.h"
#include "model/shape/shape.h"
#include "model/strand/links.h"

namespace latticast {
namespace {

std::vector<double> distinct_pressures(std::span<const LoadCase> cases, std::size_t segment) {
  std::vector<double> pressures;
  pressures.reserve(cases.size());
  for (const LoadCase& load : cases) pressures.push_back(load.pressures_kpa[segment]);
  std::sort(pressures.begin(), pressures.end());
  pressures.erase(std::unique(pressures.begin(), pressures.end()), pressures.end());
  return pressures;
}

// Before sorting, whose order a NaN would break.
void check_cases(std::span<const LoadCase> cases, std::size_t segments) {
  const auto is_finite = [](double pressure) { return std::isfinite(pressure); };
  for (const LoadCase& load : cases) {
    const std::vector<double>& pressures = load.pressures_kpa;
    if (pressures.size() != segments ||
        !std::all_of(pressures.begin(), pressures.end(), is_finite)) {
      throw std::invalid_argument("a load case needs one finite pressure per segment");
    }
  }
}

}  // namespace

ChainResponse predict_chain(std::span<const Segment> segments, const ModelChoice& model,
                            std::span<const LoadCase> cases) {
  LawsByShape laws;
  return predict_chain(segments.size(), cases,
                       [&](std::size_t s, const std::vector<double>& pressures_kpa) {
                         const PreparedSegment prepared =
                             prepare_segment(segments[s], model, known_laws(laws, segments[s]));
                         for (const auto& law : laws_of(prepared)) laws.emplace(law->shape(), law);
                         return predict(prepared, pressures_kpa);
                       });
}

ChainResponse predict_chain(std::size_t segments, std::span<const LoadCase> cases,
                            const PredictSegment& predict_segment) {
  check_cases(cases, segments);
  ChainResponse chain{{cases.begin(), cases.end()}, {}, {}};
  for (std::size_t s = 0; s < segments; ++s) {
    chain.pressures_kpa.push_back(distinct_pressures(cases, s));
    chain.responses.push_back(predict_segment(s, chain.pressures_kpa.back()));
  }
  return chain;
}

const std::optional<State>& state_in(const ChainResponse& chain, std::size_t load_case,
                                     std::size_t segment) {
  const std::vector<double>& pressures = chain.pressures_kpa[segment];
  const auto at = std::lower_bound(pressures.begin(), pressures.end(),
                                   chain.cases[load_case].pressures_kpa[segment]);
  return chain.responses[segment].states[at - pressures.begin()];
}

std::optional<std::vector<State>> states_in(const ChainResponse& chain, std::size_t load_case) {
  std::vector<State> states;
  for (std::size_t s = 0; s < chain.responses.size(); ++s) {
    const std::optional<State>& state = state_in(chain, load_case, s);
    if (!state) return std::nullopt;
    states.push_back(*state);
  }
  return states;
}

std::optional<Shape> shape_in(const ChainResponse& chain, std::span<const Segment> segments,
                              std::size_t load_case) {
  const auto states = states_in(chain, load_case);
  if (!states) return std::nullopt;
  return Shape(segments, *states);
}

}  // namespace latticast
