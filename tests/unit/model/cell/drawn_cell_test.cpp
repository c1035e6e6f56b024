// SPDX-License-Identifier: GPL-3.0-or-later
// Unit cells of any lattice: wedges against closed forms, the drawn cell against other meshes,
// symmetry, and the finite-element cells of elongation and bending.
#include "model/cell/drawn_cell.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/solid/lattice_drawing.h"
#include "model/cell/element_energy.h"
#include "model/cell/lattice_period.h"
#include "model/cell/swept_cell.h"
#include "model/section/section_reading.h"
#include "model/section_response.h"
#include "model/segment_response.h"
#include "tests/golden/fe_cell_rows.h"
#include "tests/random_numbers.h"
#include "tests/unit/model/cell/derivatives.h"
#include "tests/unit/model/cell/waves.h"

namespace latticast::testing {
namespace {

/// A period's plane, from the whole circumference or one of 16 columns.
PeriodMesh plane_of(const Segment& segment, int sectors, double size_mm) {
  const PlaneGrid grid = make_plane_grid(segment.lattice_circumference_mm(), segment.length_mm, 16);
  const auto from = static_cast<std::int32_t>(std::lround(1.25 * wave_mm / grid.z_step_mm));
  const auto to = static_cast<std::int32_t>(std::lround(1.75 * wave_mm / grid.z_step_mm));
  LatticeDrawing drawing(segment);
  const std::array cuts = {from, to};
  return triangulate_period(drawing.united(1e-3, grid, cuts, 0.02),
                            {.sectors = sectors, .z_from = from, .z_to = to, .mirrored = true},
                            {.size_mm = size_mm, .most_turn_rad = pi / 6});
}

CellMesh one_column() {
  const Segment segment = elongating(0.25);
  return swept_cell(segment, plane_of(segment, 1, 3), {.repeats = 16, .mirrored = true},
                    {.liner = 2});
}

/// The same plane without its lattice: a bare liner, all around.
CellMesh bare_liner(const Segment& segment, double size_mm) {
  PeriodMesh plane = plane_of(segment, 16, size_mm);
  for (auto& triangle : plane.triangles) triangle.layers = 0;
  return swept_cell(segment, plane, {.repeats = 1, .mirrored = true}, {.liner = 2});
}

TEST(CellWedge, HasItsDerivatives) {
  const CellMesh mesh = one_column();
  Random random(7);
  for (const std::size_t e : {std::size_t{0}, mesh.wedges.size() - 1}) {
    const auto evaluated = [&](const Components<21>& u, const TubeStrain& q) {
      ElementEnergy<21> result;
      EXPECT_TRUE(evaluate(mesh, mesh.wedges[e], u, q, nullptr, result));
      return result;
    };
    expect_derivatives(random_components<21>(random, 0.02), evaluated, 10);
  }
}

TEST(CellWedge, CavityHasItsDerivatives) {
  const CellMesh mesh = one_column();
  Random random(8);
  const auto evaluated = [&](const Components<7>& u, const TubeStrain& q) {
    CavityPart<7> result;
    evaluate(mesh, mesh.bore_triangles[2], u, q, result);
    return result;
  };
  expect_derivatives(random_components<7>(random, 0.3), evaluated, 1);
}

TEST(CellWedge, CavityOfARoundBoreIsItsCylinder) {
  // pi a^2 lambda per mm, whatever the tube twists and bends about its axis by.
  const CellMesh mesh = bare_liner(elongating(0.25), 3);
  Components<7> grown{};
  for (auto& node : grown) node[0] = 0.7;
  double volume = 0;
  for (const BoreTriangle& face : mesh.bore_triangles) {
    CavityPart<7> part;
    evaluate(mesh, face, grown, {0.3, 0.02, 0.003, -0.002}, part);
    volume += part.volume_mm3;
  }
  const double expected = pi * 12.7 * 12.7 * 1.3 * 0.5 * wave_mm;
  EXPECT_NEAR(volume, expected, 2e-4 * expected);
}

TEST(CellWedge, PassesThePatchTest) {
  // One deformation gradient everywhere: no force reaches a node within a wall of one material.
  CellMesh mesh = bare_liner(elongating(0.25), 3);
  std::vector<std::array<double, 3>> forces(mesh.nodes.size());
  ElementEnergy<21> part;
  for (const CellWedge& wedge : mesh.wedges) {
    Components<21> u{};
    for (std::size_t a = 0; a < 21; ++a) u[a] = uniform_gradient(mesh.nodes[wedge.nodes[a]]);
    ASSERT_TRUE(evaluate(mesh, wedge, u, {}, nullptr, part));
    for (std::size_t a = 0; a < 21; ++a) {
      for (std::size_t c = 0; c < 3; ++c) forces[wedge.nodes[a]][c] += part.gradient[3 * a + c];
    }
  }
  double largest = 0;
  double inner = 0;
  int inner_nodes = 0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const CellNode& node = mesh.nodes[i];
    const double force = std::hypot(forces[i][0], forces[i][1], forces[i][2]);
    largest = std::max(largest, force);
    const bool on_end = std::abs(node.height_mm - 1.25 * wave_mm) < 1e-3 ||
                        std::abs(node.height_mm - 1.75 * wave_mm) < 1e-3;
    const bool on_seam = node.angle_rad < 1e-9 || node.angle_rad > 2 * pi - 1e-9;
    if (on_end || on_seam || node.radius_mm < 12.01 || node.radius_mm > 15.99) continue;
    inner = std::max(inner, force);
    ++inner_nodes;
  }
  ASSERT_GT(inner_nodes, 100);
  ASSERT_GT(largest, 1e-3);
  EXPECT_LT(inner, 1e-12 * largest);
}

TEST(DrawnCell, OfABareTubeHasItsBendingStiffness) {
  // Saint-Venant's pure bending: E I with E = 3 mu, free to change its section, of a rubber that is
  // a thousand times as stiff in volume.
  const Segment segment = elongating(0.25);
  CondensedCell cell(bare_liner(segment, 3));
  const SectionEnergy rest = cell.at({}).value();
  const double bulk = 1000 * 0.08;
  const double modulus = 9 * bulk * 0.08 / (3 * bulk + 0.08);
  const double inertia = pi / 4 * (std::pow(16, 4) - std::pow(12, 4));
  const double expected = modulus * inertia;
  EXPECT_NEAR(rest.second(coordinate::bend_1, coordinate::bend_1), expected, 2e-3 * expected);
  EXPECT_NEAR(rest.second(coordinate::bend_2, coordinate::bend_2), expected, 2e-3 * expected);
  EXPECT_NEAR(rest.second(coordinate::bend_1, coordinate::bend_2), 0, 1e-4 * expected);
  // About its own axis, bending does not stretch it.
  EXPECT_NEAR(rest.second(coordinate::bend_1, coordinate::elongation), 0, 1e-4 * expected);
}

TEST(DrawnCell, OfEqualColumnsIsThatOfOne) {
  // All around the tube, with its axis and its turn held by springs: no bending, the same state.
  const Segment segment = elongating(0.25);
  CondensedCell one(one_column());
  CondensedCell all(swept_cell(segment, plane_of(segment, 16, 3), {.repeats = 1, .mirrored = true},
                               {.liner = 2}));
  const Deformation at{.elongation = 0.03, .inner_growth = 0.45};
  const SectionEnergy expected = one.at(at).value();
  const SectionEnergy found = all.at(at).value();
  EXPECT_NEAR(found.value, expected.value, 2e-3 * expected.value);
  const double bending = found.second(coordinate::bend_1, coordinate::bend_1);
  EXPECT_GT(bending, 0);
  // Sixteen columns, each meshed by itself, bend it by what their meshes differ.
  EXPECT_LT(std::abs(found.gradient[coordinate::bend_1]) / bending, 2e-5);
  EXPECT_LT(std::abs(found.gradient[coordinate::bend_2]) / bending, 2e-5);
}

TEST(DrawnCell, OfStripsIsNearTheirOwn) {
  const Segment segment = twisting_segment(36);
  const FoundCell drawn = find_drawn_cell(segment);
  ASSERT_TRUE(drawn.cell) << drawn.reason;
  const Section section = prepare_section(segment, {});
  const std::vector<double> pressures = {20};
  const Response by_wedges =
      section_response({section, drawn.cell.get(), 80}, pressures, {}, SolverOptions{});
  const State& found = by_wedges.states.front().value();
  const Response by_strips = predict(segment, unit_cell(), pressures);
  const State& own = by_strips.states.front().value();
  EXPECT_NEAR(found.stretch - 1, own.stretch - 1, 0.015 * (own.stretch - 1));
  EXPECT_NEAR(found.twist_rad_per_mm, own.twist_rad_per_mm, 0.015 * -own.twist_rad_per_mm);
  EXPECT_NEAR(found.inner_radius_mm, own.inner_radius_mm, 0.015 * (own.inner_radius_mm - 12));
}

TEST(DrawnCell, OfElongationAgreesWithAnotherProgramsMeshes) {
  // That table is of one mesh each, 1 to 4 % stiff (docs/unit-cell.md#any-lattice).
  for (const auto& [centre, phase] :
       {std::pair{"bulge apex (mirror cell)", 0.25}, std::pair{"junction", 0.5}}) {
    const Segment segment = elongating(phase);
    std::vector<ElongationRow> rows = elongation_rows(centre);
    std::vector<double> pressures;
    rows.resize(3);  // to 30 kPa
    for (const ElongationRow& row : rows) pressures.push_back(row.pressure_kpa);
    const Response response = predict(segment, unit_cell(), pressures);
    ASSERT_EQ(response.status, Status::ok) << response.message;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const State& state = response.states[i].value();
      const double ratio = (state.stretch - 1) / (rows[i].stretch - 1);
      EXPECT_GT(ratio, 1) << centre << ' ' << rows[i].pressure_kpa;
      EXPECT_LT(ratio, 1.045) << centre << ' ' << rows[i].pressure_kpa;
      EXPECT_NEAR(std::abs(state.twist_rad_per_mm), rows[i].twist_rad_per_mm,
                  0.045 * rows[i].twist_rad_per_mm);
      EXPECT_TRUE(state.stable);
    }
  }
}

