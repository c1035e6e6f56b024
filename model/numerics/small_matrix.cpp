// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/numerics/small_matrix.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace latticast {
namespace {

constexpr int most_sweeps = 30;

/// Row indices after elimination; the matrix then holds its triangular factors L (unit diagonal)
/// and U.
using RowSwaps = std::array<std::size_t, largest_matrix>;

RowSwaps factorise(std::span<double> a, std::size_t n) {
  RowSwaps swaps{};
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (std::abs(a[k * n + i]) > std::abs(a[k * n + pivot])) pivot = i;
    }
    swaps[k] = pivot;
    if (pivot != k) {
      for (std::size_t j = 0; j < n; ++j) std::swap(a[j * n + k], a[j * n + pivot]);
    }
    for (std::size_t i = k + 1; i < n; ++i) a[k * n + i] /= a[k * n + k];
    for (std::size_t j = k + 1; j < n; ++j) {
      for (std::size_t i = k + 1; i < n; ++i) a[j * n + i] -= a[k * n + i] * a[j * n + k];
    }
  }
  return swaps;
}

void substitute(std::span<const double> factors, const RowSwaps& swaps, std::span<double> x) {
  const std::size_t n = x.size();
  for (std::size_t k = 0; k < n; ++k) std::swap(x[k], x[swaps[k]]);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = j + 1; i < n; ++i) x[i] -= x[j] * factors[j * n + i];
  }
  for (std::size_t j = n; j-- > 0;) {
    x[j] /= factors[j * n + j];
    for (std::size_t i = 0; i < j; ++i) x[i] -= x[j] * factors[j * n + i];
  }
}

std::size_t size_of(std::span<const double> matrix) {
  std::size_t n = 0;
  while (n * n < matrix.size()) ++n;
  return n;
}

/// Turns the plane of two axes so that the entry (p, q) becomes zero.
void rotate(std::span<double> a, std::span<double> vectors, std::size_t n, std::size_t p,
            std::size_t q) {
  const double off = a[q * n + p];
  const double half = 0.5 * (a[q * n + q] - a[p * n + p]) / off;
  const double tangent = std::copysign(1.0, half) / (std::abs(half) + std::sqrt(1 + half * half));
  const double cosine = 1 / std::sqrt(1 + tangent * tangent);
  const double sine = tangent * cosine;
  const auto turn = [&](double& x, double& y) {
    const double old = x;
    x = cosine * old - sine * y;
    y = sine * old + cosine * y;
  };
  a[p * n + p] -= tangent * off;
  a[q * n + q] += tangent * off;
  a[q * n + p] = 0;
  // Only the upper triangle is kept.
  for (std::size_t i = 0; i < p; ++i) turn(a[p * n + i], a[q * n + i]);
  for (std::size_t i = p + 1; i < q; ++i) turn(a[i * n + p], a[q * n + i]);
  for (std::size_t i = q + 1; i < n; ++i) turn(a[i * n + p], a[i * n + q]);
  if (vectors.empty()) return;
  for (std::size_t i = 0; i < n; ++i) turn(vectors[p * n + i], vectors[q * n + i]);
}

/// Whether an entry off the diagonal is too small to change the eigenvalues.
bool negligible(double off, double scale) {
  return !(std::abs(off) > 0.1 * std::numeric_limits<double>::epsilon() * scale);
}

void diagonalise(std::span<double> a, std::span<double> vectors, std::size_t n) {
  double scale = 0;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) scale = std::max(scale, std::abs(a[i * n + j]));
  }
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    bool done = true;
    for (std::size_t q = 1; q < n; ++q) {
      for (std::size_t p = 0; p < q; ++p) {
        if (negligible(a[q * n + p], scale)) continue;
        rotate(a, vectors, n, p, q);
        done = false;
      }
    }
    if (done) return;
  }
}

/// Takes the eigenvalues from the diagonal, ascending, and sorts the vectors with them.
void sort_diagonal(std::span<const double> matrix, std::span<double> values,
                   std::span<double> vectors) {
  const std::size_t n = values.size();
  for (std::size_t i = 0; i < n; ++i) values[i] = matrix[i * n + i];
  for (std::size_t i = 0; i + 1 < n; ++i) {
    std::size_t least = i;
    for (std::size_t j = i + 1; j < n; ++j) {
      if (values[j] < values[least]) least = j;
    }
    if (least == i) continue;
    std::swap(values[i], values[least]);
    if (vectors.empty()) continue;
    for (std::size_t k = 0; k < n; ++k) std::swap(vectors[i * n + k], vectors[least * n + k]);
  }
}

}  // namespace

void solve_in_place(std::span<double> matrix, std::span<double> right) {
  const RowSwaps swaps = factorise(matrix, right.size());
  substitute(matrix, swaps, right);
}

void invert(std::span<double> matrix, std::span<double> inverse) {
  const std::size_t n = size_of(matrix);
  const RowSwaps swaps = factorise(matrix, n);
  std::fill(inverse.begin(), inverse.end(), 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    inverse[i * n + i] = 1;
    substitute(matrix, swaps, inverse.subspan(i * n, n));
  }
}

void symmetric_eigenvalues(std::span<double> matrix, std::span<double> values) {
  diagonalise(matrix, {}, values.size());
  sort_diagonal(matrix, values, {});
}

void symmetric_eigenvectors(std::span<double> matrix, std::span<double> values,
                            std::span<double> vectors) {
  const std::size_t n = values.size();
  std::fill(vectors.begin(), vectors.end(), 0.0);
  for (std::size_t i = 0; i < n; ++i) vectors[i * n + i] = 1;
  diagonalise(matrix, vectors, n);
  sort_diagonal(matrix, values, vectors);
}

double norm(std::span<const double> vector) {
  double square = 0;
  for (const double entry : vector) square += entry * entry;
  return std::sqrt(square);
}

}  // namespace latticast
