// SPDX-License-Identifier: GPL-3.0-or-later
// Disjoint sets (union–find with path halving) of the numbers 0 .. n - 1.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace latticast {

/// Every number starts as a set of its own. Each set has one of its numbers for its root.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  std::size_t size() const { return parent_.size(); }

  /// Adds a number in a set of its own.
  void add() { parent_.push_back(static_cast<std::uint32_t>(parent_.size())); }

  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  /// Joins the set of i to that of j, whose root stays. Says whether they were two.
  bool join(std::uint32_t i, std::uint32_t j) {
    i = root(i);
    j = root(j);
    parent_[i] = j;
    return i != j;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace latticast
