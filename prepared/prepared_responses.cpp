// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepared/prepared_responses.h"

#include <map>
#include <tuple>

#include "design/design.h"
#include "model/chain.h"
#include "model/prediction.h"
#include "model/segment_response.h"
#include "model/strand/links.h"

namespace latticast {
namespace {

using SectionKey = std::tuple<std::size_t, ModulusFactors>;
using ResponseKey = std::tuple<std::size_t, ModulusFactors, std::vector<double>>;

}  // namespace

struct PreparedResponses::Kept {
  std::map<SectionKey, PreparedSegment> sections;
  std::map<ResponseKey, Response> responses;
  LawsByShape laws;
};

PreparedResponses::PreparedResponses(const Design& design)
    : design_(design), kept_(std::make_unique<Kept>()) {}
PreparedResponses::~PreparedResponses() = default;

const PreparedSegment& PreparedResponses::section(std::size_t segment, ModulusFactors factors) {
  const SectionKey key{segment, factors};
  const auto found = kept_->sections.find(key);
  if (found != kept_->sections.end()) return found->second;
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
      prepare_segment(scaled_segment, design_.model, known_laws(kept_->laws, scaled_segment));
  for (const auto& law : laws_of(made)) kept_->laws.emplace(law->shape(), law);
  return kept_->sections.emplace(key, std::move(made)).first->second;
}

const Response& PreparedResponses::response(std::size_t segment,
                                            const std::vector<double>& pressures_kpa,
                                            ModulusFactors factors) {
  const ResponseKey key{segment, factors, pressures_kpa};
  const auto found = kept_->responses.find(key);
  if (found != kept_->responses.end()) return found->second;
  Response solved = predict(section(segment, factors), pressures_kpa);
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
