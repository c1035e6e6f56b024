// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/mesh_checks.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "checks/bed_check.h"
#include "checks/lattice_use.h"
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
        "a cavity of {:.4g} mm3 has no way out, at {}: resin, powder or supports stay in it",
        -body.volume_mm3, place_text(body.first));
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
      "walls of {:.3g} mm, the thinnest at {}; {:.2g} % of the surface bounds walls thinner than "
      "{:.3g} mm, two lines of a 0.4 mm nozzle (a file does not say its printer)",
      found.least_mm, place_text(found.where), 100 * found.thinner_mm2 / found.surface_mm2, limit);
  finding.remedy = fmt::format(
      "make them {:.3g} mm thick, or print with a process that makes such walls", limit);
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

// Says whether the object is sound.
bool check_object(const TriangleMesh& mesh, const std::string& name, CheckFindings& findings) {
  const TriangleMesh welded = weld(mesh);
  const Audit found = audit(welded);
  check_defects(found, name, findings);
  if (found.passes()) {
    check_walls(welded, name, findings);
    check_voids(welded, name, findings);
  }
  if (found.count(Defect::not_finite) == 0) check_size(found, name, findings);
  return found.passes();
}

CheckFinding overlap_finding(const std::vector<MeshObject>& objects, const PartOverlap& overlap,
                             const std::string& name) {
  CheckFinding finding = check_finding("parts-overlap");
  finding.part = name;
  finding.value = overlap.depth_mm;
  finding.limit = contact_depth_mm;
  finding.unit = "mm";
  finding.message = fmt::format(
      "{} and {} overlap, {:.2g} mm deep at {}; {:.2g} mm3 belong to both, and a slicer gives them "
      "to "
      "one or to both",
      title_of(objects, overlap.first), title_of(objects, overlap.second), overlap.depth_mm,
      place_text(overlap.where), overlap.volume_mm3);
  finding.remedy = "unite the parts, or move them apart";
  return finding;
}

}  // namespace

CheckFindings mesh_checks(const std::vector<MeshObject>& objects, const std::string& name) {
  CheckFindings findings;
  std::vector<bool> sound;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::string part = objects.size() == 1 ? name : name + " " + title_of(objects, i);
    sound.push_back(check_object(objects[i].mesh, part, findings));
  }
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
