// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solid/period_frame.h"

#include <algorithm>
#include <cmath>

namespace latticast {
namespace {

constexpr double side_rounding_mm = 1e-7;

/// Sorted; of places nearer to each other than `same` the first stays, both ends wholly.
std::vector<double> merged(std::vector<double> places, double low, double high, double same) {
  std::sort(places.begin(), places.end());
  std::vector<double> kept = {low};
  for (const double place : places) {
    if (place - kept.back() > same && high - place > same) kept.push_back(place);
  }
  kept.push_back(high);
  return kept;
}

std::vector<double> with_steps(const std::vector<double>& corners, double size) {
  std::vector<double> places = {corners.front()};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const double length = corners[i + 1] - corners[i];
    const int count = std::max(1, static_cast<int>(std::ceil(length / size - 1e-6)));
    for (int k = 1; k < count; ++k) places.push_back(corners[i] + length * k / count);
    places.push_back(corners[i + 1]);
  }
  return places;
}

}  // namespace

PeriodFrame::PeriodFrame(const PeriodOutline& outline, const PeriodBox& box, const Period& period,
                         double size_mm)
    : box_(box), period_(period) {
  std::vector<double> sides;
  std::vector<double> ends;
  std::vector<double> tops;
  for (const PlanePoint& p : outline.points) {
    if (is_on(PeriodSide::left, p) || is_on(PeriodSide::right, p)) sides.push_back(p.z);
    if (is_on(PeriodSide::bottom, p)) ends.push_back(p.u);
    if (!is_on(PeriodSide::top, p)) continue;
    if (period.mirrored) tops.push_back(p.u);
    if (!period.mirrored) ends.push_back(at_bottom(p.u));
  }
  if (!period.mirrored) ends.push_back(at_bottom(0));
  const double width = box.width_mm;
  sides_ = merged(std::move(sides), box.z_from_mm, box.z_to_mm, same_place_mm);
  sides_ = with_steps(sides_, size_mm);
  ends_ = with_steps(merged(std::move(ends), 0, width, same_place_mm), size_mm);
  tops_ = with_steps(merged(std::move(tops), 0, width, same_place_mm), size_mm);
}

std::vector<PlanePoint> PeriodFrame::division(PeriodSide side) const {
  std::vector<double> places = ends_;
  if (side == PeriodSide::left || side == PeriodSide::right) places = sides_;
  if (side == PeriodSide::top && period_.mirrored) places = tops_;
  if (side == PeriodSide::top && !period_.mirrored) {
    for (double& u : places) u = at_top(u);
    places = merged(std::move(places), 0, box_.width_mm, side_rounding_mm);
  }
  std::vector<PlanePoint> points;
  points.reserve(places.size());
  for (const double along : places) points.push_back(place(side, along));
  return points;
}

bool PeriodFrame::add(const std::vector<PlanePoint>& points) {
  const std::size_t before = sides_.size() + ends_.size() + tops_.size();
  for (const PlanePoint& p : points) {
    if (is_on(PeriodSide::left, p) || is_on(PeriodSide::right, p)) sides_.push_back(p.z);
    if (is_on(PeriodSide::bottom, p)) ends_.push_back(p.u);
    if (!is_on(PeriodSide::top, p)) continue;
    if (period_.mirrored) tops_.push_back(p.u);
    if (!period_.mirrored) ends_.push_back(at_bottom(p.u));
  }
  sides_ = merged(std::move(sides_), box_.z_from_mm, box_.z_to_mm, side_rounding_mm);
  ends_ = merged(std::move(ends_), 0, box_.width_mm, side_rounding_mm);
  tops_ = merged(std::move(tops_), 0, box_.width_mm, side_rounding_mm);
  return sides_.size() + ends_.size() + tops_.size() > before;
}

bool PeriodFrame::is_on(PeriodSide side, PlanePoint point) const {
  const bool upright = side == PeriodSide::left || side == PeriodSide::right;
  return distance(point, place(side, upright ? point.z : point.u)) < side_rounding_mm;
}

double PeriodFrame::around(double u_mm) const {
  const double u = std::fmod(u_mm, box_.width_mm);
  const double inside = u < -side_rounding_mm ? u + box_.width_mm : std::max(u, 0.0);
  return box_.width_mm - inside < side_rounding_mm ? 0 : inside;
}

double PeriodFrame::at_bottom(double u_of_top_mm) const {
  return around(u_of_top_mm - period_.shift_mm);
}

double PeriodFrame::at_top(double u_of_bottom_mm) const {
  return around(u_of_bottom_mm + period_.shift_mm);
}

PlanePoint PeriodFrame::place(PeriodSide side, double along_mm) const {
  switch (side) {
    case PeriodSide::left:
      return {0, along_mm};
    case PeriodSide::right:
      return {box_.width_mm, along_mm};
    case PeriodSide::bottom:
      return {along_mm, box_.z_from_mm};
    case PeriodSide::top:
      break;
  }
  return {along_mm, box_.z_to_mm};
}

}  // namespace latticast
