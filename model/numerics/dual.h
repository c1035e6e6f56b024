// SPDX-License-Identifier: GPL-3.0-or-later
// A number that carries its first and second derivatives with respect to N variables (second-order
// forward-mode differentiation). A formula written once on Dual<N> yields value, gradient and
// Hessian, exact up to rounding. Fixed size, no heap.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace latticast {

template <std::size_t N>
struct Dual {
  static constexpr std::size_t pairs = N * (N + 1) / 2;

  double value = 0;
  std::array<double, N> gradient{};
  std::array<double, pairs> hessian{};  ///< upper triangle by rows: (0,0) (0,1) ... (1,1) (1,2) ...

  constexpr Dual() = default;
  constexpr Dual(double constant) : value(constant) {}  // NOLINT: numbers are constants

  /// Variable number `index`, at `at`.
  static constexpr Dual variable(std::size_t index, double at) {
    Dual x(at);
    x.gradient[index] = 1;
    return x;
  }

  /// d2/(dq_i dq_j).
  constexpr double second(std::size_t i, std::size_t j) const {
    const std::size_t row = i < j ? i : j;
    const std::size_t column = i < j ? j : i;
    return hessian[row * (2 * N - row - 1) / 2 + column];
  }

  constexpr void set_second(std::size_t i, std::size_t j, double value_ij) {
    const std::size_t row = i < j ? i : j;
    const std::size_t column = i < j ? j : i;
    hessian[row * (2 * N - row - 1) / 2 + column] = value_ij;
  }

  constexpr Dual& operator+=(const Dual& other) {
    value += other.value;
    for (std::size_t i = 0; i < N; ++i) gradient[i] += other.gradient[i];
    for (std::size_t i = 0; i < pairs; ++i) hessian[i] += other.hessian[i];
    return *this;
  }
  constexpr Dual& operator-=(const Dual& other) {
    value -= other.value;
    for (std::size_t i = 0; i < N; ++i) gradient[i] -= other.gradient[i];
    for (std::size_t i = 0; i < pairs; ++i) hessian[i] -= other.hessian[i];
    return *this;
  }
  constexpr Dual& operator*=(double factor) {
    value *= factor;
    for (double& g : gradient) g *= factor;
    for (double& h : hessian) h *= factor;
    return *this;
  }
};

/// f(x), given f, f', f'' at x.value.
template <std::size_t N>
constexpr Dual<N> chain(const Dual<N>& x, double f, double f1, double f2) {
  Dual<N> result(f);
  std::size_t pair = 0;
  for (std::size_t i = 0; i < N; ++i) {
    result.gradient[i] = f1 * x.gradient[i];
    const double bent = f2 * x.gradient[i];
    for (std::size_t j = i; j < N; ++j, ++pair) {
      result.hessian[pair] = f1 * x.hessian[pair] + bent * x.gradient[j];
    }
  }
  return result;
}

/// A function of two numbers with its partial derivatives at one place.
struct TwoVariableJet {
  double value = 0;
  double by_x = 0;
  double by_y = 0;
  double by_xx = 0;
  double by_xy = 0;
  double by_yy = 0;
};

/// f(x, y), given `f` at (x.value, y.value).
template <std::size_t N>
constexpr Dual<N> chain(const Dual<N>& x, const Dual<N>& y, const TwoVariableJet& f) {
  Dual<N> result(f.value);
  std::size_t pair = 0;
  for (std::size_t i = 0; i < N; ++i) {
    result.gradient[i] = f.by_x * x.gradient[i] + f.by_y * y.gradient[i];
    const double to_x = f.by_xx * x.gradient[i] + f.by_xy * y.gradient[i];
    const double to_y = f.by_xy * x.gradient[i] + f.by_yy * y.gradient[i];
    for (std::size_t j = i; j < N; ++j, ++pair) {
      result.hessian[pair] = f.by_x * x.hessian[pair] + f.by_y * y.hessian[pair] +
                             to_x * x.gradient[j] + to_y * y.gradient[j];
    }
  }
  return result;
}

/// f(x), given `f` with its derivatives by the numbers of x.
template <std::size_t N, std::size_t M>
constexpr Dual<N> chain(const std::array<Dual<N>, M>& x, const Dual<M>& f) {
  Dual<N> result(f.value);
  for (std::size_t m = 0; m < M; ++m) {
    for (std::size_t i = 0; i < N; ++i) result.gradient[i] += f.gradient[m] * x[m].gradient[i];
    for (std::size_t p = 0; p < Dual<N>::pairs; ++p) {
      result.hessian[p] += f.gradient[m] * x[m].hessian[p];
    }
    for (std::size_t l = 0; l < M; ++l) {
      std::size_t pair = 0;
      for (std::size_t i = 0; i < N; ++i) {
        const double bent = f.second(m, l) * x[m].gradient[i];
        for (std::size_t j = i; j < N; ++j, ++pair) result.hessian[pair] += bent * x[l].gradient[j];
      }
    }
  }
  return result;
}

