// SPDX-License-Identifier: GPL-3.0-or-later
// Loss of Drucker stability against closed forms and against the stress curves themselves.
#include "design/material/drucker.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/design/material/literal_laws.h"

namespace latticast::testing {
namespace {

/// Second differences of the author's formula by the logarithms of both stretches, long double.
bool is_stable_by_differences(const Law& law, long double stretch_1, long double stretch_2) {
  const long double h = 1e-4L;
  const auto w = [&](int i, int j) {
    const long double a = stretch_1 * std::exp(i * h);
    const long double b = stretch_2 * std::exp(j * h);
    return literal_energy(law, {a, b, 1 / (a * b)});
  };
  const long double h11 = w(1, 0) - 2 * w(0, 0) + w(-1, 0);
  const long double h22 = w(0, 1) - 2 * w(0, 0) + w(0, -1);
  const long double h12 = (w(1, 1) - w(1, -1) - w(-1, 1) + w(-1, -1)) / 4;
  return h11 > 0 && h11 * h22 > h12 * h12;
}

TEST(Drucker, MatrixIsThatOfTheFormula) {
  const std::vector<Law> laws = {NeoHookean{0.08}, Yeoh{0.04, -0.004, 0}, Yeoh{0.04, -0.004, 2e-4},
                                 Gent{0.08, 30}};
  int unstable = 0;
  for (const Law& law : laws) {
    for (const double a : {0.6, 1.0, 1.4, 2.0, 2.7}) {
      for (const double b : {0.7, 1.0, 1.4, 1.9}) {
        EXPECT_EQ(is_drucker_stable(law, a, b), is_stable_by_differences(law, a, b))
            << law_text(law) << " at " << a << ", " << b;
        unstable += !is_drucker_stable(law, a, b);
      }
    }
  }
  EXPECT_GT(unstable, 5);
}

TEST(Drucker, ConvexLawsNeverLoseIt) {
  EXPECT_FALSE(drucker_loss(NeoHookean{0.08}, 8));
  EXPECT_FALSE(drucker_loss(Yeoh{0.04, 0.002, 1e-4}, 8));
  EXPECT_FALSE(drucker_loss(Linear{0.24, 0.5}, 8));
  // Up to its limit, which is at a stretch of about 2.9 in uniaxial tension.
  EXPECT_FALSE(drucker_loss(Gent{0.08, 6}, 8));
}

/// Yeoh with c3 = 0: at the loss the matrix is singular, and it is the first of the three tests.
TEST(Drucker, LossIsFoundWhereTheMatrixIsSingular) {
  const Law law = Yeoh{0.04, -0.003, 0};
  const auto loss = drucker_loss(law, 5);
  ASSERT_TRUE(loss);
  EXPECT_EQ(loss->test, "equibiaxial tension");
  EXPECT_TRUE(is_drucker_stable(law, loss->stretch - 1e-7, loss->stretch - 1e-7));
  EXPECT_FALSE(is_drucker_stable(law, loss->stretch + 1e-7, loss->stretch + 1e-7));
  EXPECT_FALSE(drucker_loss(law, loss->stretch - 1e-6));
  for (double s = 1; s < loss->stretch; s += 0.01) {
    EXPECT_TRUE(is_stable_by_differences(law, s, 1 / std::sqrt(s)));
    EXPECT_TRUE(is_stable_by_differences(law, s, 1));
  }
}

}  // namespace
}  // namespace latticast::testing
