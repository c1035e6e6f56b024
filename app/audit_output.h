// SPDX-License-Identifier: GPL-3.0-or-later
// What an audit found, for people.
#pragma once

#include <string>

#include "geometry/solid/audit.h"

namespace latticast {

/// "closed, 1 piece, genus 57, 7174.51 mm3, 11870 triangles", for a mesh that passes.
std::string audit_summary(const Audit& audit);

/// Each kind of defect with its number and the first places, a line each, indented; empty for a
/// mesh that passes.
std::string audit_findings(const Audit& audit);

}  // namespace latticast
