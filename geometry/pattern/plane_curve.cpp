// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/plane_curve.h"

#include <cmath>

namespace latticast {
namespace {

PlanePoint at(const StraightLine& line, double t) {
  return {std::lerp(line.from.u, line.to.u, t), std::lerp(line.from.z, line.to.z, t)};
}

PlanePoint at(const CircularArc& arc, double t) {
  const double angle = std::lerp(arc.from_rad, arc.to_rad, t);
  return {arc.centre.u + arc.radius_mm * std::cos(angle),
          arc.centre.z + arc.radius_mm * std::sin(angle)};
}

PlanePoint sum(PlanePoint a, PlanePoint b) {
  return {a.u + b.u, a.z + b.z};
}

StraightLine elsewhere(const StraightLine& line, PlanePoint by) {
  return {sum(line.from, by), sum(line.to, by)};
}

CircularArc elsewhere(CircularArc arc, PlanePoint by) {
  arc.centre = sum(arc.centre, by);
  return arc;
}

}  // namespace

PlanePoint point_at(const PlaneCurve& curve, double t) {
  return std::visit([t](const auto& shape) { return at(shape, t); }, curve);
}

PlaneCurve moved(const PlaneCurve& curve, PlanePoint by) {
  return std::visit([by](const auto& shape) { return PlaneCurve{elsewhere(shape, by)}; }, curve);
}

}  // namespace latticast
