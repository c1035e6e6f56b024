// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/print_checks.h"

#include <gtest/gtest.h>

#include "checks/strand_checks.h"
#include "geometry/pattern/horseshoe_path.h"
#include "tests/unit/checks/checked_designs.h"

namespace latticast {
namespace {

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

bool finds(const Design& design, std::string_view code) {
  return !with_code(findings_in_print(design), code).empty();
}

CheckFinding only(const Design& design, std::string_view code) {
  const auto found = with_code(findings_in_print(design), code);
  EXPECT_EQ(found.size(), 1U) << code;
  return found.empty() ? CheckFinding{} : found.front();
}

// Both edges of a strip, as lines of the plane that is unrolled at another radius.
TEST(WidthAtRadius, IsTheDistanceOfTheEdgesOnThatCylinder) {
  const unsigned seed = 20264;
  std::mt19937 random(seed);
  const Segment segment = twisting_segment();
  for (int i = 0; i < 200; ++i) {
    const double angle = uniform(random, 1, 179) * test_pi / 180;
    const double width = uniform(random, 0.1, 5);
    const double radius = uniform(random, 10, 25);
    // A chord of width / sin(angle) along u at R_c subtends the same angle at any radius.
    const double along_u = width / std::sin(angle) / 17 * radius;
    const double du = std::cos(angle) / 17 * radius;
    const double dz = std::sin(angle);
    EXPECT_NEAR(width_at_radius_mm(segment, angle * 180 / test_pi, width, radius),
                along_u * dz / std::hypot(du, dz), 1e-12)
        << "seed " << seed << ", strip " << i;
  }
}

TEST(StrandChecks, LetPassWhatIsAtItsLimit) {
  Segment segment = twisting_segment();
  segment.lattice->rings->width_mm = 0.7;
  segment.lattice->thickness_mm = 0.6;
  segment.lattice->grids[0].widths_mm.assign(8, 0.5);
  for (const char* code : {"ring-too-thin", "layer-too-thin", "strand-too-thin"}) {
    Design design = printed(segment);
    const double value = *only(design, code).value;
    design.printer.min_wall_mm = value;
    EXPECT_FALSE(finds(design, code)) << code;
    design.printer.min_wall_mm = value * (1 + 1e-6);
    EXPECT_TRUE(finds(design, code)) << code;
  }
}

TEST(GapTooSmall, LetsPassWhatIsAtItsLimit) {
  Segment segment = twisting_segment();
  segment.lattice->grids[0].widths_mm.assign(8, 7.6);
  Segment rings = segment;
  rings.lattice->grids.clear();
  rings.lattice->rings = Rings{40, std::nullopt, 2};
  Segment pitched = rings;
  pitched.lattice->rings = Rings{std::nullopt, 2.1, 2};
  Segment arcs = twisting_segment();
  arcs.lattice->grids = {{90, std::vector<double>(16, 3.0), Horseshoe{2.65625, 180, true}}};
  for (const Segment& one : {segment, rings, pitched, arcs}) {
    Design design = printed(one);
    const double value = *only(design, "gap-too-small").value;
    design.printer.min_gap_mm = value;
    EXPECT_FALSE(finds(design, "gap-too-small"));
    design.printer.min_gap_mm = value * (1 + 1e-6);
    EXPECT_TRUE(finds(design, "gap-too-small"));
  }
}

TEST(GapTooSmall, IsAnErrorOnlyWhereTheDesignStatesTheLimit) {
  Segment segment = twisting_segment();
  segment.lattice->grids[0].widths_mm.assign(8, 7.6);
  Design design = printed(segment);
  EXPECT_EQ(only(design, "gap-too-small").severity, Severity::warning);
  design.printer.min_gap_mm = 0.4;
  EXPECT_EQ(only(design, "gap-too-small").severity, Severity::error);
}

TEST(GapTooSmall, IsNotWhatTheFilletCloses) {
  Segment segment = twisting_segment();
  segment.lattice->grids[0].widths_mm.assign(8, 7.6);
  segment.lattice->fillet_mm = 0.13;
  EXPECT_FALSE(finds(printed(segment), "gap-too-small"));
}

// Between the drawn outlines of two neighbours, moved to the inner radius.
double drawn_gap(const Segment& segment, const Grid& grid, int first, int second) {
  const double stretch = segment.liner_outer_radius_mm() / segment.lattice_mid_radius_mm();
  const double spacing = 2 * test_pi * segment.lattice_mid_radius_mm() / grid.count();
  const auto points = [&](int strand) {
    const HorseshoeColumn column{std::get<Horseshoe>(grid.path), strand * spacing, grid.angle_deg,
                                 grid.widths_mm[strand], segment.length_mm};
    std::vector<PlanePoint> all;
    for (const Strand& arc : draw_strand(column, 1e-3).links) {
      for (std::size_t i = 0; i < arc.outline.size(); ++i) {
        const PlanePoint a = arc.outline[i];
        const PlanePoint b = arc.outline[(i + 1) % arc.outline.size()];
        for (const double part : {0.0, 0.25, 0.5, 0.75}) {
          all.push_back({stretch * (a.u + part * (b.u - a.u)), a.z + part * (b.z - a.z)});
        }
      }
    }
    return all;
  };
  double nearest = HUGE_VAL;
  const std::vector<PlanePoint> others = points(second);
  for (const PlanePoint& p : points(first)) {
    for (const PlanePoint& q : others) {
      nearest = std::min(nearest, (p.u - q.u) * (p.u - q.u) + (p.z - q.z) * (p.z - q.z));
    }
  }
  return std::sqrt(nearest);
}

TEST(GapTooSmall, OfHorseshoesIsNearTheDrawnGapAndNeverMore) {
  for (const double arc : {120.0, 180.0}) {
    for (const double angle : {90.0, 70.0}) {
      Segment segment = twisting_segment();
      segment.length_mm = 42.5;
      segment.lattice->rings.reset();
      HorseshoeColumn column{{2.65625, arc, true}, 0, angle, 2.4, segment.length_mm};
      column.shape.radius_mm = closing_radius_mm(column);
      segment.lattice->grids = {{angle, std::vector<double>(16, 1.6), column.shape}};
      Design design = printed(segment);
      design.printer.min_gap_mm = 5;
      const double stated = *only(design, "gap-too-small").value;
      const double drawn = drawn_gap(segment, segment.lattice->grids[0], 0, 1);
      EXPECT_LE(stated, drawn + 2e-3) << arc << " " << angle;
      EXPECT_GE(stated, drawn * 16 / 17 - 2e-3) << arc << " " << angle;
    }
  }
}

// What a remedy's number says is applied, and the finding must be gone.
TEST(PrintChecks, RemediesPass) {
  const unsigned seed = 20265;
  std::mt19937 random(seed);
  int tried = 0;
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", design " + std::to_string(i));
    Segment segment = twisting_segment();
    Lattice& lattice = *segment.lattice;
    Grid& grid = lattice.grids[0];
    grid.angle_deg = uniform(random, 20, 160);
    grid.widths_mm.assign(8, uniform(random, 0.3, 1.5));
    lattice.thickness_mm = uniform(random, 0.3, 2);
    lattice.rings->width_mm = uniform(random, 0.3, 1.5);
    lattice.rings->count = 4 + static_cast<int>(uniform(random, 0, 40));
    Design design = printed(segment);
    design.printer.min_wall_mm = uniform(random, 0.4, 1.2);
    design.printer.min_gap_mm = uniform(random, 0.5, 6);
    for (const CheckFinding& finding : findings_in_print(design)) {
      Design better = design;
      Lattice& to = *better.segments[0].lattice;
      Grid& strands = to.grids[0];
      const auto value = [&](const char* key) { return remedy_value(finding, key); };
      if (finding.code == "strand-too-thin") {
        strands.widths_mm.assign(8, value("width").value());
      } else if (finding.code == "ring-too-thin") {
        to.rings->width_mm = value("rings.width").value();
      } else if (finding.code == "layer-too-thin") {
        to.thickness_mm = value("lattice.thickness").value();
      } else if (finding.code == "gap-too-small" && finding.part == "rings") {
        if (!value("rings.count")) continue;
        to.rings->count = static_cast<int>(*value("rings.count"));
      } else if (finding.code == "gap-too-small") {
        if (!value("count")) continue;
        strands.widths_mm.resize(static_cast<std::size_t>(*value("count")));
      } else {
        continue;
      }
      ++tried;
      for (const CheckFinding& left : with_code(findings_in_print(better), finding.code)) {
        EXPECT_NE(left.part.substr(0, 4), finding.part.substr(0, 4))
            << finding.message << " | " << finding.remedy << " | " << left.message;
      }
    }
  }
  EXPECT_GT(tried, 60);
}

