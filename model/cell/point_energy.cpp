// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/point_energy.h"

#include <cmath>
#include <span>

#include "model/numerics/small_matrix.h"

namespace latticast {
namespace {

constexpr std::size_t at(std::size_t row, std::size_t column) {
  return 3 * row + column;
}

double product(const Tensor& a, const Tensor& b) {
  double sum = 0;
  for (std::size_t i = 0; i < 9; ++i) sum += a[i] * b[i];
  return sum;
}

bool is_of_first_invariant(const Law& law) {
  return std::visit(
      [](const auto& kind) {
        using L = std::decay_t<decltype(kind)>;
        return !std::is_same_v<L, Mooney> && !std::is_same_v<L, Ogden>;
      },
      law);
}

/// f(J^(-2/3) F:F - 3): nothing but traces.
std::optional<PointEnergy> of_first_invariant(const Law& law, const Tensor& f) {
  const VolumeRatio volume = volume_ratio(f);
  if (!(volume.value > 0)) return std::nullopt;
  const double isochoric = 1 / std::cbrt(volume.value * volume.value);
  const double trace = product(f, f);
  const double j = isochoric * trace - 3;
  if (!(j < first_invariant_limit(law))) return std::nullopt;
  // A simple shear of distortion j has this first invariant.
  const EnergyDensity w = energy_density(law, {.area = 0, .distortion = std::max(j, 0.0)});

  Tensor inverse{};  // transposed
  for (std::size_t i = 0; i < 9; ++i) inverse[i] = volume.cofactor[i] / volume.value;
  Tensor slope{};  // of j
  for (std::size_t i = 0; i < 9; ++i) {
    slope[i] = 2 * isochoric * (f[i] - trace / 3 * inverse[i]);
  }
  PointEnergy result{.energy = w.value};
  for (std::size_t i = 0; i < 9; ++i) result.stress[i] = w.by_distortion * slope[i];

  // d2j/dF2 = J^(-2/3) [2 1 - 4/3 (F x C + C x F) + 10/9 I1 C x C - 2/3 I1/J d2J], C = F^-T.
  const double bend = w.by_distortion * isochoric;
  for (std::size_t i = 0; i < 9; ++i) {
    for (std::size_t k = 0; k < 9; ++k) {
      double entry = -4.0 / 3 * (f[i] * inverse[k] + inverse[i] * f[k]) +
                     10.0 / 9 * trace * inverse[i] * inverse[k];
      if (i == k) entry += 2;
      result.tangent[9 * i + k] = bend * entry + w.by_distortion_distortion * slope[i] * slope[k];
    }
  }
  add_volume_curvature(f, -2.0 / 3 * bend * trace / volume.value, result.tangent);
  return result;
}

/// Kirchhoff stresses tau_i and moduli dtau_i/d(ln lambda_j) in principal axes, and for each two
/// axes (tau_i - tau_j)/(lambda_i^2 - lambda_j^2), which the distortion in their plane gives
/// without a difference.
struct PrincipalEnergy {
  double energy = 0;
  std::array<double, 3> stress{};
  Tensor moduli{};
  Tensor shear{};
};

PrincipalEnergy principal_energy(const Law& law, const std::array<double, 3>& stretches,
                                 double volume) {
  PrincipalEnergy result;
  const double scale = 1 / std::cbrt(volume);
  const std::array<double, 3> l = {scale * stretches[0], scale * stretches[1],
                                   scale * stretches[2]};
  EnergyDensity first;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i + 1; j < 3; ++j) {
      const double apart = l[i] - l[j];
      const EnergyDensity w =
          energy_density(law, {.area = l[i] * l[j] - 1, .distortion = apart * apart});
      if (j == 1) first = w;
      result.shear[at(i, j)] = result.shear[at(j, i)] = 2 * w.by_distortion * scale * scale;
    }
  }
  result.energy = first.value;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double apart = (stretches[i] - stretches[j]) * (stretches[i] + stretches[j]);
      result.stress[i] += result.shear[at(i, j)] * apart / 3;
    }
  }
  // By x = ln l_0 and y = ln l_1, the third following.
  const double area = l[0] * l[1];
  const double cross = 2 * area;
  const std::array<double, 2> slope = {2 * l[0] * l[0] - cross, 2 * l[1] * l[1] - cross};
  const std::array<double, 3> bend = {4 * l[0] * l[0] - cross, -cross, 4 * l[1] * l[1] - cross};
  const auto second = [&](std::size_t i, std::size_t j) {
    return first.by_area_area * area * area + first.by_area * area +
           first.by_area_distortion * area * (slope[i] + slope[j]) +
           first.by_distortion_distortion * slope[i] * slope[j] + first.by_distortion * bend[i + j];
  };
  // ln l_i = ln lambda_i - ln J/3.
  constexpr double share[2][3] = {{2.0 / 3, -1.0 / 3, -1.0 / 3}, {-1.0 / 3, 2.0 / 3, -1.0 / 3}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t a = 0; a < 2; ++a) {
        for (std::size_t b = 0; b < 2; ++b) {
          result.moduli[at(i, j)] += share[a][i] * second(a, b) * share[b][j];
        }
      }
    }
  }
  return result;
}

