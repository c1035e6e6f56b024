// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/builder.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "app/audit_output.h"
#include "app/file_error.h"
#include "app/flat_pattern.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "app/staging_folder.h"
#include "export/atomic_file.h"
#include "export/mesh/glb_file.h"
#include "export/mesh/mesh_file.h"
#include "export/mesh/three_mf_file.h"
#include "geometry/mesh/weld.h"
#include "geometry/solid/audit.h"
#include "geometry/solid/tube_solids.h"
#if LATTICAST_HAS_MOLDS
#include "app/mold_picture.h"
#include "app/mold_set.h"
#include "molds/print_size.h"
#endif
#if LATTICAST_HAS_PREDICT
#include "app/build_report.h"
#include "report/preview.h"
#endif

namespace latticast {
namespace {

// A mesh to be delivered, and what a report says of it.
struct Part {
  std::string stem;  // of its files
  std::string kind;  // empty: a preview, which is no piece of the actuator
  std::size_t segment = 0;
  const Material* material = nullptr;  // none for what the printer prints
  std::vector<Colour> colours = {};    // of the vertices, in formats that have them
};

class Builder {
 public:
  Builder(const BuildOrder& order, const Console& console)
      : order_(order),
        design_(order.design),
        plan_(order.plan),
        console_(console),
        progress_(console),
        staging_(order.folder) {
    double start = 0;
    for (const Segment& segment : design_.segments) {
      start_z_mm_.push_back(start);
      start += segment.length_mm;
    }
  }

  std::string run() {
    try {
      make_all();
      progress_.finish();
    } catch (const Interrupted&) {
      console_.end_progress();
      throw Interrupted(
          fmt::format("interrupted at {} %: {} files were ready and have been discarded; {} is as "
                      "it was before",
                      progress_.percent(), ready_, order_.folder.string()));
    }
    staging_.commit();
    return summary_;
  }

 private:
  void make_all() {
#if LATTICAST_HAS_MOLDS
    const bool any_mold = plan_.runs(Stage::lattice_mold) || plan_.runs(Stage::liner_mold);
    if (any_mold) progress_.begin("molds");
    const std::vector<PlannedMold> molds = make_molds(order_.prepared, plan_);
    for (const PlannedMold& planned : molds) {
      expect_meshes(planned.mold.pieces.size());
    }
    if (any_mold) note_time("molds, planned and meshed");
#endif
    expect_steps();
    for (std::size_t s = 0; s < design_.segments.size(); ++s) build_segment(s);
    if (together_.size() > 1) write_together();
#if LATTICAST_HAS_MOLDS
    for (const PlannedMold& planned : molds) build_mold(planned);
#endif
#if LATTICAST_HAS_PREDICT
    if (plan_.runs(Stage::preview)) build_preview();
    if (plan_.runs(Stage::report)) build_report();
#endif
  }

  // Each mesh is drawn, then written and proved in every format.
  void expect_meshes(std::size_t count) {
    progress_.expect(static_cast<int>(count * (1 + 2 * design_.output.formats.size())));
  }

  void expect_steps() {
    const std::size_t segments = design_.segments.size();
    if (plan_.runs(Stage::lattice)) expect_meshes(segments);
    if (plan_.runs(Stage::liner)) expect_meshes(segments);
    if (plan_.runs(Stage::flat_pattern)) progress_.expect(static_cast<int>(segments));
    if (plan_.runs(Stage::preview)) {
      expect_meshes(2 * segments * design_.make.preview->cases.size());
      progress_.expect(1);  // the picture
    }
    if (plan_.runs(Stage::report)) progress_.expect(3);
  }

  void build_segment(std::size_t s) {
    const Segment& segment = design_.segments[s];
    const SolidOptions options{design_.output.tolerance_mm, start_z_mm_[s], 0, 1};
    if (plan_.runs(Stage::lattice) && segment.lattice) {
      const Part part{part_name(s, "lattice"), "lattice", s, &segment.lattice->material};
      progress_.begin(part.stem);
      deliver_at_rest(part, lattice_solid(order_.prepared.lattices.of(s), options));
    }
    if (plan_.runs(Stage::liner)) {
      const Part part{part_name(s, "liner"), "liner", s, &segment.liner.material};
      progress_.begin(part.stem);
      deliver_at_rest(part, liner_solid(segment, options));
    }
    if (plan_.runs(Stage::flat_pattern)) build_flat_pattern(s);
  }

  void deliver_at_rest(const Part& part, const Solid& solid) {
    deliver(part, solid);
    if (writes(MeshFormat::three_mf)) together_.push_back({part.stem, solid.mesh});
  }

  // 3MF holds several parts in their places; each was proved in its own file.
  void write_together() {
    const std::string file = design_.name + ".3mf";
    write_three_mf(add_file(file), together_);
    summary_ += fmt::format("{}: {} parts in their places\n", file, together_.size());
  }

