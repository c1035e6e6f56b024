// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mesh_plan.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <fmt/core.h>

#include "app/delivery.h"
#include "design/design.h"
#include "design/text/written_number.h"
#include "design/unsupported_design.h"
#include "geometry/solid/mesh_size.h"
#include "geometry/solid/relief.h"
#include "prepared/prepared_design.h"
#if LATTICAST_HAS_PREDICT
#include "report/no_equilibrium.h"
#include "report/preview.h"
#endif

namespace latticast {
namespace {

constexpr double most_together = 10 * most_triangles;
// Measured on the examples.
constexpr double program_bytes = 20e6;
constexpr double picture_bytes = 50e6;
constexpr double bytes_of_kept_triangle = 60;
constexpr double lattice_share_of_mold = 0.6;
constexpr double shell_triangles_a_sector = 140;
constexpr double liner_mold_triangles_a_sector = 100;

using SizeAt = std::function<double(double tolerance_mm)>;

// What is planned so far, segment by segment.
class MeshPlanner {
 public:
  explicit MeshPlanner(PreparedDesign& prepared) : prepared_(prepared) {
    plan_.memory_bytes = program_bytes;
    sizes_.resize(design().segments.size());
  }

  const Design& design() const { return prepared_.design; }

  void add_lattices() {
    for_lattices([&](std::size_t s) {
      add(s, "lattice", 1, [this, s](double tolerance) { return rest_lattice(s, tolerance); });
    });
  }

  void add_liners() {
    for (std::size_t s = 0; s < sizes_.size(); ++s) {
      add(s, "liner", 1, [this, s](double tolerance) {
        return liner_triangles(design().segments[s], {.tolerance_mm = tolerance});
      });
    }
  }

  void add_lattice_molds() {
    for_lattices([&](std::size_t s) {
      keep(add(s, "lattice-mold", 1, [this, s](double tolerance) {
        return lattice_share_of_mold * rest_lattice(s, tolerance) +
               shell_triangles_a_sector * sectors_of_mold(s, tolerance);
      }));
    });
  }

  void add_liner_molds() {
    for (std::size_t s = 0; s < sizes_.size(); ++s) {
      keep(add(s, "liner-mold", 1, [this, s](double tolerance) {
        return liner_mold_triangles_a_sector * sectors_of_mold(s, tolerance);
      }));
    }
  }

#if LATTICAST_HAS_PREDICT
  void add_previews() {
    try {
      const std::vector<PreviewShape> shapes = predict_preview(prepared_.responses);
      plan_.memory_bytes += picture_bytes;
      for (std::size_t s = 0; s < sizes_.size(); ++s) add_preview(s, shapes);
    } catch (const NoEquilibrium& reason) {
      plan_.unknown_preview = reason.what();
    } catch (const UnsupportedDesign& reason) {
      plan_.unknown_preview = reason.what();
    }
  }
#endif

  MeshPlan finished() {
    double largest = 0;
    for (const PlannedMesh& mesh : plan_.meshes) largest = std::max(largest, mesh.triangles);
    plan_.memory_bytes += memory_of_mesh(largest);
    return std::move(plan_);
  }

 private:
  template <class Do>
  void for_lattices(Do act) {
    for (std::size_t s = 0; s < sizes_.size(); ++s) {
      if (design().segments[s].lattice) act(s);
    }
  }

  const LatticeSize& size_of(std::size_t s) {
    if (!sizes_[s]) sizes_[s].emplace(design().segments[s]);
    return *sizes_[s];
  }

  double rest_lattice(std::size_t s, double tolerance_mm) {
    return size_of(s).triangles({.tolerance_mm = tolerance_mm});
  }

  double sectors_of_mold(std::size_t s, double tolerance_mm) const {
    const Make& make = design().make;
    const double wall = std::max(make.lattice_mold ? make.lattice_mold->wall_mm : 0,
                                 make.liner_mold ? make.liner_mold->wall_mm : 0);
    return sectors_for(design().segments[s].outer_radius_mm() + wall, tolerance_mm);
  }

