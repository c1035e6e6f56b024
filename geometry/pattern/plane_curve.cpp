// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/plane_curve.h"

#include <cmath>
#include <numbers>

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

PlanePoint at(const SinusoidOffset& wave, double t) {
  const double phase = std::numbers::pi * t;
  const double slope = std::numbers::pi * wave.amplitude_mm / wave.chord_mm * std::cos(phase);
  const double turn = std::atan(slope);
  const double s = wave.chord_mm * t - wave.offset_mm * std::sin(turn);
  const double out = wave.amplitude_mm * std::sin(phase) + wave.offset_mm * std::cos(turn);
  return {wave.start.u + s * wave.along.u + out * wave.bulge.u,
          wave.start.z + s * wave.along.z + out * wave.bulge.z};
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

SinusoidOffset elsewhere(SinusoidOffset wave, PlanePoint by) {
  wave.start = sum(wave.start, by);
  return wave;
}

}  // namespace

PlanePoint point_at(const PlaneCurve& curve, double t) {
  return std::visit([t](const auto& shape) { return at(shape, t); }, curve);
}

PlaneCurve moved(const PlaneCurve& curve, PlanePoint by) {
  return std::visit([by](const auto& shape) { return PlaneCurve{elsewhere(shape, by)}; }, curve);
}

}  // namespace latticast