  void build_flat_pattern(std::size_t s) {
    const std::string stem = part_name(s, "flat");
    progress_.begin(stem);
    if (!design_.segments[s].lattice) {
      summary_ += fmt::format("{}: no flat pattern, the segment has no lattice\n", stem);
      return;
    }
    const FlatSheet sheet = flat_sheet(order_.prepared.lattices.of(s), design_.output.tolerance_mm);
    const FlatDrawing drawing = flat_drawing(design_, s, sheet);
    write_svg(add_file(stem + ".svg"), drawing);
    write_dxf(add_file(stem + ".dxf"), drawing);
    summary_ += fmt::format("{0}.svg, {0}.dxf: flat pattern, {1}\n", stem, describe(sheet));
    note_time(stem);
  }

#if LATTICAST_HAS_MOLDS
  void build_mold(const PlannedMold& planned) {
    const std::string stem = part_name(planned.segment, planned.kind);
    for (const MoldPiece& piece : planned.mold.pieces) {
      const Part part{stem + "-" + piece.name, planned.kind, planned.segment};
      progress_.begin(part.stem);
      Solid printed = piece.solid;
      printed.mesh = printing_pose(piece);
      deliver(part, printed);
    }
    write_png(add_file(stem + ".png"), exploded_picture(planned.mold));
    write_file_atomically(add_file(stem + ".md"), planned.procedure);
    record_pour(planned);
    summary_ += fmt::format("{}.md: pieces, assembly and pouring; {}.png: the mold taken apart\n",
                            stem, stem);
  }
#endif

#if LATTICAST_HAS_PREDICT
  void build_preview() {
    const std::vector<PreviewShape> shapes = predict_preview(order_.prepared.responses);
    PreviewParts parts;
    for (std::size_t s = 0; s < design_.segments.size(); ++s) {
      const SolidOptions options = preview_options(design_, s, start_z_mm_[s], shapes);
      if (design_.segments[s].lattice) preview_part(s, false, options, shapes, parts);
      preview_part(s, true, options, shapes, parts);
    }
    const std::string file = design_.name + "-preview.png";
    progress_.begin(file);
    write_png(add_file(file), preview_picture(parts.picture, shapes));
    summary_ += fmt::format("{}: {} shapes side by side\n", file, shapes.size());
    if (writes(MeshFormat::glb)) write_animation(parts.scene);
    note_time("preview, picture");
  }

  // All parts of a preview, for its picture and its animation.
  struct PreviewParts {
    std::vector<PicturePart> picture;
    Scene scene;
  };

  void write_animation(const Scene& scene) {
    const std::string file = design_.name + "-preview.glb";
    write_glb(add_file(file), scene);
    summary_ += fmt::format("{}: all of them, as an animation from rest\n", file);
  }

  void preview_part(std::size_t s, bool is_liner, const SolidOptions& options,
                    const std::vector<PreviewShape>& shapes, PreviewParts& parts) {
    const Segment& segment = design_.segments[s];
    const Solid rest = is_liner ? liner_solid(segment, options)
                                : lattice_solid(order_.prepared.lattices.of(s), options);
    const std::string kind = is_liner ? "liner" : "lattice";
    StrainColours colours;
    if (writes(MeshFormat::ply)) {
      colours = strain_colours(segment, s, is_liner, rest.mesh, options, shapes);
      summary_ += fmt::format("{}: colours in PLY from strain {:g} to {:g}\n",
                              part_name(s, "preview-" + kind), colours.ramp.low, colours.ramp.high);
    }
    SceneBody body{part_name(s, kind), rest.mesh,
                   is_liner ? preview_liner_colour : preview_lattice_colour};
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      Part part{part_name(s, fmt::format("preview-{}-{}", shapes[i].label, kind)), "", s};
      if (!colours.of_shape.empty()) part.colours = colours.of_shape[i];
      progress_.begin(part.stem);
      Solid moved{moved_mesh(rest.mesh, shapes[i].shape, s), 0, 0, rest.pieces, rest.genus};
      moved.error = moved_error(rest, moved.mesh, shapes[i].shape, s);
      if (shapes[i].shape.bend_rad(s) == 0) keep_volume(rest, moved);
      deliver(part, moved);
      body.targets.push_back({shapes[i].label, moved.mesh.vertices});
      parts.picture.push_back({std::move(moved.mesh), i, is_liner});
    }
    parts.scene.bodies.push_back(std::move(body));
    parts.scene.animated = true;
  }

  // The wall is incompressible; bending alone makes one side larger and the other smaller.
  static void keep_volume(const Solid& rest, Solid& moved) {
    moved.volume_mm3 = rest.volume_mm3;
    moved.volume_bound_mm3 = moved.error.volume_mm3;
    moved.error.volume_mm3 = rest.error.volume_mm3;
  }

