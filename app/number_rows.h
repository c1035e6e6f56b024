// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of numbers under named columns, written as table or CSV.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace latticast {

/// A row that would be there if there were an equilibrium.
struct MissingRow {
  std::vector<std::pair<std::string, double>> of;  ///< as in the columns: segment 2, 30 kPa
  std::string reason;
};

struct NumberRows {
  std::vector<std::string> columns;       ///< names as CSV and JSON write them, with units
  std::vector<std::vector<double>> rows;  ///< one number for each column
  std::vector<MissingRow> missing = {};
};

/// Right-aligned columns for people, three decimals where a column is not all whole numbers.
std::string rows_as_table(const NumberRows& numbers);

/// A line of names, then a line a row; numbers in their shortest exact form.
std::string rows_as_csv(const NumberRows& numbers);

}  // namespace latticast
