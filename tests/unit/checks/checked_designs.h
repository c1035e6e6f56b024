// SPDX-License-Identifier: GPL-3.0-or-later
// Designs that tests of checks start from.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "checks/casting_checks.h"
#include "checks/check_finding.h"
#include "checks/load_checks.h"
#include "checks/print_checks.h"
#include "design/design.h"
#include "prepared/prepared_design.h"

namespace latticast {

inline constexpr double test_pi = std::numbers::pi;

/// The paper's twisting segment: liner 12-16, lattice 16-18, 8 rings and 8 strands of 2 mm at 36
/// degrees on 85 mm.
inline Segment twisting_segment() {
  Segment segment;
  segment.length_mm = 85;
  segment.liner = {12, 4, {}};
  segment.lattice.emplace();
  segment.lattice->thickness_mm = 2;
  segment.lattice->rings = Rings{8, std::nullopt, 2};
  segment.lattice->grids.push_back({36, std::vector<double>(8, 2.0), StraightPath{}});
  return segment;
}

inline Design printed(const Segment& segment) {
  Design design;
  design.segments.push_back(segment);
  design.make.lattice = true;
  return design;
}

inline Design cast(const Segment& segment) {
  Design design;
  design.segments.push_back(segment);
  design.make.lattice_mold.emplace();
  return design;
}

inline std::vector<CheckFinding> with_code(const CheckFindings& findings, std::string_view code) {
  std::vector<CheckFinding> found;
  for (const CheckFinding& finding : findings) {
    if (finding.code == code) found.push_back(finding);
  }
  return found;
}

inline CheckFindings findings_in_print(const Design& design) {
  PreparedDesign prepared(design);
  return print_checks(design, prepared.lattices);
}

inline CheckFindings findings_in_casting(const Design& design) {
  PreparedDesign prepared(design);
  return casting_checks(design, prepared.lattices, prepared.molds);
}

inline CheckFindings findings_under_load(const Design& design) {
  PreparedDesign prepared(design);
  return load_checks(prepared.responses);
}

/// The number behind `key` in a remedy; nothing where it does not name the key.
inline std::optional<double> remedy_value(const CheckFinding& finding, const std::string& key) {
  const std::size_t at = finding.remedy.find(key + " = ");
  if (at == std::string::npos) return std::nullopt;
  return std::stod(finding.remedy.substr(at + key.size() + 3));
}

}  // namespace latticast
