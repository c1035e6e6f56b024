// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepared/prepared_responses.h"

#include <map>
#include <tuple>

#include "design/design.h"
#include "model/chain.h"
#include "model/prediction.h"
#include "model/segment_response.h"

namespace latticast {
namespace {

using SectionKey = std::tuple<std::size_t, ModulusFactors>;
// By the section, so that equal segments have one response.
using ResponseKey = std::tuple<const PreparedSegment*, std::vector<double>>;

}  // namespace

struct PreparedResponses::Kept {
  explicit Kept(const ModelChoice& model) : segments(model) {}

  PreparedSegments segments;
  std::map<SectionKey, const PreparedSegment*> sections;
  std::map<ResponseKey, Response> responses;
};

PreparedResponses::PreparedResponses(const Design& design)
    : design_(design), kept_(std::make_unique<Kept>(design.model)) {}
PreparedResponses::~PreparedResponses() = default;

const PreparedSegment& PreparedResponses::section(std::size_t segment, ModulusFactors factors) {
  const SectionKey key{segment, factors};
  const auto found = kept_->sections.find(key);
  if (found != kept_->sections.end()) return *found->second;
  Segment scaled_segment = design_.segments[segment];
  if (factors.liner != 1) {
    Law& law = scaled_segment.liner.material.law;
    law = scaled(law, factors.liner);
  }
  if (factors.lattice != 1) {
    Law& law = scaled_segment.lattice->material.law;
    law = scaled(law, factors.lattice);
  }
  const PreparedSegment& made = kept_->segments.prepare(scaled_segment);
  kept_->sections.emplace(key, &made);
  return made;
}

const Response& PreparedResponses::response(std::size_t segment,
                                            const std::vector<double>& pressures_kpa,
                                            ModulusFactors factors) {
  const PreparedSegment& prepared = section(segment, factors);
  const ResponseKey key{&prepared, pressures_kpa};
  const auto found = kept_->responses.find(key);
  if (found != kept_->responses.end()) return found->second;
  Response solved = predict(prepared, pressures_kpa);
  return kept_->responses.emplace(key, std::move(solved)).first->second;
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
