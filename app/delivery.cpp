// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/delivery.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "app/audit_output.h"
#include "app/builder.h"
#include "app/file_error.h"
#include "design/design.h"
#include "design/text/written_number.h"
#include "export/mesh/mesh_file.h"
#include "files/atomic_file.h"
#include "geometry/mesh/weld.h"
#include "geometry/solid/tube_solids.h"

namespace latticast {
namespace {

void prove(const std::string& file, const Part& part, const Solid& solid, const Audit& result) {
  const bool touches = part.touches_itself && result.has_only(Defect::self_intersection);
  if (!result.passes() && !touches) {
    throw AuditFailed(
        fmt::format("{} fails its audit and was not written:\n{}", file, audit_findings(result)));
  }
  if (result.components != solid.pieces || result.genus != solid.genus) {
    throw AuditFailed(
        fmt::format("{} has {} pieces and genus {}, its pattern has {} and {}; it was not written",
                    file, result.components, result.genus, solid.pieces, solid.genus));
  }
  if (solid.volume_mm3 > 0 &&
      std::abs(result.volume_mm3 - solid.volume_mm3) > solid.volume_bound_mm3) {
    throw AuditFailed(fmt::format("{} has {} mm3, its pattern {}; it was not written", file,
                                  result.volume_mm3, solid.volume_mm3));
  }
}

}  // namespace

std::string part_name(const Design& design, std::size_t segment, std::string_view part) {
  if (design.segments.size() == 1) return fmt::format("{}-{}", design.name, part);
  return fmt::format("{}-segment-{}-{}", design.name, segment + 1, part);
}

Delivery::Delivery(const Design& design, const std::filesystem::path& folder,
                   const Console& console)
    : design_(design), console_(console), progress_(console), staging_(folder) {}

void Delivery::expect_meshes(std::size_t count) {
  progress_.expect(static_cast<int>(count * (1 + 2 * design_.output.formats.size())));
}

std::string Delivery::part_name(std::size_t segment, std::string_view part) const {
  return latticast::part_name(design_, segment, part);
}

bool Delivery::writes(MeshFormat format) const {
  const std::vector<MeshFormat>& formats = design_.output.formats;
  return std::find(formats.begin(), formats.end(), format) != formats.end();
}

std::filesystem::path Delivery::add_file(const std::string& name) {
  ++ready_;
  list_file(name);
  return staging_.add(name);
}

void Delivery::tell_of_contact(const Part& part, const Audit& result) {
  const Point& at = result.findings.front().where;
  tell(
      fmt::format("{}: touches itself, first at x {}, y {}, z {}; contact is not modelled, and the "
                  "shape runs through itself there\n",
                  part.stem, written(at[0], 4), written(at[1], 4), written(at[2], 4)));
}

void Delivery::write_listed(const std::string& name, const std::string& bytes) {
  write_file_atomically(staging_.add(name), bytes);
  ++ready_;
}

void Delivery::deliver(const Part& part, const Solid& solid, const Audit* known) {
  std::vector<std::string> files;
  // Most formats keep the mesh bit for bit: what was proved of it, or of one file, holds for the
  // next.
  TriangleMesh proved = known != nullptr ? weld(solid.mesh) : TriangleMesh{};
  Audit result = known != nullptr ? *known : Audit{};
  if (known != nullptr) prove(part.stem, part, solid, result);
  for (const MeshFormat format : design_.output.formats) {
    const std::string file = part.stem + std::string(extension(format));
    const std::filesystem::path path = staging_.add(file);
    progress_.begin("writing " + file);
    write_mesh(path, solid.mesh, format, {part.colour, part.vertex_colours, part.vertex_strains});
    progress_.begin("proving " + file);
    TriangleMesh in_file = weld(read_mesh(path));
    if (proved.triangles.empty() || !same_triangles(in_file, proved)) {
      result = audit(in_file);
      prove(file, part, solid, result);
      proved = std::move(in_file);
    }
    summary_ += fmt::format("{}: {}, {}\n", file, audit_summary(result),
                            describe(error_of_file(solid, result)));
    files.push_back(file);
    ++ready_;
  }
  if (part.touches_itself && !result.passes()) tell_of_contact(part, result);
  delivered_.files.insert(delivered_.files.end(), files.begin(), files.end());
  if (!part.kind.empty()) {
    record({.name = part.stem,
            .kind = part.kind,
            .segment = part.segment,
            .files = files,
            .material = part.material,
            .volume_mm3 = result.volume_mm3,
            .prints = part.prints,
            .mesh = DeliveredMesh{result, error_of_file(solid, result)}});
  }
  note_time(part.stem);
}

Delivery::Mark Delivery::mark() const {
  return {staging_.count(), delivered_.files.size(), delivered_.pieces.size(), summary_.size(),
          ready_};
}

void Delivery::take_back(const Mark& mark) {
  staging_.take_back(mark.staged);
  delivered_.files.resize(mark.files);
  delivered_.pieces.resize(mark.pieces);
  summary_.resize(mark.summary);
  ready_ = mark.ready;
}

void Delivery::note_time(const std::string& stage) {
  const auto now = std::chrono::steady_clock::now();
  const double seconds = std::chrono::duration<double>(now - since_).count();
  console_.note(fmt::format("{}: {:.2f} s", stage, seconds));
  since_ = now;
  delivered_.seconds.emplace_back(stage, seconds);
}

}  // namespace latticast
