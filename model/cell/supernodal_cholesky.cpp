// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/supernodal_cholesky.h"

#ifdef LATTICAST_CHOLMOD

#include <algorithm>
#include <array>
#include <utility>

#include <cholmod.h>
#include <dlfcn.h>

namespace latticast {
namespace {

/// The functions that are asked for, found in the library by name.
struct Library {
  void* handle = nullptr;
  decltype(&cholmod_start) start = nullptr;
  decltype(&cholmod_finish) finish = nullptr;
  decltype(&cholmod_analyze) analyze = nullptr;
  decltype(&cholmod_factorize) factorize = nullptr;
  decltype(&cholmod_solve2) solve = nullptr;
  decltype(&cholmod_free_factor) free_factor = nullptr;
  decltype(&cholmod_free_dense) free_dense = nullptr;
  decltype(&cholmod_version) version = nullptr;

  template <class Function>
  bool find(Function& function, const char* name) const {
    function = reinterpret_cast<Function>(dlsym(handle, name));
    return function != nullptr;
  }

  /// Structures are laid out as in the header this was compiled with.
  bool is_the_same() const {
    std::array<int, 3> numbers{};
    version(numbers.data());
    return numbers[0] == CHOLMOD_MAIN_VERSION && numbers[1] == CHOLMOD_SUB_VERSION;
  }

  bool load() {
    handle = dlopen(LATTICAST_CHOLMOD, RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) return false;
    const bool found = find(start, "cholmod_start") && find(finish, "cholmod_finish") &&
                       find(analyze, "cholmod_analyze") && find(factorize, "cholmod_factorize") &&
                       find(solve, "cholmod_solve2") && find(free_factor, "cholmod_free_factor") &&
                       find(free_dense, "cholmod_free_dense") && find(version, "cholmod_version");
    if (!found || !is_the_same()) return false;
    // One thread a solve: responses share the cores among themselves, and threads that CHOLMOD
    // starts for each supernode cost more than they do.
    void (*set)(int) = nullptr;
    if (find(set, "openblas_set_num_threads")) set(1);
    if (find(set, "omp_set_max_active_levels")) set(0);
    return true;
  }
};

const Library* library() {
  static const std::unique_ptr<const Library> loaded = [] {
    auto library = std::make_unique<Library>();
    return library->load() ? std::move(library) : nullptr;
  }();
  return loaded.get();
}

}  // namespace

struct SupernodalCholesky::Factor {
  Factor(const Library& loaded, const LowerTriangle& of) : cholmod(loaded) {
    cholmod.start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.final_ll = 1;
    common.quick_return_if_not_posdef = 1;
    matrix.nrow = matrix.ncol = of.starts.size() - 1;
    matrix.nzmax = of.values.size();
    // The library only reads what these point to.
    matrix.p = const_cast<int*>(of.starts.data());
    matrix.i = const_cast<int*>(of.rows.data());
    matrix.x = const_cast<double*>(of.values.data());
    matrix.stype = -1;
    matrix.itype = CHOLMOD_INT;
    matrix.xtype = CHOLMOD_REAL;
    matrix.dtype = CHOLMOD_DOUBLE;
    matrix.sorted = 1;
    matrix.packed = 1;
    factor = cholmod.analyze(&matrix, &common);
  }
  Factor(const Factor&) = delete;
  Factor& operator=(const Factor&) = delete;
  ~Factor() {
    cholmod.free_factor(&factor, &common);
    for (cholmod_dense** kept : {&solution, &work, &spare}) cholmod.free_dense(kept, &common);
    cholmod.finish(&common);
  }

  const Library& cholmod;
  cholmod_common common{};
  cholmod_sparse matrix{};
  cholmod_factor* factor = nullptr;
  cholmod_dense* solution = nullptr;
  cholmod_dense* work = nullptr;
  cholmod_dense* spare = nullptr;
};

std::unique_ptr<SupernodalCholesky> SupernodalCholesky::make(const LowerTriangle& matrix) {
  if (library() == nullptr) return nullptr;
  auto factor = std::make_unique<Factor>(*library(), matrix);
  if (factor->factor == nullptr) return nullptr;
  return std::unique_ptr<SupernodalCholesky>(new SupernodalCholesky(std::move(factor)));
}

bool SupernodalCholesky::factor() {
  Factor& f = *factor_;
  return f.cholmod.factorize(&f.matrix, f.factor, &f.common) != 0 && f.common.status == CHOLMOD_OK;
}

void SupernodalCholesky::solve(std::span<double> right) {
  Factor& f = *factor_;
  cholmod_dense given{};
  given.nrow = given.d = f.matrix.nrow;
  given.nzmax = right.size();
  given.ncol = right.size() / f.matrix.nrow;
  given.x = right.data();
  given.xtype = CHOLMOD_REAL;
  given.dtype = CHOLMOD_DOUBLE;
  f.cholmod.solve(CHOLMOD_A, f.factor, &given, nullptr, &f.solution, nullptr, &f.work, &f.spare,
                  &f.common);
  std::copy_n(static_cast<const double*>(f.solution->x), right.size(), right.data());
}

}  // namespace latticast

#else

namespace latticast {

struct SupernodalCholesky::Factor {};

std::unique_ptr<SupernodalCholesky> SupernodalCholesky::make(const LowerTriangle&) {
  return nullptr;
}
bool SupernodalCholesky::factor() {
  return false;
}
void SupernodalCholesky::solve(std::span<double>) {}

}  // namespace latticast

#endif

namespace latticast {

SupernodalCholesky::SupernodalCholesky(std::unique_ptr<Factor> factor)
    : factor_(std::move(factor)) {}
SupernodalCholesky::~SupernodalCholesky() = default;

}  // namespace latticast
