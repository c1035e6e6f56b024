// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strand/links.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <set>
#include <string>
#include <thread>
#include <type_traits>
#include <variant>

#include "geometry/pattern/strand_path.h"
#include "model/horseshoe/horseshoe_law.h"
#include "model/sinusoid/sinusoid_law.h"

namespace latticast {
double strand_modulus_mpa(const Lattice& lattice) {
  if (const auto* linear = std::get_if<Linear>(&lattice.material.law)) {
    return linear->youngs_modulus_mpa;
  }
  throw UnsupportedDesign(
      "the lattice material is a rubber; strands need a linear material (E, nu)");
}

std::optional<LinkShape> link_shape(const Segment& segment, const Grid& grid, double width_mm) {
  if (!is_curved(grid.path)) return std::nullopt;  // whose material may be any
  const Strip strip{.width_mm = width_mm,
                    .thickness_mm = segment.lattice->thickness_mm,
                    .youngs_modulus_mpa = strand_modulus_mpa(*segment.lattice),
                    .chord_mm = link_chord_mm(placed_strand(segment, grid))};
  const auto shape = [&](const auto& path) -> std::optional<LinkShape> {
    if constexpr (std::is_same_v<decltype(path), const StraightPath&>) {
      return std::nullopt;
    } else {
      return shape_of(path, strip);
    }
  };
  return std::visit(shape, grid.path);
}

std::vector<LinkShape> link_shapes(const Segment& segment) {
  std::vector<LinkShape> shapes;
  if (!segment.lattice) return shapes;
  std::set<LinkShape, LinkShapeOrder> met;
  for (const Grid& grid : segment.lattice->grids) {
    for (const double width : grid.widths_mm) {
      const auto shape = link_shape(segment, grid, width);
      if (!shape) break;
      if (met.insert(*shape).second) shapes.push_back(*shape);
    }
  }
  return shapes;
}

double full_extension(const LinkShape& shape) {
  return std::visit([](const auto& kind) { return full_extension(kind); }, shape);
}

std::optional<double> largest_fibre_strain(const LinkShape& shape, double strain) {
  return std::visit([&](const auto& kind) { return largest_fibre_strain(kind, strain); }, shape);
}

StrandLaw make_law(const LinkShape& shape) {
  return std::visit([](const auto& kind) { return make_law(kind); }, shape);
}

StrandLaws make_laws(std::span<const LinkShape> shapes, int threads) {
  std::vector<LinkShape> distinct;
  std::vector<std::size_t> which;
  std::map<LinkShape, std::size_t, LinkShapeOrder> numbers;
  for (const LinkShape& shape : shapes) {
    const auto [known, is_new] = numbers.emplace(shape, distinct.size());
    which.push_back(known->second);
    if (is_new) distinct.push_back(shape);
  }

  StrandLaws solved(distinct.size());
  std::vector<std::exception_ptr> failures(distinct.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < distinct.size(); i = next++) {
      try {
        solved[i] = std::make_shared<const StrandLaw>(make_law(distinct[i]));
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

  StrandLaws laws;
  laws.reserve(which.size());
  for (const std::size_t i : which) laws.push_back(solved[i]);
  return laws;
}

LawsByShape build_laws(const Segment& segment, const StrandLaws& known) {
  LawsByShape laws;
  for (const auto& law : known) laws.emplace(law->shape(), law);
  std::vector<LinkShape> missing = link_shapes(segment);
  std::erase_if(missing, [&](const LinkShape& shape) { return laws.contains(shape); });
  try {
    for (const auto& law : make_laws(missing)) laws.emplace(law->shape(), law);
  } catch (const LinkOutOfScope& reason) {
    throw UnsupportedDesign("a " + std::string(reason.path) +
                            " strand cannot be predicted: " + reason.what());
  } catch (const LawNotSolved& reason) {
    throw UnsupportedDesign(std::string("a curved strand cannot be predicted: ") + reason.what());
  }
  return laws;
}

StrandLaws known_laws(const LawsByShape& laws, const Segment& segment) {
  StrandLaws known;
  for (const LinkShape& shape : link_shapes(segment)) {
    const auto found = laws.find(shape);
    if (found != laws.end()) known.push_back(found->second);
  }
  return known;
}

}  // namespace latticast
