// SPDX-License-Identifier: GPL-3.0-or-later
// A segment under its whole load, predicted once, and what goes beyond a limit on the way.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "checks/check_finding.h"
#include "design/design.h"
#include "model/equilibrium/response.h"
#include "prepared/prepared_responses.h"

namespace latticast {

/// How far beyond the load a segment is predicted, to see a limit that is near: 1.25 is a common
/// margin on pressure, and an unnoticed scatter of the modulus moves a limit point in proportion.
inline constexpr double least_limit_margin = 1.25;

struct CellWall;
class WallsByPressure;

/// One segment over the load that the design asks of it: at every asked pressure, and at eight even
/// steps from rest to the largest one and to the deepest suction. Of more than 64 asked pressures
/// 64 are taken, the ends among them: the branch between them is the same.
struct LoadedSegment {
  const Segment* segment = nullptr;        ///< into the design, which must outlive this
  int number = 0;                          ///< from 1
  PreparedResponses* responses = nullptr;  ///< must outlive this, too
  std::vector<double> pressures_kpa;       ///< these, distinct, ascending
  Response response;                       ///< at those, then at the margin beyond either end

  std::shared_ptr<WallsByPressure> walls;  ///< none without a unit cell

  const PreparedSegment& section() const;

  /// The wall as the segment's unit cell has it in one of its states; null without a unit cell, or
  /// where that cannot be followed.
  const CellWall* wall(const State& state) const;

  /// The segment at other pressures.
  const Response& response_at(const std::vector<double>& other_kpa,
                              ModulusFactors factors = {}) const;

  /// States at these pressures, as far as there are any, ascending.
  std::vector<const State*> states() const;
};

/// Predicts one segment of the responses' design. Precondition: the design has a load. Throws
/// UnsupportedDesign.
LoadedSegment load_segment(PreparedResponses& responses, std::size_t index);

/// A number of an equilibrium that should stay within a limit, the limit itself included.
struct Measure {
  std::string_view code;
  std::string part;
  std::string unit;
  double limit = 0;
  bool upper = true;  ///< false: a least value
  std::function<double(const State&)> value;
};

/// Where a measure leaves its limit: the pressure nearest to rest at which it does, found between
/// the asked pressures to 0.4 % of their distance, and the worst value at an asked one.
struct Excess {
  double from_kpa = 0;
  double safe_kpa = 0;  ///< just before, still within the limit
  double worst_kpa = 0;
  double worst = 0;
};

/// Empty when the measure stays within its limit at every asked pressure.
std::optional<Excess> excess(const LoadedSegment& loaded, const Measure& measure);

/// The finding of an excess, its message and remedy still to be written: `pressure_kpa` is where it
/// begins, `value` the worst one.
CheckFinding finding_of(const LoadedSegment& loaded, const Measure& measure, const Excess& excess);

/// "pressure up to 43.2 kPa": three digits, rounded toward rest.
std::string pressure_remedy(double limit_kpa);

}  // namespace latticast