TEST(PrintChecks, LimitsChangePlacesInAMold) {
  Segment segment = twisting_segment();
  segment.lattice->grids[0].widths_mm.assign(8, 0.6);
  Design design = printed(segment);
  design.printer.min_wall_mm = 0.8;
  design.printer.min_gap_mm = 0.4;
  EXPECT_EQ(only(design, "strand-too-thin").limit, 0.8);
  design.make = cast(segment).make;
  EXPECT_FALSE(finds(design, "strand-too-thin"));
  design.printer.min_gap_mm = 0.65;
  const CheckFinding groove = only(design, "strand-too-thin");
  EXPECT_EQ(groove.limit, 0.65);
  EXPECT_NE(groove.message.find("groove"), std::string::npos);
  EXPECT_EQ(groove.part, "lattice-mold grid 1 strand 1");
  design.make.lattice = true;
  EXPECT_EQ(with_code(findings_in_print(design), "strand-too-thin").size(), 2U);
  design.make.lattice = false;
  design.make.lattice_mold->method = MoldMethod::replica;
  EXPECT_EQ(only(design, "strand-too-thin").limit, 0.8);
}

TEST(PrintChecks, LookAtNothingThatIsNotMade) {
  Segment segment = twisting_segment();
  segment.lattice->grids[0].widths_mm.assign(8, 0.1);
  Design design = printed(segment);
  design.make = {};
  EXPECT_TRUE(finds(design, "strand-too-thin")) << "nothing is named yet: as if it were printed";
  design.make.liner = true;
  EXPECT_TRUE(findings_in_print(design).empty());
  design.segments[0].liner.thickness_mm = 0.5;
  EXPECT_EQ(only(design, "layer-too-thin").part, "liner");
  design.segments[0].lattice.reset();
  design.make.liner = false;
  EXPECT_TRUE(findings_in_print(design).empty());
}

