// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/mesh_checks.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "checks/bed_check.h"
#include "checks/lattice_use.h"
#include "design/text/written_number.h"
#include "geometry/mesh/disjoint_sets.h"
#include "geometry/mesh/weld.h"
#include "geometry/solid/audit.h"
#include "geometry/solid/part_overlap.h"
#include "geometry/solid/wall_thickness.h"

namespace latticast {
namespace {

struct DefectCode {
  Defect defect;
  std::string_view code;
  std::string_view what;
  std::string_view remedy;
};

constexpr std::array defect_codes = {
    DefectCode{Defect::not_finite, "mesh-not-finite",
               "vertices with a coordinate that is not a finite number",
               "export the file again: numbers were lost"},
    DefectCode{Defect::degenerate, "mesh-degenerate", "triangles without area",
               "remove them, and join the vertices that they stood between"},
    DefectCode{Defect::open_edge, "mesh-open-edge", "edges with one triangle only",
               "close the holes: a slicer guesses what is inside"},
    DefectCode{Defect::crowded_edge, "mesh-crowded-edge", "edges with more than two triangles",
               "unite the bodies that meet there, or move them apart"},
    DefectCode{Defect::inconsistent_edge, "mesh-inconsistent-edge",
               "edges whose two triangles face opposite sides", "orient all faces outwards"},
    DefectCode{Defect::pinched_vertex, "mesh-pinched-vertex",
               "vertices in which the surface touches itself",
               "move the surfaces apart, or join them by more than a point"},
    DefectCode{Defect::self_intersection, "mesh-self-intersection", "triangles that cross others",
               "unite the bodies before the export"},
    DefectCode{Defect::inside_out, "mesh-inside-out", "bodies that face the wrong way",
               "turn their faces around"},
};

std::string place_text(const Point& p) {
  return fmt::format("x {:.3f}, y {:.3f}, z {:.3f} mm", p[0], p[1], p[2]);
}

void check_defects(const Audit& found, const std::string& name, CheckFindings& findings) {
  for (const DefectCode& entry : defect_codes) {
    const std::size_t count = found.count(entry.defect);
    if (count == 0) continue;
    CheckFinding finding = check_finding(entry.code);
    finding.part = name;
    finding.value = static_cast<double>(count);
    finding.limit = 0;
    finding.message = fmt::format("{}: {}", entry.what, count);
    const auto first = std::find_if(found.findings.begin(), found.findings.end(),
                                    [&](const Finding& f) { return f.defect == entry.defect; });
    if (first != found.findings.end()) {
      finding.message +=
          fmt::format("; the first at {}, triangle {}", place_text(first->where), first->triangle);
    }
    finding.remedy = entry.remedy;
    findings.push_back(std::move(finding));
  }
}

struct Body {
  double volume_mm3 = 0;
  Point first{};
};

std::vector<Body> bodies_of(const TriangleMesh& mesh) {
  DisjointSets connected(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles) {
    connected.join(t[1], t[0]);
    connected.join(t[2], t[0]);
  }
  std::vector<std::size_t> body(mesh.vertices.size(), SIZE_MAX);
  std::vector<Body> bodies;
  for (const Triangle& t : mesh.triangles) {
    const Point& a = mesh.vertices[t[0]];
    const Point& b = mesh.vertices[t[1]];
    const Point& c = mesh.vertices[t[2]];
    std::size_t& index = body[connected.root(t[0])];
    if (index == SIZE_MAX) {
      index = bodies.size();
      bodies.push_back({0, a});
    }
    bodies[index].volume_mm3 +=
        (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0])) /
        6;
  }
  return bodies;
}

// In a sound mesh, only cavities face inwards.
void check_voids(const TriangleMesh& mesh, const std::string& name, CheckFindings& findings) {
  for (const Body& body : bodies_of(mesh)) {
    if (body.volume_mm3 >= 0) continue;
    CheckFinding finding = check_finding("enclosed-void");
    finding.part = name;
    finding.value = -body.volume_mm3;
    finding.limit = 0;
    finding.unit = "mm3";
    finding.message = fmt::format(
        "a cavity of {} mm3 has no way out, at {}: resin, powder or supports stay in it",
        written(-body.volume_mm3, 4), place_text(body.first));
    finding.remedy = "open it to the outside, or fill it";
    findings.push_back(std::move(finding));
  }
}

