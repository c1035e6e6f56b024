// SPDX-License-Identifier: GPL-3.0-or-later
// The molds that a design's [make] asks for, planned and made once for checks, files and pictures.
#pragma once

#include <cstddef>
#include <map>
#include <memory>

namespace latticast {

struct Design;
struct LatticeMoldPlan;
struct Mold;
class PreparedLattices;

/// For one thread at a time. Design and lattices must outlive it.
class PreparedMolds {
 public:
  PreparedMolds(const Design& design, PreparedLattices& lattices);
  ~PreparedMolds();

  /// plan_lattice_mold() with the design's options. Preconditions of this and the next: the design
  /// asks for a lattice mold and the segment has a lattice. Throws as the functions named do.
  const LatticeMoldPlan& lattice_mold_plan(std::size_t segment);

  /// lattice_mold() or replica_mold(), as the design asks.
  const Mold& lattice_mold(std::size_t segment);

  /// liner_mold() with the design's options. Precondition: the design asks for one.
  const Mold& liner_mold(std::size_t segment);

 private:
  const Design& design_;
  PreparedLattices& lattices_;
  std::map<std::size_t, std::unique_ptr<LatticeMoldPlan>> plans_;
  std::map<std::size_t, std::unique_ptr<Mold>> lattice_molds_;
  std::map<std::size_t, std::unique_ptr<Mold>> liner_molds_;
};

}  // namespace latticast
