// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/cell_assembly.h"

#include <algorithm>
#include <utility>

namespace latticast {

CellAssembly::CellAssembly(CellMesh mesh) : mesh_(std::move(mesh)), matrix_(make_matrix()) {
  for (auto& scatter : elements_) find_places(scatter);
  for (auto& scatter : bore_) find_places(scatter);
}

template <std::size_t N, class Nodes>
CellAssembly::Scatter<N> CellAssembly::scatter_of(const Nodes& nodes) const {
  Scatter<N> scatter;
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const CellNode& node = mesh_.nodes[static_cast<std::size_t>(nodes[a])];
    for (std::size_t c = 0; c < 3; ++c) {
      scatter.unknown[3 * a + c] = node.unknown[c].number;
      scatter.sign[3 * a + c] = node.unknown[c].sign;
    }
  }
  return scatter;
}

SparseSolver CellAssembly::make_matrix() {
  std::vector<std::pair<int, int>> entries;
  for (const CellElement& element : mesh_.elements) {
    elements_.push_back(scatter_of<81>(element.nodes));
    const auto& unknown = elements_.back().unknown;
    for (std::size_t i = 0; i < unknown.size(); ++i) {
      for (std::size_t j = i; j < unknown.size(); ++j) {
        if (unknown[i] < 0 || unknown[j] < 0) continue;
        entries.emplace_back(std::max(unknown[i], unknown[j]), std::min(unknown[i], unknown[j]));
      }
    }
  }
  for (const auto& face : mesh_.bore) bore_.push_back(scatter_of<27>(face));
  return {mesh_.unknowns, entries};
}

template <std::size_t N>
void CellAssembly::find_places(Scatter<N>& scatter) const {
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = i; j < N; ++j) {
      const auto [column, row] = std::minmax(scatter.unknown[i], scatter.unknown[j]);
      scatter.place.push_back(column < 0 ? -1
                                         : static_cast<std::int32_t>(matrix_.place(row, column)));
    }
  }
}

template <std::size_t N>
auto CellAssembly::components(const Scatter<N>& scatter, std::span<const double> unknowns) {
  std::array<std::array<double, 3>, N / 3> result{};
  for (std::size_t i = 0; i < N; ++i) {
    if (scatter.unknown[i] < 0) continue;
    result[i / 3][i % 3] = scatter.sign[i] * unknowns[static_cast<std::size_t>(scatter.unknown[i])];
  }
  return result;
}

template <std::size_t N, class Part>
void CellAssembly::add(const Scatter<N>& scatter, const Part& part, double factor,
                       AssembledCell& result) {
  constexpr std::size_t size = N + tube_strains;
  const std::span<double> values = matrix_.values();
  std::size_t pair = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const double* row = &part.hessian[i * size];
    if (scatter.unknown[i] < 0) {
      pair += N - i;
      continue;
    }
    const auto own = static_cast<std::size_t>(scatter.unknown[i]);
    const double sign = factor * scatter.sign[i];
    result.residual[own] += sign * part.gradient[i];
    for (std::size_t q = 0; q < tube_strains; ++q) result.mixed[q][own] += sign * row[N + q];
    for (std::size_t j = i; j < N; ++j, ++pair) {
      const std::int32_t place = scatter.place[pair];
      if (place < 0) continue;
      const double entry = sign * scatter.sign[j] * row[j];
      // Two components of one unknown meet on the diagonal from both sides.
      const bool twice = j != i && scatter.unknown[j] == scatter.unknown[i];
      values[static_cast<std::size_t>(place)] += twice ? 2 * entry : entry;
    }
  }
  for (std::size_t q = 0; q < tube_strains; ++q) {
    result.by_strain[q] += factor * part.gradient[N + q];
    for (std::size_t p = q; p < tube_strains; ++p) {
      result.strain_curvature[q * tube_strains + p] +=
          factor * part.hessian[(N + q) * size + N + p];
    }
  }
}

bool CellAssembly::assemble(std::span<const double> unknowns, const TubeStrain& strain,
                            double pressure_mpa, std::span<const ElementPressure> held,
                            AssembledCell& result) {
  const std::size_t n = unknowns.size();
  result.pressures.resize(elements_.size());
  pressure_by_.resize(elements_.size());
  std::ranges::fill(matrix_.values(), 0.0);
  result.energy = 0;
  result.volume_mm3 = 0;
  result.residual.assign(n, 0);
  result.volume_slope.assign(n, 0);
  for (auto& column : result.mixed) column.assign(n, 0);
  result.by_strain = {};
  result.volume_by_strain = {};
  result.strain_curvature = {};
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const auto moved = components(elements_[e], unknowns);
    const ElementPressure* pressure = held.empty() ? nullptr : &held[e];
    if (!evaluate(mesh_, mesh_.elements[e], moved, strain, pressure, element_)) return false;
    result.pressures[e] = element_.pressure;
    pressure_by_[e] = element_.pressure_by;
    result.energy += element_.energy;
    add(elements_[e], element_, 1, result);
  }
  for (std::size_t f = 0; f < bore_.size(); ++f) {
    const Scatter<27>& scatter = bore_[f];
    evaluate(mesh_, mesh_.bore[f], components(scatter, unknowns), strain, cavity_);
    result.volume_mm3 += cavity_.volume_mm3;
    add(scatter, cavity_, -pressure_mpa, result);
    for (std::size_t i = 0; i < scatter.unknown.size(); ++i) {
      if (scatter.unknown[i] < 0) continue;
      result.volume_slope[static_cast<std::size_t>(scatter.unknown[i])] +=
          scatter.sign[i] * cavity_.gradient[i];
    }
    for (std::size_t q = 0; q < tube_strains; ++q) {
      result.volume_by_strain[q] += cavity_.gradient[scatter.unknown.size() + q];
    }
  }
  return true;
}

std::vector<ElementPressure> CellAssembly::pressures_after(std::span<const double> step,
                                                           const AssembledCell& from) const {
  std::vector<ElementPressure> result = from.pressures;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const Scatter<81>& scatter = elements_[e];
    for (std::size_t p = 0; p < result[e].size(); ++p) {
      const double* row = &pressure_by_[e][p * ElementEnergy::size];
      for (std::size_t i = 0; i < scatter.unknown.size(); ++i) {
        if (scatter.unknown[i] < 0) continue;
        result[e][p] +=
            row[i] * scatter.sign[i] * step[static_cast<std::size_t>(scatter.unknown[i])];
      }
    }
  }
  return result;
}

}  // namespace latticast
