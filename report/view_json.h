// SPDX-License-Identifier: GPL-3.0-or-later
// What the report's page reads of its view.
#pragma once

#include <string>
#include <vector>

namespace latticast {

struct CheckFinding;
struct Design;
struct ReportView;

/// The view without its meshes, as the report's page reads it (docs/report.md): states with the far
/// end's place, load cases, and a place for every finding that has one.
std::string view_json(const ReportView& view, const Design& design,
                      const std::vector<CheckFinding>& findings);

}  // namespace latticast