TEST(PrintChecks, ColumnsThatOverlapAreNamedOnlyWhereTheyAreDrawn) {
  Segment segment = twisting_segment();
  segment.lattice->grids = {{90, std::vector<double>(16, 5.0), Horseshoe{2.65625, 180, true}}};
  Design design = printed(segment);
  EXPECT_TRUE(finds(design, "columns-fused"));
  EXPECT_FALSE(finds(design, "cannot-draw"));
  design.make = {};
  design.model.columns = ColumnModel::rods;
  EXPECT_FALSE(finds(design, "columns-fused"));
  design.make.preview.emplace();
  EXPECT_TRUE(finds(design, "columns-fused"));
}

TEST(PrintChecks, NeverThrow) {
  const unsigned seed = 20267;
  std::mt19937 random(seed);
  const auto power = [&](double low, double high) {
    return std::exp(uniform(random, std::log(low), std::log(high)));
  };
  int clean = 0;
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", design " + std::to_string(i));
    Segment segment = twisting_segment();
    const double size = power(0.1, 300);
    segment.length_mm = size * power(0.3, 5);
    segment.liner = {size, size * power(0.02, 1), {}};
    Lattice& lattice = *segment.lattice;
    lattice.thickness_mm = size * power(0.01, 0.3);
    lattice.rings.reset();
    if (i % 3 != 0) lattice.rings = Rings{2 + i % 5, std::nullopt, 0.02 * segment.length_mm};
    if (i % 4 == 0) lattice.fillet_mm = size * power(1e-3, 0.2);
    lattice.grids.clear();
    for (int g = 0; g < i % 4; ++g) {
      const double angle = uniform(random, 15, 165);
      const int count = 1 + static_cast<int>(uniform(random, 0, 9));
      const double share =
          2 * test_pi * segment.lattice_mid_radius_mm() * std::sin(angle * test_pi / 180) / count;
      const std::vector<double> widths(count, share * uniform(random, 0.01, 0.98));
      lattice.grids.push_back({angle, widths, StraightPath{}});
      if (i % 7 != 0) continue;
      HorseshoeColumn column{{size * power(0.05, 0.5), uniform(random, 90, 180), true},
                             0,
                             angle,
                             widths[0],
                             segment.length_mm};
      column.shape.radius_mm = closing_radius_mm(column);
      lattice.grids.back().path = column.shape;
    }
    if (!lattice.rings && lattice.grids.empty()) continue;
    Design design = i % 2 == 0 ? printed(segment) : cast(segment);
    CheckFindings findings;
    EXPECT_NO_THROW(findings = findings_in_print(design));
    for (const CheckFinding& finding : findings) {
      EXPECT_FALSE(finding.message.empty());
      EXPECT_FALSE(finding.remedy.empty());
      EXPECT_TRUE(!finding.value || std::isfinite(*finding.value)) << finding.code;
      EXPECT_TRUE(!finding.place ||
                  (finding.place->theta_deg >= 0 && finding.place->theta_deg <= 360 &&
                   finding.place->z_mm >= 0 && finding.place->z_mm <= segment.length_mm))
          << finding.code;
    }
    clean += with_code(findings, "cannot-draw").empty() ? 1 : 0;
  }
  EXPECT_GT(clean, 150);
}

