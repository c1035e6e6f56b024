// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of a design's segments and their responses to pressure, each prepared and solved
// once for checks, preview and report.
#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <span>
#include <tuple>
#include <vector>

#include "design/design.h"
#include "model/chain.h"
#include "model/prediction.h"
#include "model/segment_response.h"
#include "model/strand/links.h"

namespace latticast {

/// Materials that are softer or stiffer than stated.
struct ModulusFactors {
  double liner = 1;
  double lattice = 1;

  friend auto operator<=>(const ModulusFactors&, const ModulusFactors&) = default;
};

/// For one thread at a time. The design must outlive it. Nothing is held; every function throws
/// UnsupportedDesign as prepare_segment does.
class PreparedResponses {
 public:
  explicit PreparedResponses(const Design& design) : design_(design) {}

  const Design& design() const { return design_; }

  /// prepare_segment(); laws of equal shapes are built once for all segments.
  const PreparedSegment& section(std::size_t segment, ModulusFactors factors = {});

  /// predict() of that section at these pressures, in their order.
  const Response& response(std::size_t segment, const std::vector<double>& pressures_kpa,
                           ModulusFactors factors = {});

  /// The response, and with `with_bands` those at the ends of the liner's modulus range.
  SegmentPrediction prediction(std::size_t segment, const std::vector<double>& pressures_kpa,
                               bool with_bands);

  /// The chain of all segments in these cases.
  ChainResponse chain(std::span<const LoadCase> cases);

 private:
  using SectionKey = std::tuple<std::size_t, ModulusFactors>;
  using ResponseKey = std::tuple<std::size_t, ModulusFactors, std::vector<double>>;

  const Design& design_;
  std::map<SectionKey, PreparedSegment> sections_;
  std::map<ResponseKey, Response> responses_;
  LawsByShape laws_;
};

}  // namespace latticast
