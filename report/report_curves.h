// SPDX-License-Identifier: GPL-3.0-or-later
// What a report shows of the response: curves fine enough to be drawn, and the chain's cases.
#pragma once

#include <vector>

#include "design/design.h"
#include "model/chain.h"
#include "model/kind_prediction.h"
#include "model/prediction.h"

namespace latticast {

class PreparedResponses;

/// One segment over its whole load, rest included: pressures ascending, each once, at least 33 of
/// them where the load is more than rest, and closer together toward the branch's end if that lies
/// within the load.
struct ResponseCurve {
  SegmentPrediction prediction;
  std::vector<bool> asked;  ///< of each pressure: whether the design's load names it

  /// States that exist, ascending.
  std::vector<State> states() const;
};

struct ReportCurves {
  std::vector<ResponseCurve> segments;
  std::vector<KindPrediction> other_kinds;  ///< of the asked pressures, where the design's own kind
                                            ///< has a unit cell; else none
  ChainResponse chain;                      ///< in the load's cases
  std::size_t cases_left_out = 0;           ///< beyond the first 2000
};

/// Every segment over its load, with modulus bands, and the chain in its load cases.
/// Precondition: the design has a load. Throws UnsupportedDesign.
ReportCurves predict_curves(PreparedResponses& responses);

}  // namespace latticast
