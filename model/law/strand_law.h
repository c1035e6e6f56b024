// SPDX-License-Identifier: GPL-3.0-or-later
// Force law of a link by the strain of its chord, whatever path the strand follows: energy, force
// and slope from a table that is made once per shape (horseshoe_law.h, sinusoid_law.h).
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "model/law/force_table.h"
#include "model/law/link_shape.h"

namespace latticast {

/// One link at one strain.
struct LinkState {
  double energy_nmm = 0;  ///< stored by the link, 0 at rest
  double force_n = 0;     ///< along the chord at each end, positive when pulled; d energy/d chord
  double slope_n = 0;     ///< d force/d strain
  double error = 0;       ///< of the force, relative: the largest found near this strain
};

/// A shape is outside of what its laws are made for, or a range does not hold 0 or is too wide.
struct LinkOutOfScope : std::invalid_argument {
  LinkOutOfScope(std::string_view path_name, const std::string& reason)
      : std::invalid_argument(reason), path(path_name) {}

  std::string_view path;  ///< "horseshoe"; a literal
};

/// The law of one shape, with a relative error of the force of at most ForceTable::tolerance.
/// Immutable: any number of threads may read it.
class StrandLaw {
 public:
  /// `force_unit_n` is what the table's force of 1 stands for.
  StrandLaw(const LinkShape& shape, double rest_chord_mm, double force_unit_n, ForceTable table);

  /// Empty outside of the range and for a strain that is not a number.
  std::optional<LinkState> at(double strain) const;

  const LinkShape& shape() const { return shape_; }
  /// Distance of the link's ends at rest.
  double rest_chord_mm() const { return rest_chord_mm_; }
  const StrainRange& range() const { return table_.range(); }
  const TableAccuracy& accuracy() const { return table_.accuracy(); }
  const ForceTable& table() const { return table_; }

 private:
  LinkShape shape_;
  ForceTable table_;
  double rest_chord_mm_;
  double force_unit_n_;
  double energy_unit_nmm_;  // that times the rest chord
};

/// Strains that laws of curved links are made for: from -0.3 to half a rest chord beyond the strain
/// at which the link's centre line is straight.
StrainRange link_range(double full_extension);

/// `range`; throws LinkOutOfScope where it does not hold 0 or leaves `widest`.
const StrainRange& checked_range(const StrainRange& range, const StrainRange& widest,
                                 std::string_view path_name);

/// Laws built once, to be reused wherever their shapes occur.
using StrandLaws = std::vector<std::shared_ptr<const StrandLaw>>;

}  // namespace latticast
