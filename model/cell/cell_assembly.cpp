// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/cell_assembly.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "design/material/law.h"

namespace latticast {

namespace {

// Of a spring, against the stiffest entry that a mean displacement meets: what it keeps at zero is
// off by a share of this order, and the matrix still has half of its digits.
constexpr double spring_by_modulus = 1e6;

}  // namespace

CellAssembly::CellAssembly(CellMesh mesh) : mesh_(std::move(mesh)), matrix_(make_matrix()) {
  for (auto& scatter : hexahedra_.scatters) find_places(scatter);
  for (auto& scatter : wedges_.scatters) find_places(scatter);
  for (auto& scatter : quadrilaterals_) find_places(scatter);
  for (auto& scatter : triangles_) find_places(scatter);
}

template <std::size_t N>
CellAssembly::Scatter<N> CellAssembly::scatter_of(const std::array<std::int32_t, N>& nodes) const {
  Scatter<N> scatter;
  for (std::size_t a = 0; a < N; ++a) {
    const CellNode& node = mesh_.nodes[static_cast<std::size_t>(nodes[a])];
    for (std::size_t c = 0; c < 3; ++c) {
      scatter.unknown[3 * a + c] = node.unknown[c].number;
      scatter.sign[3 * a + c] = node.unknown[c].sign;
    }
  }
  return scatter;
}

template <std::size_t N>
void CellAssembly::add_elements(const std::vector<CellElement<N>>& from, Elements<N>& to,
                                Entries& entries) const {
  to.scatters.reserve(from.size());
  to.pressure_by.resize(from.size());
  for (const CellElement<N>& element : from) {
    to.scatters.push_back(scatter_of<N>(element.nodes));
    const auto& unknown = to.scatters.back().unknown;
    for (std::size_t i = 0; i < unknown.size(); ++i) {
      for (std::size_t j = i; j < unknown.size(); ++j) {
        if (unknown[i] < 0 || unknown[j] < 0) continue;
        entries.emplace_back(std::max(unknown[i], unknown[j]), std::min(unknown[i], unknown[j]));
      }
    }
  }
}

/// Three for a ring of nodes: its mean displacement across the tube, and its mean turn about it.
void CellAssembly::make_springs(Entries& entries) {
  if (mesh_.centred.empty()) return;
  double modulus = 0;
  for (const CellMaterial& material : mesh_.materials) {
    modulus = std::max(modulus, rest_shear_modulus_mpa(material.law));
  }
  std::array<Spring, 3> springs;
  for (const auto& [number, mean] : mesh_.centred) {
    const CellNode& node = mesh_.nodes[static_cast<std::size_t>(number)];
    const double cosine = std::cos(node.angle_rad);
    const double sine = std::sin(node.angle_rad);
    const auto add = [&, share = mean](Spring& spring, std::size_t component, double weight) {
      const NodeUnknown& unknown = node.unknown[component];
      if (unknown.number < 0) return;
      spring.terms.emplace_back(unknown.number, share * weight * unknown.sign);
    };
    add(springs[0], 0, cosine);
    add(springs[0], 1, -sine);
    add(springs[1], 0, sine);
    add(springs[1], 1, cosine);
    add(springs[2], 1, 1);
  }
  for (Spring& spring : springs) {
    spring.stiffness = spring_by_modulus * modulus * mesh_.inner_radius_mm;
    for (const auto& [row, a] : spring.terms) {
      for (const auto& [column, b] : spring.terms) {
        if (row >= column) entries.emplace_back(row, column);
      }
    }
    springs_.push_back(std::move(spring));
  }
}

SparseSolver CellAssembly::make_matrix() {
  Entries entries;
  add_elements(mesh_.hexahedra, hexahedra_, entries);
  add_elements(mesh_.wedges, wedges_, entries);
  for (const auto& face : mesh_.bore_quadrilaterals) quadrilaterals_.push_back(scatter_of(face));
  for (const auto& face : mesh_.bore_triangles) triangles_.push_back(scatter_of(face));
  make_springs(entries);
  return {mesh_.unknowns, entries};
}

template <std::size_t N>
void CellAssembly::find_places(Scatter<N>& scatter) const {
  const auto& unknown = scatter.unknown;
  scatter.place.reserve(unknown.size() * (unknown.size() + 1) / 2);
  for (std::size_t i = 0; i < unknown.size(); ++i) {
    for (std::size_t j = i; j < unknown.size(); ++j) {
      const auto [column, row] = std::minmax(unknown[i], unknown[j]);
      scatter.place.push_back(column < 0 ? -1
                                         : static_cast<std::int32_t>(matrix_.place(row, column)));
    }
  }
}

template <std::size_t N>
auto CellAssembly::components(const Scatter<N>& scatter, std::span<const double> unknowns) {
  std::array<std::array<double, 3>, N> result{};
  for (std::size_t i = 0; i < scatter.unknown.size(); ++i) {
    if (scatter.unknown[i] < 0) continue;
    result[i / 3][i % 3] = scatter.sign[i] * unknowns[static_cast<std::size_t>(scatter.unknown[i])];
  }
  return result;
}

template <std::size_t N, class Part>
void CellAssembly::add(const Scatter<N>& scatter, const Part& part, double factor,
                       AssembledCell& result) {
  constexpr std::size_t n = 3 * N;
  constexpr std::size_t size = n + tube_strains;
  const std::span<double> values = matrix_.values();
  std::size_t pair = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double* row = &part.hessian[i * size];
    if (scatter.unknown[i] < 0) {
      pair += n - i;
      continue;
    }
    const auto own = static_cast<std::size_t>(scatter.unknown[i]);
    const double sign = factor * scatter.sign[i];
    result.residual[own] += sign * part.gradient[i];
    for (std::size_t q = 0; q < tube_strains; ++q) result.mixed[q][own] += sign * row[n + q];
    for (std::size_t j = i; j < n; ++j, ++pair) {
      const std::int32_t place = scatter.place[pair];
      if (place < 0) continue;
      const double entry = sign * scatter.sign[j] * row[j];
      // Two components of one unknown meet on the diagonal from both sides.
      const bool twice = j != i && scatter.unknown[j] == scatter.unknown[i];
      values[static_cast<std::size_t>(place)] += twice ? 2 * entry : entry;
    }
  }
  for (std::size_t q = 0; q < tube_strains; ++q) {
    result.by_strain[q] += factor * part.gradient[n + q];
    for (std::size_t p = q; p < tube_strains; ++p) {
      result.strain_curvature[q * tube_strains + p] +=
          factor * part.hessian[(n + q) * size + n + p];
    }
  }
}

