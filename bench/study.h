// SPDX-License-Identifier: GPL-3.0-or-later
// What the studies share: a table that becomes CSV (for plots) and Markdown (for the page
// docs/error-and-run-time.md), processor time, and the exponent of a power law.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace latticast {

/// A number, or words. Numbers are written with three digits in Markdown and all digits in CSV.
using Cell = std::variant<double, std::string>;

/// The result of one study. Its name is also that of its files and of its place on the page.
class StudyTable {
 public:
  StudyTable(std::string name, std::vector<std::string> columns);

  /// One row, a cell for each column; anything else throws std::invalid_argument.
  void add(std::vector<Cell> row);

  /// Writes NAME.csv and, when `on_page`, NAME.md into a folder. Throws std::runtime_error when a
  /// file cannot be written.
  void write(const std::filesystem::path& folder, bool on_page = true) const;

 private:
  std::string name_;
  std::vector<std::string> columns_;
  std::vector<std::vector<Cell>> rows_;
};

/// Writes NAME.md: words that a study puts on the page, such as a sentence with its numbers.
void write_sentence(const std::filesystem::path& folder, const std::string& name,
                    const std::string& text);

/// The folder that a study was asked to write to: its only argument, made if missing. Ends the
/// program with status 2 and a usage line when it is not given.
std::filesystem::path study_folder(int count, char** arguments);

/// Processor seconds of one call, all threads: the least of three batches, each repeated until it
/// took `least_batch_s` (a longer call is a batch of its own, made once when over a second).
double processor_seconds(const std::function<void()>& call, double least_batch_s = 0.02);

/// The slope of log y over log x by least squares; at least two points, all positive.
double fitted_exponent(std::span<const double> x, std::span<const double> y);

/// Largest memory that this process has had so far, MB. Never falls: to compare cases, run each in
/// a process of its own (see in_own_process).
double peak_memory_mb();

/// What a call in a process of its own needed.
struct Cost {
  bool finished = false;  ///< false: it threw, crashed or needed more processor time than the limit
  double seconds = 0;     ///< processor time, user and system
  double memory_mb = 0;   ///< largest resident memory, the parent's share at the start included
  std::string result;     ///< what the call returned
};

/// Runs a call in a child process, so that its memory is its own and its end is known, whatever it
/// is. The child's result is carried back as text.
Cost in_own_process(const std::function<std::string()>& call, double limit_s = 60);

}  // namespace latticast
