// SPDX-License-Identifier: GPL-3.0-or-later
// Force and energy of one horseshoe arc by its strain (MODEL.md section 4; method and limits in
// docs/horseshoe.md).
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "model/horseshoe/arc_law.h"

namespace latticast {

/// A circular arc of rectangular section, as cut.
struct HorseshoeShape {
  double radius_mm = 0;     ///< R_h of the centre line
  double arc_rad = 0;       ///< full angle, 2 phi0
  double width_mm = 0;      ///< w, in the plane of the arc
  double thickness_mm = 0;  ///< h, square to that plane
  double youngs_modulus_mpa = 0;

  bool operator==(const HorseshoeShape&) const = default;
};

/// A total order of shapes to look them up by; numbers that are none have their places in it, too.
struct HorseshoeShapeOrder {
  bool operator()(const HorseshoeShape& a, const HorseshoeShape& b) const;
};

/// Distance of the ends at rest, 2 R_h sin(phi0).
double rest_chord_mm(const HorseshoeShape& shape);

/// Strain at which the chord is as long as the arc was: phi0/sin(phi0) - 1.
double full_extension(const HorseshoeShape& shape);

/// -0.3 to full extension + 0.5, what a law is made for.
StrainRange widest_range(const HorseshoeShape& shape);

/// One arc at one strain.
struct HorseshoeState {
  double energy_nmm = 0;  ///< stored by the arc, 0 at rest
  double force_n = 0;     ///< along the chord at each end, positive when pulled; d energy/d chord
  double slope_n = 0;     ///< d force/d strain
  double error = 0;       ///< of the force, relative: the largest found near this strain
};

/// The shape is outside of what the law is made for (arc 20 to 300 degrees, w/R_h 1e-3 to 100,
/// everything positive and finite), or the range does not hold 0 or exceeds widest_range.
struct HorseshoeOutOfScope : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// The law of one shape: solved at construction, evaluated from polynomials (ArcLaw) with a
/// relative error of the force of at most ArcLaw::tolerance. Immutable: any number of threads may
/// read it.
class HorseshoeLaw {
 public:
  /// Over widest_range, or over a part of it. Throws HorseshoeOutOfScope; ArcNotSolved, which has
  /// not been seen within the scope.
  explicit HorseshoeLaw(const HorseshoeShape& shape);
  HorseshoeLaw(const HorseshoeShape& shape, const StrainRange& range);

  /// Empty outside of the range and for a strain that is not a number.
  std::optional<HorseshoeState> at(double strain) const;

  const HorseshoeShape& shape() const { return shape_; }
  const StrainRange& range() const { return arc_law_.range(); }
  const ArcLawAccuracy& accuracy() const { return arc_law_.accuracy(); }

  /// beta(strain) behind it.
  const ArcLaw& arc_law() const { return arc_law_; }

 private:
  HorseshoeShape shape_;
  ArcLaw arc_law_;
  double force_unit_n_;     // E I/R_h^2
  double energy_unit_nmm_;  // that times the rest chord
};

/// Laws built once, to be reused wherever their shapes occur.
using HorseshoeLaws = std::vector<std::shared_ptr<const HorseshoeLaw>>;

/// The laws of `shapes` over their widest ranges, in that order. Each distinct shape is solved once
/// and its law shared, found in n log n; distinct ones are solved side by side on up to `threads`
/// threads (0: as many as the machine has). Throws as the constructor does, after all threads have
/// come back.
HorseshoeLaws horseshoe_laws(std::span<const HorseshoeShape> shapes, int threads = 0);

}  // namespace latticast