TEST(DrawnCell, OfBendingAgreesWithAnotherProgramsFinestMesh) {
  const Segment segment = waves(halves(16, 2.5, 2), 0.25);
  const std::vector<BendingRow> rows = bending_rows("2:2.5", 55293);
  const std::vector<double> pressures = {rows.front().pressure_kpa};
  const Response response = predict(segment, unit_cell(), pressures);
  ASSERT_EQ(response.status, Status::ok) << response.message;
  const State& state = response.states.front().value();
  const double ratio = state.bend_magnitude_rad_per_mm() / rows.front().bend_rad_per_mm;
  EXPECT_GT(ratio, 1);  // that mesh has one element through the liner
  EXPECT_LT(ratio, 1.045);
  EXPECT_EQ(state.twist_rad_per_mm, 0);
  // It bends toward the thick half, not exactly: all columns bulge the same way at one height.
  const double middle_of_thick = 7.0 / 16 * 180;
  EXPECT_NEAR(state.bend_direction_rad() / degree, middle_of_thick, 20);
}

TEST(DrawnCell, OfAFusedNetAgreesWithAnotherProgramsMesh) {
  // The paper's 2:3.5 with sixteen columns: the thick ones overlap by 0.28 mm.
  const Segment segment = waves(halves(16, 3.5, 2), 0.25);
  const FoundCell found = find_unit_cell(segment);
  ASSERT_TRUE(found.cell) << found.reason;
  EXPECT_NE(found.cell->assumed.find("one net"), std::string::npos);
  EXPECT_NE(found.cell->assumed.find("by 0.28"), std::string::npos) << found.cell->assumed;
  const std::vector<BendingRow> rows = bending_rows("2:3.5", 53649);
  const std::vector<double> pressures = {rows.front().pressure_kpa};
  const State state = predict(segment, unit_cell(), pressures).states.front().value();
  const double ratio = state.bend_magnitude_rad_per_mm() / rows.front().bend_rad_per_mm;
  EXPECT_GT(ratio, 1);
  EXPECT_LT(ratio, 1.05);
}

