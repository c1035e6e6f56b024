// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/build_command.h"

#include <chrono>
#include <cmath>
#include <stdexcept>

#include <fmt/core.h>

#include "app/audit_output.h"
#include "app/design_input.h"
#include "app/file_error.h"
#include "app/flat_pattern.h"
#include "app/interrupt.h"
#include "app/plan.h"
#include "app/staging_folder.h"
#include "export/mesh_file.h"
#include "geometry/mesh/weld.h"
#include "geometry/pattern/drawing_problems.h"
#include "geometry/solid/audit.h"
#include "geometry/solid/tube_solids.h"
#if LATTICAST_HAS_MOLDS
#include "app/mold_picture.h"
#include "app/mold_set.h"
#include "export/atomic_file.h"
#include "molds/print_size.h"
#endif
#if LATTICAST_HAS_PREDICT
#include "app/preview.h"
#endif

namespace latticast {
namespace {

/// A mesh that this program made fails its own audit: nothing is delivered.
struct AuditFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Builder {
 public:
  Builder(const Design& design, const Plan& plan, const BuildArguments& arguments,
          const Console& console)
      : design_(design), plan_(plan), console_(console), staging_(arguments.folder) {
    double start = 0;
    for (const Segment& segment : design.segments) {
      start_z_mm_.push_back(start);
      start += segment.length_mm;
    }
  }

  // Returns the list of files, for people.
  std::string run() {
#if LATTICAST_HAS_MOLDS
    const std::vector<PlannedMold> molds = make_molds(design_, plan_);
    for (const PlannedMold& planned : molds) {
      steps_ += static_cast<int>(planned.mold.pieces.size());
    }
    if (!molds.empty()) note_time("molds, planned and meshed");
#endif
    count_steps();
    for (std::size_t s = 0; s < design_.segments.size(); ++s) build_segment(s);
#if LATTICAST_HAS_MOLDS
    for (const PlannedMold& planned : molds) build_mold(planned);
#endif
#if LATTICAST_HAS_PREDICT
    if (plan_.runs(Stage::preview)) build_preview();
#endif
    staging_.commit();
    return summary_;
  }

 private:
  void count_steps() {
    const std::size_t parts =
        plan_.runs(Stage::lattice) + plan_.runs(Stage::liner) + plan_.runs(Stage::flat_pattern);
    const std::size_t shapes = plan_.runs(Stage::preview) ? design_.make.preview->cases.size() : 0;
    steps_ += static_cast<int>(design_.segments.size() * (parts + 2 * shapes));
  }

  void build_segment(std::size_t s) {
    const Segment& segment = design_.segments[s];
    const SolidOptions options{design_.output.tolerance_mm, start_z_mm_[s], 0, 1};
    if (plan_.runs(Stage::lattice) && segment.lattice) {
      begin(part_name(s, "lattice"));
      deliver(part_name(s, "lattice"), lattice_solid(segment, options));
    }
    if (plan_.runs(Stage::liner)) {
      begin(part_name(s, "liner"));
      deliver(part_name(s, "liner"), liner_solid(segment, options));
    }
    if (plan_.runs(Stage::flat_pattern)) build_flat_pattern(s);
  }

  void build_flat_pattern(std::size_t s) {
    const std::string stem = part_name(s, "flat");
    begin(stem);
    if (!design_.segments[s].lattice) {
      summary_ += fmt::format("{}: no flat pattern, the segment has no lattice\n", stem);
      return;
    }
    const FlatSheet sheet = flat_sheet(design_.segments[s], design_.output.tolerance_mm);
    const FlatDrawing drawing = flat_drawing(design_, s, sheet);
    write_svg(staging_.add(stem + ".svg"), drawing);
    write_dxf(staging_.add(stem + ".dxf"), drawing);
    summary_ += fmt::format("{0}.svg, {0}.dxf: flat pattern, {1}\n", stem, describe(sheet));
    note_time(stem);
  }

#if LATTICAST_HAS_MOLDS
  void build_mold(const PlannedMold& planned) {
    const std::string stem = part_name(planned.segment, planned.kind);
    for (const MoldPiece& piece : planned.mold.pieces) {
      begin(stem + "-" + piece.name);
      Solid printed = piece.solid;
      printed.mesh = printing_pose(piece);
      deliver(stem + "-" + piece.name, printed);
    }
    write_png(staging_.add(stem + ".png"), exploded_picture(planned.mold));
    write_file_atomically(staging_.add(stem + ".md"), planned.procedure);
    summary_ += fmt::format("{}.md: pieces, assembly and pouring; {}.png: the mold taken apart\n",
                            stem, stem);
  }
#endif

#if LATTICAST_HAS_PREDICT
  void build_preview() {
    const std::vector<PreviewShape> shapes = predict_preview(design_);
    std::vector<PicturePart> picture;
    for (std::size_t s = 0; s < design_.segments.size(); ++s) {
      const SolidOptions options = preview_options(design_, s, start_z_mm_[s], shapes);
      const Segment& segment = design_.segments[s];
      if (segment.lattice) {
        preview_part(s, false, lattice_solid(segment, options), shapes, picture);
      }
      preview_part(s, true, liner_solid(segment, options), shapes, picture);
    }
    const std::string file = design_.name + "-preview.png";
    write_png(staging_.add(file), preview_picture(picture, shapes));
    summary_ += fmt::format("{}: {} shapes side by side\n", file, shapes.size());
  }

