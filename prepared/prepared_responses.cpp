// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepared/prepared_responses.h"

namespace latticast {

const PreparedSegment& PreparedResponses::section(std::size_t segment, ModulusFactors factors) {
  const SectionKey key{segment, factors};
  const auto found = sections_.find(key);
  if (found != sections_.end()) return found->second;
  Segment scaled_segment = design_.segments[segment];
  if (factors.liner != 1) {
    Law& law = scaled_segment.liner.material.law;
    law = scaled(law, factors.liner);
  }
  if (factors.lattice != 1) {
    Law& law = scaled_segment.lattice->material.law;
    law = scaled(law, factors.lattice);
  }
  PreparedSegment made =
      prepare_segment(scaled_segment, design_.model, known_laws(laws_, scaled_segment));
  for (const auto& law : laws_of(made)) laws_.emplace(law->shape(), law);
  return sections_.emplace(key, std::move(made)).first->second;
}

const Response& PreparedResponses::response(std::size_t segment,
                                            const std::vector<double>& pressures_kpa,
                                            ModulusFactors factors) {
  const ResponseKey key{segment, factors, pressures_kpa};
  const auto found = responses_.find(key);
  if (found != responses_.end()) return found->second;
  Response solved = predict(section(segment, factors), pressures_kpa);
  return responses_.emplace(key, std::move(solved)).first->second;
}

SegmentPrediction PreparedResponses::prediction(std::size_t segment,
                                                const std::vector<double>& pressures_kpa,
                                                bool with_bands) {
  SegmentPrediction result{pressures_kpa, response(segment, pressures_kpa), {}, {}};
  if (!with_bands) return result;
  const Material& liner = design_.segments[segment].liner.material;
  const auto at = [&](std::optional<double> factor) -> std::optional<Response> {
    if (!factor) return std::nullopt;
    return response(segment, pressures_kpa, {*factor, 1});
  };
  result.softest = at(liner.modulus_low_factor);
  result.stiffest = at(liner.modulus_high_factor);
  return result;
}

ChainResponse PreparedResponses::chain(std::span<const LoadCase> cases) {
  return predict_chain(design_.segments.size(), cases,
                       [&](std::size_t segment, const std::vector<double>& pressures_kpa) {
                         return response(segment, pressures_kpa);
                       });
}

}  // namespace latticast
