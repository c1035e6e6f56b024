// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/numerics/newton.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

#include <kinsol/kinsol.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

namespace latticast {
namespace {

constexpr double step_tolerance = 1e-10;

template <class T>
T* require(T* object) {
  if (object == nullptr) throw std::runtime_error("KINSOL could not be set up");
  return object;
}

void require_success(int flag) {
  if (flag != 0) throw std::runtime_error("KINSOL could not be set up");
}

void keep_silent(int, const char*, const char*, char*, void*) {}

struct FreeContext {
  void operator()(SUNContext context) const { SUNContext_Free(&context); }
};
struct FreeVector {
  void operator()(N_Vector vector) const { N_VDestroy(vector); }
};
struct FreeMatrix {
  void operator()(SUNMatrix matrix) const { SUNMatDestroy(matrix); }
};
struct FreeLinearSolver {
  void operator()(SUNLinearSolver solver) const { SUNLinSolFree(solver); }
};
struct FreeSolver {
  void operator()(void* solver) const { KINFree(&solver); }
};

template <class Handle, class Free>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Free>;

SUNContext create_context() {
  SUNContext context = nullptr;
  require_success(SUNContext_Create(nullptr, &context));
  return context;
}

}  // namespace

/// Members are in order of dependence: each is freed before what it was made with.
struct NewtonSolver::Kinsol {
  explicit Kinsol(int n)
      : size(n),
        context(create_context()),
        unknowns(require(N_VNew_Serial(n, context.get()))),
        ones(require(N_VNew_Serial(n, context.get()))),
        matrix(require(SUNDenseMatrix(n, n, context.get()))),
        linear_solver(require(SUNLinSol_Dense(unknowns.get(), matrix.get(), context.get()))),
        solver(require(KINCreate(context.get()))),
        jacobian(static_cast<std::size_t>(n) * n) {
    N_VConst(1.0, ones.get());
    require_success(KINSetErrHandlerFn(solver.get(), keep_silent, nullptr));
    require_success(KINSetUserData(solver.get(), this));
    require_success(KINInit(solver.get(), evaluate, unknowns.get()));
    require_success(KINSetLinearSolver(solver.get(), linear_solver.get(), matrix.get()));
    require_success(KINSetJacFn(solver.get(), copy_jacobian));
    require_success(KINSetMaxSetupCalls(solver.get(), 1));
    require_success(KINSetScaledStepTol(solver.get(), step_tolerance));
    // The step decides alone: how small a residual can get depends on how stiff the lattice is.
    require_success(KINSetFuncNormTol(solver.get(), std::numeric_limits<double>::min()));
  }

  static int evaluate(N_Vector x, N_Vector residual, void* self) {
    auto& kinsol = *static_cast<Kinsol*>(self);
    const auto n = static_cast<std::size_t>(kinsol.size);
    const bool defined =
        (*kinsol.system)(std::span<const double>(N_VGetArrayPointer(x), n),
                         std::span<double>(N_VGetArrayPointer(residual), n), kinsol.jacobian);
    return defined ? 0 : 1;
  }

  /// KINSOL asks for the Jacobian only where it has just evaluated the residual.
  static int copy_jacobian(N_Vector, N_Vector, SUNMatrix matrix, void* self, N_Vector, N_Vector) {
    const auto& jacobian = static_cast<const Kinsol*>(self)->jacobian;
    std::copy(jacobian.begin(), jacobian.end(), SUNDenseMatrix_Data(matrix));
    return 0;
  }

  int size;
  Owned<SUNContext, FreeContext> context;
  Owned<N_Vector, FreeVector> unknowns;
  Owned<N_Vector, FreeVector> ones;
  Owned<SUNMatrix, FreeMatrix> matrix;
  Owned<SUNLinearSolver, FreeLinearSolver> linear_solver;
  std::unique_ptr<void, FreeSolver> solver;
  std::vector<double> jacobian;
  const NonlinearSystem* system = nullptr;
};

NewtonSolver::NewtonSolver(int size) : kinsol_(std::make_unique<Kinsol>(size)) {}
NewtonSolver::~NewtonSolver() = default;
NewtonSolver::NewtonSolver(NewtonSolver&&) noexcept = default;
NewtonSolver& NewtonSolver::operator=(NewtonSolver&&) noexcept = default;

bool NewtonSolver::solve(std::span<double> x, const NonlinearSystem& system, int most_iterations) {
  Kinsol& kinsol = *kinsol_;
  kinsol.system = &system;
  double* unknowns = N_VGetArrayPointer(kinsol.unknowns.get());
  std::copy(x.begin(), x.end(), unknowns);
  KINSetNumMaxIters(kinsol.solver.get(), most_iterations);
  const int flag = KINSol(kinsol.solver.get(), kinsol.unknowns.get(), KIN_NONE, kinsol.ones.get(),
                          kinsol.ones.get());
  std::copy_n(unknowns, x.size(), x.begin());
  kinsol.system = nullptr;
  return flag == KIN_SUCCESS || flag == KIN_INITIAL_GUESS_OK || flag == KIN_STEP_LT_STPTOL;
}

int NewtonSolver::iterations() const {
  long iterations = 0;
  KINGetNumNonlinSolvIters(kinsol_->solver.get(), &iterations);
  return static_cast<int>(iterations);
}

}  // namespace latticast
