// SPDX-License-Identifier: GPL-3.0-or-later
// Dimensions of the design beside those measured on its meshes, and the materials.
"use strict";

/** @param {number[]|null} widths @returns {string} "2" when all are equal, else all of them */
function widths_text(widths) {
  const values = list(widths);
  if (values.length === 0) return MISSING;
  const same = values.every((width) => width === values[0]);
  return same ? given(values[0]) : values.map(given).join(", ");
}

/** @param {Object} sizes of a strand path, their units in their names @returns {string} */
function sizes_text(sizes) {
  const words = Object.entries(sizes).map(([name, value]) =>
    name.endsWith("_mm") ? `${name.slice(0, -3)} ${with_unit(value, "mm", given)}` : `${name} ${given(value)}`,
  );
  return words.join(", ");
}

/** @param {Object} grid @returns {string} the strands' path: the grid's only table besides its lists */
function path_text(grid) {
  const horseshoe = grid.horseshoe;
  if (!horseshoe) {
    const is_table = (value) => value !== null && typeof value === "object" && !Array.isArray(value);
    const found = Object.entries(grid).find(([, value]) => is_table(value));
    return found ? `${found[0]}, ${sizes_text(found[1])}` : "straight";
  }
  return (
    `horseshoe, radius ${with_unit(horseshoe.radius_mm, "mm", given)}, arc ` +
    `${with_unit(horseshoe.arc_deg, "°", given)}${horseshoe.alternate ? ", alternating" : ""}`
  );
}

/** @param {number} most grids of any segment @returns {Array} lines of property_table() */
function grid_lines(most) {
  const lines = [];
  for (let i = 0; i < most; ++i) {
    const name = most > 1 ? `Grid ${i + 1}` : "Grid";
    const of = (value) => (segment) => {
      const grid = list(segment.lattice?.grids)[i];
      return grid ? value(grid) : null;
    };
    lines.push(
      [`${name}, angle`, "°", of((grid) => given(grid.angle_deg))],
      [`${name}, strands`, "", of((grid) => count(grid.count))],
      [`${name}, strand width`, "mm", of((grid) => widths_text(grid.widths_mm))],
      [`${name}, strand shape`, "", of((grid) => path_text(grid))],
    );
  }
  return lines;
}

/** @param {Object} rings @returns {string} */
function rings_text(rings) {
  const place = is_number(rings.count)
    ? counted(rings.count, "ring")
    : `every ${with_unit(rings.pitch_mm, "mm", given)}`;
  const phase = is_number(rings.phase) ? `, phase ${given(rings.phase)}` : "";
  return `${place}${phase}, ${with_unit(rings.width_mm, "mm", given)} wide`;
}

/** @param {number[]|null} size_mm @returns {string} */
function size_text(size_mm) {
  return list(size_mm).length === 3 ? size_mm.map((value) => measured(value)).join(" × ") : MISSING;
}

/** @param {Object[]} pieces @param {string} kind @returns {function(Object): string} size of a segment's piece */
function measured_size(pieces, kind) {
  return (segment) => {
    const piece = pieces.find((p) => p.kind === kind && (p.segment ?? 1) === segment.number);
    return piece ? size_text(piece.size_mm) : null;
  };
}

/** @param {Object[]} segments @param {Object[]} pieces @returns {Array} lines of property_table() */
function dimension_lines(segments, pieces) {
  const most = Math.max(0, ...segments.map((segment) => list(segment.lattice?.grids).length));
  return [
    ["Length at rest", "mm", (s) => given(s.length_mm)],
    ["Inner radius", "mm", (s) => given(s.inner_radius_mm)],
    ["Outer radius of the liner", "mm", (s) => given(s.liner_outer_radius_mm)],
    ["Outer radius", "mm", (s) => given(s.outer_radius_mm)],
    ["Liner thickness", "mm", (s) => given(s.liner?.thickness_mm)],
    ["Liner material", "", (s) => s.liner?.material ?? null],
    ["Lattice thickness", "mm", (s) => (s.lattice ? given(s.lattice.thickness_mm) : null)],
    ["Lattice material", "", (s) => s.lattice?.material ?? null],
    ["Fillets", "mm", (s) => (s.lattice?.fillet_mm ? given(s.lattice.fillet_mm) : null)],
    ["Rings", "", (s) => (s.lattice?.rings ? rings_text(s.lattice.rings) : null)],
    ...grid_lines(most),
    ["Lattice as meshed, x × y × z", "mm", measured_size(pieces, "lattice")],
    ["Liner as meshed, x × y × z", "mm", measured_size(pieces, "liner")],
  ];
}

/** @param {Object|null} parameters of a law @returns {string} "c1 = 0.019, c2 = 0.0009" */
function parameters_text(parameters) {
  const write = ([name, value]) =>
    value !== null && typeof value === "object"
      ? `${name} = ${JSON.stringify(value)}`
      : `${name} = ${is_number(value) ? given(value) : value}`;
  return (
    Object.entries(parameters ?? {})
      .map(write)
      .join(", ") || MISSING
  );
}

/** @param {Object[]} materials @returns {HTMLElement} */
function material_table(materials) {
  return table_of(
    "Materials",
    [
      { head: "Material", cell: (m) => m.name },
      { head: "Used for", cell: (m) => listed(list(m.role)) },
      { head: "Law", cell: (m) => m.law },
      { head: "Parameters", cell: (m) => parameters_text(m.parameters) },
      { head: "Density", unit: "g/cm³", number: true, cell: (m) => given(m.density_g_per_cm3) },
      { head: "Source", cell: (m) => m.source || null },
    ],
    materials,
  );
}

/** @param {Object} report */
function show_dimensions(report) {
  const segments = list(report.design?.segments);
  const box = by_id("dimensions-content");
  const heads = segments.map((segment) => (segments.length > 1 ? `Segment ${segment.number}` : "Value"));
  box.append(property_table("Dimensions", heads, dimension_lines(segments, list(report.pieces)), segments));
  if (is_number(report.design?.tolerance_mm)) {
    box.append(
      h(
        "p",
        { class: "note" },
        "Curved surfaces are meshed to within ",
        with_unit(report.design.tolerance_mm, "mm", given),
        ".",
      ),
    );
  }
  const materials = list(report.materials);
  if (materials.length) box.append(material_table(materials));
}
