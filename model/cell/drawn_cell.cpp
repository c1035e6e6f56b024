// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell/drawn_cell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "design/units.h"
#include "geometry/pattern/cannot_draw.h"
#include "geometry/pattern/drawing_problems.h"
#include "geometry/pattern/pattern.h"
#include "geometry/solid/fillet.h"
#include "geometry/solid/geometry_error.h"
#include "geometry/solid/region.h"
#include "geometry/solid/tolerance_budget.h"
#include "model/cell/lattice_period.h"
#include "model/cell/swept_cell.h"

namespace latticast {
namespace {

/// A mesh of the cell; sizes are in units of element_size_mm().
struct Mesh {
  double size = 1;
  double most_turn_rad = 0;
  SweptDivision through;
};
constexpr std::array<Mesh, drawn_levels + 1> meshes = {{
    {2, pi / 6, {.liner = 1, .lattice = 1, .grading = 1}},
    {1, pi / 6, {.liner = 2, .lattice = 1, .grading = 3}},
    {0.5, pi / 6, {.liner = 4, .lattice = 1, .grading = 3}},
    {0.25, pi / 12, {.liner = 6, .lattice = 2, .grading = 3}},
}};

// The finer mesh's error over the difference of both, docs/unit-cell.md#any-lattice.
constexpr std::array<double, drawn_levels> extrapolation_of_wedges = {0.4, 0.6, 0.6};

constexpr double flatness_mm = 1e-3;  // of chords, which the mesh takes together again
constexpr double closing_by_width = 0.02;
constexpr int least_sectors = 3;

// About 5 kB an unknown are needed.
constexpr int most_unknowns = 120000;

/// Nearly one element across the thinnest strand, and nearly four from strand to strand.
double element_size_mm(const Segment& segment) {
  double between = segment.lattice_circumference_mm();
  for (const Grid& grid : segment.lattice->grids) {
    if (grid.count() == 0) continue;
    between = std::min(between,
                       segment.lattice_circumference_mm() * grid.direction().sine / grid.count());
  }
  return 0.9 * std::max(thinnest_strand_mm(*segment.lattice), 0.3 * between);
}

/// The plane of a period, united.
struct PeriodPlane {
  Region region;
  Period period;
};

PeriodPlane plane_of(const LatticePeriod& found) {
  const Segment& drawn = found.drawn;
  const int turns = (least_sectors + found.repeats - 1) / found.repeats;
  const PlaneGrid grid =
      make_plane_grid(drawn.lattice_circumference_mm(), drawn.length_mm, found.repeats * turns);
  const auto steps = [&](double z_mm) {
    return static_cast<std::int32_t>(std::lround(z_mm / grid.z_step_mm));
  };
  const std::array<std::int32_t, 2> cuts = {steps(found.from_mm), steps(found.to_mm)};
  Pattern pattern = draw_lattice(drawn, flatness_mm);
  const double fillet_mm = drawn.lattice->fillet_mm;
  if (fillet_mm > 0) pattern = with_fillets(pattern, fillet_mm, flatness_mm);
  const double closing = closing_by_width * thinnest_strand_mm(*drawn.lattice);
  return {unite(std::move(pattern), grid, cuts, closing),
          {turns, cuts[0], cuts[1], found.shift_mm, found.mirrored}};
}

CellMesh mesh_of(const Segment& segment, const LatticePeriod& found, const PeriodPlane& plane,
                 const Mesh& mesh) {
  const PeriodDivision division{mesh.size * element_size_mm(segment), mesh.most_turn_rad};
  return swept_cell(segment, triangulate_period(plane.region, plane.period, division),
                    {found.repeats, found.mirrored}, mesh.through);
}

/// Straight families of opposite angles meet at u = 0: a plane through the axis there mirrors them.
bool is_mirrored_around(const Segment& segment) {
  std::vector<std::pair<double, std::size_t>> leans;  // cosine, strands
  for (const Grid& grid : segment.lattice->grids) {
    if (grid.count() == 0) continue;
    if (is_curved(grid.path)) return false;
    leans.emplace_back(grid.direction().cosine, grid.widths_mm.size());
  }
  return std::all_of(leans.begin(), leans.end(), [&](const auto& lean) {
    return std::find(leans.begin(), leans.end(), std::pair{-lean.first, lean.second}) !=
           leans.end();
  });
}

/// Columns that overlap are one net; the first of them says by how much.
std::string with_net(std::string assumed, const Segment& segment) {
  const std::vector<std::string> overlaps = overlapping_neighbours(segment);
  if (overlaps.empty()) return assumed;
  if (!assumed.empty()) assumed += "; ";
  return assumed +
         "the unit cell has overlapping columns as the one net that is drawn: " + overlaps.front();
}

FoundCell cell_of(const Segment& segment, const LatticePeriod& found, std::size_t level) {
  const PeriodPlane plane = plane_of(found);
  UnitCell cell{.coarse = mesh_of(segment, found, plane, meshes[level]),
                .fine = mesh_of(segment, found, plane, meshes[level + 1]),
                .extrapolation = extrapolation_of_wedges[level],
                .kind = UnitCellKind::drawn,
                .twists = !found.mirrored && !is_mirrored_around(segment),
                .bends = found.repeats == 1,
                .assumed = with_net(found.assumed, segment)};
  if (cell.fine.unknowns > most_unknowns) {
    return {nullptr, "would have " + std::to_string(cell.fine.unknowns) +
                         " unknowns, more than the " + std::to_string(most_unknowns) +
                         " that are solved for (0.6 GB, about 2 s each time)"};
  }
  return {std::make_shared<const UnitCell>(std::move(cell)), {}};
}

// Of a deck, which takes some kB each in the program that solves it.
constexpr std::size_t most_wedges = 1'000'000;

FoundWedges wedges_of(const Segment& segment, int sectors, double size) {
  LatticePeriod all;
  all.drawn = segment;
  all.to_mm = segment.length_mm;
  all.repeats = sectors;
  all.mirrored = true;  // nothing lies beyond the ends
  const PeriodPlane plane = plane_of(all);
  const PeriodDivision division{size * element_size_mm(segment), pi / 6};
  const PeriodMesh triangles = triangulate_period(plane.region, plane.period, division);
  const SweptDivision through{.liner = 2, .lattice = 1, .grading = 3};
  const std::size_t most = triangles.triangles.size() * 3;
  if (most > most_wedges) {
    return {{}, "would have up to " + std::to_string(most) + " wedges, more than a million"};
  }
  return {swept_wedges(segment, triangles, sectors, through), {}};
}

/// What `make` finds, or why the lattice cannot be drawn or meshed.
template <class Found, class Make>
Found drawn(Make&& make) {
  try {
    return make();
  } catch (const CannotDraw& problem) {
    return {{}, std::string("cannot be drawn: ") + problem.what()};
  } catch (const GeometryError& problem) {
    return {{}, std::string("cannot be meshed: ") + problem.what()};
  }
}

}  // namespace

FoundWedges find_drawn_wedges(const Segment& segment, bool whole, double size) {
  return drawn<FoundWedges>(
      [&] { return wedges_of(segment, whole ? 1 : equal_sectors(segment), size); });
}

FoundCell find_drawn_cell(const Segment& segment, int level) {
  const FoundPeriod found = find_period(segment);
  if (!found.period) return {nullptr, found.reason};
  return drawn<FoundCell>(
      [&] { return cell_of(segment, *found.period, static_cast<std::size_t>(level)); });
}

}  // namespace latticast