/// Energy gained from `from` to `to` less the work of its gradient on the way, by what it gained;
/// three Gauss points a step.
double energy_less_work(UnitCellEnergy& energy, const Deformation& from, const Deformation& to,
                        int steps) {
  const auto between = [&](double share) {
    return Deformation{.elongation = std::lerp(from.elongation, to.elongation, share),
                       .twist = std::lerp(from.twist, to.twist, share),
                       .inner_growth = std::lerp(from.inner_growth, to.inner_growth, share),
                       .bend_1 = std::lerp(from.bend_1, to.bend_1, share),
                       .bend_2 = std::lerp(from.bend_2, to.bend_2, share)};
  };
  const std::array<double, coordinate_count> way = {
      to.elongation - from.elongation, to.twist - from.twist, to.inner_growth - from.inner_growth,
      to.bend_1 - from.bend_1, to.bend_2 - from.bend_2};
  const double start = energy.at(from)->energy.value;
  double work = 0;
  for (int i = 0; i < steps; ++i) {
    for (const auto& [place, weight] :
         {std::pair{-std::sqrt(0.6), 5.0 / 18}, {0.0, 8.0 / 18}, {std::sqrt(0.6), 5.0 / 18}}) {
      const auto here = energy.at(between((i + 0.5 + 0.5 * place) / steps));
      for (std::size_t k = 0; k < way.size(); ++k) {
        work += weight / steps * way[k] * here->energy.gradient[k];
      }
    }
  }
  const double gained = energy.at(to)->energy.value - start;
  return (gained - work) / gained;
}

