// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/cvode_path.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

namespace latticast {
namespace {

constexpr long most_steps = 5000;

void keep_silent(int, const char*, const char*, char*, void*) {}

int evaluate(double t, N_Vector y, N_Vector rate, void* call) {
  (*static_cast<const PathRate*>(call))(t, N_VGetArrayPointer(y), N_VGetArrayPointer(rate));
  return std::isfinite(N_VMaxNorm(rate)) ? 0 : 1;
}

}  // namespace

struct CvodePath::Solver {
  Solver(int n, double relative, double absolute) {
    SUNContext_Create(nullptr, &context);
    y = N_VNew_Serial(n, context);
    matrix = SUNDenseMatrix(n, n, context);
    linear = SUNLinSol_Dense(y, matrix, context);
    memory = CVodeCreate(CV_ADAMS, context);
    if (y == nullptr || matrix == nullptr || linear == nullptr || memory == nullptr) {
      throw std::runtime_error("CVODE could not be set up");
    }
    CVodeSetErrHandlerFn(memory, keep_silent, nullptr);
    CVodeInit(memory, evaluate, 0, y);
    CVodeSStolerances(memory, relative, absolute);
    CVodeSetLinearSolver(memory, linear, matrix);
    CVodeSetMaxNumSteps(memory, most_steps);
  }

  ~Solver() {
    CVodeFree(&memory);
    SUNLinSolFree(linear);
    SUNMatDestroy(matrix);
    N_VDestroy(y);
    SUNContext_Free(&context);
  }

  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  SUNContext context = nullptr;
  N_Vector y = nullptr;
  SUNMatrix matrix = nullptr;
  SUNLinearSolver linear = nullptr;
  void* memory = nullptr;
};

CvodePath::CvodePath(int size, double relative_tolerance, double absolute_tolerance)
    : solver_(std::make_unique<Solver>(size, relative_tolerance, absolute_tolerance)) {}

CvodePath::~CvodePath() = default;

bool CvodePath::walk(const PathRate& rate, double length, std::span<double> y) {
  std::copy(y.begin(), y.end(), N_VGetArrayPointer(solver_->y));
  PathRate call = rate;
  CVodeSetUserData(solver_->memory, &call);
  if (CVodeReInit(solver_->memory, 0, solver_->y) != CV_SUCCESS) return false;
  CVodeSetStopTime(solver_->memory, length);
  double t = 0;
  const int flag = CVode(solver_->memory, length, solver_->y, &t, CV_NORMAL);
  std::copy_n(N_VGetArrayPointer(solver_->y), y.size(), y.begin());
  return flag == CV_TSTOP_RETURN || flag == CV_SUCCESS;
}

}  // namespace latticast
