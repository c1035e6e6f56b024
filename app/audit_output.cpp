// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/audit_output.h"

#include <algorithm>

#include <fmt/core.h>

#include "checks/mesh_checks.h"
#include "design/text/written_number.h"

namespace latticast {

std::string audit_summary(const Audit& audit) {
  return fmt::format("closed, {} piece{}, genus {}, {} mm3, {} triangles", audit.components,
                     audit.components == 1 ? "" : "s", audit.genus, written(audit.volume_mm3, 6),
                     audit.triangles);
}

std::string audit_findings(const Audit& audit) {
  std::string text;
  for (std::size_t i = 0; i < audit.findings.size(); ++i) {
    const Finding& finding = audit.findings[i];
    if (i == 0 || audit.findings[i - 1].defect != finding.defect) {
      text += fmt::format("  {}: {}\n", name(finding.defect), audit.count(finding.defect));
    }
    text +=
        fmt::format("    at x {}, y {}, z {} (triangle {})\n", written(finding.where[0], 6),
                    written(finding.where[1], 6), written(finding.where[2], 6), finding.triangle);
  }
  if (!audit.searched_intersections) {
    text += "  self-intersections were not searched: not every coordinate is finite\n";
  }
  return text;
}

namespace {

Audit sum_of(const std::vector<Audit>& audits) {
  Audit sum;
  for (const Audit& audit : audits) {
    sum.triangles += audit.triangles;
    sum.components += audit.components;
    sum.genus += audit.genus;
    sum.volume_mm3 += audit.volume_mm3;
  }
  return sum;
}

std::string overlap_notes(const std::vector<MeshObject>& objects, const PartOverlaps& overlaps) {
  constexpr std::size_t listed = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(listed, overlaps.found.size()); ++i) {
    const PartOverlap& overlap = overlaps.found[i];
    text += fmt::format(
        "  note: {} and {} overlap, {} mm deep at x {}, y {}, z {}; "
        "about {} mm3 belong to both\n",
        title_of(objects, overlap.first), title_of(objects, overlap.second),
        written(overlap.depth_mm, 2), written(overlap.where[0], 6), written(overlap.where[1], 6),
        written(overlap.where[2], 6), written(overlap.volume_mm3, 2));
  }
  if (overlaps.found.size() > listed) {
    text += fmt::format("  note: {} pairs of parts overlap\n", overlaps.found.size());
  }
  if (!overlaps.searched_all) {
    text += "  note: there are too many parts to compare each with each\n";
  }
  return text;
}

}  // namespace

std::string audit_report(const std::string& file, const std::vector<MeshObject>& objects,
                         const std::vector<Audit>& audits, const PartOverlaps& overlaps) {
  const bool passes =
      std::all_of(audits.begin(), audits.end(), [](const Audit& a) { return a.passes(); });
  const Audit sum = sum_of(audits);
  const std::string parts = objects.size() == 1 ? "" : fmt::format("{} objects, ", objects.size());
  std::string text = passes ? fmt::format("pass {}: {}{}\n", file, parts, audit_summary(sum))
                            : fmt::format("FAIL {}: {}{} triangles\n", file, parts, sum.triangles);
  for (std::size_t i = 0; i < audits.size(); ++i) {
    if (audits[i].passes()) continue;
    if (objects.size() > 1) text += fmt::format("  {}:\n", title_of(objects, i));
    text += audit_findings(audits[i]);
  }
  const std::string hint = unit_hint(audits);
  if (!hint.empty()) text += "  note: " + hint + "\n";
  return text + overlap_notes(objects, overlaps);
}

}  // namespace latticast
