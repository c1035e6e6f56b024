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

class Cholmod final : public SupernodalCholesky {
 public:
  Cholmod(const Library& library, const LowerTriangle& matrix) : library_(library) {
    library_.start(&common_);
    common_.print = 0;
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.final_ll = 1;
    common_.quick_return_if_not_posdef = 1;
    matrix_.nrow = matrix_.ncol = matrix.starts.size() - 1;
    matrix_.nzmax = matrix.values.size();
    // The library only reads what these point to.
    matrix_.p = const_cast<int*>(matrix.starts.data());
    matrix_.i = const_cast<int*>(matrix.rows.data());
    matrix_.x = const_cast<double*>(matrix.values.data());
    matrix_.stype = -1;
    matrix_.itype = CHOLMOD_INT;
    matrix_.xtype = CHOLMOD_REAL;
    matrix_.dtype = CHOLMOD_DOUBLE;
    matrix_.sorted = 1;
    matrix_.packed = 1;
    factor_ = library_.analyze(&matrix_, &common_);
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;
  ~Cholmod() override {
    library_.free_factor(&factor_, &common_);
    for (cholmod_dense** kept : {&solution_, &work_, &spare_}) library_.free_dense(kept, &common_);
    library_.finish(&common_);
  }

  bool is_ready() const { return factor_ != nullptr; }

  bool factor() override {
    return library_.factorize(&matrix_, factor_, &common_) != 0 && common_.status == CHOLMOD_OK;
  }

  void solve(std::span<double> right) override {
    cholmod_dense given{};
    given.nrow = given.d = matrix_.nrow;
    given.nzmax = right.size();
    given.ncol = right.size() / matrix_.nrow;
    given.x = right.data();
    given.xtype = CHOLMOD_REAL;
    given.dtype = CHOLMOD_DOUBLE;
    library_.solve(CHOLMOD_A, factor_, &given, nullptr, &solution_, nullptr, &work_, &spare_,
                   &common_);
    const auto* values = static_cast<const double*>(solution_->x);
    std::copy_n(values, right.size(), right.data());
  }

 private:
  const Library& library_;
  cholmod_common common_{};
  cholmod_sparse matrix_{};
  cholmod_factor* factor_ = nullptr;
  cholmod_dense* solution_ = nullptr;
  cholmod_dense* work_ = nullptr;
  cholmod_dense* spare_ = nullptr;
};

}  // namespace

std::unique_ptr<SupernodalCholesky> SupernodalCholesky::make(const LowerTriangle& matrix) {
  if (library() == nullptr) return nullptr;
  auto made = std::make_unique<Cholmod>(*library(), matrix);
  if (!made->is_ready()) return nullptr;
  return made;
}

}  // namespace latticast

#else

namespace latticast {

std::unique_ptr<SupernodalCholesky> SupernodalCholesky::make(const LowerTriangle&) {
  return nullptr;
}

}  // namespace latticast

#endif
