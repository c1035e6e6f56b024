// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/symmetric_product.h"

namespace latticast {
namespace {

constexpr std::size_t tall = 4;
constexpr std::size_t wide = 8;

template <std::size_t Width>
[[gnu::always_inline]] inline void product(const double* left, const double* right,
                                           std::size_t rows, double* result) {
  for (std::size_t i = 0; i < Width; i += tall) {
    for (std::size_t j = i / wide * wide; j < Width; j += wide) {
      double sum[tall][wide] = {};
      for (std::size_t r = 0; r < rows; ++r) {
        const double* a = left + r * Width + i;
        const double* b = right + r * Width + j;
        for (std::size_t k = 0; k < tall; ++k) {
          for (std::size_t l = 0; l < wide; ++l) sum[k][l] += a[k] * b[l];
        }
      }
      for (std::size_t k = 0; k < tall; ++k) {
        for (std::size_t l = 0; l < wide; ++l) result[(i + k) * Width + j + l] = sum[k][l];
      }
    }
  }
}

template <std::size_t Width>
[[gnu::always_inline]] inline void rows_product(const double* tangent, double factor,
                                                const double* left, double* result) {
  for (std::size_t i = 0; i < 9; ++i) {
    double* row = result + i * Width;
    for (std::size_t j = 0; j < Width; ++j) row[j] = 0;
    for (std::size_t k = 0; k < 9; ++k) {
      const double share = factor * tangent[9 * i + k];
      const double* from = left + k * Width;
      for (std::size_t j = 0; j < Width; ++j) row[j] += share * from[j];
    }
  }
}

}  // namespace

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#define LATTICAST_WIDER_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define LATTICAST_WIDER_VECTORS
#endif

// Clones are made of functions that are no templates.
#define LATTICAST_PRODUCTS(width)                                                                \
  LATTICAST_WIDER_VECTORS static void product_##width(const double* left, const double* right,   \
                                                      std::size_t rows, double* result) {        \
    product<width>(left, right, rows, result);                                                   \
  }                                                                                              \
  LATTICAST_WIDER_VECTORS static void rows_product_##width(const double* tangent, double factor, \
                                                           const double* left, double* result) { \
    rows_product<width>(tangent, factor, left, result);                                          \
  }                                                                                              \
  template <>                                                                                    \
  void symmetric_product<width>(const double* left, const double* right, std::size_t rows,       \
                                double* result) {                                                \
    product_##width(left, right, rows, result);                                                  \
  }                                                                                              \
  template <>                                                                                    \
  void tangent_product<width>(const double* tangent, double factor, const double* left,          \
                              double* result) {                                                  \
    rows_product_##width(tangent, factor, left, result);                                         \
  }

LATTICAST_PRODUCTS(88)
LATTICAST_PRODUCTS(72)

}  // namespace latticast