template <std::size_t N>
constexpr Dual<N> operator+(Dual<N> x, const Dual<N>& y) {
  return x += y;
}
template <std::size_t N>
constexpr Dual<N> operator-(Dual<N> x, const Dual<N>& y) {
  return x -= y;
}
template <std::size_t N>
constexpr Dual<N> operator-(Dual<N> x) {
  return x *= -1;
}
template <std::size_t N>
constexpr Dual<N> operator+(Dual<N> x, double y) {
  x.value += y;
  return x;
}
template <std::size_t N>
constexpr Dual<N> operator+(double x, Dual<N> y) {
  y.value += x;
  return y;
}
template <std::size_t N>
constexpr Dual<N> operator-(Dual<N> x, double y) {
  x.value -= y;
  return x;
}
template <std::size_t N>
constexpr Dual<N> operator*(Dual<N> x, double factor) {
  return x *= factor;
}
template <std::size_t N>
constexpr Dual<N> operator*(double factor, Dual<N> x) {
  return x *= factor;
}

template <std::size_t N>
constexpr Dual<N> operator*(const Dual<N>& x, const Dual<N>& y) {
  Dual<N> result(x.value * y.value);
  std::size_t pair = 0;
  for (std::size_t i = 0; i < N; ++i) {
    result.gradient[i] = x.value * y.gradient[i] + y.value * x.gradient[i];
    for (std::size_t j = i; j < N; ++j, ++pair) {
      result.hessian[pair] = x.value * y.hessian[pair] + y.value * x.hessian[pair] +
                             x.gradient[i] * y.gradient[j] + x.gradient[j] * y.gradient[i];
    }
  }
  return result;
}

/// x^2.
constexpr double square(double x) {
  return x * x;
}
template <std::size_t N>
constexpr Dual<N> square(const Dual<N>& x) {
  return chain(x, x.value * x.value, 2 * x.value, 2);
}

/// 1/x; x.value must not be 0.
template <std::size_t N>
constexpr Dual<N> reciprocal(const Dual<N>& x) {
  const double inverse = 1 / x.value;
  return chain(x, inverse, -inverse * inverse, 2 * inverse * inverse * inverse);
}

template <std::size_t N>
constexpr Dual<N> operator/(const Dual<N>& x, const Dual<N>& y) {
  return x * reciprocal(y);
}

/// Square root; x.value must be positive.
template <std::size_t N>
Dual<N> sqrt(const Dual<N>& x) {
  const double root = std::sqrt(x.value);
  const double slope = 0.5 / root;
  return chain(x, root, slope, -0.5 * slope / x.value);
}

/// ln(1 + x), accurate for small x; x.value must exceed -1.
template <std::size_t N>
Dual<N> log1p(const Dual<N>& x) {
  const double slope = 1 / (1 + x.value);
  return chain(x, std::log1p(x.value), slope, -slope * slope);
}

/// Angle of the vector (x, y) from the x axis, in (-pi, pi]; the vector must not be zero.
template <std::size_t N>
Dual<N> atan2(const Dual<N>& y, const Dual<N>& x) {
  const double square_length = x.value * x.value + y.value * y.value;
  const double from_x = -y.value / square_length;
  const double from_y = x.value / square_length;
  const double from_xx = -2 * from_x * from_y;
  const double from_xy = from_x * from_x - from_y * from_y;
  Dual<N> result(std::atan2(y.value, x.value));
  std::size_t pair = 0;
  for (std::size_t i = 0; i < N; ++i) {
    result.gradient[i] = from_x * x.gradient[i] + from_y * y.gradient[i];
    for (std::size_t j = i; j < N; ++j, ++pair) {
      result.hessian[pair] =
          from_x * x.hessian[pair] + from_y * y.hessian[pair] +
          from_xx * (x.gradient[i] * x.gradient[j] - y.gradient[i] * y.gradient[j]) +
          from_xy * (x.gradient[i] * y.gradient[j] + y.gradient[i] * x.gradient[j]);
    }
  }
  return result;
}

}  // namespace latticast
