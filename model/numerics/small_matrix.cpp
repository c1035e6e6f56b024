// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/numerics/small_matrix.h"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace latticast {
namespace {

// No heap.
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                             largest_matrix, largest_matrix>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, largest_matrix, 1>;

Eigen::Map<Eigen::VectorXd> entries(std::span<double> vector) {
  return {vector.data(), static_cast<Eigen::Index>(vector.size())};
}

Eigen::Map<Eigen::MatrixXd> square(std::span<double> matrix, std::size_t n) {
  return {matrix.data(), static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n)};
}

std::size_t size_of(std::span<const double> matrix) {
  std::size_t n = 0;
  while (n * n < matrix.size()) ++n;
  return n;
}

/// What Eigen reads of a symmetric matrix; callers keep the other half.
Matrix lower(std::span<double> matrix, std::size_t n) {
  return square(matrix, n).transpose();
}

}  // namespace

void solve_in_place(std::span<double> matrix, std::span<double> right) {
  const Matrix left = square(matrix, right.size());
  const Vector solution = left.partialPivLu().solve(entries(right));
  entries(right) = solution;
}

void invert(std::span<double> matrix, std::span<double> inverse) {
  const std::size_t n = size_of(matrix);
  const Matrix left = square(matrix, n);
  square(inverse, n) = left.partialPivLu().inverse();
}

void symmetric_eigenvalues(std::span<double> matrix, std::span<double> values) {
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(lower(matrix, values.size()),
                                                     Eigen::EigenvaluesOnly);
  entries(values) = solver.eigenvalues();
}

void symmetric_eigenvectors(std::span<double> matrix, std::span<double> values,
                            std::span<double> vectors) {
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(lower(matrix, values.size()));
  entries(values) = solver.eigenvalues();
  square(vectors, values.size()) = solver.eigenvectors();
}

double norm(std::span<const double> vector) {
  double sum = 0;
  for (const double entry : vector) sum += entry * entry;
  return std::sqrt(sum);
}

}  // namespace latticast
