// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/weld.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace latticast {
namespace {

using Key = std::array<float, 3>;

Key key_of(const Point& point) {
  // Adding zero turns -0.0 into 0.0, so that equal keys have equal bits.
  return {static_cast<float>(point[0]) + 0.0F, static_cast<float>(point[1]) + 0.0F,
          static_cast<float>(point[2]) + 0.0F};
}

bool has_nan(const Key& key) {
  return std::isnan(key[0]) || std::isnan(key[1]) || std::isnan(key[2]);
}

std::uint64_t hash_of(const Key& key) {
  const auto x = std::bit_cast<std::uint32_t>(key[0]);
  const auto y = std::bit_cast<std::uint32_t>(key[1]);
  const auto z = std::bit_cast<std::uint32_t>(key[2]);
  std::uint64_t hash = (std::uint64_t{x} << 32U | y) * 0x9E3779B97F4A7C15U;
  hash = (hash ^ (hash >> 32U) ^ z) * 0xD6E8FEB86659FD93U;
  return hash ^ (hash >> 32U);
}

/// Distinct keys in order of appearance. The table grows with them instead of with the vertices:
/// for a triangle soup it is six times smaller and stays in the cache.
class KeySet {
 public:
  std::uint32_t index_of(const Key& key) {
    const auto next = static_cast<std::uint32_t>(keys_.size());
    // Equal to nothing, NaN keys would pile up behind one slot: they stay out of the table.
    if (has_nan(key)) {
      keys_.push_back(key);
      return next;
    }
    if (2 * (keys_.size() + 1) > slots_.size()) {
      grow();
    }
    std::uint32_t& slot = slots_[find(key)];
    if (slot == empty) {
      slot = next;
      keys_.push_back(key);
    }
    return slot;
  }

  const std::vector<Key>& keys() const { return keys_; }

 private:
  static constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();

  std::size_t find(const Key& key) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash_of(key) & mask;
    while (slots_[slot] != empty && keys_[slots_[slot]] != key) {
      slot = (slot + 1) & mask;
    }
    return slot;
  }

  void grow() {
    slots_.assign(slots_.empty() ? 1024 : 4 * slots_.size(), empty);
    for (std::uint32_t i = 0; i < keys_.size(); ++i) {
      if (!has_nan(keys_[i])) {
        slots_[find(keys_[i])] = i;
      }
    }
  }

  std::vector<Key> keys_;
  std::vector<std::uint32_t> slots_;  // power of two in number, at most half full
};

}  // namespace

TriangleMesh weld(const TriangleMesh& mesh) {
  KeySet distinct;
  std::vector<std::uint32_t> index(mesh.vertices.size());
  for (std::size_t i = 0; i < index.size(); ++i) {
    index[i] = distinct.index_of(key_of(mesh.vertices[i]));
  }
  TriangleMesh welded;
  welded.vertices.reserve(distinct.keys().size());
  for (const Key& key : distinct.keys()) {
    welded.vertices.push_back({key[0], key[1], key[2]});
  }
  welded.triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    welded.triangles.push_back({index[t[0]], index[t[1]], index[t[2]]});
  }
  return welded;
}

bool is_closed(const TriangleMesh& welded) {
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Edge> forward;
  std::vector<Edge> backward;
  for (const Triangle& t : welded.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = t[i];
      const std::uint32_t to = t[(i + 1) % 3];
      if (from < to) forward.emplace_back(from, to);
      if (from > to) backward.emplace_back(to, from);
    }
  }
  std::sort(forward.begin(), forward.end());
  std::sort(backward.begin(), backward.end());
  return forward == backward;
}

bool same_triangles(const TriangleMesh& a, const TriangleMesh& b) {
  return std::equal(a.triangles.begin(), a.triangles.end(), b.triangles.begin(), b.triangles.end(),
                    [&](const Triangle& s, const Triangle& t) {
                      return a.vertices[s[0]] == b.vertices[t[0]] &&
                             a.vertices[s[1]] == b.vertices[t[1]] &&
                             a.vertices[s[2]] == b.vertices[t[2]];
                    });
}

}  // namespace latticast