template <std::size_t N>
bool CellAssembly::add_energies(const std::vector<CellElement<N>>& elements,
                                std::span<const double> unknowns, const TubeStrain& strain,
                                std::span<const ElementPressure> held, std::size_t first,
                                Elements<N>& kept, AssembledCell& result) {
  // On the heap: what a thread keeps for itself is set to zero when the program starts.
  thread_local const auto scratch = std::make_unique<ElementEnergy<N>>();
  ElementEnergy<N>& energy = *scratch;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const auto moved = components(kept.scatters[e], unknowns);
    const ElementPressure* pressure = held.empty() ? nullptr : &held[first + e];
    if (!evaluate(mesh_, elements[e], moved, strain, pressure, energy)) return false;
    result.pressures[first + e] = energy.pressure;
    kept.pressure_by[e] = energy.pressure_by;
    result.energy += energy.energy;
    add(kept.scatters[e], energy, 1, result);
  }
  return true;
}

template <std::size_t N>
void CellAssembly::add_cavity(const std::vector<BoreFace<N>>& faces,
                              const std::vector<Scatter<N>>& scatters,
                              std::span<const double> unknowns, const TubeStrain& strain,
                              double pressure_mpa, AssembledCell& result) {
  CavityPart<N> cavity;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Scatter<N>& scatter = scatters[f];
    evaluate(mesh_, faces[f], components(scatter, unknowns), strain, cavity);
    result.volume_mm3 += cavity.volume_mm3;
    add(scatter, cavity, -pressure_mpa, result);
    for (std::size_t i = 0; i < scatter.unknown.size(); ++i) {
      if (scatter.unknown[i] < 0) continue;
      result.volume_slope[static_cast<std::size_t>(scatter.unknown[i])] +=
          scatter.sign[i] * cavity.gradient[i];
    }
    for (std::size_t q = 0; q < tube_strains; ++q) {
      result.volume_by_strain[q] += cavity.gradient[scatter.unknown.size() + q];
    }
  }
}

