// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/read_settings.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

#include <fmt/core.h>

#include "design/pressure_sweep.h"
#include "design/read_molds.h"
#include "design/text/written_number.h"

namespace latticast {
namespace {

std::vector<double> read_sweep(const Field& field) {
  TableReader table = field.as_table("");
  PressureSweep sweep;
  sweep.from_kpa = table.need("from", "from = 0").number(limits::pressure);
  sweep.to_kpa = table.need("to", "to = 60").number(limits::pressure);
  const Field step = table.need("step", "step = 5");
  sweep.step_kpa = step.number(limits::pressure);
  table.refuse_unknown_keys();
  if (std::isnan(sweep.from_kpa + sweep.to_kpa + sweep.step_kpa)) return {};
  const double size = sweep_size(sweep);
  if (size == 0) {
    step.refuse("must lead from `from` to `to`, in steps that are not zero",
                sweep.to_kpa < sweep.from_kpa ? "write a negative step" : "write a positive step");
  } else if (size > limits::load_cases) {
    step.refuse(fmt::format("a sweep must not hold more than {} pressures; this one holds {}",
                            limits::load_cases, written(size, 6)),
                "use a larger step");
  } else {
    return sweep_pressures_kpa(sweep);
  }
  return {};
}

std::vector<double> read_common_pressures(const Field& field) {
  if (field.is_table()) return read_sweep(field);
  if (field.is_number()) return {field.number(limits::pressure)};
  field.refuse("must be a number in kPa or a sweep { from, to, step }",
               "for chosen pressures or one per segment, write a [[load.case]] for each");
  return {};
}

/// One pressure for all segments, or a list with one for each.
LoadCase read_pressures_of_case(const Field& pressure, std::size_t segments) {
  LoadCase load;
  if (pressure.is_list()) {
    load.pressures_kpa = pressure.numbers(1, limits::segments, limits::pressure);
    if (segments > 0 && !load.pressures_kpa.empty() && load.pressures_kpa.size() != segments) {
      pressure.refuse(fmt::format("must hold one pressure per segment: {} for {} segments",
                                  load.pressures_kpa.size(), segments),
                      "or write a single number for all segments");
    }
  } else {
    load.pressures_kpa.assign(segments, pressure.number(limits::pressure));
  }
  return load;
}

LoadCase read_case(TableReader table, std::size_t segments) {
  LoadCase load = read_pressures_of_case(table.need("pressure", "pressure = 30"), segments);
  table.refuse_unknown_keys();
  return load;
}

/// The pressures that one segment runs through in a grid of cases.
std::vector<double> read_grid_side(const Field& field) {
  if (field.is_list()) return field.numbers(1, limits::load_cases, limits::pressure);
  if (field.is_table()) return read_sweep(field);
  return {field.number(limits::pressure)};
}

/// Every combination of the sides, the last one running fastest.
std::vector<LoadCase> combined(const std::vector<std::vector<double>>& sides) {
  std::vector<LoadCase> cases(1);
  for (const std::vector<double>& side : sides) {
    std::vector<LoadCase> longer;
    longer.reserve(cases.size() * side.size());
    for (const LoadCase& load : cases) {
      for (const double pressure : side) {
        longer.push_back(load);
        longer.back().pressures_kpa.push_back(pressure);
      }
    }
    cases = std::move(longer);
  }
  return cases;
}

std::vector<LoadCase> read_case_grid(const Field& field, std::size_t segments) {
  constexpr std::string_view hint =
      "write one entry per segment, as in grid = [{ from = 0, to = 30, step = 3 }, [0, 20, 60]]";
  std::vector<std::vector<double>> sides;
  double size = 1;
  for (const Field& item : field.items(1, limits::segments, hint)) {
    sides.push_back(read_grid_side(item));
    size *= static_cast<double>(sides.back().size());
  }
  if (sides.empty() || segments == 0) return {};
  if (sides.size() != segments) {
    field.refuse(
        fmt::format("must hold one entry per segment: {} for {} segments", sides.size(), segments),
        std::string(hint));
    return {};
  }
  if (size > limits::load_cases) {
    field.refuse(fmt::format("must not make more than {} cases; this one makes {}",
                             limits::load_cases, written(size, 6)),
                 "use larger steps");
    return {};
  }
  return combined(sides);
}

std::optional<Preview> read_preview(const Field& field, std::size_t segments) {
  if (!field.present()) return std::nullopt;
  TableReader table = field.as_table("write preview = { pressures = [0, 20, 40] }");
  const Field pressures = table.need("pressures", "pressures = [0, 20, 40]");
  table.refuse_unknown_keys();
  Preview preview;
  constexpr std::string_view hint =
      "write pressures = [0, 20, 40]; for one pressure per segment, an entry is a list: [[0, 20]]";
  for (const Field& item : pressures.items(1, limits::preview_cases, hint)) {
    preview.cases.push_back(read_pressures_of_case(item, segments));
  }
  return preview;
}

std::vector<MeshFormat> read_formats(const Field& field) {
  std::vector<Word<MeshFormat>> words;
  words.reserve(std::size(mesh_format_names));
  for (const MeshFormatName& known : mesh_format_names) words.push_back({known.name, known.format});
  // A list without duplicates cannot be longer than the words; the bound leaves room to name each
  // duplicate.
  constexpr std::size_t longest = 20;
  std::vector<MeshFormat> formats;
  std::vector<std::string> seen;
  for (const Field& item : field.items(1, longest, R"(write formats = ["stl", "obj"])")) {
    const MeshFormat format = item.word_or(MeshFormat::stl, std::span(std::as_const(words)));
    const std::string typed = item.is_text() ? *item.text() : "";
    if (std::find(seen.begin(), seen.end(), typed) != seen.end()) {
      item.refuse("must not be named twice", "leave it out");
    }
    seen.push_back(typed);
    formats.push_back(format);
  }
  return formats;
}

double thinnest_feature_mm(const std::vector<Segment>& segments) {
  double thinnest = std::numeric_limits<double>::infinity();
  // fmin passes over NaN, the mark of a refused number.
  const auto meet = [&thinnest](double size_mm) { thinnest = std::fmin(thinnest, size_mm); };
  for (const Segment& segment : segments) {
    meet(segment.liner.thickness_mm);
    if (!segment.lattice) continue;
    meet(segment.lattice->thickness_mm);
    if (segment.lattice->fillet_mm != 0) meet(segment.lattice->fillet_mm);
    if (segment.lattice->rings) meet(segment.lattice->rings->width_mm);
    for (const Grid& grid : segment.lattice->grids) {
      for (const double width : grid.widths_mm) meet(width);
    }
  }
  return thinnest;
}

std::optional<Deck> read_deck(const Field& field, bool has_load) {
  if (!field.present()) return std::nullopt;
  constexpr std::string_view hint = R"(write deck = { formats = ["inp"], part = "sector" })";
  TableReader table = field.as_table(hint);
  Deck deck;
  const Field formats = table.may("formats");
  if (formats.present()) {
    enum class Format { inp, msh };
    constexpr Word<Format> words[] = {{"inp", Format::inp}, {"msh", Format::msh}};
    deck.inp = false;
    for (const Field& item : formats.items(1, 2, R"(write formats = ["inp", "msh"])")) {
      (item.word_or(Format::inp, words) == Format::inp ? deck.inp : deck.msh) = true;
    }
  }
  enum class Part { sector, actuator };
  constexpr Word<Part> parts[] = {{"sector", Part::sector}, {"actuator", Part::actuator}};
  deck.whole = table.may("part").word_or(Part::sector, parts) == Part::actuator;
  table.refuse_unknown_keys();
  if (deck.inp && !has_load) {
    field.refuse("a deck has a step for each pressure, and there is none",
                 "add [load] pressure = { from = 10, to = 40, step = 10 }");
  }
  return deck;
}

}  // namespace

std::vector<LoadCase> read_load(const Field& field, std::size_t segments) {
  TableReader table = field.as_table("start with a line [load]");
  std::vector<LoadCase> cases;
  for (const double pressure : read_common_pressures(table.may("pressure"))) {
    cases.push_back({std::vector<double>(segments, pressure)});
  }
  constexpr std::string_view hint = "start each case with a line [[load.case]]";
  for (const Field& item : table.may("case").items(1, limits::load_cases, hint)) {
    cases.push_back(read_case(item.as_table(hint), segments));
  }
  const Field grid = table.may("grid");
  if (grid.present()) {
    for (LoadCase& load : read_case_grid(grid, segments)) cases.push_back(std::move(load));
  }
  table.refuse_unknown_keys();
  return cases;
}

namespace {

Calibrate read_calibrate(const Field& field, WallKind wall) {
  if (field.present() && wall != WallKind::bonded) {
    field.refuse("calibrate is for kind = \"bonded\", whose stiffness a unit cell sets",
                 "leave it out, or use kind = \"bonded\"");
  }
  const bool is_word = field.is_text() && field.text() == "state";
  if (field.is_text() || field.is_number() || field.is_list() || field.is_table()) {
    if (!is_word) {
      field.refuse(R"(must be true, false or "state")", R"(write calibrate = "state")");
    }
    return Calibrate::state;
  }
  return field.flag_or(true) ? Calibrate::stiffness : Calibrate::nothing;
}

double read_cell_error(const Field& field, WallKind wall) {
  if (field.present() && wall != WallKind::bonded && wall != WallKind::unit_cell) {
    field.refuse("cell is for kind = \"unit-cell\" and \"bonded\", which use a unit cell",
                 "leave it out, or use kind = \"unit-cell\"");
    return 0;
  }
  TableReader table = field.as_table("write cell = { error = 3 }");
  const double error = table.may("error").number_or(0, limits::cell_error);
  table.refuse_unknown_keys();
  return error;
}

}  // namespace

ModelChoice read_model(const Field& field) {
  constexpr Word<ColumnModel> columns[] = {{"distributed", ColumnModel::distributed},
                                           {"rods", ColumnModel::rods}};
  constexpr Word<JointModel> joints[] = {{"none", JointModel::none},
                                         {"paper", JointModel::paper},
                                         {"clear-span", JointModel::clear_span}};
  TableReader table = field.as_table("start with a line [model]");
  ModelChoice model;
  model.wall = table.may("kind").word_or(model.wall, std::span<const Word<WallKind>>(wall_kinds));
  model.calibrate = read_calibrate(table.may("calibrate"), model.wall);
  const Field columns_field = table.may("columns");
  model.columns = columns_field.word_or(model.columns, columns);
  if (model.columns == ColumnModel::rods &&
      (model.wall == WallKind::bonded || model.wall == WallKind::unit_cell)) {
    columns_field.refuse("two rods stand for the columns of a wall in layers only",
                         "use kind = \"layered\", or columns = \"distributed\"");
  }
  model.joint = table.may("joint").word_or(model.joint, joints);
  model.cell_error_percent = read_cell_error(table.may("cell"), model.wall);
  table.refuse_unknown_keys();
  return model;
}

Make read_make(const Field& field, const std::vector<Segment>& segments, const Printer& printer,
               bool has_load) {
  TableReader table = field.as_table("start with a line [make]");
  const MoldSurroundings around{segments, fit_clearance_mm(printer)};
  const Field lattice = table.may("lattice");
  Make make;
  make.lattice = lattice.flag_or(false);
  make.liner = table.may("liner").flag_or(false);
  const Field flat_pattern = table.may("flat_pattern");
  make.flat_pattern = flat_pattern.flag_or(false);
  make.lattice_mold = read_lattice_mold(table.may("lattice_mold"), around);
  make.liner_mold = read_liner_mold(table.may("liner_mold"), around);
  make.preview = read_preview(table.may("preview"), segments.size());
  const Field deck = table.may("deck");
  make.deck = read_deck(deck, has_load);
  make.report = table.may("report").flag_or(false);
  table.refuse_unknown_keys();

  const auto has_lattice = [](const Segment& segment) { return segment.lattice.has_value(); };
  if (segments.empty() || std::any_of(segments.begin(), segments.end(), has_lattice)) return make;
  constexpr std::string_view hint = "add [segment.lattice], or leave this out";
  if (make.lattice) {
    lattice.refuse("a lattice must be there to be made, but no segment has one", std::string(hint));
  }
  if (make.deck) {
    deck.refuse("a lattice must be there to be meshed, but no segment has one", std::string(hint));
  }
  if (make.flat_pattern) {
    flat_pattern.refuse("a lattice must be there to be drawn flat, but no segment has one",
                        std::string(hint));
  }
  return make;
}

Export read_export(TableReader& file, const std::vector<Segment>& segments) {
  const Field field = file.may("export");
  TableReader table = field.as_table("start with a line [export]");
  Export output;
  const Field formats = table.may("formats");
  const Field tolerance = table.may("tolerance");
  if (formats.present()) output.formats = read_formats(formats);
  output.tolerance_mm = tolerance.number_or(output.tolerance_mm, limits::tolerance);
  table.refuse_unknown_keys();
  const double thinnest = thinnest_feature_mm(segments);
  if (output.tolerance_mm >= thinnest) {
    const std::string rule = fmt::format(
        "export.tolerance (here {} mm) must be finer than the thinnest layer, strand, ring or "
        "fillet, {} mm",
        output.tolerance_mm, thinnest);
    // The default breaks the rule as well as a written value does; then the file is to blame.
    const Field& nearest = field.present() ? field : file.table();
    (tolerance.present() ? tolerance : nearest).refuse(rule, "use a finer tolerance, as in 0.001");
  }
  return output;
}

Printer read_printer(const Field& field) {
  constexpr Word<Process> processes[] = {{"fdm", Process::fdm}, {"sla", Process::sla}};
  TableReader table = field.as_table("start with a line [printer]");
  Printer printer;
  printer.process = table.may("process").word_or(printer.process, processes);
  printer.min_wall_mm = table.may("min_wall").optional_number(limits::length);
  printer.min_gap_mm = table.may("min_gap").optional_number(limits::length);
  printer.clearance_mm = table.may("clearance").optional_number(limits::length);
  const Field bed = table.may("bed");
  if (bed.present()) {
    const std::vector<double> sides = bed.numbers(3, 3, limits::length);
    if (sides.size() == 3) printer.bed_mm = {sides[0], sides[1], sides[2]};
  }
  table.refuse_unknown_keys();
  return printer;
}

}  // namespace latticast