  void build_report() {
    progress_.begin("report: response");
    predict_report(order_.prepared.responses, report_);
    note_time("report, response");
    progress_.begin("report: view");
    const ReportView view = make_view(order_.prepared, report_.curves ? &*report_.curves : nullptr);
    note_time("report, view");
    progress_.begin("report: page");
    complete_report(order_, report_);
    for (const ReportFile& file : report_files(report_, view, order_)) {
      write_file_atomically(staging_.add(file.name), file.bytes);
      summary_ += fmt::format("{}: {}\n", file.name, file.meaning);
      ++ready_;
    }
    note_time("report, page");
  }
#endif

  bool writes(MeshFormat format) const {
    const std::vector<MeshFormat>& formats = design_.output.formats;
    return std::find(formats.begin(), formats.end(), format) != formats.end();
  }

  // A file that is no mesh; meshes are recorded with what their audit found.
  std::filesystem::path add_file(const std::string& name) {
    ++ready_;
#if LATTICAST_HAS_PREDICT
    report_.files.push_back(name);
#endif
    return staging_.add(name);
  }

  std::string part_name(std::size_t s, std::string_view part) const {
    if (design_.segments.size() == 1) return fmt::format("{}-{}", design_.name, part);
    return fmt::format("{}-segment-{}-{}", design_.name, s + 1, part);
  }

  // Writes a solid in every format, reads each file back and proves it.
  void deliver(const Part& part, const Solid& solid) {
    std::vector<std::string> files;
    TriangleMesh proved;
    Audit result;
    for (const MeshFormat format : design_.output.formats) {
      const std::string file = part.stem + std::string(extension(format));
      const std::filesystem::path path = staging_.add(file);
      progress_.begin("writing " + file);
      write_mesh(path, solid.mesh, format, part.colours);
      progress_.begin("proving " + file);
      TriangleMesh in_file = weld(read_mesh(path));
      // Most formats keep the mesh bit for bit: what was proved of one file holds for the next.
      if (files.empty() || !same_triangles(in_file, proved)) {
        result = audit(in_file);
        prove(file, solid, result);
        proved = std::move(in_file);
      }
      summary_ += fmt::format("{}: {}, {}\n", file, audit_summary(result),
                              describe(error_of_file(solid, result)));
      files.push_back(file);
      ++ready_;
    }
    record_piece(part, files, solid, result);
    note_time(part.stem);
  }

  // Since the part before: all that was done for this one.
  void note_time(const std::string& stem) {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - since_).count();
    console_.note(fmt::format("{}: {:.2f} s", stem, seconds));
    since_ = now;
#if LATTICAST_HAS_PREDICT
    report_.times.push_back({stem, seconds});
#endif
  }

  void record_piece([[maybe_unused]] const Part& part,
                    [[maybe_unused]] const std::vector<std::string>& files,
                    [[maybe_unused]] const Solid& solid, [[maybe_unused]] const Audit& result) {
#if LATTICAST_HAS_PREDICT
    report_.files.insert(report_.files.end(), files.begin(), files.end());
    if (part.kind.empty()) return;
    report_.pieces.push_back({part.stem, part.kind, static_cast<int>(part.segment) + 1, files,
                              part.material, result.volume_mm3,
                              report_mesh(result, error_of_file(solid, result))});
#endif
  }

#if LATTICAST_HAS_MOLDS
  void record_pour([[maybe_unused]] const PlannedMold& planned) {
#if LATTICAST_HAS_PREDICT
    const std::string stem = part_name(planned.segment, planned.kind);
    const Material* poured = poured_material(design_, planned);
    report_.pieces.push_back({stem + ", poured",
                              "pour",
                              static_cast<int>(planned.segment) + 1,
                              {},
                              poured,
                              planned.mold.cavity_mm3,
                              std::nullopt});
#endif
  }
#endif

  static void prove(const std::string& file, const Solid& solid, const Audit& result) {
    if (!result.passes()) {
      throw AuditFailed(
          fmt::format("{} fails its audit and was not written:\n{}", file, audit_findings(result)));
    }
    if (result.components != solid.pieces || result.genus != solid.genus) {
      throw AuditFailed(fmt::format(
          "{} has {} pieces and genus {}, its pattern has {} and {}; it was not written", file,
          result.components, result.genus, solid.pieces, solid.genus));
    }
    if (solid.volume_mm3 > 0 &&
        std::abs(result.volume_mm3 - solid.volume_mm3) > solid.volume_bound_mm3) {
      throw AuditFailed(fmt::format("{} has {} mm3, its pattern {}; it was not written", file,
                                    result.volume_mm3, solid.volume_mm3));
    }
  }

  const BuildOrder& order_;
  const Design& design_;
  const Plan& plan_;
  const Console& console_;
  Progress progress_;
  StagingFolder staging_;
#if LATTICAST_HAS_PREDICT
  ReportData report_;
#endif
  std::vector<NamedMesh> together_;
  std::vector<double> start_z_mm_;
  std::string summary_;
  int ready_ = 0;
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

}  // namespace

std::string build_parts(const BuildOrder& order, const Console& console) {
  return Builder(order, console).run();
}

}  // namespace latticast
