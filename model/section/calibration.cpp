// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/section/calibration.h"

#include <cmath>
#include <span>
#include <tuple>

#include "model/numerics/small_matrix.h"

namespace latticast {
namespace {

constexpr int radial_points = 16;
constexpr int points_around = 32;

using Vector = std::array<double, coordinate_count>;
using Matrix = std::array<double, std::size_t{coordinate_count} * coordinate_count>;

/// What is calibrated: coordinates that the section's symmetry leaves free, and as many natural
/// strains. Matrices are square, column after column.
struct Calibrated {
  std::array<int, coordinate_count> coordinates{};
  std::array<std::size_t, coordinate_count> strains{};
  std::size_t n = 0;

  explicit Calibrated(const Section& section) {
    add(coordinate::elongation, 0);
    add(coordinate::inner_growth, 1);
    if (section.twists) add(coordinate::twist, 2);
    if (section.bending_axes == 0) return;
    add(coordinate::bend_1, 3);
    if (section.bending_axes == 2) add(coordinate::bend_2, 4);
  }

  void add(int coordinate, std::size_t strain) {
    coordinates[n] = coordinate;
    strains[n++] = strain;
  }

  std::span<double> all(Matrix& matrix) const { return std::span(matrix).first(n * n); }
  std::span<double> all(Vector& vector) const { return std::span(vector).first(n); }
  double& entry(Matrix& matrix, std::size_t row, std::size_t column) const {
    return matrix[column * n + row];
  }

  Matrix hessian(const SectionEnergy& energy) const {
    Matrix matrix{};
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        entry(matrix, i, j) = energy.second(coordinates[i], coordinates[j]);
      }
    }
    return matrix;
  }

  /// Whether a matrix by the coordinates is positive definite, the unit of length being R_i.
  bool is_positive(Matrix matrix, double radius_mm) const {
    const auto scale = [&](std::size_t i) {
      if (coordinates[i] == coordinate::elongation) return 1.0;
      return coordinates[i] == coordinate::inner_growth ? radius_mm : 1 / radius_mm;
    };
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) entry(matrix, i, j) *= scale(i) * scale(j);
    }
    Vector eigenvalues{};
    symmetric_eigenvalues(all(matrix), all(eigenvalues));
    return eigenvalues.front() > 0;
  }
};

SectionEnergy energy_at(const Section& section, const Deformation& at) {
  const Quadrature quadrature = make_quadrature(section, radial_points, radial_points,
                                                section.bending_axes > 0 ? points_around : 1);
  if (section.bending_axes > 0) return *stored_energy(section, quadrature, at);
  constexpr std::array straight = {coordinate::elongation, coordinate::twist,
                                   coordinate::inner_growth};
  return *stored_energy(section, quadrature, at, straight);
}

Section bare(Section section) {
  section.families.clear();
  section.bond.reset();
  section.calibration.reset();
  section.ring_modulus_mpa = 0;
  return section;
}

/// Natural strains with their derivatives by the coordinates.
std::array<SectionEnergy, most_natural_strains> strains_at(const Section& section,
                                                           const Calibration& calibration,
                                                           const Deformation& at) {
  const auto elongation = SectionEnergy::variable(coordinate::elongation, at.elongation);
  const auto twist = SectionEnergy::variable(coordinate::twist, at.twist);
  const auto growth = SectionEnergy::variable(coordinate::inner_growth, at.inner_growth);
  const double inner = section.inner_radius_mm;
  const double radius = calibration.radius_mm;
  const double outside = (radius - inner) * (radius + inner);
  const SectionEnergy hoop =
      stretch_minus_1((growth * (growth + 2 * inner) - elongation / (elongation + 1.0) * outside) *
                      (1 / (radius * radius)));
  const SectionEnergy current = (hoop + 1.0) * radius;
  const std::array<SectionEnergy, most_natural_strains> middle = {
      hoop, elongation, twist, current * SectionEnergy::variable(coordinate::bend_1, at.bend_1),
      current * SectionEnergy::variable(coordinate::bend_2, at.bend_2)};
  MiddleStrains values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = middle[i].value;
  const NaturalStrains strains = natural_strains(calibration, values);
  std::array<SectionEnergy, most_natural_strains> result;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = chain(middle, strains[i]);
  return result;
}

}  // namespace

NaturalStrains natural_strains(const Calibration& calibration, const MiddleStrains& at) {
  const WallStrains wall{calibration.radius_mm, at[0], at[1], at[2]};
  const auto strand = strand_stretch(calibration.cosine, calibration.sine, wall);
  const std::array<WallEnergy, 3> straight = {strand.strain(), strand.hoop_strain, strand.turn()};
  NaturalStrains z;
  for (std::size_t i = 0; i < straight.size(); ++i) {
    z[i].value = straight[i].value;
    for (std::size_t j = 0; j < 3; ++j) {
      z[i].gradient[j] = straight[i].gradient[j];
      for (std::size_t k = j; k < 3; ++k) z[i].set_second(j, k, straight[i].second(j, k));
    }
  }
  z[3] = CalibrationEnergy::variable(3, at[3]);
  z[4] = CalibrationEnergy::variable(4, at[4]);
  return z;
}

