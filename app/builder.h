// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the parts that a plan names, and proves each file before any appears.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/product_failure.h"

namespace latticast {

struct CheckFinding;
struct Design;
struct Plan;
struct PreparedDesign;

/// A mesh that this program made fails its own audit: it is not delivered.
struct AuditFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct BuildOrder {
  const Design& design;
  PreparedDesign& prepared;  ///< of the design: what the checks have left there is used
  const Plan& plan;
  const std::vector<CheckFinding>& findings;  ///< for the report
  std::filesystem::path folder;
  bool times_in_report = false;  ///< its JSON then differs from run to run
};

struct BuildResult {
  std::string files;              ///< the list of them, for people: a line each
  std::vector<Failure> failures;  ///< of products that were not made
};

/// Makes everything in the plan. A product that cannot be made leaves none of its files, and the
/// others are made all the same; their files appear in the folder together, or not at all. Throws
/// Interrupted (which says how many files were ready) and FileError.
BuildResult build_parts(const BuildOrder& order, const Console& console);

}  // namespace latticast
