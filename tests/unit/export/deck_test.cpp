// SPDX-License-Identifier: GPL-3.0-or-later
// Decks as a finite-element program reads them: volumes and images of the written mesh, sets,
// steps.
#include "export/deck/deck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "design/units.h"
#include "geometry/pattern/pattern.h"
#include "geometry/pattern/rings.h"
#include "geometry/solid/region.h"
#include "model/cell/drawn_cell.h"
#include "model/cell/lattice_period.h"
#include "model/cell/strip_wedges.h"
#include "tests/unit/model/segments.h"

namespace latticast::testing {
namespace {

using Point = std::array<double, 3>;

constexpr StripDivision small = {
    .strip = 1, .gap = 3, .ring = 1, .span = 1, .liner = 2, .lattice = 1, .grading = 1};

WedgeMesh mesh_of(double angle_deg, bool whole, const StripDivision& division = small) {
  const Segment segment = twisting_segment(angle_deg);
  return strip_wedges(find_strips(segment).tube.value(), segment.length_mm,
                      ring_centres_mm(*segment.lattice->rings, segment.length_mm), division, whole);
}

DeckJob job_of(const Law& liner) {
  return {"a deck", liner, Linear{19.46, 0.49}, {10, 25.5}};
}

double determinant(const Point& a, const Point& b, const Point& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Volume of a quadratic wedge by Gauss points, from shape functions written out from their nodes.
double volume(const std::array<Point, 15>& nodes) {
  const auto at = [&](double u, double v, double w) {
    const std::array<double, 3> l = {1 - u - v, u, v};
    Point x{};
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const std::array<double, 5> shape = {0.5 * l[i] * ((2 * l[i] - 1) * (1 - w) - (1 - w * w)),
                                           0.5 * l[i] * ((2 * l[i] - 1) * (1 + w) - (1 - w * w)),
                                           2 * l[i] * l[j] * (1 - w), 2 * l[i] * l[j] * (1 + w),
                                           l[i] * (1 - w * w)};
      const std::array<int, 5> place = {i, 3 + i, 6 + i, 9 + i, 12 + i};
      for (int s = 0; s < 5; ++s) {
        for (int c = 0; c < 3; ++c) x[c] += shape[s] * nodes[place[s]][c];
      }
    }
    return x;
  };
  constexpr double h = 1e-4;
  double sum = 0;
  for (const auto& [u, v] : {std::pair{1 / 6., 1 / 6.}, {2 / 3., 1 / 6.}, {1 / 6., 2 / 3.}}) {
    for (const double w : {-1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}) {
      const auto slope = [&](double du, double dv, double dw) {
        const Point ahead = at(u + h * du, v + h * dv, w + h * dw);
        const Point behind = at(u - h * du, v - h * dv, w - h * dw);
        return Point{(ahead[0] - behind[0]) / (2 * h), (ahead[1] - behind[1]) / (2 * h),
                     (ahead[2] - behind[2]) / (2 * h)};
      };
      const double jacobian = determinant(slope(1, 0, 0), slope(0, 1, 0), slope(0, 0, 1));
      EXPECT_GT(jacobian, 0);
      sum += jacobian / 6;
    }
  }
  return sum;
}

std::array<Point, 15> places(const WedgeMesh& mesh, const Wedge& wedge) {
  std::array<Point, 15> nodes;
  for (int n = 0; n < 15; ++n) nodes[n] = mesh.nodes[wedge.nodes[n]];
  return nodes;
}

TEST(StripWedges, FillTheTube) {
  StripDivision fine = small;
  fine.strip = 2;
  fine.gap = 6;
  const double length = twisting_segment(36).length_mm;
  for (const bool whole : {false, true}) {
    const WedgeMesh mesh = mesh_of(36, whole, fine);
    std::map<WedgePart, double> filled;
    for (const Wedge& wedge : mesh.wedges) filled[wedge.part] += volume(places(mesh, wedge));
    const double share = whole ? 1 : 1.0 / 8;
    EXPECT_NEAR(filled[WedgePart::liner] / (share * pi * (16 * 16 - 12 * 12) * length), 1, 1e-4);
    // Strips follow constant angles: their share is that at R_c, less where rings cross them.
    const double covered = 8 * 2 / (2 * pi * 17 * std::sin(radians(36)));
    const double solid = 1 - (1 - 0.2) * (1 - covered);
    EXPECT_NEAR(filled[WedgePart::lattice] / (share * pi * (18 * 18 - 16 * 16) * length * solid), 1,
                1e-3);
  }
}

TEST(StripWedges, SidesOfASectorAreImages) {
  const WedgeMesh mesh = mesh_of(60, false);
  ASSERT_EQ(mesh.sectors, 8);
  std::size_t on_near_side = mesh.ties.size();
  EXPECT_GT(on_near_side, 100U);
  const double c = std::cos(2 * pi / 8);
  const double s = std::sin(2 * pi / 8);
  for (const auto& [near, far] : mesh.ties) {
    const Point& a = mesh.nodes[near];
    const Point& b = mesh.nodes[far];
    EXPECT_NEAR(b[0], c * a[0] - s * a[1], 1e-12);
    EXPECT_NEAR(b[1], s * a[0] + c * a[1], 1e-12);
    EXPECT_EQ(b[2], a[2]);
  }
  for (const std::int32_t n : mesh.base) EXPECT_EQ(mesh.nodes[n][2], 0);
  for (const std::int32_t n : mesh.tip) EXPECT_EQ(mesh.nodes[n][2], 80);
  for (const std::int32_t n : mesh.bond) {
    EXPECT_NEAR(std::hypot(mesh.nodes[n][0], mesh.nodes[n][1]), 16, 1e-12);
  }
  for (const std::int32_t w : mesh.bore) {
    for (const int n : {0, 1, 2, 6, 7, 8}) {
      const Point& at = mesh.nodes[mesh.wedges[w].nodes[n]];
      EXPECT_NEAR(std::hypot(at[0], at[1]), 12, 1e-12);
    }
  }
  EXPECT_TRUE(mesh_of(60, true).ties.empty());
}

/// Two tilted families and columns of horseshoes; the paper's unequal columns, which fuse.
std::vector<Segment> any_lattices() {
  Segment crossed = paper_segment({50, 130});
  crossed.lattice->material.law = Linear{19.46, 0.49};
  Segment waves = columns(std::vector<double>(16, 2.0));
  waves.lattice->material.law = Linear{19.46, 0.49};
  Segment uneven = columns(halves(16, 3.5, 2));
  uneven.lattice->material.law = Linear{19.46, 0.49};
  return {crossed, waves, uneven};
}

// The lattice's volume is its area in the plane, drawn by itself, times what wrapping makes of it.
TEST(DrawnWedges, FillWhatIsDrawn) {
  for (const Segment& segment : any_lattices()) {
    Pattern pattern = draw_lattice(segment, 1e-3);
    const PlaneGrid grid =
        make_plane_grid(segment.lattice_circumference_mm(), segment.length_mm, 16);
    const double area = area_mm2(unite(std::move(pattern), grid, {}, 1e-3));
    for (const bool whole : {false, true}) {
      const FoundWedges found = find_drawn_wedges(segment, whole);
      ASSERT_TRUE(found.mesh) << found.reason;
      const WedgeMesh& mesh = *found.mesh;
      EXPECT_EQ(mesh.sectors, whole ? 1 : equal_sectors(segment));
      std::map<WedgePart, double> filled;
      for (const Wedge& wedge : mesh.wedges) filled[wedge.part] += volume(places(mesh, wedge));
      const double share = 1.0 / mesh.sectors;
      EXPECT_NEAR(filled[WedgePart::liner] / (share * pi * (16 * 16 - 12 * 12) * 85), 1, 1e-4);
      EXPECT_NEAR(filled[WedgePart::lattice] / (share * area * (18 * 18 - 16 * 16) / (2 * 17)), 1,
                  2e-3);
    }
  }
}

TEST(DrawnWedges, SidesOfASectorAreImages) {
  const Segment segment = any_lattices()[1];
  const WedgeMesh mesh = find_drawn_wedges(segment, false).mesh.value();
  ASSERT_EQ(mesh.sectors, 16);
  EXPECT_GT(mesh.ties.size(), 100U);
  const double c = std::cos(2 * pi / 16);
  const double s = std::sin(2 * pi / 16);
  for (const auto& [near, far] : mesh.ties) {
    const Point& a = mesh.nodes[near];
    const Point& b = mesh.nodes[far];
    EXPECT_NEAR(b[0], c * a[0] - s * a[1], 1e-9);
    EXPECT_NEAR(b[1], s * a[0] + c * a[1], 1e-9);
    EXPECT_NEAR(b[2], a[2], 1e-9);
  }
  for (const std::int32_t n : mesh.base) EXPECT_NEAR(mesh.nodes[n][2], 0, 1e-6);
  for (const std::int32_t n : mesh.tip) EXPECT_NEAR(mesh.nodes[n][2], 85, 1e-6);
  EXPECT_FALSE(mesh.base.empty());
  EXPECT_FALSE(mesh.tip.empty());
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++found;
  }
  return found;
}

TEST(InpDeck, HoldsMeshSetsAndASteppedLoad) {
  const WedgeMesh mesh = mesh_of(36, false);
  const std::string deck = inp_deck(mesh, job_of(NeoHookean{0.08}));
  for (const char* set : {"NSET=BASE", "NSET=TIP\n", "NSET=BOND", "ELSET=CAVITY", "ELSET=LINER\n",
                          "ELSET=LATTICE\n", "NSET=TIP_REFERENCE", "NSET=TIP_TURN"}) {
    EXPECT_NE(deck.find(set), std::string::npos) << set;
  }
  EXPECT_EQ(count(deck, "*STEP"), 2U);
  EXPECT_NE(deck.find("CAVITY, P1, 0.0255\n"), std::string::npos);
  EXPECT_NE(deck.find("*HYPERELASTIC, NEO HOOKE\n0.04, 0.0125\n"), std::string::npos);
  // Ties of nodes that neither end holds: three equations each.
  std::size_t free_ties = 0;
  for (const auto& [near, far] : mesh.ties) {
    const double z = mesh.nodes[near][2];
    if (z > 0 && z < 80) ++free_ties;
  }
  EXPECT_EQ(count(deck, "*EQUATION"), 3 * free_ties);
  EXPECT_EQ(inp_deck(mesh_of(36, true), job_of(NeoHookean{0.08})).find("*EQUATION"),
            std::string::npos);
  for (std::istringstream lines(deck); !lines.eof();) {
    std::string line;
    std::getline(lines, line);
    EXPECT_LE(line.size(), 132U) << line;
  }
}

TEST(InpDeck, TiesAreKeptByImagesOnly) {
  const WedgeMesh mesh = mesh_of(36, false);
  std::map<int, int> near_of;
  for (const auto& [near, far] : mesh.ties) near_of[far + 1] = near + 1;
  const double c = std::cos(2 * pi / 8);
  const double s = std::sin(2 * pi / 8);
  const Point near_moves = {0.3, -0.2, 0.7};
  const Point far_moves = {c * near_moves[0] - s * near_moves[1],
                           s * near_moves[0] + c * near_moves[1], near_moves[2]};
  std::string deck = inp_deck(mesh, job_of(NeoHookean{0.08}));
  std::replace(deck.begin(), deck.end(), ',', ' ');
  std::istringstream file(deck);
  int equations = 0;
  for (std::string line; std::getline(file, line);) {
    if (line != "*EQUATION") continue;
    int terms = 0, far = 0;
    file >> terms;
    double sum = 0;
    for (int i = 0; i < terms; ++i) {
      int node = 0, component = 0;
      double factor = 0;
      file >> node >> component >> factor;
      if (i == 0) far = node;
      if (i > 0) {
        EXPECT_EQ(node, near_of.at(far));
      }
      sum += factor * (i == 0 ? far_moves : near_moves)[component - 1];
    }
    EXPECT_NEAR(sum, 0, 1e-14);
    ++equations;
  }
  EXPECT_GT(equations, 300);
}

TEST(InpDeck, PullsTheTipAsAClosedEndDoes) {
  // P pi R_i^2 of the tube, an eighth of it on a sector.
  for (const bool whole : {false, true}) {
    const std::string deck = inp_deck(mesh_of(36, whole), job_of(NeoHookean{0.08}));
    const std::string before = "TIP_REFERENCE, 3, ";
    const double force = std::stod(deck.substr(deck.find(before) + before.size()));
    EXPECT_NEAR(force, 0.01 * pi * 144 / (whole ? 1 : 8), 1e-12);
  }
}

TEST(InpDeck, WritesEveryLawItsProgramsHave) {
  const WedgeMesh mesh = mesh_of(36, false);
  const auto lines = [&](const Law& law) {
    const std::string deck = inp_deck(mesh, job_of(law));
    const std::size_t from = deck.find("*HYPERELASTIC");
    return deck.substr(from, deck.find("*MATERIAL", from) - from);
  };
  EXPECT_EQ(lines(Mooney{0.03, 0.01}), "*HYPERELASTIC, MOONEY-RIVLIN\n0.03, 0.01, 0.0125\n");
  EXPECT_EQ(lines(Yeoh{0.04, 0.002, 0.0005}),
            "*HYPERELASTIC, YEOH\n0.04, 0.002, 0.0005, 0.0125, 12500, 12500\n");
  // 2 mu/alpha^2 there is mu/alpha here.
  EXPECT_EQ(lines(Ogden{{0.08}, {2}}), "*HYPERELASTIC, OGDEN, N=1\n0.08, 2, 0.0125\n");
  EXPECT_EQ(lines(Ogden{{0.1, -0.01}, {2, -2}}).substr(0, 42),
            "*HYPERELASTIC, OGDEN, N=2\n0.1, 2, 0.01, -2");
  EXPECT_EQ(law_without_deck(Gent{0.08, 40}), "gent");
  EXPECT_EQ(law_without_deck(Mooney{0.03, 0.01}), "");
}

TEST(MshDeck, OrdersItsNodesAsTheFormatSays) {
  const WedgeMesh mesh = mesh_of(36, false);
  std::istringstream file(msh_deck(mesh));
  std::string line;
  std::vector<Point> nodes;
  std::map<int, int> groups;
  std::size_t elements = 0;
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    if (line == "$Nodes") {
      std::size_t size = 0;
      file >> size;
      nodes.resize(size);
      for (Point& at : nodes) {
        int number = 0;
        file >> number >> at[0] >> at[1] >> at[2];
      }
    }
    if (line != "$Elements") continue;
    file >> elements;
    for (std::size_t e = 0; e < elements; ++e) {
      int number = 0, type = 0, tags = 0, group = 0, entity = 0;
      file >> number >> type >> tags >> group >> entity;
      ++groups[group];
      std::vector<int> own(type == 18 ? 15 : type == 9 ? 6 : 8);
      for (int& n : own) file >> n;
      if (type != 18) continue;
      // Each middle lies half way between the ends of its edge, to the arc's height.
      constexpr std::array<std::pair<int, int>, 9> edges = {
          {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}}};
      for (std::size_t m = 0; m < edges.size(); ++m) {
        const Point& a = nodes[own[edges[m].first] - 1];
        const Point& b = nodes[own[edges[m].second] - 1];
        const Point& middle = nodes[own[6 + m] - 1];
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(middle[c], 0.5 * (a[c] + b[c]), 0.35);
      }
    }
  }
  EXPECT_EQ(nodes.size(), mesh.nodes.size());
  EXPECT_EQ(static_cast<std::size_t>(groups[1] + groups[2]), mesh.wedges.size());
  EXPECT_EQ(static_cast<std::size_t>(groups[3]), mesh.bore.size());
  EXPECT_EQ(groups[4], groups[5]);
  EXPECT_GT(groups[4], 0);
}

}  // namespace
}  // namespace latticast::testing
