// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/horseshoe/horseshoe_law.h"

#include <algorithm>
#include <cmath>

#include "design/limits.h"
#include "design/units.h"
#include "model/horseshoe/arc_equilibrium.h"
#include "model/law/force_table_builder.h"

namespace latticast {
namespace {

constexpr double rounding = 1e-12;  // what conversion of units may add to a limit

bool between(double x, double low, double high) {
  return x >= low * (1 - rounding) && x <= high * (1 + rounding);
}

const HorseshoeShape& checked(const HorseshoeShape& shape) {
  if (!is_size(shape.radius_mm) || !is_size(shape.width_mm) || !is_size(shape.thickness_mm) ||
      !is_size(shape.youngs_modulus_mpa)) {
    throw LinkOutOfScope(HorseshoeShape::name,
                         "a horseshoe's sizes and modulus must be positive and finite");
  }
  if (!between(shape.arc_rad, radians(limits::horseshoe_arc.low),
               radians(limits::horseshoe_arc.high))) {
    throw LinkOutOfScope(HorseshoeShape::name, "a horseshoe's arc must be from 20 to 300 degrees");
  }
  if (!between(shape.width_mm / shape.radius_mm, 1e-3, 100)) {
    throw LinkOutOfScope(HorseshoeShape::name,
                         "a horseshoe's width must be from 0.001 to 100 of its radius");
  }
  return shape;
}

Arc arc_of(const HorseshoeShape& shape) {
  const double slenderness = shape.width_mm / shape.radius_mm;
  return {shape.arc_rad / 2, slenderness * slenderness / 12};
}

double force_unit_n(const HorseshoeShape& shape) {
  const double moment_of_area_mm4 = shape.thickness_mm * std::pow(shape.width_mm, 3) / 12;
  return shape.youngs_modulus_mpa * moment_of_area_mm4 / (shape.radius_mm * shape.radius_mm);
}

// Equilibria of one arc, as tables are built from them.
struct ArcBranch {
  using Point = ArcEquilibrium;
  ArcSolver solver;

  const Point& rest() const { return solver.rest(); }
  double force(const Point& point) const { return point.bent.force; }
  double slope(const Point& point) const { return point.force_by_strain; }
  std::optional<Point> advance(const Point& from, double strain) const {
    return solver.advance(from, strain);
  }
  std::optional<Point> check(const Point& from, double strain) const {
    return solver.advance(from, strain);
  }
  double defect(const Point& point) const { return solver.invariant_defect(point); }

  // Half way to straight.
  double first_piece() const {
    const double half_angle = solver.arc().half_angle_rad;
    return (half_angle / std::sin(half_angle) - 1) / 2;
  }
};

}  // namespace

double rest_chord_mm(const HorseshoeShape& shape) {
  return 2 * shape.radius_mm * std::sin(shape.arc_rad / 2);
}

double full_extension(const HorseshoeShape& shape) {
  return shape.arc_rad / 2 / std::sin(shape.arc_rad / 2) - 1;
}

StrainRange widest_range(const HorseshoeShape& shape) {
  return link_range(full_extension(shape));
}

ForceTable arc_table(const Arc& arc, const StrainRange& range) {
  const ArcBranch branch{ArcSolver(arc)};
  return ForceTableBuilder(branch).build(range);
}

StrandLaw make_law(const HorseshoeShape& shape) {
  return make_law(shape, widest_range(shape));
}

StrandLaw make_law(const HorseshoeShape& shape, const StrainRange& range) {
  const Arc arc = arc_of(checked(shape));
  return {shape, rest_chord_mm(shape), force_unit_n(shape),
          arc_table(arc, checked_range(range, widest_range(shape), HorseshoeShape::name))};
}

std::optional<double> largest_fibre_strain(const HorseshoeShape& shape, double strain) {
  const double slenderness = shape.width_mm / shape.radius_mm;
  const Arc arc = arc_of(shape);
  const ArcSolver solver(arc);
  const auto bent = solver.advance(solver.rest(), strain);
  if (!bent) return std::nullopt;
  const double pull = bent->bent.force;
  const double axial = arc.compliance * pull;
  // cos - 1 and cos^2 - 1 at the end, without cancellation.
  const double lag = -2 * end_sine_squared(arc, bent->bent);
  const double squared = 1 + 2 * pull * lag + pull * axial * lag * (2 + lag);
  const double turning = std::sqrt(std::max(0.0, squared));
  return axial + 0.5 * slenderness * std::abs(1 - turning);
}

}  // namespace latticast