  void preview_part(std::size_t s, bool is_liner, const Solid& rest,
                    const std::vector<PreviewShape>& shapes, std::vector<PicturePart>& picture) {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const std::string part =
          fmt::format("preview-{}-{}", shapes[i].label, is_liner ? "liner" : "lattice");
      begin(part_name(s, part));
      Solid moved{moved_mesh(rest.mesh, shapes[i].shape, s), 0, 0, rest.pieces, rest.genus};
      moved.error = moved_error(rest, moved.mesh, shapes[i].shape, s);
      if (shapes[i].shape.bend_rad(s) == 0) keep_volume(rest, moved);
      deliver(part_name(s, part), moved);
      picture.push_back({std::move(moved.mesh), i, is_liner});
    }
  }

  // The wall is incompressible; bending alone makes one side larger and the other smaller.
  static void keep_volume(const Solid& rest, Solid& moved) {
    moved.volume_mm3 = rest.volume_mm3;
    moved.volume_bound_mm3 = moved.error.volume_mm3;
    moved.error.volume_mm3 = rest.error.volume_mm3;
  }
#endif

  std::string part_name(std::size_t s, std::string_view part) const {
    if (design_.segments.size() == 1) return fmt::format("{}-{}", design_.name, part);
    return fmt::format("{}-segment-{}-{}", design_.name, s + 1, part);
  }

  void begin(const std::string& what) {
    stop_if_interrupted();
    console_.progress(++step_, steps_, what);
  }

  // Writes a solid in every format, reads each file back and proves it.
  void deliver(const std::string& stem, const Solid& solid) {
    for (const MeshFormat format : design_.output.formats) {
      const std::string file = stem + std::string(extension(format));
      const std::filesystem::path path = staging_.add(file);
      write_mesh(path, solid.mesh, format);
      const Audit result = audit(weld(read_mesh(path)));
      prove(file, solid, result);
      summary_ += fmt::format("{}: {}, {}\n", file, audit_summary(result),
                              describe(error_of_file(solid, result)));
      stop_if_interrupted();
    }
    note_time(stem);
  }

  // Since the part before: all that was done for this one.
  void note_time(const std::string& stem) {
    const auto now = std::chrono::steady_clock::now();
    console_.note(
        fmt::format("{}: {:.2f} s", stem, std::chrono::duration<double>(now - since_).count()));
    since_ = now;
  }

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

  const Design& design_;
  const Plan& plan_;
  const Console& console_;
  StagingFolder staging_;
  std::vector<double> start_z_mm_;
  std::string summary_;
  int step_ = 0;
  int steps_ = 0;
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

bool makes_anything(const Plan& plan) {
  return plan.runs(Stage::lattice) || plan.runs(Stage::liner) || plan.runs(Stage::flat_pattern) ||
         plan.runs(Stage::preview) || plan.runs(Stage::lattice_mold) ||
         plan.runs(Stage::liner_mold);
}

bool draws_lattice(const Plan& plan) {
  return plan.runs(Stage::lattice) || plan.runs(Stage::flat_pattern) || plan.runs(Stage::preview) ||
         plan.runs(Stage::lattice_mold);
}

}  // namespace

ExitStatus run_build(const BuildArguments& arguments, const Console& console) {
  const auto materials = load_materials(arguments.materials, console);
  if (!materials) return ExitStatus::invalid;
  const auto design = load_design(arguments.design, *materials, console);
  if (!design) return ExitStatus::invalid;
  const Plan plan = plan_build(*design, arguments.only);
  if (arguments.dry_run) console.data(describe(plan));

  const std::vector<std::string> missing = unavailable(plan, *design);
  for (const std::string& line : missing) console.error(line);
  if (!missing.empty()) return ExitStatus::invalid;
  if (draws_lattice(plan)) require_drawable(design->segments);
  if (arguments.dry_run) return ExitStatus::done;
  if (!makes_anything(plan)) {
    console.note("nothing to make: name what you want under [make], for example lattice = true");
    return ExitStatus::done;
  }
  try {
    watch_for_interrupt();
    console.data(Builder(*design, plan, arguments, console).run());
  } catch (const AuditFailed& fault) {
    console.error(fault.what());
    return ExitStatus::check_failed;
  }
  console.note(fmt::format("files are in {}", arguments.folder.string()));
  return ExitStatus::done;
}

}  // namespace latticast
