// SPDX-License-Identifier: GPL-3.0-or-later
// Initial-value problems by SUNDIALS CVODE, as a method that ours are measured against.
#pragma once

#include <functional>
#include <memory>
#include <span>

namespace latticast {

/// dy/dt at t; both arrays have the size of the system.
using PathRate = std::function<void(double t, const double* y, double* rate)>;

/// Adams' formulas of variable order and step with a dense Newton iteration.
class CvodePath {
 public:
  /// Throws std::runtime_error when CVODE cannot be set up.
  CvodePath(int size, double relative_tolerance, double absolute_tolerance);
  ~CvodePath();
  CvodePath(const CvodePath&) = delete;
  CvodePath& operator=(const CvodePath&) = delete;

  /// Carries y from t = 0 to `length`; false when CVODE gives up, y is then not to be used.
  bool walk(const PathRate& rate, double length, std::span<double> y);

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace latticast
