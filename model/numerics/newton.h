// SPDX-License-Identifier: GPL-3.0-or-later
// Small dense nonlinear systems with an exact Jacobian, solved by SUNDIALS KINSOL.
#pragma once

#include <functional>
#include <memory>
#include <span>

namespace latticast {

/// Evaluates residual F(x) (size n) and Jacobian dF/dx (n x n, column after column); false where F
/// is not defined, upon which the solver shortens its step.
using NonlinearSystem = std::function<bool(std::span<const double> x, std::span<double> residual,
                                           std::span<double> jacobian)>;

/// Newton's method on systems of one size. Unknowns and residuals must be scaled to order 1 by the
/// caller. One object serves any number of solves, one at a time; it shares no state with others.
class NewtonSolver {
 public:
  /// Throws std::runtime_error when KINSOL cannot be set up.
  explicit NewtonSolver(int size);
  ~NewtonSolver();
  NewtonSolver(NewtonSolver&&) noexcept;
  NewtonSolver& operator=(NewtonSolver&&) noexcept;

  /// Newton's method from x, until a step is below 1e-10 of max(|x|, 1) in every unknown:
  /// convergence being quadratic, x is then good to rounding. On success x is the solution and the
  /// last evaluation of `system` was made there; on failure (no convergence in `most_iterations`,
  /// singular Jacobian, F undefined) x is not to be used. The Jacobian is evaluated together with
  /// F, once per point.
  bool solve(std::span<double> x, const NonlinearSystem& system, int most_iterations);

  /// Newton iterations of the last solve, failed ones included.
  int iterations() const;

 private:
  struct Kinsol;
  std::unique_ptr<Kinsol> kinsol_;
};

}  // namespace latticast
