// SPDX-License-Identifier: GPL-3.0-or-later
// What a check before fabrication has to say.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace latticast {

/// An error will spoil the part or makes its prediction void; a warning may, or costs work; a note
/// is good to know.
enum class Severity { note, warning, error };

std::string_view name(Severity severity);

/// A point of a segment's wall, in the material at rest.
struct CheckPlace {
  double theta_deg = 0;
  double z_mm = 0;
};

/// One finding: what is wrong, where, by how much, and what to write instead. Numbers are empty
/// where they mean nothing.
struct CheckFinding {
  std::string code;  ///< stable, one of all_check_codes()
  Severity severity = Severity::note;
  int segment = 0;   ///< from 1; 0: the design as a whole, or a file
  std::string part;  ///< "grid 0 strand 3", "rings", "liner", "lattice-mold shell-1", a file's name
  std::optional<CheckPlace> place;
  std::optional<double> pressure_kpa;  ///< at which it happens
  std::optional<double> value;
  std::optional<double> limit;
  std::string unit;     ///< of value and limit
  std::string message;  ///< a sentence, with the numbers
  std::string remedy;   ///< what to change, with a value that passes where there is one
};

using CheckFindings = std::vector<CheckFinding>;

bool has_error(const CheckFindings& findings);

/// One thing that can be found.
struct CheckCode {
  std::string_view code;
  Severity severity = Severity::note;
  std::string_view meaning;  ///< as a reader of the list wants it
};

/// Every code there is, in the order of the work: printing, casting, inflating, files.
std::span<const CheckCode> all_check_codes();

/// A finding of this code with the code's severity. Precondition: the code exists.
CheckFinding check_finding(std::string_view code);

/// Limits are inclusive: a value counts as below its limit only beyond rounding, so that one at the
/// limit passes.
bool clearly_below(double value, double limit);
bool clearly_above(double value, double limit);

}  // namespace latticast
