// SPDX-License-Identifier: GPL-3.0-or-later
// Events and steps on branches whose equilibria are known in closed form.
#include "model/equilibrium/branch_events.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "model/equilibrium/step_control.h"

namespace latticast::testing {
namespace {

using Point = std::span<const double>;

/// Equations of one coordinate, residual g(x) - P.
EquilibriumEquations scalar(const std::function<double(double)>& load,
                            const std::function<double(double)>& slope) {
  const auto at = [=](Point x) -> std::optional<BalanceAt> {
    BalanceAt balance;
    balance.residual[0] = load(x[0]) - x[1];
    balance.tangent_stiffness[0] = slope(x[0]);
    balance.load_vector[0] = 1;
    return balance;
  };
  return {.size = 1, .at = at, .finer_at = at, .suppressed_modes = [](Point) {
            return SuppressedModes{};
          }};
}

/// P = x - x^2: the branch turns back at x = 1/2, P = 1/4.
EquilibriumEquations fold() {
  return scalar([](double x) { return x - x * x; }, [](double x) { return 1 - 2 * x; });
}

/// Energy x^2/2 + (1 - P/3) y^2/2 - P x: a strut that shortens by x = P and buckles in y at P = 3.
EquilibriumEquations strut(bool suppressed) {
  const auto at = [=](Point x) -> std::optional<BalanceAt> {
    const int n = suppressed ? 1 : 2;
    BalanceAt balance;
    balance.residual[0] = x[0] - x[n];
    balance.tangent_stiffness[0] = 1;
    balance.load_vector[0] = 1;
    if (suppressed) return balance;
    balance.residual[1] = (1 - x[2] / 3) * x[1];
    balance.tangent_stiffness[3] = 1 - x[2] / 3;
    balance.load_vector[1] = x[1] / 3;
    balance.load_stiffness[3] = 1.0 / 3;
    return balance;
  };
  const auto modes = [=](Point x) {
    SuppressedModes result;
    if (suppressed) result.eigenvalues[result.count++] = 1 - x[1] / 3;
    return result;
  };
  return {.size = suppressed ? 1 : 2, .at = at, .finer_at = at, .suppressed_modes = modes};
}

struct Model {
  explicit Model(EquilibriumEquations these)
      : equations(std::move(these)), newton(equations.size + 1) {}

  std::optional<BranchState> in_plane(const BranchPoint& start, const BranchPoint& normal) {
    return corrected(equations, newton, start, normal, load_axis(equations.size));
  }
  CorrectInPlane correct() {
    return [this](const BranchPoint& start, const BranchPoint& normal) {
      return in_plane(start, normal);
    };
  }
  /// The equilibrium of a load, found from coordinates near it.
  BranchState at(BranchPoint near, double load) {
    const int n = equations.size;
    return in_plane(at_load(near, load, n), load_axis(n)).value();
  }

