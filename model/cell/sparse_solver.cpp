// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/sparse_solver.h"

#include <algorithm>
#include <cmath>

#include <Eigen/SparseCholesky>

#include "model/cell/supernodal_cholesky.h"

namespace latticast {

namespace {

// Rows from which a supernodal factorisation is the faster one, docs/unit-cell.md#run-time.
constexpr int supernodal_rows = 1500;

}  // namespace

struct SparseSolver::Factor {
  Eigen::SparseMatrix<double> matrix;
  std::unique_ptr<SupernodalCholesky> supernodal;  // of large matrices, while they are definite
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt;
  bool is_analysed = false;
  bool is_supernodal = false;  // what was factored last

  bool factor_by_ldlt() {
    if (!is_analysed) ldlt.analyzePattern(matrix);
    is_analysed = true;
    ldlt.factorize(matrix);
    return ldlt.info() == Eigen::Success && ldlt.vectorD().allFinite();
  }
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
  const Eigen::SparseMatrix<double>& matrix = factor_->matrix;
  if (size < supernodal_rows) return;
  const auto columns = static_cast<std::size_t>(size);
  const auto count = static_cast<std::size_t>(matrix.nonZeros());
  factor_->supernodal = SupernodalCholesky::make({.starts = {matrix.outerIndexPtr(), columns + 1},
                                                  .rows = {matrix.innerIndexPtr(), count},
                                                  .values = {matrix.valuePtr(), count}});
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
  factor_->is_supernodal = factor_->supernodal && factor_->supernodal->factor();
  return factor_->is_supernodal || factor_->factor_by_ldlt();
}

int SparseSolver::negative_pivots() const {
  if (factor_->is_supernodal) return 0;
  return static_cast<int>((factor_->ldlt.vectorD().array() < 0).count());
}

void SparseSolver::solve(std::span<double> right) const {
  if (factor_->is_supernodal) return factor_->supernodal->solve(right);
  const Eigen::Index rows = factor_->matrix.rows();
  Eigen::Map<Eigen::MatrixXd> columns(right.data(), rows,
                                      static_cast<Eigen::Index>(right.size()) / rows);
  const Eigen::MatrixXd solution = factor_->ldlt.solve(columns);
  columns = solution;
}

}  // namespace latticast
