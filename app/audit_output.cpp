// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/audit_output.h"

#include <fmt/core.h>

namespace latticast {

std::string audit_summary(const Audit& audit) {
  return fmt::format("closed, {} piece{}, genus {}, {:.6g} mm3, {} triangles", audit.components,
                     audit.components == 1 ? "" : "s", audit.genus, audit.volume_mm3,
                     audit.triangles);
}

std::string audit_findings(const Audit& audit) {
  std::string text;
  for (std::size_t i = 0; i < audit.findings.size(); ++i) {
    const Finding& finding = audit.findings[i];
    if (i == 0 || audit.findings[i - 1].defect != finding.defect) {
      text += fmt::format("  {}: {}\n", name(finding.defect), audit.count(finding.defect));
    }
    text += fmt::format("    at x {:.6g}, y {:.6g}, z {:.6g} (triangle {})\n", finding.where[0],
                        finding.where[1], finding.where[2], finding.triangle);
  }
  if (!audit.searched_intersections) {
    text += "  self-intersections were not searched: not every coordinate is finite\n";
  }
  return text;
}

}  // namespace latticast
