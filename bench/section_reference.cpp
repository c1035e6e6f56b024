// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/section_reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <stdexcept>

#include <Eigen/Dense>

#include "bench/long_gauss.h"

namespace latticast {
namespace {

using Real = long double;
using Coordinates = std::array<Real, coordinate_count>;
constexpr Real pi = std::numbers::pi_v<Real>;

constexpr int radial_points = 64;
constexpr int directions = 96;

// A number with its derivatives by the five coordinates.
struct Jet {
  Real value = 0;
  Coordinates slope{};

  Jet() = default;
  Jet(Real constant) : value(constant) {}  // NOLINT: numbers are constants
};

Jet chained(const Jet& x, Real value, Real slope) {
  Jet result(value);
  for (int i = 0; i < coordinate_count; ++i) result.slope[i] = slope * x.slope[i];
  return result;
}

Jet operator+(const Jet& a, const Jet& b) {
  Jet result(a.value + b.value);
  for (int i = 0; i < coordinate_count; ++i) result.slope[i] = a.slope[i] + b.slope[i];
  return result;
}

Jet operator-(const Jet& a, const Jet& b) {
  return a + chained(b, -b.value, -1);
}

Jet operator*(const Jet& a, const Jet& b) {
  Jet result(a.value * b.value);
  for (int i = 0; i < coordinate_count; ++i) {
    result.slope[i] = a.slope[i] * b.value + a.value * b.slope[i];
  }
  return result;
}

Jet operator/(const Jet& a, const Jet& b) {
  return a * chained(b, 1 / b.value, -1 / (b.value * b.value));
}

Jet root(const Jet& x) {
  const Real value = std::sqrt(x.value);
  return chained(x, value, 1 / (2 * value));
}

Jet square(const Jet& x) {
  return x * x;
}

Jet angle(const Jet& y, const Jet& x) {
  const Real size = x.value * x.value + y.value * y.value;
  Jet result(std::atan2(y.value, x.value));
  for (int i = 0; i < coordinate_count; ++i) {
    result.slope[i] = (x.value * y.slope[i] - y.value * x.slope[i]) / size;
  }
  return result;
}

struct Place {
  Real cosine;
  Real sine;
  Real weight;
};

std::array<Place, directions> whole_turn() {
  std::array<Place, directions> places{};
  for (int i = 0; i < directions; ++i) {
    const Real at = 2 * pi * i / directions;
    places[i] = {std::cos(at), std::sin(at), Real{1} / directions};
  }
  return places;
}

// The section in one state: everything is asked at a radius and a direction.
class Wall {
 public:
  Wall(const Section& section, const Coordinates& q) : section_(section) {
    std::array<Jet, coordinate_count> variable;
    for (int i = 0; i < coordinate_count; ++i) {
      variable[i] = Jet(q[i]);
      variable[i].slope[i] = 1;
    }
    stretch_ = Jet(1) + variable[coordinate::elongation];
    twist_ = variable[coordinate::twist];
    bore_ = Jet(section.inner_radius_mm) + variable[coordinate::inner_growth];
    bend_ = {variable[coordinate::bend_1], variable[coordinate::bend_2]};
  }

  // dPi/dq, the horseshoes' share through the law's force.
  Coordinates gradient(Real pressure) const {
    const Jet cavity = Jet(pi) * (square(bore_) * stretch_);
    const Jet sum = liner() + lattice() - Jet(pressure) * cavity;
    Coordinates result = sum.slope;
    add_horseshoes(result);
    return result;
  }

 private:
  Jet radius(Real rest) const {
    const Real inner = section_.inner_radius_mm;
    return root(square(bore_) + Jet((rest - inner) * (rest + inner)) / stretch_);
  }

  Jet axial(const Jet& r, const Place& place) const {
    return stretch_ + r * (bend_[0] * Jet(place.cosine) + bend_[1] * Jet(place.sine));
  }

  // mu/2 (tr F^T F - 3), F_rr being 1/(hoop axial).
  Jet liner() const {
    const auto* law = std::get_if<NeoHookean>(&section_.liner_law);
    if (law == nullptr) throw std::invalid_argument("the reference knows neo-Hookean liners only");
    return over_radii(section_.isotropic_from_mm, section_.isotropic_to_mm, [&](Real rest) {
      const Jet r = radius(rest);
      const Jet hoop = r / Jet(rest);
      Jet sum;
      for (const Place& place : places_) {
        const Jet length = axial(r, place);
        const Jet invariant =
            square(Jet(1) / (hoop * length)) + square(hoop) + square(twist_ * r) + square(length);
        sum = sum + Jet(place.weight) * (invariant - Jet(3));
      }
      return Jet(law->shear_modulus_mpa * section_.isotropic_fraction / 2) * sum;
    });
  }

  Jet lattice() const {
    return over_radii(section_.anisotropic_from_mm, section_.anisotropic_to_mm, [&](Real rest) {
      const Jet r = radius(rest);
      Jet sum = Jet(section_.ring_modulus_mpa / 2) * square(r / Jet(rest) - Jet(1));
      for (const StrandFamily& family : section_.families) {
        if (family.links_per_mm == 0) sum = sum + strips(family, rest, r);
      }
      return sum;
    });
  }

  // F A of a strand: around and along the tube.
  std::array<Jet, 2> carried(const StrandFamily& family, Real rest, const Jet& r,
                             const Place& place) const {
    const Jet around = r / Jet(rest) * (Jet(family.cosine) + twist_ * Jet(rest * family.sine));
    return {around, axial(r, place) * Jet(family.sine)};
  }

