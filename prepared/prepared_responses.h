// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of a design's segments and their responses to pressure, each prepared and solved
// once for checks, preview and report.
#pragma once

#include <compare>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace latticast {

struct ChainResponse;
struct Design;
struct LoadCase;
struct PreparedSegment;
struct Response;
struct SegmentPrediction;

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
  explicit PreparedResponses(const Design& design);
  ~PreparedResponses();

  const Design& design() const { return design_; }

  /// prepare_segment(); equal segments are one, and laws of equal shapes are built once for all.
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
  struct Kept;

  const Design& design_;
  std::unique_ptr<Kept> kept_;
};

}  // namespace latticast
