// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/horseshoe/horseshoe_law.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <compare>
#include <exception>
#include <map>
#include <numbers>
#include <thread>

#include "design/limits.h"
#include "design/units.h"

namespace latticast {
namespace {

constexpr double rounding = 1e-12;  // what conversion of units may add to a limit
constexpr double lowest_strain = -0.3;
constexpr double beyond_full_extension = 0.5;

bool between(double x, double low, double high) {
  return x >= low * (1 - rounding) && x <= high * (1 + rounding);
}

bool positive(double x) {
  return x > 0 && std::isfinite(x);
}

const HorseshoeShape& checked(const HorseshoeShape& shape) {
  if (!positive(shape.radius_mm) || !positive(shape.width_mm) || !positive(shape.thickness_mm) ||
      !positive(shape.youngs_modulus_mpa)) {
    throw HorseshoeOutOfScope("a horseshoe's sizes and modulus must be positive and finite");
  }
  if (!between(shape.arc_rad, radians(limits::horseshoe_arc.low),
               radians(limits::horseshoe_arc.high))) {
    throw HorseshoeOutOfScope("a horseshoe's arc must be from 20 to 300 degrees");
  }
  if (!between(shape.width_mm / shape.radius_mm, 1e-3, 100)) {
    throw HorseshoeOutOfScope("a horseshoe's width must be from 0.001 to 100 of its radius");
  }
  return shape;
}

const StrainRange& checked(const StrainRange& range, const HorseshoeShape& shape) {
  const StrainRange widest = widest_range(shape);
  const bool holds_rest = range.lowest <= 0 && range.highest >= 0 && range.lowest < range.highest;
  if (!holds_rest || range.lowest < widest.lowest || range.highest > widest.highest) {
    throw HorseshoeOutOfScope(
        "a horseshoe's strains must hold 0 and lie from -0.3 to full extension + 0.5");
  }
  return range;
}

Arc arc_of(const HorseshoeShape& shape) {
  const double slenderness = shape.width_mm / shape.radius_mm;
  return {shape.arc_rad / 2, slenderness * slenderness / 12};
}

double force_unit_n(const HorseshoeShape& shape) {
  const double moment_of_area_mm4 = shape.thickness_mm * std::pow(shape.width_mm, 3) / 12;
  return shape.youngs_modulus_mpa * moment_of_area_mm4 / (shape.radius_mm * shape.radius_mm);
}

}  // namespace

bool HorseshoeShapeOrder::operator()(const HorseshoeShape& a, const HorseshoeShape& b) const {
  const auto numbers = [](const HorseshoeShape& shape) {
    return std::array{shape.radius_mm, shape.arc_rad, shape.width_mm, shape.thickness_mm,
                      shape.youngs_modulus_mpa};
  };
  return std::ranges::lexicographical_compare(
      numbers(a), numbers(b), [](double x, double y) { return std::strong_order(x, y) < 0; });
}

double rest_chord_mm(const HorseshoeShape& shape) {
  return 2 * shape.radius_mm * std::sin(shape.arc_rad / 2);
}

double full_extension(const HorseshoeShape& shape) {
  return shape.arc_rad / 2 / std::sin(shape.arc_rad / 2) - 1;
}

StrainRange widest_range(const HorseshoeShape& shape) {
  return {lowest_strain, full_extension(shape) + beyond_full_extension};
}

HorseshoeLaw::HorseshoeLaw(const HorseshoeShape& shape)
    : HorseshoeLaw(shape, widest_range(shape)) {}

HorseshoeLaw::HorseshoeLaw(const HorseshoeShape& shape, const StrainRange& range)
    : shape_(checked(shape)),
      arc_law_(arc_of(shape), checked(range, shape)),
      force_unit_n_(force_unit_n(shape)),
      energy_unit_nmm_(force_unit_n_ * rest_chord_mm(shape)) {}

std::optional<HorseshoeState> HorseshoeLaw::at(double strain) const {
  const std::optional<ArcLaw::State> state = arc_law_.at(strain);
  if (!state) return {};
  return HorseshoeState{energy_unit_nmm_ * state->energy, force_unit_n_ * state->force,
                        force_unit_n_ * state->slope, state->error};
}

std::vector<std::shared_ptr<const HorseshoeLaw>> horseshoe_laws(
    std::span<const HorseshoeShape> shapes, int threads) {
  std::vector<HorseshoeShape> distinct;
  std::vector<std::size_t> which;
  std::map<HorseshoeShape, std::size_t, HorseshoeShapeOrder> numbers;
  for (const HorseshoeShape& shape : shapes) {
    const auto [known, is_new] = numbers.emplace(shape, distinct.size());
    which.push_back(known->second);
    if (is_new) distinct.push_back(shape);
  }

  std::vector<std::shared_ptr<const HorseshoeLaw>> solved(distinct.size());
  std::vector<std::exception_ptr> failures(distinct.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < distinct.size(); i = next++) {
      try {
        solved[i] = std::make_shared<const HorseshoeLaw>(distinct[i]);
      } catch (...) {
        failures[i] = std::current_exception();
      }
    }
  };
  std::size_t helpers = 0;
  // Asking the machine takes longer than predicting a straight tube.
  if (distinct.size() > 1) {
    const unsigned wanted = threads > 0 ? threads : std::thread::hardware_concurrency();
    helpers = std::clamp<std::size_t>(wanted, 1, distinct.size()) - 1;
  }
  {
    std::vector<std::jthread> running;
    for (std::size_t i = 0; i < helpers; ++i) running.emplace_back(work);
    work();
  }
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }

  std::vector<std::shared_ptr<const HorseshoeLaw>> laws;
  laws.reserve(which.size());
  for (const std::size_t i : which) laws.push_back(solved[i]);
  return laws;
}

}  // namespace latticast
