// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of numbers under named columns, written as table, CSV or JSON.
#pragma once

#include <string>
#include <vector>

namespace latticast {

struct NumberRows {
  std::vector<std::string> columns;       ///< names as CSV and JSON write them, with units
  std::vector<std::vector<double>> rows;  ///< one number for each column
};

/// Right-aligned columns for people, three decimals where a column is not all whole numbers.
std::string rows_as_table(const NumberRows& numbers);

/// A line of names, then a line a row; numbers in their shortest exact form.
std::string rows_as_csv(const NumberRows& numbers);

/// A list of objects, one a row.
std::string rows_as_json(const NumberRows& numbers);

/// In the format that --format names: "table", "csv" or "json".
std::string rows_as(const std::string& format, const NumberRows& numbers);

}  // namespace latticast