TEST(Overhang, SlopesAreThoseOfTheOuterRadius) {
  const Segment segment = twisting_segment();
  Grid grid = segment.lattice->grids[0];
  const double slope = std::atan2(std::tan(36 * test_pi / 180) * 17, 18) * 180 / test_pi;
  EXPECT_NEAR(least_slope_deg(segment, grid), slope, 1e-9);
  grid.angle_deg = 144;
  EXPECT_NEAR(least_slope_deg(segment, grid), slope, 1e-9);
  grid.angle_deg = 90;
  EXPECT_EQ(least_slope_deg(segment, grid), 90);
  grid.path = Horseshoe{3, 60, true};
  EXPECT_NEAR(least_slope_deg(segment, grid),
              std::atan2(std::tan(test_pi / 3) * 17, 18) * 180 / test_pi, 1e-9);
  std::get<Horseshoe>(grid.path).arc_deg = 180;
  EXPECT_EQ(least_slope_deg(segment, grid), 0);
}

TEST(Overhang, ResinPrintersReachFurther) {
  Design design = printed(twisting_segment());
  EXPECT_TRUE(finds(design, "overhang"));
  EXPECT_TRUE(finds(design, "long-bridge"));
  design.printer.process = Process::sla;
  EXPECT_FALSE(finds(design, "overhang"));
  EXPECT_FALSE(finds(design, "long-bridge"));
}

TEST(ExceedsBed, KnowsTheQuarterTurnAndTheLimit) {
  Design design = printed(twisting_segment());
  design.make.liner = true;
  design.printer.bed_mm = {36, 36, 85};
  EXPECT_FALSE(finds(design, "exceeds-bed"));
  design.printer.bed_mm = {36, 35.9, 85};
  EXPECT_EQ(only(design, "exceeds-bed").part, "lattice");
  design.printer.bed_mm = {35.9, 100, 85};
  EXPECT_EQ(only(design, "exceeds-bed").limit, 35.9);
  design.printer.bed_mm = {100, 100, 84};
  const auto found = with_code(findings_in_print(design), "exceeds-bed");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[1].part, "liner");
  EXPECT_EQ(found[1].value, 85);
}

}  // namespace
}  // namespace latticast
