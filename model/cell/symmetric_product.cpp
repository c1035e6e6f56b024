// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/symmetric_product.h"

namespace latticast {
namespace {

constexpr std::size_t tall = 4;
constexpr std::size_t wide = 8;

}  // namespace

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
__attribute__((target_clones("avx2", "default")))
#endif
void symmetric_product(const double* left, const double* right, std::size_t rows, double* result) {
  for (std::size_t i = 0; i < product_width; i += tall) {
    for (std::size_t j = i / wide * wide; j < product_width; j += wide) {
      double sum[tall][wide] = {};
      for (std::size_t r = 0; r < rows; ++r) {
        const double* a = left + r * product_width + i;
        const double* b = right + r * product_width + j;
        for (std::size_t k = 0; k < tall; ++k) {
          for (std::size_t l = 0; l < wide; ++l) sum[k][l] += a[k] * b[l];
        }
      }
      for (std::size_t k = 0; k < tall; ++k) {
        for (std::size_t l = 0; l < wide; ++l) result[(i + k) * product_width + j + l] = sum[k][l];
      }
    }
  }
}

}  // namespace latticast