// The file has chords where a wall of just the limit was curved.
void check_walls(const TriangleMesh& mesh, const std::string& name, CheckFindings& findings) {
  const double limit = least_wall_mm(Printer{});
  const ThinWalls found = thin_walls(mesh, limit);
  if (!clearly_below(found.least_mm, (1 - chord_allowance) * limit)) return;
  CheckFinding finding = check_finding("mesh-thin-wall");
  finding.part = name;
  finding.value = found.least_mm;
  finding.limit = limit;
  finding.unit = "mm";
  finding.message = fmt::format(
      "walls of {} mm, the thinnest at {}; {} % of the surface bounds walls thinner than "
      "{} mm, two lines of a 0.4 mm nozzle (a file does not say its printer)",
      written(found.least_mm, 3), place_text(found.where),
      written(100 * found.thinner_mm2 / found.surface_mm2, 2), written(limit, 3));
  finding.remedy = fmt::format(
      "make them {} mm thick, or print with a process that makes such walls", written(limit, 3));
  findings.push_back(std::move(finding));
}

void check_size(const Audit& found, const std::string& name, CheckFindings& findings) {
  auto finding =
      bed_finding(name,
                  {found.highest[0] - found.lowest[0], found.highest[1] - found.lowest[1],
                   found.highest[2] - found.lowest[2]},
                  usual_bed_mm);
  if (!finding) return;
  finding->severity = Severity::warning;
  finding->remedy =
      "check that the file is in mm; divide the part, turn it or use a larger printer";
  findings.push_back(std::move(*finding));
}

Audit check_object(const TriangleMesh& mesh, const std::string& name, CheckFindings& findings) {
  const TriangleMesh welded = weld(mesh);
  Audit found = audit(welded);
  check_defects(found, name, findings);
  if (found.passes()) {
    check_walls(welded, name, findings);
    check_voids(welded, name, findings);
  }
  if (found.count(Defect::not_finite) == 0) check_size(found, name, findings);
  return found;
}

Point size_of(const std::vector<Audit>& objects) {
  Point lowest{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Point highest{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (const Audit& object : objects) {
    for (int axis = 0; axis < 3; ++axis) {
      lowest[axis] = std::min(lowest[axis], object.lowest[axis]);
      highest[axis] = std::max(highest[axis], object.highest[axis]);
    }
  }
  return {highest[0] - lowest[0], highest[1] - lowest[1], highest[2] - lowest[2]};
}

void check_unit(const std::vector<Audit>& objects, const std::string& name,
                CheckFindings& findings) {
  const std::string hint = unit_hint(objects);
  if (hint.empty()) return;
  const Point size = size_of(objects);
  CheckFinding finding = check_finding("mesh-too-small");
  finding.part = name;
  finding.value = *std::max_element(size.begin(), size.end());
  finding.limit = least_usual_size_mm;
  finding.unit = "mm";
  finding.message = hint;
  finding.remedy = "export it in millimetres, or scale it";
  findings.push_back(std::move(finding));
}

CheckFinding overlap_finding(const std::vector<MeshObject>& objects, const PartOverlap& overlap,
                             const std::string& name) {
  CheckFinding finding = check_finding("parts-overlap");
  finding.part = name;
  finding.value = overlap.depth_mm;
  finding.limit = contact_depth_mm;
  finding.unit = "mm";
  finding.message = fmt::format("{} and {} overlap, {} mm deep at {}; about {} mm3 belong to both",
                                title_of(objects, overlap.first), title_of(objects, overlap.second),
                                written(overlap.depth_mm, 2), place_text(overlap.where),
                                written(overlap.volume_mm3, 2));
  finding.remedy = "unite the parts, or move them apart";
  return finding;
}

}  // namespace

std::string unit_hint(const std::vector<Audit>& objects) {
  if (std::any_of(objects.begin(), objects.end(),
                  [](const Audit& object) { return object.count(Defect::not_finite) > 0; })) {
    return {};
  }
  const Point size = size_of(objects);
  const double longest = *std::max_element(size.begin(), size.end());
  if (!(longest >= 0 && longest < least_usual_size_mm)) return {};
  return fmt::format(
      "all of it measures {} x {} x {} mm: if its numbers are metres, the longest side is {} mm, "
      "if "
      "inches, {} mm",
      written(size[0], 3), written(size[1], 3), written(size[2], 3), written(1000 * longest, 3),
      written(25.4 * longest, 3));
}

CheckFindings mesh_checks(const std::vector<MeshObject>& objects, const std::string& name) {
  CheckFindings findings;
  std::vector<Audit> audits;
  std::vector<bool> sound;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::string part = objects.size() == 1 ? name : name + " " + title_of(objects, i);
    audits.push_back(check_object(objects[i].mesh, part, findings));
    sound.push_back(audits.back().passes());
  }
  check_unit(audits, name, findings);
  constexpr std::size_t listed = 10;
  const PartOverlaps overlaps = overlapping_parts(objects, sound);
  for (std::size_t i = 0; i < std::min(listed, overlaps.found.size()); ++i) {
    findings.push_back(overlap_finding(objects, overlaps.found[i], name));
  }
  return findings;
}

CheckFindings mesh_checks(TriangleMesh mesh, const std::string& name) {
  return mesh_checks(std::vector<MeshObject>{{"", std::move(mesh)}}, name);
}

}  // namespace latticast
