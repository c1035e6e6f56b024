// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tip_force.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "design/units.h"
#include "model/numerics/small_matrix.h"
#include "model/section/section_energy.h"
#include "model/segment_response.h"

namespace latticast {
namespace {

constexpr int steps = 64;
constexpr int most_tip_iterations = 30;
constexpr double difference = 1e-6;

double largest(std::span<const double> vector) {
  double size = 0;
  for (const double entry : vector) size = std::max(size, std::abs(entry));
  return size;
}

/// Stretch and bending of a section in the plane of bending under pressure, pull and moment.
class PlanarSection {
 public:
  PlanarSection(const PreparedSegment& segment, const State& free, double pressure_mpa)
      : segment_(segment), pressure_mpa_(pressure_mpa) {
    if (const auto* section = std::get_if<Section>(&segment.section)) {
      at_ = free.deformation(section->inner_radius_mm, section->axis_rad);
      quadrature_ = make_quadrature(*section, 8, 6, 1);
      quadrature_.around = half_turn(12);
    } else {
      at_ = {free.stretch - 1, 0, 0, free.bend_rad_per_mm[1], 0};
    }
  }

  double bend() const { return at_.bend_1; }
  double stretch() const { return 1 + at_.elongation; }

  /// Moves to the equilibrium under these loads, from the one before.
  bool load(double force_n, double moment_nmm) {
    if (const auto* rods = std::get_if<Rods>(&segment_.section)) {
      const auto found = rods_equilibrium(*rods, {pressure_mpa_, force_n, moment_nmm});
      if (!found) return false;
      at_.elongation = found->elongation;
      at_.bend_1 = found->bend_rad_per_mm;
      return true;
    }
    return load_section(std::get<Section>(segment_.section), force_n, moment_nmm);
  }

 private:
  bool load_section(const Section& section, double force_n, double moment_nmm) {
    constexpr std::array<int, 3> active = {coordinate::elongation, coordinate::bend_1,
                                           coordinate::inner_growth};
    const std::array scale = {1.0, 1 / section.outer_radius_mm, section.inner_radius_mm};
    const std::array loads = {force_n, moment_nmm, 0.0};
    for (int iteration = 0; iteration < most_tip_iterations; ++iteration) {
      const auto stored = stored_energy(section, quadrature_, at_, active);
      if (!stored) return false;
      const SectionEnergy cavity = cavity_growth(section, at_);
      std::array<double, 3> step{};
      std::array<double, 9> stiffness{};
      for (int i = 0; i < 3; ++i) {
        const int a = active[i];
        step[i] = scale[i] * (loads[i] - stored->gradient[a] + pressure_mpa_ * cavity.gradient[a]);
        for (int j = 0; j < 3; ++j) {
          const int b = active[j];
          stiffness[j * 3 + i] =
              scale[i] * scale[j] * (stored->second(a, b) - pressure_mpa_ * cavity.second(a, b));
        }
      }
      solve_in_place(stiffness, step);
      at_.elongation += scale[0] * step[0];
      at_.bend_1 += scale[1] * step[1];
      at_.inner_growth += scale[2] * step[2];
      if (largest(step) < 1e-11) return true;
    }
    return false;
  }

  const PreparedSegment& segment_;
  double pressure_mpa_;
  Deformation at_;
  Quadrature quadrature_;
};

/// Seen from the tip: angle of the tangent, and how far the tip is ahead along and across.
using RodState = std::array<double, 3>;

std::optional<RodState> slope(PlanarSection& section, const RodState& place, double force_n) {
  const double sine = std::sin(place[0]);
  if (!section.load(force_n * sine, -force_n * place[1])) return std::nullopt;
  return RodState{section.bend(), section.stretch() * std::cos(place[0]), section.stretch() * sine};
}

RodState moved(const RodState& from, const RodState& slope, double by) {
  return {from[0] + by * slope[0], from[1] + by * slope[1], from[2] + by * slope[2]};
}

/// The base, for a tip of given angle under a given force.
std::optional<RodState> base(PlanarSection section, double length_mm, double tip_angle,
                             double force_n) {
  const double h = length_mm / steps;
  RodState place = {tip_angle, 0, 0};
  for (int i = 0; i < steps; ++i) {
    const auto a = slope(section, place, force_n);
    if (!a) return std::nullopt;
    const auto b = slope(section, moved(place, *a, h / 2), force_n);
    if (!b) return std::nullopt;
    const auto c = slope(section, moved(place, *b, h / 2), force_n);
    if (!c) return std::nullopt;
    const auto d = slope(section, moved(place, *c, h), force_n);
    if (!d) return std::nullopt;
    for (int j = 0; j < 3; ++j) {
      place[j] += h / 6 * ((*a)[j] + 2 * (*b)[j] + 2 * (*c)[j] + (*d)[j]);
    }
  }
  return place;
}

void refuse_unless_planar(const PreparedSegment& segment) {
  const auto* section = std::get_if<Section>(&segment.section);
  if (section != nullptr && (section->twists || section->bending_axes == 2)) {
    throw UnsupportedDesign(
        "the tip force is known for segments that bend in one plane: axial columns whose widths "
        "have a mirror plane");
  }
}

}  // namespace

std::optional<TipForce> blocked_tip_force(const PreparedSegment& segment, double pressure_kpa) {
  refuse_unless_planar(segment);
  const Response response = predict(segment, std::array{pressure_kpa});
  const std::optional<State>& free = response.states[0];
  if (!free || !free->stable) return std::nullopt;
  PlanarSection section(segment, *free, mpa_from_kpa(pressure_kpa));
  const double length = segment.length_mm;
  const double bend = section.bend();
  if (std::abs(bend) * length < 1e-12) return TipForce{0, 0, 0, free->stretch * length};

  // A small moment gives the bending stiffness, and linear theory with it the first guess.
  PlanarSection probe = section;
  const double small = 1e-3;
  if (!probe.load(0, small)) return std::nullopt;
  const double stiffness = small / (probe.bend() - bend);
  const double unit = 1.5 * stiffness * bend / (length * free->stretch);
  double angle = -0.25 * bend * length;
  double force = 1;  // in `unit`
  for (int i = 0; i < most_tip_iterations; ++i) {
    const auto at = base(section, length, angle, force * unit);
    const auto turned = base(section, length, angle + difference, force * unit);
    const auto pushed = base(section, length, angle, (force + difference) * unit);
    if (!at || !turned || !pushed) return std::nullopt;
    std::array jacobian = {
        ((*turned)[0] - (*at)[0]) / difference, ((*turned)[2] - (*at)[2]) / difference / length,
        ((*pushed)[0] - (*at)[0]) / difference, ((*pushed)[2] - (*at)[2]) / difference / length};
    std::array step = {-(*at)[0], -(*at)[2] / length};
    solve_in_place(jacobian, step);
    angle += step[0];
    force += step[1];
    if (largest(step) > 1e-9) continue;
    const double newtons = std::abs(force * unit);
    return TipForce{newtons, bend > 0 ? -angle : angle, newtons * (*at)[1], (*at)[1]};
  }
  return std::nullopt;
}

}  // namespace latticast
