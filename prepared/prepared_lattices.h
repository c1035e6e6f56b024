// SPDX-License-Identifier: GPL-3.0-or-later
// The drawings of a design's lattices, one a segment.
#pragma once

#include <cstddef>
#include <map>
#include <memory>

namespace latticast {

struct Design;
class LatticeDrawing;

/// For one thread at a time. The design must outlive it.
class PreparedLattices {
 public:
  explicit PreparedLattices(const Design& design);
  ~PreparedLattices();

  /// Precondition: the segment has a lattice.
  LatticeDrawing& of(std::size_t segment);

 private:
  const Design& design_;
  std::map<std::size_t, std::unique_ptr<LatticeDrawing>> drawings_;
};

}  // namespace latticast