void CellAssembly::add_springs(std::span<const double> unknowns, AssembledCell& result) {
  const std::span<double> values = matrix_.values();
  for (const Spring& spring : springs_) {
    double length = 0;
    for (const auto& [i, weight] : spring.terms)
      length += weight * unknowns[static_cast<std::size_t>(i)];
    result.energy += 0.5 * spring.stiffness * length * length;
    for (const auto& [i, weight] : spring.terms) {
      result.residual[static_cast<std::size_t>(i)] += spring.stiffness * weight * length;
      for (const auto& [j, other] : spring.terms) {
        if (i >= j) values[matrix_.place(i, j)] += spring.stiffness * weight * other;
      }
    }
  }
}

bool CellAssembly::assemble(std::span<const double> unknowns, const TubeStrain& strain,
                            double pressure_mpa, std::span<const ElementPressure> held,
                            AssembledCell& result) {
  const std::size_t n = unknowns.size();
  const std::size_t first_wedge = mesh_.hexahedra.size();
  result.pressures.resize(first_wedge + mesh_.wedges.size());
  std::ranges::fill(matrix_.values(), 0.0);
  result.energy = 0;
  result.volume_mm3 = 0;
  result.residual.assign(n, 0);
  result.volume_slope.assign(n, 0);
  for (auto& column : result.mixed) column.assign(n, 0);
  result.by_strain = {};
  result.volume_by_strain = {};
  result.strain_curvature = {};
  if (!add_energies(mesh_.hexahedra, unknowns, strain, held, 0, hexahedra_, result) ||
      !add_energies(mesh_.wedges, unknowns, strain, held, first_wedge, wedges_, result)) {
    return false;
  }
  add_cavity(mesh_.bore_quadrilaterals, quadrilaterals_, unknowns, strain, pressure_mpa, result);
  add_cavity(mesh_.bore_triangles, triangles_, unknowns, strain, pressure_mpa, result);
  add_springs(unknowns, result);
  return true;
}

template <std::size_t N>
void CellAssembly::add_steps(const Elements<N>& elements, std::span<const double> step,
                             std::size_t first, std::vector<ElementPressure>& pressures) {
  for (std::size_t e = 0; e < elements.scatters.size(); ++e) {
    const Scatter<N>& scatter = elements.scatters[e];
    for (std::size_t p = 0; p < pressures[first + e].size(); ++p) {
      const double* row = &elements.pressure_by[e][p * ElementEnergy<N>::size];
      for (std::size_t i = 0; i < scatter.unknown.size(); ++i) {
        if (scatter.unknown[i] < 0) continue;
        pressures[first + e][p] +=
            row[i] * scatter.sign[i] * step[static_cast<std::size_t>(scatter.unknown[i])];
      }
    }
  }
}

std::vector<ElementPressure> CellAssembly::pressures_after(std::span<const double> step,
                                                           const AssembledCell& from) const {
  std::vector<ElementPressure> result = from.pressures;
  add_steps(hexahedra_, step, 0, result);
  add_steps(wedges_, step, mesh_.hexahedra.size(), result);
  return result;
}

}  // namespace latticast
