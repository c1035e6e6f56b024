// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/workspace.h"

#include <optional>
#include <stdexcept>

namespace latticast {
namespace {

struct Choice {
  double pressure_kpa = 0;
  Frame end;  // of the segment alone
};

std::vector<Choice> choices(const PreparedSegment& segment, const std::vector<double>& pressures) {
  std::vector<Choice> found;
  const Response response = predict(segment, pressures);
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    const std::optional<State>& state = response.states[i];
    if (state) found.push_back({pressures[i], frame_along(*state, segment.length_mm)});
  }
  return found;
}

void extend(const std::vector<std::vector<Choice>>& all, std::size_t segment,
            const TipPlace& so_far, std::vector<TipPlace>& places) {
  if (segment == all.size()) {
    places.push_back(so_far);
    return;
  }
  for (const Choice& choice : all[segment]) {
    TipPlace next = so_far;
    next.pressures_kpa.push_back(choice.pressure_kpa);
    next.tip = composed(so_far.tip, choice.end);
    extend(all, segment + 1, next, places);
  }
}

}  // namespace

std::vector<TipPlace> workspace(std::span<const PreparedSegment> segments,
                                std::span<const std::vector<double>> pressures_kpa) {
  if (segments.empty() || segments.size() != pressures_kpa.size()) {
    throw std::invalid_argument("a workspace needs a list of pressures for each of its segments");
  }
  std::vector<std::vector<Choice>> all;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    all.push_back(choices(segments[i], pressures_kpa[i]));
  }
  std::vector<TipPlace> places;
  extend(all, 0, {}, places);
  return places;
}

}  // namespace latticast