TEST(DrawnCell, StoresTheWorkThatIsDone) {
  UnitCellEnergy twisting(*find_unit_cell(elongating(0.5)).cell);
  EXPECT_NEAR(
      energy_less_work(twisting, {}, {.elongation = 0.06, .twist = 0.003, .inner_growth = 0.8}, 1),
      0, 1e-5);
  // Bent, by a coarse mesh of the whole circumference.
  const Segment bending = waves(halves(16, 2.5, 2), 0.25);
  const CellMesh mesh =
      swept_cell(bending, plane_of(bending, 16, 8), {.repeats = 1, .mirrored = true}, {.liner = 1});
  UnitCellEnergy bent({.coarse = mesh, .fine = mesh, .kind = UnitCellKind::drawn, .assumed = {}});
  EXPECT_NEAR(energy_less_work(
                  bent, {},
                  {.elongation = 0.05, .inner_growth = 0.5, .bend_1 = 0.002, .bend_2 = -0.001}, 1),
              0, 1e-5);
}

TEST(DrawnCell, IsGivenUpAfterTheFactorisationsItMayTake) {
  const CellMesh mesh = one_column();
  UnitCellEnergy energy({.coarse = mesh, .fine = mesh, .kind = UnitCellKind::drawn, .assumed = {}},
                        12);
  int states = 0;
  while (states < 20 && energy.at({.elongation = 0.01 * (states + 1)})) ++states;
  EXPECT_GE(states, 3);
  EXPECT_LT(states, 13);
  EXPECT_TRUE(energy.exhausted());
  EXPECT_FALSE(energy.buckled());
  EXPECT_TRUE(energy.at({})) << "rest is always known";
}