CalibrationEnergy calibration_energy(const Calibration& calibration, const MiddleStrains& at) {
  const NaturalStrains z = natural_strains(calibration, at);
  double along = 0;
  double state = 0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    along += z[i].value * calibration.along[i];
    state += z[i].value * calibration.state_n[i];
  }
  CalibrationEnergy by_strain(0.5 * along * along * state);
  for (std::size_t i = 0; i < z.size(); ++i) {
    const auto& [row, a, b] =
        std::tie(calibration.stiffness_n[i], calibration.along[i], calibration.state_n[i]);
    double slope = 0;
    for (std::size_t j = 0; j < z.size(); ++j) {
      slope += row[j] * z[j].value;
      if (j < i) continue;
      by_strain.set_second(i, j,
                           row[j] + a * calibration.along[j] * state +
                               along * (a * calibration.state_n[j] + calibration.along[j] * b));
    }
    by_strain.value += 0.5 * slope * z[i].value;
    by_strain.gradient[i] = slope + along * a * state + 0.5 * along * along * b;
  }
  return chain(z, by_strain);
}

std::optional<Calibration> calibrated_at_rest(const Section& section,
                                              const SectionEnergy& cell_at_rest) {
  const StrandFamily& family = section.families.front();
  Calibration result{.radius_mm = 0.5 * (section.liner_outer_radius_mm + section.outer_radius_mm),
                     .cosine = family.cosine,
                     .sine = family.sine};
  const Calibrated q(section);
  const Matrix cell = q.hessian(cell_at_rest);
  const Matrix liner = q.hessian(energy_at(bare(section), {}));
  const Matrix uncorrected = q.hessian(energy_at(section, {}));
  Matrix lattice = cell;
  Matrix missing = cell;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    lattice[i] -= liner[i];
    missing[i] -= uncorrected[i];
  }
  if (!q.is_positive(lattice, section.inner_radius_mm)) return std::nullopt;

  const auto strains = strains_at(section, result, {});
  Matrix by_strain{};
  for (std::size_t i = 0; i < q.n; ++i) {
    for (std::size_t j = 0; j < q.n; ++j) {
      q.entry(by_strain, i, j) = strains[q.strains[i]].gradient[q.coordinates[j]];
    }
  }
  Matrix inverse{};
  invert(q.all(by_strain), q.all(inverse));
  for (std::size_t i = 0; i < q.n; ++i) {
    for (std::size_t j = 0; j < q.n; ++j) {
      for (std::size_t k = 0; k < q.n; ++k) {
        for (std::size_t l = 0; l < q.n; ++l) {
          result.stiffness_n[q.strains[i]][q.strains[j]] +=
              q.entry(inverse, k, i) * q.entry(missing, k, l) * q.entry(inverse, l, j);
        }
      }
    }
  }
  return result;
}

std::optional<Calibration> calibrated_at(
    const Section& section, const Deformation& cell_state,
    const std::array<double, coordinate_count>& cell_gradient) {
  Calibration result = *section.calibration;
  const Calibrated q(section);
  // How strains leave rest with pressure.
  Matrix stiffness = q.hessian(energy_at(section, {}));
  const SectionEnergy cavity_at_rest = cavity_growth(section, {});
  Vector leaving{};
  for (std::size_t i = 0; i < q.n; ++i) leaving[i] = cavity_at_rest.gradient[q.coordinates[i]];
  solve_in_place(q.all(stiffness), q.all(leaving));
  const auto at_rest = strains_at(section, result, {});
  for (std::size_t i = 0; i < q.n; ++i) {
    for (std::size_t j = 0; j < q.n; ++j) {
      result.along[q.strains[i]] += at_rest[q.strains[i]].gradient[q.coordinates[j]] * leaving[j];
    }
  }
  const double length = norm(result.along);
  for (double& part : result.along) part /= length;

  // Of 1/2 x^2 (b . z) with x = along . z: the gradient by z is x (b . z) along + 1/2 x^2 b.
  const auto z = strains_at(section, result, cell_state);
  double x = 0;
  for (std::size_t i = 0; i < z.size(); ++i) x += result.along[i] * z[i].value;
  Matrix by_state{};
  for (std::size_t c = 0; c < q.n; ++c) {
    double along = 0;
    for (std::size_t i = 0; i < z.size(); ++i) {
      along += z[i].gradient[q.coordinates[c]] * result.along[i];
    }
    for (std::size_t i = 0; i < q.n; ++i) {
      const SectionEnergy& strain = z[q.strains[i]];
      q.entry(by_state, c, i) =
          x * along * strain.value + 0.5 * x * x * strain.gradient[q.coordinates[c]];
    }
  }
  const SectionEnergy stored = energy_at(section, cell_state);
  Vector missing{};
  for (std::size_t c = 0; c < q.n; ++c) {
    missing[c] = cell_gradient[q.coordinates[c]] - stored.gradient[q.coordinates[c]];
  }
  solve_in_place(q.all(by_state), q.all(missing));
  for (std::size_t i = 0; i < q.n; ++i) {
    if (!std::isfinite(missing[i])) return std::nullopt;
    result.state_n[q.strains[i]] = missing[i];
  }
  return result;
}

}  // namespace latticast
