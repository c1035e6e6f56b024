// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/text/written_number.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace latticast {
namespace {

TEST(WrittenNumber, HasNoExponentWherePeopleWriteNone) {
  EXPECT_EQ(written(100, 2), "100");
  EXPECT_EQ(written(99.6, 2), "100");
  EXPECT_EQ(written(0.0996, 2), "0.1");
  EXPECT_EQ(written(12345, 3), "12300");
  EXPECT_EQ(written(1234567.8, 6), "1234570");
  EXPECT_EQ(written(8e-6, 6), "0.000008");
  EXPECT_EQ(written(5.34e-6, 2), "0.0000053");
  EXPECT_EQ(written(-0.25, 3), "-0.25");
  EXPECT_EQ(written(0, 3), "0");
  EXPECT_EQ(written(-0.0, 3), "0");
  EXPECT_EQ(written(85, 6), "85");
  EXPECT_EQ(written(1.0 / 3, 4), "0.3333");
}

TEST(WrittenNumber, HasOneWhereNobodyWouldReadIt) {
  EXPECT_EQ(written(1.25e15, 3), "1.25e+15");
  EXPECT_EQ(written(9.996e14, 3), "1e+15");
  EXPECT_EQ(written(2e-12, 2), "2e-12");
  EXPECT_EQ(written(std::numeric_limits<double>::max(), 2), "1.8e+308");
  EXPECT_EQ(written(HUGE_VAL, 3), "inf");
  EXPECT_EQ(written(-HUGE_VAL, 3), "-inf");
  EXPECT_EQ(written(std::nan(""), 3), "nan");
}

TEST(WrittenNumber, TellsADoubleByItsFewestDigits) {
  EXPECT_EQ(written(1e-5), "0.00001");
  EXPECT_EQ(written(1e6), "1000000");
  EXPECT_EQ(written(0.1), "0.1");
  EXPECT_EQ(written(-85.125), "-85.125");
  EXPECT_EQ(written(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(written(0), "0");
  EXPECT_EQ(written(1e300), "1e+300");
  EXPECT_EQ(written(std::nan("")), "nan");
}

/// It is the number that printf rounds to, in another form.
TEST(WrittenNumber, RoundsAsPrintfDoes) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 20000; ++trial) {
    const double value = std::ldexp(1 + 1e-9 * static_cast<double>(random() % 1000000000),
                                    static_cast<int>(random() % 90) - 40);
    const int digits = 1 + static_cast<int>(random() % 12);
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    EXPECT_EQ(std::stod(written(value, digits)), std::stod(text)) << value << " " << digits;
  }
}

}  // namespace
}  // namespace latticast
