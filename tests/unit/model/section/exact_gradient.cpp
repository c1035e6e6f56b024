// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/model/section/exact_gradient.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <variant>
#include <vector>

#include "model/horseshoe/arc_equilibrium.h"

namespace latticast::testing {
namespace {

using Real = long double;
using Complex = std::complex<Real>;

constexpr Real pi = std::numbers::pi_v<Real>;
constexpr Real step = 1e-60L;  // nothing is subtracted, so that it may be as small as one likes
constexpr int directions = 64;

/// Without directions to go through there is time for many: a bore that has nearly closed needs
/// them.
int radial_points(bool bent) {
  return bent ? 64 : 256;
}

struct Node {
  Real at;
  Real weight;
};

/// Gauss-Legendre on (from, to), to the last bit of long double.
std::vector<Node> gauss(int count, Real from, Real to) {
  std::vector<Node> nodes;
  for (int i = 0; i < count; ++i) {
    Real x = std::cos(pi * (i + 0.75L) / (count + 0.5L));
    Real slope = 0;
    for (int iteration = 0; iteration < 50; ++iteration) {
      Real before = 1;
      Real value = x;
      for (int k = 2; k <= count; ++k) {
        const Real next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
      }
      slope = count * (x * value - before) / (x * x - 1);
      x -= value / slope;
    }
    const Real half = (to - from) / 2;
    nodes.push_back({(from + to) / 2 + half * x, half * 2 / ((1 - x * x) * slope * slope)});
  }
  return nodes;
}

struct Coordinates {
  Complex stretch;
  Complex twist;
  Complex inner_radius;
  Complex bend_1;
  Complex bend_2;
};

Coordinates coordinates(const Section& section, const Deformation& at, int stepped) {
  std::array<Complex, 5> q = {Real{1} + Real{at.elongation}, Real{at.twist},
                              Real{section.inner_radius_mm} + Real{at.inner_growth},
                              Real{at.bend_1}, Real{at.bend_2}};
  q[stepped] += Complex(0, step);
  return {q[0], q[1], q[2], q[3], q[4]};
}

Complex radius(const Section& section, const Coordinates& q, Real reference) {
  const Real inner = section.inner_radius_mm;
  return std::sqrt(q.inner_radius * q.inner_radius +
                   (reference * reference - inner * inner) / q.stretch);
}

Complex axial(const Coordinates& q, const Complex& r, Real cosine, Real sine) {
  return q.stretch + r * (q.bend_1 * cosine + q.bend_2 * sine);
}

/// atan2 with its derivative carried along: arguments differ from real ones by a step only.
Complex angle_of(const Complex& y, const Complex& x) {
  const Real square = x.real() * x.real() + y.real() * y.real();
  return {std::atan2(y.real(), x.real()), (x.real() * y.imag() - y.real() * x.imag()) / square};
}

Complex rubber(const Law& law, const Complex& j) {  // j = I1 - 3
  if (const auto* neo = std::get_if<NeoHookean>(&law)) {
    return Real{neo->shear_modulus_mpa} / 2 * j;
  }
  if (const auto* yeoh = std::get_if<Yeoh>(&law)) {
    return j * (Real{yeoh->c1_mpa} + j * (Real{yeoh->c2_mpa} + j * Real{yeoh->c3_mpa}));
  }
  const auto& gent = std::get<Gent>(law);
  const Real limit = gent.limit_jm;
  return -Real{gent.shear_modulus_mpa} * limit / 2 * std::log(Real{1} - j / limit);
}

Complex liner_energy(const Section& section, const Coordinates& q, bool bent) {
  Complex sum = 0;
  const int around = bent ? directions : 1;
  for (const Node& node :
       gauss(radial_points(bent), section.isotropic_from_mm, section.isotropic_to_mm)) {
    const Complex r = radius(section, q, node.at);
    for (int i = 0; i < around; ++i) {
      const Real phi = 2 * pi * i / around;
      const Complex along = axial(q, r, std::cos(phi), std::sin(phi));
      const Complex thin = node.at / (r * along);
      const Complex hoop = r / node.at;
      const Complex shear = q.twist * r;
      const Complex j = thin * thin + hoop * hoop + shear * shear + along * along - Real{3};
      sum += rubber(section.liner_law, j) * (2 * pi * node.at * node.weight / around);
    }
  }
  return sum * Real{section.isotropic_fraction};
}

struct Stretched {
  Complex stretch;
  Complex turn;
};

/// |F A| and the angle from A to F A.
Stretched stretched(const Complex& r, const Complex& along, const Coordinates& q, Real reference,
                    const StrandFamily& family) {
  const Real c = family.cosine;
  const Real s = family.sine;
  const Complex around = r / reference * c + q.twist * r * s;
  const Complex axially = along * s;
  return {std::sqrt(around * around + axially * axially),
          angle_of(c * axially - s * around, c * around + s * axially)};
}

/// Calls visit(cosine, sine, share of the family, strand) for every place that the family's energy
/// is summed over.
template <class Visit>
void for_each_place(const StrandFamily& family, bool bent, const Visit& visit) {
  if (family.averaged && bent) {
    for (int i = 0; i < directions; ++i) {
      const Real phi = 2 * pi * i / directions;
      for (const StrandPlace& strand : family.strands) {
        visit(std::cos(phi), std::sin(phi), Real{1} / directions, strand);
      }
    }
    return;
  }
  for (const StrandPlace& strand : family.strands) {
    visit(Real{strand.cosine}, Real{strand.sine}, Real{1}, strand);
  }
}

Complex strip_energy(const Section& section, const Coordinates& q, bool bent) {
  Complex sum = 0;
  if (!(section.anisotropic_to_mm > section.anisotropic_from_mm)) return sum;
  for (const Node& node :
       gauss(radial_points(bent), section.anisotropic_from_mm, section.anisotropic_to_mm)) {
    const Complex r = radius(section, q, node.at);
    const Complex hoop = r / node.at - Real{1};
    Complex density = Real{section.ring_modulus_mpa} / 2 * hoop * hoop;
    for (const StrandFamily& family : section.families) {
      if (family.links_per_mm > 0) continue;
      for_each_place(family, bent, [&](Real c, Real s, Real share, const StrandPlace& strand) {
        const Stretched strip = stretched(r, axial(q, r, c, s), q, node.at, family);
        const Complex strain = strip.stretch - Real{1};
        density += share / 2 *
                   (Real{strand.stretch_modulus_mpa} * strain * strain +
                    Real{strand.joint_modulus_mpa} * strip.turn * strip.turn);
      });
    }
    sum += density * (2 * pi * node.at * node.weight);
  }
  return sum;
}

/// Force along the chord of one arc, N, solved at this very strain.
Real arc_force(const HorseshoeShape& shape, Real strain) {
  const double slenderness = shape.width_mm / shape.radius_mm;
  const ArcSolver solver({shape.arc_rad / 2, slenderness * slenderness / 12});
  const auto solved = solver.advance(solver.rest(), static_cast<double>(strain));
  if (!solved) throw std::runtime_error("the arc could not be solved");
  const Real width = shape.width_mm;
  const Real moment_of_area = Real{shape.thickness_mm} * width * width * width / 12;
  const Real left = strain - Real{static_cast<double>(strain)};
  return Real{shape.youngs_modulus_mpa} * moment_of_area /
         (Real{shape.radius_mm} * shape.radius_mm) *
         (solved->bent.force + left * solved->force_by_strain);
}

/// Its derivative by the stepped coordinate, as the imaginary part over the step.
Complex horseshoe_work(const Section& section, const Coordinates& q, bool bent) {
  Complex sum = 0;
  const Real middle = (Real{section.liner_outer_radius_mm} + section.outer_radius_mm) / 2;
  const Complex r = radius(section, q, middle);
  for (const StrandFamily& family : section.families) {
    if (family.links_per_mm == 0) continue;
    for_each_place(family, bent, [&](Real c, Real s, Real share, const StrandPlace& strand) {
      const Complex strain = stretched(r, axial(q, r, c, s), q, middle, family).stretch - Real{1};
      const auto& shape = std::get<HorseshoeShape>(strand.law->shape());
      const Real chord = 2 * Real{shape.radius_mm} * std::sin(Real{shape.arc_rad} / 2);
      if (strain.imag() == 0) return;
      sum += share * Real{family.links_per_mm} * chord * arc_force(shape, strain.real()) *
             Complex(0, strain.imag());
    });
  }
  return sum;
}

}  // namespace

std::array<long double, 5> exact_gradient(const Section& section, const Deformation& at,
                                          double pressure_mpa, const std::array<bool, 5>& wanted) {
  const bool bent =
      wanted[coordinate::bend_1] || wanted[coordinate::bend_2] || at.bend_1 != 0 || at.bend_2 != 0;
  std::array<long double, 5> gradient{};
  for (int i = 0; i < 5; ++i) {
    if (!wanted[i]) continue;
    const Coordinates q = coordinates(section, at, i);
    const Complex cavity = pi * q.inner_radius * q.inner_radius * q.stretch;
    const Complex total = liner_energy(section, q, bent) + strip_energy(section, q, bent) +
                          horseshoe_work(section, q, bent) - Real{pressure_mpa} * cavity;
    gradient[i] = total.imag() / step;
  }
  return gradient;
}

}  // namespace latticast::testing
