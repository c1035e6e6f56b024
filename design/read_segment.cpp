// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/read_segment.h"

#include <fmt/core.h>

#include "design/check_lattice.h"
#include "design/grid_widths.h"
#include "design/read_material.h"
#include "design/read_name.h"
#include "design/read_strand_path.h"

namespace latticast {
namespace {

constexpr std::string_view segment_hint = "start each segment with a line [[segment]]";

void check_liner_law(const Material& material, ColumnModel columns, const Field& field) {
  const bool linear = std::holds_alternative<Linear>(material.law);
  if (columns == ColumnModel::rods && !linear) {
    field.refuse(R"(must be linear when model.columns is "rods")",
                 R"(use "ecoflex-00-50-linear" or { law = "linear", E = 0.082, nu = 0.499 })");
  }
  if (columns == ColumnModel::distributed && linear) {
    field.refuse(fmt::format("must be a rubber ({}), not linear", rubber_law_names()),
                 R"(use "ecoflex-00-50" or { law = "neo-hookean", mu = 0.08 })");
  }
}

Liner read_liner(TableReader table, const MaterialLibrary& library, ColumnModel columns) {
  Liner liner;
  liner.inner_radius_mm = table.need("inner_radius", "inner_radius = 12").number(limits::length);
  liner.thickness_mm = table.need("thickness", "thickness = 4").number(limits::length);
  const Field field = table.need("material", R"(material = "ecoflex-00-50")");
  if (const std::optional<Material> material = read_material(field, library)) {
    check_liner_law(*material, columns, field);
    liner.material = *material;
  }
  table.refuse_unknown_keys();
  return liner;
}

Rings read_rings(TableReader table, double segment_length_mm) {
  const Field count = table.may("count");
  const Field pitch = table.may("pitch");
  const Field phase = table.may("phase");
  Rings rings;
  rings.count = count.whole(2, limits::strands_or_rings);
  rings.pitch_mm = pitch.optional_number(limits::length);
  rings.phase = phase.number_or(rings.phase, limits::ring_phase);
  rings.width_mm = table.need("width", "width = 2").number(limits::length);
  table.refuse_unknown_keys();
  if (count.present() && !pitch.present()) {
    phase.refuse("is for rings given by pitch; rings given by count are flush with both ends",
                 "leave phase out, or write a pitch in place of count");
  }
  if (count.present() == pitch.present()) {
    const Field& blamed = count.present() ? pitch : table.table();
    blamed.refuse("exactly one of count and pitch must be given",
                  "keep count for rings flush with both ends, or pitch for a fixed spacing");
  } else {
    check_rings(rings, segment_length_mm, count.present() ? count : pitch);
  }
  return rings;
}

std::vector<double> read_widths(TableReader& table, const Field& width) {
  const Field count = width.is_list() ? table.may("count") : table.need("count", "count = 8");
  const std::optional<int> strands = count.whole(1, limits::strands_or_rings);
  if (width.is_list()) return read_listed_widths(width, strands);
  if (width.is_table()) return read_graded_widths(width, strands.value_or(0));
  const double every_width = width.number(limits::length);
  return std::vector<double>(strands.value_or(0), every_width);
}

Grid read_grid(TableReader table, const Segment& segment, ColumnModel columns,
               std::vector<std::string>& names) {
  Grid grid;
  read_entry_name(table.may("name"), names);
  const Field angle = table.need("angle", "angle = 36");
  const Field width = table.need("width", "width = 2");
  grid.angle_deg = angle.number(limits::grid_angle);
  grid.widths_mm = read_widths(table, width);
  grid.path = read_strand_path(table, segment, grid.angle_deg);
  table.refuse_unknown_keys();
  // Effective rods stand for columns of any width; drawing such columns finds their overlap.
  const bool stands_for_columns = columns == ColumnModel::rods && is_curved(grid.path);
  if (!stands_for_columns) check_strand_gaps(grid, segment, width);
  check_strand_turns(grid, segment, angle);
  return grid;
}

Material read_lattice_material(const Field& field, const MaterialLibrary& library) {
  const std::optional<Material> material = read_material(field, library);
  if (!material) return {};
  if (!std::holds_alternative<Linear>(material->law)) {
    const std::string rule =
        fmt::format("must be linear; this material is {}", law_name(material->law));
    field.refuse(rule, R"(use "hei-cast-8400" or { law = "linear", E = 19.46 })");
  }
  return *material;
}

void read_lattice(TableReader table, const MaterialLibrary& library, ColumnModel columns,
                  Segment& segment) {
  // In place, because the grids' rules need the layer's radius.
  Lattice& lattice = segment.lattice.emplace();
  lattice.thickness_mm = table.need("thickness", "thickness = 2").number(limits::length);
  const Field material = table.need("material", R"(material = "hei-cast-8400")");
  lattice.material = read_lattice_material(material, library);
  const Field fillet = table.may("fillet");
  lattice.fillet_mm = fillet.number_or(lattice.fillet_mm, limits::length);
  check_fillet(segment, fillet);
  const Field rings = table.may("rings");
  if (rings.present()) {
    lattice.rings =
        read_rings(rings.as_table("start with a line [segment.lattice.rings]"), segment.length_mm);
  }
  const Field grid = table.may("grid");
  constexpr std::string_view grid_hint = "start each family with a line [[segment.lattice.grid]]";
  std::vector<std::string> names;
  for (const Field& item : grid.items(1, limits::families, grid_hint)) {
    lattice.grids.push_back(read_grid(item.as_table(grid_hint), segment, columns, names));
  }
  table.refuse_unknown_keys();
  if (table.present() && !rings.present() && !grid.present()) {
    table.table().refuse("a lattice must have rings or at least one grid",
                         "add [segment.lattice.rings] or [[segment.lattice.grid]], or leave the "
                         "lattice out for a bare tube");
  }
  check_crossings(segment, table.table());
}

Segment read_segment(TableReader table, const MaterialLibrary& library, ColumnModel columns,
                     std::vector<std::string>& names) {
  Segment segment;
  segment.name = read_entry_name(table.may("name"), names);
  segment.length_mm = table.need("length", "length = 85").number(limits::length);
  const Field liner = table.need("liner", "a line [segment.liner], with its keys below");
  const Field lattice = table.may("lattice");
  segment.liner = read_liner(liner.as_table("start with a line [segment.liner]"), library, columns);
  if (lattice.present()) {
    read_lattice(lattice.as_table("start with a line [segment.lattice]"), library, columns,
                 segment);
  }
  table.refuse_unknown_keys();
  return segment;
}

}  // namespace

std::vector<Segment> read_segments(const Field& field, const MaterialLibrary& library,
                                   ColumnModel columns) {
  std::vector<Segment> segments;
  std::vector<std::string> names;
  for (const Field& item : field.items(1, limits::segments, segment_hint)) {
    segments.push_back(read_segment(item.as_table(segment_hint), library, columns, names));
  }
  return segments;
}

}  // namespace latticast
