// SPDX-License-Identifier: GPL-3.0-or-later
// Frame of one period of the plane: its four sides, divided so that opposite ones are alike.
#pragma once

#include <array>
#include <vector>

#include "geometry/solid/period_outline.h"

namespace latticast {

enum class PeriodSide { left, right, bottom, top };
inline constexpr std::array period_sides = {PeriodSide::left, PeriodSide::right, PeriodSide::bottom,
                                            PeriodSide::top};

/// What is alike: left and right at equal z; bottom and top at u and u + shift, unless they are
/// mirrors.
class PeriodFrame {
 public:
  /// Divided at the outline's points on the sides, and into pieces of at most `size_mm` between.
  /// Points whose images are nearer than a thousandth of a mm become one.
  PeriodFrame(const PeriodOutline& outline, const PeriodBox& box, const Period& period,
              double size_mm);

  /// Ends of the side's pieces, from the lower to the higher u or z.
  std::vector<PlanePoint> division(PeriodSide side) const;

  /// Adds points that lie on the sides, and their images. False when all were there before.
  bool add(const std::vector<PlanePoint>& points);

  bool is_on(PeriodSide side, PlanePoint point) const;

  /// Where a place of the top has its image at the bottom, 0 <= u < width.
  double at_bottom(double u_of_top_mm) const;

  static constexpr double same_place_mm = 1e-3;

 private:
  double at_top(double u_of_bottom_mm) const;
  double around(double u_mm) const;
  PlanePoint place(PeriodSide side, double along_mm) const;

  PeriodBox box_;
  Period period_;
  std::vector<double> sides_;  // z of the left and the right
  std::vector<double> ends_;   // u of the bottom, and by their images of the top
  std::vector<double> tops_;   // u of a top that is a mirror
};

}  // namespace latticast
