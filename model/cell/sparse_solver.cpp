// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/sparse_solver.h"

#include <algorithm>
#include <cmath>

#include <Eigen/SparseCholesky>

namespace latticast {

struct SparseSolver::Factor {
  Eigen::SparseMatrix<double> matrix;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt;
};

SparseSolver::SparseSolver(int size, const std::vector<std::pair<int, int>>& entries)
    : factor_(std::make_unique<Factor>()) {
  std::vector<Eigen::Triplet<double>> triplets;
  triplets.reserve(entries.size() + static_cast<std::size_t>(size));
  for (const auto& [row, column] : entries) triplets.emplace_back(row, column, 0.0);
  for (int i = 0; i < size; ++i) triplets.emplace_back(i, i, 1.0);
  factor_->matrix.resize(size, size);
  factor_->matrix.setFromTriplets(triplets.begin(), triplets.end());
  factor_->matrix.makeCompressed();
  factor_->ldlt.analyzePattern(factor_->matrix);
}

SparseSolver::~SparseSolver() = default;
SparseSolver::SparseSolver(SparseSolver&&) noexcept = default;
SparseSolver& SparseSolver::operator=(SparseSolver&&) noexcept = default;

std::size_t SparseSolver::place(int row, int column) const {
  const auto& matrix = factor_->matrix;
  const int* begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column];
  const int* end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column + 1];
  return static_cast<std::size_t>(std::lower_bound(begin, end, row) - matrix.innerIndexPtr());
}

std::span<double> SparseSolver::values() {
  return {factor_->matrix.valuePtr(), static_cast<std::size_t>(factor_->matrix.nonZeros())};
}

bool SparseSolver::factor() {
  factor_->ldlt.factorize(factor_->matrix);
  if (factor_->ldlt.info() != Eigen::Success) return false;
  const auto& pivots = factor_->ldlt.vectorD();
  return pivots.allFinite();
}

int SparseSolver::negative_pivots() const {
  return static_cast<int>((factor_->ldlt.vectorD().array() < 0).count());
}

void SparseSolver::solve(std::span<double> right) const {
  Eigen::Map<Eigen::VectorXd> vector(right.data(), static_cast<Eigen::Index>(right.size()));
  const Eigen::VectorXd solution = factor_->ldlt.solve(vector);
  vector = solution;
}

}  // namespace latticast