/// Any law, in the principal axes of F = sum of lambda_i n_i N_i.
std::optional<PointEnergy> in_principal_axes(const Law& law, const Tensor& f) {
  const double volume = volume_ratio(f).value;
  if (!(volume > 0)) return std::nullopt;
  Tensor square{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) square[at(i, j)] += f[at(k, i)] * f[at(k, j)];
    }
  }
  std::array<double, 3> squares{};
  Tensor axes{};  // N_i, one after the other
  symmetric_eigenvectors(square, squares, axes);
  std::array<double, 3> stretch{};
  Tensor turned{};  // n_i
  for (std::size_t a = 0; a < 3; ++a) {
    stretch[a] = std::sqrt(squares[a]);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        turned[at(a, i)] += f[at(i, j)] * axes[at(a, j)] / stretch[a];
      }
    }
  }
  const PrincipalEnergy w = principal_energy(law, stretch, volume);
  const auto dyad = [&](std::size_t a, std::size_t b) {
    Tensor result{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) result[at(i, j)] = turned[at(a, i)] * axes[at(b, j)];
    }
    return result;
  };

  PointEnergy result{.energy = w.energy};
  const auto add = [&](double factor, const Tensor& a, const Tensor& b) {
    for (std::size_t i = 0; i < 9; ++i) {
      const double left = factor * a[i];
      for (std::size_t k = 0; k < 9; ++k) result.tangent[9 * i + k] += left * b[k];
    }
  };
  for (std::size_t a = 0; a < 3; ++a) {
    const Tensor along = dyad(a, a);
    for (std::size_t i = 0; i < 9; ++i) result.stress[i] += w.stress[a] / stretch[a] * along[i];
    for (std::size_t b = 0; b < 3; ++b) {
      const double both = stretch[a] * stretch[b];
      const double own = a == b ? w.stress[a] : 0;
      add((w.moduli[at(a, b)] - own) / both, along, dyad(b, b));
      if (a == b) continue;
      const Tensor shear = dyad(a, b);
      add(w.shear[at(a, b)], shear, shear);
      add((w.shear[at(a, b)] * stretch[b] * stretch[b] - w.stress[b]) / both, shear, dyad(b, a));
    }
  }
  return result;
}

// Where the minor of an entry stands, a11 a22 - a12 a21: rows and columns follow the entry's own in
// cyclic order, so that it needs no sign.
struct Minor {
  std::size_t a11, a12, a21, a22;
};

template <class Visit>
void for_each_minor(const Visit& visit) {
  const auto next = [](std::size_t i) { return (i + 1) % 3; };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i1 = next(i);
    const std::size_t i2 = next(i1);
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = next(j);
      const std::size_t j2 = next(j1);
      visit(at(i, j), Minor{at(i1, j1), at(i1, j2), at(i2, j1), at(i2, j2)});
    }
  }
}

}  // namespace

VolumeRatio volume_ratio(const Tensor& f) {
  VolumeRatio result;
  for_each_minor([&](std::size_t entry, const Minor& m) {
    result.cofactor[entry] = f[m.a11] * f[m.a22] - f[m.a12] * f[m.a21];
  });
  result.value = f[0] * result.cofactor[0] + f[1] * result.cofactor[1] + f[2] * result.cofactor[2];
  return result;
}

void add_volume_curvature(const Tensor& f, double factor, TensorPair& tangent) {
  for_each_minor([&](std::size_t entry, const Minor& m) {
    const std::size_t row = 9 * entry;
    tangent[row + m.a11] += factor * f[m.a22];
    tangent[row + m.a22] += factor * f[m.a11];
    tangent[row + m.a12] -= factor * f[m.a21];
    tangent[row + m.a21] -= factor * f[m.a12];
  });
}

std::optional<PointEnergy> isochoric_energy(const Law& law, const Tensor& f) {
  return is_of_first_invariant(law) ? of_first_invariant(law, f) : in_principal_axes(law, f);
}

}  // namespace latticast
