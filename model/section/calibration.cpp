// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/section/calibration.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "model/numerics/small_matrix.h"

namespace latticast {
namespace {

constexpr int size = natural_strain_count;
constexpr int radial_points = 16;

using Vector = std::array<double, size>;
using Matrix = std::array<double, std::size_t{size} * size>;  // column after column

double& entry(Matrix& matrix, std::size_t row, std::size_t column) {
  return matrix[column * size + row];
}

/// By (lambda, k, a), which come first among the coordinates.
Matrix hessian(const SectionEnergy& energy) {
  Matrix matrix{};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) entry(matrix, i, j) = energy.second(i, j);
  }
  return matrix;
}

SectionEnergy energy_at(const Section& section, const Deformation& at) {
  return *stored_energy(section, make_quadrature(section, radial_points, radial_points), at);
}

Section bare(Section section) {
  section.families.clear();
  section.bond.reset();
  section.calibration.reset();
  section.ring_modulus_mpa = 0;
  return section;
}

/// Whether a matrix by (lambda, k, a) is positive definite, the unit of length being R_i.
bool is_positive(Matrix matrix, double radius_mm) {
  const Vector scale = {1, 1 / radius_mm, radius_mm};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) entry(matrix, i, j) *= scale[i] * scale[j];
  }
  Vector eigenvalues{};
  symmetric_eigenvalues(matrix, eigenvalues);
  return eigenvalues.front() > 0;
}

/// Natural strains with their derivatives by (lambda, k, a).
NaturalStrains strains_at(const Section& section, const Calibration& calibration,
                          const Deformation& at) {
  const auto elongation = WallEnergy::variable(coordinate::elongation, at.elongation);
  const auto twist = WallEnergy::variable(coordinate::twist, at.twist);
  const auto growth = WallEnergy::variable(coordinate::inner_growth, at.inner_growth);
  const double inner = section.inner_radius_mm;
  const double radius = calibration.radius_mm;
  const double outside = (radius - inner) * (radius + inner);
  const WallEnergy stretch = elongation + 1.0;
  const WallEnergy hoop = stretch_minus_1(
      (growth * (growth + 2 * inner) - elongation / stretch * outside) * (1 / (radius * radius)));
  const NaturalStrains strains = natural_strains(
      calibration.cosine, calibration.sine, {radius, hoop.value, elongation.value, twist.value});
  NaturalStrains result;
  for (std::size_t i = 0; i < size; ++i) {
    result[i] = chain(std::array{hoop, elongation, twist}, strains[i]);
  }
  return result;
}

Matrix jacobian(const NaturalStrains& strains) {
  Matrix matrix{};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) entry(matrix, i, j) = strains[i].gradient[j];
  }
  return matrix;
}

}  // namespace

NaturalStrains natural_strains(double cosine, double sine, const WallStrains& at) {
  const auto strand = strand_stretch(cosine, sine, at);
  return {strand.strain(), strand.hoop_strain, strand.turn()};
}

WallEnergy calibration_energy(const Calibration& calibration, const WallStrains& at) {
  const NaturalStrains z = natural_strains(calibration.cosine, calibration.sine, at);
  WallEnergy quadratic(0);
  WallEnergy along(0);
  WallEnergy state(0);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      quadratic += z[i] * z[j] * (0.5 * calibration.stiffness_n[i][j]);
    }
    along += z[i] * calibration.along[i];
    state += z[i] * calibration.state_n[i];
  }
  return quadratic + square(along) * state * 0.5;
}

std::optional<Calibration> calibrated_at_rest(const Section& section,
                                              const SectionEnergy& cell_at_rest) {
  const double inner = section.inner_radius_mm;
  const Matrix cell = hessian(cell_at_rest);
  const Matrix liner = hessian(energy_at(bare(section), {}));
  const Matrix uncorrected = hessian(energy_at(section, {}));
  Matrix lattice = cell;
  Matrix missing = cell;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    lattice[i] -= liner[i];
    missing[i] -= uncorrected[i];
  }
  if (!is_positive(lattice, inner)) return std::nullopt;

  const StrandFamily& family = section.families.front();
  Calibration result{.radius_mm = 0.5 * (section.liner_outer_radius_mm + section.outer_radius_mm),
                     .cosine = family.cosine,
                     .sine = family.sine};
  Matrix by_strain = jacobian(strains_at(section, result, {}));
  Matrix inverse{};
  invert(by_strain, inverse);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      for (std::size_t k = 0; k < size; ++k) {
        for (std::size_t l = 0; l < size; ++l) {
          result.stiffness_n[i][j] +=
              entry(inverse, k, i) * entry(missing, k, l) * entry(inverse, l, j);
        }
      }
    }
  }
  return result;
}

std::optional<Calibration> calibrated_at(const Section& section, const Deformation& cell_state,
                                         const std::array<double, 3>& cell_gradient) {
  Calibration result = *section.calibration;
  // How strains leave rest with pressure.
  Matrix stiffness = hessian(energy_at(section, {}));
  const SectionEnergy cavity_at_rest = cavity_growth(section, {});
  Vector leaving{};
  std::copy_n(cavity_at_rest.gradient.begin(), size, leaving.begin());
  solve_in_place(stiffness, leaving);
  const NaturalStrains at_rest = strains_at(section, result, {});
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) result.along[i] += at_rest[i].gradient[j] * leaving[j];
  }
  const double length = norm(result.along);
  for (double& part : result.along) part /= length;

  // Of 1/2 x^2 (b . z) with x = along . z: the gradient by z is x (b . z) along + 1/2 x^2 b.
  const NaturalStrains z = strains_at(section, result, cell_state);
  double x = 0;
  for (std::size_t i = 0; i < size; ++i) x += result.along[i] * z[i].value;
  Matrix by_state{};
  for (std::size_t q = 0; q < size; ++q) {
    double along = 0;
    for (std::size_t i = 0; i < size; ++i) along += z[i].gradient[q] * result.along[i];
    for (std::size_t i = 0; i < size; ++i) {
      entry(by_state, q, i) = x * along * z[i].value + 0.5 * x * x * z[i].gradient[q];
    }
  }
  const SectionEnergy stored = energy_at(section, cell_state);
  for (std::size_t q = 0; q < size; ++q) {
    result.state_n[q] = cell_gradient[q] - stored.gradient[q];
  }
  solve_in_place(by_state, result.state_n);
  const bool known = std::all_of(result.state_n.begin(), result.state_n.end(),
                                 [](double part) { return std::isfinite(part); });
  if (!known) return std::nullopt;
  return result;
}

}  // namespace latticast
