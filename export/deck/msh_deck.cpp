// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <vector>

#include <fmt/core.h>

#include "export/deck/deck.h"

namespace latticast {
namespace {

// Numbers that the format gives its elements.
constexpr int triangle_6 = 9;
constexpr int quadrilateral_8 = 16;
constexpr int prism_15 = 18;

/// Of a wedge's nodes in the format's order: corners, then edges 1-2, 1-3, 1-4, 2-3, 2-5, 3-6, 4-5,
/// 4-6, 5-6.
constexpr std::array<std::size_t, 15> prism_order = {0,  1, 2,  3,  4, 5,  6, 8,
                                                     12, 7, 13, 14, 9, 11, 10};
constexpr std::array<std::size_t, 6> inner_face = {0, 1, 2, 6, 7, 8};
constexpr std::array<std::array<std::size_t, 8>, 3> side_faces = {
    {{0, 1, 4, 3, 6, 13, 9, 12}, {1, 2, 5, 4, 7, 14, 10, 13}, {2, 0, 3, 5, 8, 12, 11, 14}}};

struct Group {
  int dimension;
  int number;
  const char* name;
};
constexpr std::array<Group, 5> groups = {
    {{3, 1, "LINER"}, {3, 2, "LATTICE"}, {2, 3, "CAVITY"}, {2, 4, "BASE"}, {2, 5, "TIP"}}};

class MshWriter {
 public:
  explicit MshWriter(const WedgeMesh& mesh) : mesh_(mesh) {}

  std::string text() {
    for (const std::int32_t w : mesh_.bore) add(triangle_6, 3, mesh_.wedges[w], inner_face);
    add_end(mesh_.base, 4);
    add_end(mesh_.tip, 5);
    for (const Wedge& wedge : mesh_.wedges) {
      add(prism_15, wedge.part == WedgePart::liner ? 1 : 2, wedge, prism_order);
    }
    std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    text += fmt::format("$PhysicalNames\n{}\n", groups.size());
    for (const Group& group : groups) {
      text += fmt::format("{} {} \"{}\"\n", group.dimension, group.number, group.name);
    }
    text += fmt::format("$EndPhysicalNames\n$Nodes\n{}\n", mesh_.nodes.size());
    for (std::size_t n = 0; n < mesh_.nodes.size(); ++n) {
      const auto& [x, y, z] = mesh_.nodes[n];
      text += fmt::format("{} {:.12g} {:.12g} {:.12g}\n", n + 1, x, y, z);
    }
    text += fmt::format("$EndNodes\n$Elements\n{}\n", count_);
    return text + elements_ + "$EndElements\n";
  }

 private:
  void add(int type, int group, const Wedge& wedge, std::span<const std::size_t> order) {
    elements_ += fmt::format("{} {} 2 {} {}", ++count_, type, group, group);
    for (const std::size_t n : order) elements_ += fmt::format(" {}", wedge.nodes[n] + 1);
    elements_ += '\n';
  }

  void add_end(const std::vector<std::int32_t>& nodes, int group) {
    const std::set<std::int32_t> end(nodes.begin(), nodes.end());
    for (const Wedge& wedge : mesh_.wedges) {
      for (const auto& face : side_faces) {
        const bool all = std::all_of(face.begin(), face.end(),
                                     [&](std::size_t n) { return end.contains(wedge.nodes[n]); });
        if (all) add(quadrilateral_8, group, wedge, face);
      }
    }
  }

  const WedgeMesh& mesh_;
  std::string elements_;
  int count_ = 0;
};

}  // namespace

std::string msh_deck(const WedgeMesh& mesh) {
  return MshWriter(mesh).text();
}

}  // namespace latticast