TEST(DrawnCell, OfTheMirroredLatticeTwistsTheOtherWay) {
  const std::vector<double> pressures = {30};
  // Mirrored by half a wave: rings on the other junctions.
  const Response here = predict(elongating(0.5), unit_cell(), pressures);
  Segment other = elongating(0.5);
  other.lattice->rings->phase = 0;
  const Response there = predict(other, unit_cell(), pressures);
  const State& a = here.states.front().value();
  const State& b = there.states.front().value();
  EXPECT_GT(std::abs(a.twist_rad_per_mm), 1e-3);
  EXPECT_NEAR(b.twist_rad_per_mm, -a.twist_rad_per_mm, 0.01 * std::abs(a.twist_rad_per_mm));
  EXPECT_NEAR(b.stretch - 1, a.stretch - 1, 0.005 * (a.stretch - 1));
}

TEST(LatticePeriod, IsTheSmallest) {
  const auto period = [](const Segment& segment) { return find_period(segment).period.value(); };
  const LatticePeriod bulges = period(elongating(0.25));
  EXPECT_TRUE(bulges.mirrored);
  EXPECT_EQ(bulges.repeats, 16);
  EXPECT_NEAR(bulges.to_mm - bulges.from_mm, 0.5 * wave_mm, 1e-9);
  const LatticePeriod junctions = period(elongating(0.5));
  EXPECT_FALSE(junctions.mirrored);
  EXPECT_NEAR(junctions.to_mm - junctions.from_mm, wave_mm, 1e-9);
  EXPECT_EQ(period(waves(halves(16, 3, 2), 0.25)).repeats, 1);
  EXPECT_EQ(period(waves({2, 2.5, 2, 2.5, 2, 2.5, 2, 2.5}, 0.25)).repeats, 4);
  const LatticePeriod strips = period(twisting_segment(36));
  EXPECT_NEAR(strips.shift_mm, 10 / std::tan(36 * degree), 1e-9);
  EXPECT_EQ(strips.repeats, 8);
  EXPECT_TRUE(strips.assumed.empty());
}

TEST(LatticePeriod, SaysWhatItAssumes) {
  // Eight flush rings on eight waves drift along them.
  const LatticePeriod drifting = find_period(columns(std::vector<double>(16, 2.0))).period.value();
  EXPECT_TRUE(drifting.mirrored);
  EXPECT_NE(drifting.assumed.find("every 10.625 mm, on the bulges, not every 11.857"),
            std::string::npos)
      << drifting.assumed;
}

TEST(LatticePeriod, NamesThePitchThatRepeats) {
  const FoundPeriod pair = find_period(paper_segment({36, 144}));
  ASSERT_FALSE(pair.period);
  EXPECT_NE(pair.reason.find("rings every "), std::string::npos) << pair.reason;
  const double pitch = std::stod(pair.reason.substr(pair.reason.find("rings every ") + 12));
  Segment better = paper_segment({36, 144});
  better.lattice->rings = Rings{.count = std::nullopt, .pitch_mm = pitch, .width_mm = 2};
  EXPECT_TRUE(find_period(better).period);
}

TEST(DrawnCell, OfOppositeFamiliesDoesNotTwist) {
  Segment pair = paper_segment({60, 120});
  pair.lattice->material.law = Linear{19.46, 0.49};
  const double pitch = std::tan(60 * degree) * pair.lattice_circumference_mm() / 16;
  pair.lattice->rings = Rings{.count = std::nullopt, .pitch_mm = pitch, .width_mm = 2};
  const std::vector<double> pressures = {20};
  const Response cell = predict(pair, unit_cell(), pressures);
  ASSERT_EQ(cell.status, Status::ok) << cell.message;
  const State& state = cell.states.front().value();
  EXPECT_EQ(state.twist_rad_per_mm, 0);
  EXPECT_TRUE(state.stable);
  EXPECT_GT(state.stretch, 1);
  EXPECT_LT(state.stretch, predict(pair, {}, pressures).states.front().value().stretch);
}