  const PlannedMesh& add(std::size_t s, std::string_view part, std::size_t copies,
                         const SizeAt& size) {
    PlannedMesh mesh{part_name(design(), s, part), copies, size(design().output.tolerance_mm)};
    if (is_surely_too_large(mesh.triangles)) mesh.fitting_mm = fitting_tolerance_mm(size);
    plan_.triangles += mesh.triangles * static_cast<double>(copies);
    plan_.meshes.push_back(std::move(mesh));
    return plan_.meshes.back();
  }

  // Molds and moved meshes stay until the last one is made.
  void keep(const PlannedMesh& mesh) {
    plan_.memory_bytes +=
        bytes_of_kept_triangle * mesh.triangles * static_cast<double>(mesh.copies);
  }

#if LATTICAST_HAS_PREDICT
  void add_preview(std::size_t s, const std::vector<PreviewShape>& shapes) {
    const SolidOptions moved = preview_options(design(), s, 0, shapes);
    const double coarsest = coarsest_preview_mm(design().segments[s], s, shapes);
    const auto at = [moved, coarsest](double tolerance_mm) {
      SolidOptions options = moved;
      options.tolerance_mm = std::min(coarsest, tolerance_mm);
      return options;
    };
    if (design().segments[s].lattice) {
      keep(add(s, "preview-lattice", shapes.size(),
               [&](double tolerance_mm) { return size_of(s).triangles(at(tolerance_mm)); }));
    }
    keep(add(s, "preview-liner", shapes.size(), [&](double tolerance_mm) {
      return liner_triangles(design().segments[s], at(tolerance_mm));
    }));
  }
#endif

  PreparedDesign& prepared_;
  std::vector<std::optional<LatticeSize>> sizes_;
  MeshPlan plan_;
};

std::string millions(double triangles) {
  return written(triangles / 1e6, triangles < 100e6 ? 2 : 3) + " million triangles";
}

}  // namespace

MeshPlan plan_meshes(PreparedDesign& prepared, const Plan& plan) {
  MeshPlanner planner(prepared);
  if (plan.runs(Stage::lattice)) planner.add_lattices();
  if (plan.runs(Stage::liner)) planner.add_liners();
  if (plan.runs(Stage::lattice_mold)) planner.add_lattice_molds();
  if (plan.runs(Stage::liner_mold)) planner.add_liner_molds();
#if LATTICAST_HAS_PREDICT
  if (plan.runs(Stage::preview)) planner.add_previews();
#endif
  return planner.finished();
}

void require_possible(const MeshPlan& meshes, double tolerance_mm) {
  for (const PlannedMesh& mesh : meshes.meshes) {
    if (!is_surely_too_large(mesh.triangles)) continue;
    throw UnsupportedDesign(
        fmt::format("{} would have about {}, and a mesh may have {}: use a coarser "
                    "export.tolerance, {} mm fits "
                    "(it is {} mm), or fewer strands",
                    mesh.name, millions(mesh.triangles), millions(most_triangles),
                    written(mesh.fitting_mm, 2), written(tolerance_mm)));
  }
  if (meshes.triangles <= most_together) return;
  // Sizes grow at most as the tolerance shrinks.
  throw UnsupportedDesign(fmt::format(
      "all meshes together would have about {}, and {} are the most that one build makes: use a "
      "coarser export.tolerance, {} mm fits (it is {} mm), or build parts with --only",
      millions(meshes.triangles), millions(most_together),
      written(1.05 * tolerance_mm * std::pow(meshes.triangles / most_together, 2), 2),
      written(tolerance_mm)));
}

std::string describe(const MeshPlan& meshes) {
  std::string text;
  for (const PlannedMesh& mesh : meshes.meshes) {
    const std::string copies = mesh.copies == 1 ? "" : fmt::format("{} x ", mesh.copies);
    text += fmt::format("mesh  {}: {}about {} triangles\n", mesh.name, copies,
                        written(mesh.triangles, 2));
  }
  if (!meshes.unknown_preview.empty()) {
    text += fmt::format("mesh  preview: size not known: {}\n", meshes.unknown_preview);
  }
  if (meshes.meshes.empty()) return text;
  return text + fmt::format("all   about {} triangles, {} MB of memory\n",
                            written(meshes.triangles, 2), written(meshes.memory_bytes / 1e6, 2));
}

}  // namespace latticast
