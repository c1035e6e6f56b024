// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sinusoid/sinusoid_law.h"

#include <cmath>

#include "design/units.h"
#include "model/law/force_table_builder.h"

namespace latticast {
namespace {

constexpr double least_slope_deg = 1;
constexpr double most_slope_deg = 80;

const SinusoidShape& checked(const SinusoidShape& shape) {
  if (!is_size(shape.amplitude_mm) || !is_size(shape.chord_mm) || !is_size(shape.width_mm) ||
      !is_size(shape.thickness_mm) || !is_size(shape.youngs_modulus_mpa)) {
    throw LinkOutOfScope(SinusoidShape::name,
                         "a sinusoid's sizes and modulus must be positive and finite");
  }
  const double slope = degrees(std::atan(pi * shape.amplitude_mm / shape.chord_mm));
  if (!(slope >= least_slope_deg && slope <= most_slope_deg)) {
    throw LinkOutOfScope(SinusoidShape::name,
                         "a sinusoid's largest slope must be from 1 to 80 degrees");
  }
  const double slenderness = shape.width_mm / shape.chord_mm;
  if (!(slenderness >= 1e-3 && slenderness <= 1)) {
    throw LinkOutOfScope(SinusoidShape::name,
                         "a sinusoid's width must be from 0.001 to 1 of half a wave length");
  }
  return shape;
}

// Equilibria of one half wave, as tables are built from them. The check has half as many terms
// again.
struct WaveBranch {
  using Point = WaveEquilibrium;
  WaveSolver solver;
  WaveSolver finer;
  double half_way = 0;  // to straight

  WaveBranch(const Wave& wave, double full_extension)
      : solver(wave, enough_terms(wave)),
        finer(wave, enough_terms(wave) * 3 / 2),
        half_way(0.5 * full_extension) {}

  const Point& rest() const { return solver.rest(); }
  double force(const Point& point) const { return point.force; }
  double slope(const Point& point) const { return point.force_by_strain; }
  std::optional<Point> advance(const Point& from, double strain) const {
    return solver.advance(from, strain);
  }
  std::optional<Point> check(const Point& from, double strain) const {
    const std::optional<Point> here = solver.advance(from, strain);
    if (!here) return {};
    std::optional<Point> better = finer.corrected(*here);
    if (better) better->defect = std::abs(here->force / better->force - 1);
    return better;
  }
  double defect(const Point& point) const { return point.defect; }
  double first_piece() const { return half_way; }
};

double force_unit_n(const SinusoidShape& shape) {
  const double moment_of_area_mm4 = shape.thickness_mm * std::pow(shape.width_mm, 3) / 12;
  return shape.youngs_modulus_mpa * moment_of_area_mm4 * std::pow(pi / shape.chord_mm, 2);
}

}  // namespace

Wave wave_of(const SinusoidShape& shape) {
  const double slenderness = pi * shape.width_mm / shape.chord_mm;
  return {pi * shape.amplitude_mm / shape.chord_mm, slenderness * slenderness / 12};
}

double full_extension(const SinusoidShape& shape) {
  const double slope = pi * shape.amplitude_mm / shape.chord_mm;
  const double secant = std::hypot(1, slope);
  return 2 / pi * secant * std::comp_ellint_2(slope / secant) - 1;
}

StrainRange widest_range(const SinusoidShape& shape) {
  return link_range(full_extension(shape));
}

StrandLaw make_law(const SinusoidShape& shape) {
  return make_law(shape, widest_range(checked(shape)));
}

StrandLaw make_law(const SinusoidShape& shape, const StrainRange& range) {
  const WaveBranch branch(wave_of(checked(shape)), full_extension(shape));
  return {shape, shape.chord_mm, force_unit_n(shape),
          ForceTableBuilder(branch).build(
              checked_range(range, widest_range(shape), SinusoidShape::name))};
}

std::optional<double> largest_fibre_strain(const SinusoidShape& shape, double strain) {
  if (strain == 0) return 0;
  const Wave wave = wave_of(shape);
  const WaveSolver solver(wave, enough_terms(wave));
  const auto at = solver.advance(solver.rest(), strain);
  if (!at) return std::nullopt;
  return solver.fibre_strain(*at, 0.5 * pi * shape.width_mm / shape.chord_mm);
}

}  // namespace latticast