  EquilibriumEquations equations;
  NewtonSolver newton;
};

TEST(BranchState, TangentAndStabilityOfAFold) {
  Model model(fold());
  const BranchState state = model.at({0.1}, 0.16);  // x = 0.2, dP/dx = 0.6
  EXPECT_NEAR(state.x[0], 0.2, 1e-15);
  EXPECT_NEAR(state.tangent[0], 1 / std::hypot(1, 0.6), 1e-14);
  EXPECT_NEAR(state.tangent[1], 0.6 / std::hypot(1, 0.6), 1e-14);
  EXPECT_NEAR(state.smallest_eigenvalue, 0.6, 1e-14);
  EXPECT_EQ(state.negative_eigenvalues, 0);
}

TEST(BranchState, NoEquilibriumAboveAFold) {
  Model model(fold());
  EXPECT_FALSE(model.in_plane({0.4, 0.3}, load_axis(1)));
}

TEST(BranchEvents, LimitPointOfAFold) {
  Model model(fold());
  const BranchState here = model.at({0.3}, 0.21);    // x = 0.3
  const BranchState beyond = model.at({0.6}, 0.24);  // x = 0.6
  NewtonSolver newton(limit_point_unknowns(1));
  const auto limit = locate_limit_point(model.equations, newton, limit_point_guess(here, beyond));
  ASSERT_TRUE(limit);
  EXPECT_EQ(limit->kind, CriticalKind::limit_point);
  EXPECT_NEAR(limit->x[0], 0.5, 1e-12);
  EXPECT_NEAR(limit->x[1], 0.25, 1e-15);
  EXPECT_TRUE(lies_between(limit->x, here, beyond));
  EXPECT_FALSE(lies_between({0.9, 0.25}, here, beyond));
  EXPECT_TRUE(is_connected(here, limit->x, 1, model.correct()));
}

TEST(BranchEvents, ALimitPointBehindAGapIsNotConnected) {
  // The load rises, falls and rises again, so that the chord to its third extremum leaves the
  // branch.
  Model model(scalar([](double x) { return x + std::sin(4 * x); },
                     [](double x) { return 1 + 4 * std::cos(4 * x); }));
  const BranchState here = model.at({0.1}, 0.1 + std::sin(0.4));
  // The third extremum of the load; a maximum and a minimum lie before it.
  const double third = (2 * std::acos(-1.0) + std::acos(-0.25)) / 4;
  EXPECT_FALSE(is_connected(here, {third, third + std::sin(4 * third)}, 1, model.correct()));
}

TEST(BranchEvents, LandsBetweenHereAndALimitPoint) {
  Model model(fold());
  const BranchState here = model.at({0.4}, 0.24);  // x = 0.4
  for (const double left : {1e-3, 1e-6, 1e-9}) {
    const auto landed = landed_before(here, {0.5, 0.25}, 0.25 - left, 1, model.correct());
    ASSERT_TRUE(landed) << left;
    EXPECT_NEAR(landed->x[0], 0.5 - std::sqrt(left), 1e-11) << left;
    EXPECT_GT(landed->smallest_eigenvalue, 0) << left;
  }
}

TEST(BranchEvents, BifurcationOfAStrut) {
  for (const bool suppressed : {false, true}) {
    Model model(strut(suppressed));
    const BranchState here = model.at({2}, 2);
    const BranchState beyond = model.at({4.5}, 4.5);
    EXPECT_EQ(here.negative_eigenvalues, 0);
    EXPECT_EQ(beyond.negative_eigenvalues, 1);
    const int n = model.equations.size;
    const auto found = bifurcation_between(here, beyond, n, model.correct());
    ASSERT_TRUE(found) << suppressed;
    EXPECT_EQ(found->kind, CriticalKind::bifurcation);
    EXPECT_NEAR(found->x[n], 3, 1e-11);
    EXPECT_NEAR(found->x[0], 3, 1e-11);
    EXPECT_LT(found->pressure_error, 1e-12);
  }
}

TEST(BranchEvents, ClosureOfABore) {
  // P = x + x^2/4 under suction; closed at x = -0.999.
  Model model(
      scalar([](double x) { return x + 0.25 * x * x; }, [](double x) { return 1 + 0.5 * x; }));
  const double expected = closed_bore + 0.25 * closed_bore * closed_bore;
  const BranchState here = model.at({-0.9}, -0.9 + 0.25 * 0.81);
  const BranchState beyond = model.at({-1.2}, -1.2 + 0.25 * 1.44);
  const auto closed = closed_from(closure_guess(here, beyond, 1), 1, model.correct());
  ASSERT_TRUE(closed);
  EXPECT_EQ(closed->x[0], closed_bore);
  EXPECT_NEAR(closed->x[1], expected, 1e-15);
  // A residual r is made good by as much load.
  BalanceAt finer = closed->balance;
  finer.residual[0] = 1e-6;
  EXPECT_NEAR(closure_error(*closed, finer, 1), 1e-6 / std::abs(expected), 1e-12);
}

TEST(BranchEvents, AsymptoteOfALoadWithABound) {
  // P = x/(1 + x) tends to 1: at x = 1000 it is 1/1001 away.
  Model model(scalar([](double x) { return x / (1 + x); },
                     [](double x) { return 1 / ((1 + x) * (1 + x)); }));
  const BranchState far = model.in_plane({1000, 0.999}, {1, 0}).value();
  const CriticalState asymptote = asymptote_at(far, 1);
  EXPECT_EQ(asymptote.kind, CriticalKind::asymptote);
  EXPECT_NEAR(asymptote.x[1], 1000.0 / 1001, 1e-15);
  EXPECT_NEAR(asymptote.pressure_error, 1.0 / 1001, 1e-5);
  // P = ln(1 + x) has no bound.
  Model unbounded(
      scalar([](double x) { return std::log1p(x); }, [](double x) { return 1 / (1 + x); }));
  const BranchState rising = unbounded.in_plane({1000, 7}, {1, 0}).value();
  EXPECT_GT(asymptote_at(rising, 1).pressure_error, 0.1);
}

TEST(StepControl, StepsCountByTheirContraction) {
  Model model(fold());
  const BranchState here = model.at({0.1}, 0.09);
  const auto step = [&](double length) {
    BranchPoint start = here.x;
    for (int i = 0; i < 2; ++i) start[i] += length * here.tangent[i];
    return judged_step(here, start, model.in_plane(start, here.tangent), 1);
  };
  EXPECT_TRUE(step(0.05).accepted);
  EXPECT_FALSE(step(0.5).accepted);  // past the fold the tangent has turned too far
  // The correction goes with the square of the step.
  EXPECT_NEAR(step(0.02).contraction / step(0.01).contraction, 2, 0.1);
  EXPECT_FALSE(judged_step(here, here.x, std::nullopt, 1).accepted);
}

TEST(StepControl, LengthsFollowTheContraction) {
  EXPECT_DOUBLE_EQ(lengthened(1, 0.08), 1);
  EXPECT_DOUBLE_EQ(lengthened(1, 0.04), 2);
  EXPECT_DOUBLE_EQ(lengthened(1, 0), 4);
  EXPECT_DOUBLE_EQ(lengthened(1, 10), 0.5);
  EXPECT_DOUBLE_EQ(shortened(1, 0.2), 0.4);
  EXPECT_DOUBLE_EQ(shortened(1, 0.01), 0.5);
  EXPECT_DOUBLE_EQ(shortened(1, 100), 0.1);
  EXPECT_DOUBLE_EQ(longest_step({0.1, 0.2}, 1), 0.5);
  EXPECT_DOUBLE_EQ(longest_step({99, 0.2}, 1), 25);
}

TEST(StepControl, ASlopeThatDipsMayVanish) {
  EXPECT_FALSE(slope_may_vanish(1, 1, 1));
  EXPECT_FALSE(slope_may_vanish(1, 2, 1.5));
  EXPECT_TRUE(slope_may_vanish(1, 1, 0.5));
  EXPECT_TRUE(slope_may_vanish(-1, -1, -0.5));
  EXPECT_TRUE(slope_may_vanish(1, 9, 5));
}

TEST(LimitPointBetween, FindsTheFold) {
  Model model(fold());
  const auto here = model.in_plane({0.3, 0.21}, load_axis(1));
  const auto beyond = model.in_plane({0.65, 0.2275}, {1, 0});
  ASSERT_TRUE(here && beyond);
  const auto limit = limit_point_between(model.equations, *here, *beyond, model.correct());
  ASSERT_TRUE(limit);
  EXPECT_EQ(limit->kind, CriticalKind::limit_point);
  EXPECT_NEAR(limit->x[1], 0.25, 1e-6);
  EXPECT_NEAR(limit->x[0], 0.5, 1e-3);
}

}  // namespace
}  // namespace latticast::testing
