// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/pour_plan.h"

#include <gtest/gtest.h>

#include "molds/liner_mold.h"
#include "molds/plugs.h"

namespace latticast {
namespace {

Segment tube() {
  Segment segment;
  segment.length_mm = 85;
  segment.liner.inner_radius_mm = 12;
  segment.liner.thickness_mm = 4;
  segment.liner.material.name = "ecoflex-00-50";
  segment.liner.material.density_g_per_cm3 = 1.07;
  return segment;
}

std::string procedure(const Segment& segment, const LinerMoldOptions& options, Process process) {
  const Mold mold = liner_mold(segment, options);
  Casting casting{"Liner", mold, segment.liner.material, process};
  casting.into_lattice = options.keyed;
  casting.extras = end_plugs(segment, {});
  return pour_procedure(casting);
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(MoldGrowth, UndoesTheShrinkage) {
  Material material;
  EXPECT_EQ(mold_growth(material), 1);
  material.shrinkage = 0.2;
  EXPECT_DOUBLE_EQ(mold_growth(material), 1.25);
  EXPECT_DOUBLE_EQ(mold_growth(material) * (1 - 0.2), 1);
}

TEST(PourAmount, AddsWasteAndResidue) {
  Material material;
  const PourAmount by_volume = pour_amount(20000, material);
  EXPECT_DOUBLE_EQ(by_volume.cavity_ml, 20);
  EXPECT_DOUBLE_EQ(by_volume.mixed_ml, 28);
  EXPECT_FALSE(by_volume.mixed_g);
  material.density_g_per_cm3 = 1.5;
  EXPECT_DOUBLE_EQ(pour_amount(20000, material).mixed_g.value(), 42);
  EXPECT_DOUBLE_EQ(pour_amount(20000, material, {0.5, 0}).mixed_ml, 30);
}

TEST(PourProcedure, TakesAMaterialsWordsAsText) {
  Segment segment = tube();
  segment.liner.material.name = "ecoflex *00-50* | <b>";
  segment.liner.material.note =
      "stiff\n# Pour\n[data](https://example.org) <script>alert(1)</script> & \x1b[2J\u202E `x`";
  const std::string text = procedure(segment, {}, Process::fdm);
  EXPECT_TRUE(holds(text, "ecoflex \\*00-50\\* \\| &lt;b\\>: the cavity holds"));
  EXPECT_TRUE(holds(text,
                    "says of it: stiff \\# Pour \\[data\\]\\(https://example.org\\) "
                    "&lt;script\\>alert\\(1\\)&lt;/script\\> &amp; \\u001b\\[2J\\u202e "
                    "\\`x\\`\n"));
}

TEST(DemoldingOrder, FreesOnePieceAfterTheOther) {
  LinerMoldOptions options;
  options.pieces = 3;
  const Mold mold = liner_mold(tube(), options);
  std::string order;
  for (const MoldPiece* piece : demolding_order(mold)) order += piece->name + " ";
  EXPECT_EQ(order, "cap base shell-1 shell-2 shell-3 core ");
}

TEST(PourProcedure, HoldsEveryPieceAmountAndStep) {
  const std::string text = procedure(tube(), {}, Process::fdm);
  for (const char* piece : {"core", "base", "shell-1", "shell-2", "cap", "plug-inlet", "plug"}) {
    EXPECT_TRUE(holds(text, std::string("| ") + piece + " | ")) << piece;
  }
  // pi (16^2 - 12^2) 85 = 29908 mm3; 15 % more, and 5 ml: 39.4 ml, 42.2 g.
  EXPECT_TRUE(holds(text, "holds 29.9 ml. Mix 39.4 ml, 42.2 g at 1.07 g/cm3")) << text;
  EXPECT_TRUE(holds(text, "Pull shell-1 sideways, towards 90 degrees"));
  EXPECT_TRUE(holds(text, "Pull shell-2 sideways, towards 270 degrees"));
  EXPECT_TRUE(holds(text, "Set the core into the socket"));
  EXPECT_TRUE(holds(text, "Push the core out"));
  EXPECT_TRUE(holds(text, "Polyurethane needs a release agent"));
  EXPECT_TRUE(holds(text, "leave ridges"));
  EXPECT_FALSE(holds(text, "post-cure"));
  EXPECT_FALSE(holds(text, "finished lattice"));
  // Shell 21 mm and rim: 0.15 + 5 mm beyond it.
  EXPECT_TRUE(holds(text, "| 52.3 x 52.3 x 15.0 |")) << text;
  EXPECT_TRUE(holds(text, "- At their teeth"));
}

TEST(PourProcedure, StatesNoGramsWithoutADensity) {
  Segment segment = tube();
  segment.liner.material.density_g_per_cm3.reset();
  const std::string text = procedure(segment, {}, Process::fdm);
  EXPECT_FALSE(holds(text, " g at ")) << text;
  EXPECT_TRUE(holds(text, "measure by volume"));
}

TEST(PourProcedure, FollowsProcessEndsAndLattice) {
  Segment segment = tube();
  LinerMoldOptions closed;
  closed.ends = LinerEnds::closed;
  const std::string resin = procedure(segment, closed, Process::sla);
  EXPECT_TRUE(holds(resin, "post-cure"));
  EXPECT_TRUE(holds(resin, "through the hole in the middle"));
  EXPECT_FALSE(holds(resin, "Push the core out"));
  EXPECT_TRUE(holds(resin, "and its core with it"));
  segment.lattice.emplace();
  segment.lattice->thickness_mm = 2;
  segment.lattice->rings.emplace();
  segment.lattice->rings->count = 8;
  segment.lattice->rings->width_mm = 2;
  LinerMoldOptions keyed;
  keyed.keyed = true;
  const std::string inside = procedure(segment, keyed, Process::fdm);
  EXPECT_TRUE(holds(inside, "Slip the finished lattice over the core"));
  EXPECT_TRUE(holds(inside, "Keep release agent off the lattice"));
}

}  // namespace
}  // namespace latticast