  Jet strips(const StrandFamily& family, Real rest, const Jet& r) const {
    Jet sum;
    const auto add = [&](const Place& place, Real stretch_modulus, Real joint_modulus) {
      const auto [around, along] = carried(family, rest, r, place);
      const Jet strain = root(square(around) + square(along)) - Jet(1);
      const Jet turn = angle(along * Jet(family.cosine) - around * Jet(family.sine),
                             around * Jet(family.cosine) + along * Jet(family.sine));
      sum = sum + Jet(stretch_modulus / 2) * square(strain) + Jet(joint_modulus / 2) * square(turn);
    };
    if (family.averaged) {
      for (const Place& place : places_) {
        add(place, family.stretch_modulus_mpa * place.weight,
            family.joint_modulus_mpa * place.weight);
      }
    } else {
      for (const StrandPlace& strand : family.strands) {
        add({strand.cosine, strand.sine, 1}, strand.stretch_modulus_mpa, strand.joint_modulus_mpa);
      }
    }
    return sum;
  }

  void add_horseshoes(Coordinates& gradient) const {
    const Real rest = (Real{section_.liner_outer_radius_mm} + section_.outer_radius_mm) / 2;
    const Jet r = radius(rest);
    for (const StrandFamily& family : section_.families) {
      if (family.links_per_mm == 0) continue;
      const auto add = [&](const StrandLaw& law, const Place& place) {
        const auto [around, along] = carried(family, rest, r, place);
        const Jet strain = root(square(around) + square(along)) - Jet(1);
        // The strain, rounded to double, is made up for by the slope.
        const auto rounded = static_cast<double>(strain.value);
        const LinkState at = law.at(rounded).value();
        const Real force = at.force_n + at.slope_n * (strain.value - rounded);
        const Real share = force * law.rest_chord_mm() * family.links_per_mm * place.weight;
        for (int i = 0; i < coordinate_count; ++i) gradient[i] += share * strain.slope[i];
      };
      if (family.averaged) {
        const auto count = static_cast<Real>(family.strands.size());
        for (const Place& place : places_) {
          add(*family.strands.front().law, {place.cosine, place.sine, place.weight * count});
        }
      } else {
        for (const StrandPlace& strand : family.strands) {
          add(*strand.law, {strand.cosine, strand.sine, 1});
        }
      }
    }
  }

  template <class Density>
  Jet over_radii(Real from, Real to, const Density& density) const {
    static const LongGaussRule rule = long_gauss(radial_points);
    Jet sum;
    if (!(to > from)) return sum;
    for (int i = 0; i < radial_points; ++i) {
      const Real rest = ((from + to) + (to - from) * rule.points[i]) / 2;
      sum = sum + Jet(pi * (to - from) * rule.weights[i] * rest) * density(rest);
    }
    return sum;
  }

  const Section& section_;
  std::array<Place, directions> places_ = whole_turn();
  Jet stretch_;
  Jet twist_;
  Jet bore_;
  std::array<Jet, 2> bend_;
};

Coordinates scales(const Section& section) {
  const Real outer = section.outer_radius_mm;
  return {1, 1 / outer, section.inner_radius_mm, 1 / outer, 1 / outer};
}

}  // namespace

SectionReference section_reference(const Balance& balance, const BranchPoint& x) {
  const Section& section = balance.section();
  const Coordinates scale = scales(section);
  const std::vector<int>& free = balance.free_coordinates();
  const int n = balance.free_count();
  const Real pressure = balance.pressure_mpa(x);
  std::array<Real, coordinate_count> at{};
  for (int i = 0; i < n; ++i) at[i] = x[i];
  SectionReference reference{x, std::numeric_limits<double>::infinity()};
  for (int step = 0; step < 20; ++step) {
    Coordinates q{};
    for (int i = 0; i < n; ++i) q[free[i]] = at[i] * scale[free[i]];
    const Coordinates gradient = Wall(section, q).gradient(pressure);
    Eigen::VectorXd imbalance(n);
    for (int i = 0; i < n; ++i) {
      imbalance[i] =
          static_cast<double>(gradient[free[i]] * scale[free[i]] / balance.energy_unit());
    }
    const BalanceAt by = balance.at(reference.x).value();
    const Eigen::Map<const Eigen::MatrixXd> stiffness(by.tangent_stiffness.data(), n, n);
    const Eigen::VectorXd change = stiffness.partialPivLu().solve(imbalance);
    const double size = change.cwiseAbs().maxCoeff();
    if (!(size < 0.5 * reference.last_step)) break;
    reference.last_step = size;
    for (int i = 0; i < n; ++i) {
      at[i] -= change[i];
      reference.x[i] = static_cast<double>(at[i]);
    }
  }
  return reference;
}

BranchPoint scaled(const Balance& balance, const State& state) {
  const Section& section = balance.section();
  const Deformation q = state.deformation(section.inner_radius_mm, section.axis_rad);
  const std::array<double, coordinate_count> values = {q.elongation, q.twist, q.inner_growth,
                                                       q.bend_1, q.bend_2};
  const Coordinates scale = scales(section);
  BranchPoint x{};
  const std::vector<int>& free = balance.free_coordinates();
  for (std::size_t i = 0; i < free.size(); ++i) {
    x[i] = values[free[i]] / static_cast<double>(scale[free[i]]);
  }
  x[free.size()] = balance.scaled_pressure(state.pressure_kpa / 1000);
  return x;
}

double largest_error(const Balance& balance, const BranchPoint& a, const BranchPoint& b) {
  double largest = 0;
  for (int i = 0; i < balance.free_count(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace latticast
