// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/number_rows.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "design/joined.h"

namespace latticast {
namespace {

bool is_whole(double number) {
  return number == std::round(number) && std::abs(number) < 1e6;
}

// Columns of whole numbers only, such as counts and round pressures, need no decimals.
std::vector<int> decimals_of(const NumberRows& numbers) {
  std::vector<int> decimals(numbers.columns.size(), 0);
  for (const std::vector<double>& row : numbers.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (!is_whole(row[i])) decimals[i] = 3;
    }
  }
  return decimals;
}

std::string for_people(double number, int decimals) {
  // "-0.000" says no more than "0.000".
  return fmt::format("{:.{}f}", std::abs(number) < 5e-4 ? 0 : number, decimals);
}

}  // namespace

std::string rows_as_table(const NumberRows& numbers) {
  const std::vector<int> decimals = decimals_of(numbers);
  std::vector<std::vector<std::string>> cells;
  std::vector<std::size_t> widths;
  for (const std::string& column : numbers.columns) widths.push_back(column.size());
  for (const std::vector<double>& row : numbers.rows) {
    cells.emplace_back();
    for (std::size_t i = 0; i < row.size(); ++i) {
      cells.back().push_back(for_people(row[i], decimals[i]));
      widths[i] = std::max(widths[i], cells.back().back().size());
    }
  }
  cells.insert(cells.begin(), numbers.columns);
  std::string text;
  for (const std::vector<std::string>& line : cells) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      text += fmt::format("{}{:>{}}", i == 0 ? "" : "  ", line[i], widths[i]);
    }
    text += "\n";
  }
  return text;
}

std::string rows_as_csv(const NumberRows& numbers) {
  std::string text = joined(numbers.columns, ",") + "\n";
  for (const std::vector<double>& row : numbers.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += fmt::format("{}{}", i == 0 ? "" : ",", row[i]);
    }
    text += "\n";
  }
  return text;
}

}  // namespace latticast