TEST(DrawnCell, IsRefinedAsFarAsItsErrorAsks) {
  const Segment segment = elongating(0.25);
  const FoundCell finer = find_unit_cell(segment, 0.4);
  ASSERT_TRUE(finer.cell) << finer.reason;
  EXPECT_LE(rest_error_percent(*finer.cell), 0.4);
  const double error = 0.01 * rest_error_percent(*find_unit_cell(segment).cell);
  ModelChoice asked = unit_cell();
  asked.cell_error_percent = 0.4;
  const std::vector<double> pressures = {0.1};
  const State usual = predict(segment, unit_cell(), pressures).states.front().value();
  const State better = predict(segment, asked, pressures).states.front().value();
  EXPECT_NE(usual.stretch, better.stretch);
  EXPECT_NEAR(usual.stretch - 1, better.stretch - 1, error * (better.stretch - 1));
  EXPECT_NEAR(usual.inner_radius_mm, better.inner_radius_mm, error * (better.inner_radius_mm - 12));
}

TEST(DrawnCell, DoesNotDependOnTheSegmentsLength) {
  const auto sinusoids = [](int waves) {
    Segment segment = paper_segment({});
    segment.length_mm = 12.0 * waves;
    segment.lattice->grids.push_back(
        {90, std::vector<double>(14, 1.5), Sinusoid{1.6, 1.0 * waves}});
    segment.lattice->rings =
        Rings{.count = std::nullopt, .pitch_mm = 12, .width_mm = 2, .phase = 0.25};
    return segment;
  };
  const std::vector<double> pressures = {20};
  const State two = predict(sinusoids(2), unit_cell(), pressures).states.front().value();
  const State six = predict(sinusoids(6), unit_cell(), pressures).states.front().value();
  EXPECT_NEAR(six.stretch - 1, two.stretch - 1, 1e-3 * (two.stretch - 1));
  // As long as the arc that the lattice is, it gives less than the section that forgets its rings.
  EXPECT_GT(two.stretch - 1, 0.3 * (predict(sinusoids(2), {}, pressures).states[0]->stretch - 1));
}

TEST(DrawnCell, KnowsFilletsOfStrips) {
  Segment sharp = twisting_segment(36);
  Segment round = sharp;
  round.lattice->fillet_mm = 0.5;
  EXPECT_EQ(find_unit_cell(sharp).cell->kind, UnitCellKind::strips);
  EXPECT_EQ(find_unit_cell(round).cell->kind, UnitCellKind::drawn);
  const std::vector<double> pressures = {20};
  const State with = predict(round, unit_cell(), pressures).states.front().value();
  const State without = predict(sharp, unit_cell(), pressures).states.front().value();
  EXPECT_LT(with.stretch - 1, 0.98 * (without.stretch - 1));  // they stiffen the crossings
}

TEST(DrawnCell, IsRefusedByName) {
  const auto refusal = [](const Segment& segment) { return find_unit_cell(segment).reason; };
  EXPECT_NE(refusal(tube(12, 16, NeoHookean{0.08})).find("there is none"), std::string::npos);
  Segment rubber = twisting_segment(36);
  rubber.lattice->material.law = NeoHookean{1};
  EXPECT_NE(refusal(rubber).find("linear material"), std::string::npos);
  Segment bare = paper_segment({});
  EXPECT_NE(refusal(bare).find("this one has none"), std::string::npos);
  Segment uneven = twisting_segment(36);
  uneven.lattice->grids[0].widths_mm[3] = 2.5;
  EXPECT_NE(refusal(uneven).find("along the axis only"), std::string::npos);
  EXPECT_EQ(refusal(twisting_segment(36)), "");
}

}  // namespace
}  // namespace latticast::testing
