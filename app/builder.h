// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the parts that a plan names, and proves each file before any appears.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/console.h"

namespace latticast {

struct CheckFinding;
struct Design;
struct Plan;
struct PreparedDesign;

/// A mesh that this program made fails its own audit: nothing is delivered.
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

/// Makes everything in the plan; the files appear in the folder together, or not at all. Returns
/// the list of files, for people: a line each. Throws AuditFailed, Interrupted (which says how many
/// files were ready), FileError, UnsupportedDesign, GeometryError, CannotDraw, CannotMold,
/// NoEquilibrium.
std::string build_parts(const BuildOrder& order, const Console& console);

}  // namespace latticast
