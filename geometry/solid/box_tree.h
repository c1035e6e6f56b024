// SPDX-License-Identifier: GPL-3.0-or-later
// Bounding volume hierarchy: a balanced binary tree of bounds over items that stand in an order in
// which near ones are close together. Node n's children are 2n + 1 and 2n + 2, each with half of
// its items, so that the tree is an array of bounds and nothing else.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace latticast {

/// A box along N axes; empty until something is added.
template <std::size_t N>
struct Box {
  std::array<double, N> low;
  std::array<double, N> high;

  Box() {
    low.fill(HUGE_VAL);
    high.fill(-HUGE_VAL);
  }

  void add(const std::array<double, N>& point) {
    for (std::size_t i = 0; i < N; ++i) {
      low[i] = std::min(low[i], point[i]);
      high[i] = std::max(high[i], point[i]);
    }
  }
  void add(const Box& box) {
    for (std::size_t i = 0; i < N; ++i) {
      low[i] = std::min(low[i], box.low[i]);
      high[i] = std::max(high[i], box.high[i]);
    }
  }
  bool meets(const Box& box) const {
    for (std::size_t i = 0; i < N; ++i) {
      if (low[i] > box.high[i] || box.low[i] > high[i]) return false;
    }
    return true;
  }
};

/// A leaf's items: [from, to).
struct LeafItems {
  std::size_t from = 0;
  std::size_t to = 0;
};

/// Bounds need add(Bounds) and meets(query), for queries of their own type or another.
template <class Bounds>
class BoxTree {
 public:
  static constexpr std::size_t leaf_size = 4;

  BoxTree() = default;
  /// `bounds(i)` are those of item i.
  template <class BoundsOf>
  BoxTree(std::size_t count, const BoundsOf& bounds) : count_(count) {
    if (count > 0) build(0, {0, count}, bounds);
  }

  /// Calls visit(leaf) for every leaf whose bounds meet the query.
  template <class Query, class Visit>
  void for_each_meeting(const Query& query, const Visit& visit) const {
    if (count_ > 0) descend(0, {0, count_}, query, visit);
  }

  /// Calls inside(leaf) for every leaf, and between(leaf, other, bounds of other) for every two
  /// whose bounds meet.
  template <class Inside, class Between>
  void for_each_close_pair(const Inside& inside, const Between& between) const {
    if (count_ > 0) pairs_within(0, {0, count_}, inside, between);
  }

  static bool is_leaf(const LeafItems& items) { return items.to - items.from <= leaf_size; }
  /// Where a node's items are parted between its children.
  static std::size_t middle(const LeafItems& items) {
    return items.from + (items.to - items.from) / 2;
  }

 private:
  template <class BoundsOf>
  void build(std::size_t node, LeafItems items, const BoundsOf& bounds) {
    if (nodes_.size() <= node) nodes_.resize(2 * node + 1);
    if (is_leaf(items)) {
      nodes_[node] = bounds(items.from);
      for (std::size_t i = items.from + 1; i < items.to; ++i) nodes_[node].add(bounds(i));
    } else {
      build(2 * node + 1, {items.from, middle(items)}, bounds);
      build(2 * node + 2, {middle(items), items.to}, bounds);
      nodes_[node] = nodes_[2 * node + 1];
      nodes_[node].add(nodes_[2 * node + 2]);
    }
  }

  template <class Query, class Visit>
  void descend(std::size_t node, LeafItems items, const Query& query, const Visit& visit) const {
    if (!nodes_[node].meets(query)) return;
    if (is_leaf(items)) {
      visit(items);
    } else {
      descend(2 * node + 1, {items.from, middle(items)}, query, visit);
      descend(2 * node + 2, {middle(items), items.to}, query, visit);
    }
  }

  template <class Inside, class Between>
  void pairs_within(std::size_t node, LeafItems items, const Inside& inside,
                    const Between& between) const {
    if (is_leaf(items)) {
      inside(items);
      return;
    }
    const LeafItems low{items.from, middle(items)};
    const LeafItems high{middle(items), items.to};
    pairs_within(2 * node + 1, low, inside, between);
    pairs_within(2 * node + 2, high, inside, between);
    pairs_between(2 * node + 1, low, 2 * node + 2, high, between);
  }

  template <class Between>
  void pairs_between(std::size_t a, LeafItems of_a, std::size_t b, LeafItems of_b,
                     const Between& between) const {
    if (!nodes_[a].meets(nodes_[b])) return;
    if (is_leaf(of_a) && is_leaf(of_b)) {
      between(of_a, of_b, nodes_[b]);
    } else if (is_leaf(of_b) || (!is_leaf(of_a) && of_a.to - of_a.from >= of_b.to - of_b.from)) {
      pairs_between(2 * a + 1, {of_a.from, middle(of_a)}, b, of_b, between);
      pairs_between(2 * a + 2, {middle(of_a), of_a.to}, b, of_b, between);
    } else {
      pairs_between(a, of_a, 2 * b + 1, {of_b.from, middle(of_b)}, between);
      pairs_between(a, of_a, 2 * b + 2, {middle(of_b), of_b.to}, between);
    }
  }

  std::size_t count_ = 0;
  std::vector<Bounds> nodes_;
};

}  // namespace latticast
