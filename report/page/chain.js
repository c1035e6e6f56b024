// SPDX-License-Identifier: GPL-3.0-or-later
// The chain as a whole: where its tip comes to, and its centre line, in three views.
"use strict";

const PLANE = { width: 340, height: 354, margin: 44 };
const PLANES = [
  ["x", "z", 0, 2],
  ["y", "z", 1, 2],
  ["x", "y", 0, 1],
];

/** @param {Object[]} cases @returns {number[][]} tips that exist */
function tips_of(cases) {
  return cases.filter((one) => one.exists !== false && list(one.tip_mm).length === 3).map((one) => one.tip_mm);
}

/** @param {number[][]} points @returns scales of equal length on both axes, across and up */
function plane_scales(points, across, up) {
  const range = (i) => {
    const values = [0, ...points.map((p) => p[i])];
    return [Math.min(...values), Math.max(...values)];
  };
  const [[x0, x1], [y0, y1]] = [range(across), range(up)];
  const size = Math.max(x1 - x0, y1 - y0, 1) * 1.08;
  const [left, low] = [(x0 + x1 - size) / 2, (y0 + y1 - size) / 2];
  const { width, height, margin } = PLANE;
  const per_mm = (width - margin - 12) / size;
  return {
    left,
    low,
    size,
    x: (mm) => margin + (mm - left) * per_mm,
    y: (mm) => height - margin - (mm - low) * per_mm,
  };
}

/** @returns {SVGElement[]} lines and numbers of both axes, mm */
function plane_axes(scales, names) {
  const { height, margin } = PLANE;
  const [end_x, end_y] = [scales.x(scales.left + scales.size), scales.y(scales.low + scales.size)];
  const across = round_ticks(scales.left, scales.left + scales.size, 4).map((mm) => [
    svg("line", { class: "grid", x1: scales.x(mm), y1: end_y, x2: scales.x(mm), y2: height - margin }),
    svg("text", { class: "tick-text", x: scales.x(mm), y: height - margin + 16, "text-anchor": "middle" }, given(mm)),
  ]);
  const up = round_ticks(scales.low, scales.low + scales.size, 4).map((mm) => [
    svg("line", { class: "grid", x1: margin, y1: scales.y(mm), x2: end_x, y2: scales.y(mm) }),
    svg("text", { class: "tick-text", x: margin - 6, y: scales.y(mm) + 4, "text-anchor": "end" }, given(mm)),
  ]);
  return [
    ...across.flat(),
    ...up.flat(),
    svg("path", { class: "axis-line", d: `M${margin} ${end_y}V${height - margin}H${end_x}` }),
    svg(
      "text",
      { class: "axis-text", x: (margin + end_x) / 2, y: height - 8, "text-anchor": "middle" },
      `${names[0]}, mm`,
    ),
    svg("text", { class: "axis-text", x: margin - 6, y: end_y - 8, "text-anchor": "end" }, `${names[1]}, mm`),
  ];
}

/**
 * Tips and the present centre line, seen along one axis.
 * @returns {{element: HTMLElement, show: function(number[][])}}
 */
function plane_picture([name_x, name_y, across, up], tips, lines) {
  const scales = plane_scales([...tips, ...lines.flat()], across, up);
  const line = svg("polyline", { class: "centre-line" });
  const tip = svg("circle", { class: "tip", r: 5 });
  const element = h(
    "figure",
    { class: "chart-box" },
    h("figcaption", {}, `${name_x}–${name_y}`),
    svg(
      "svg",
      {
        class: "chart plane",
        viewBox: `0 0 ${PLANE.width} ${PLANE.height}`,
        role: "img",
        "aria-label": `Tips of all load cases and the present centre line, in the plane of ${name_x} and ${name_y}`,
      },
      plane_axes(scales, [name_x, name_y]),
      tips.map((p) => svg("circle", { class: "case", cx: scales.x(p[across]), cy: scales.y(p[up]), r: 2.4 })),
      line,
      tip,
    ),
  );
  const show = (points) => {
    line.setAttribute(
      "points",
      points.map((p) => `${scales.x(p[across]).toFixed(2)},${scales.y(p[up]).toFixed(2)}`).join(" "),
    );
    const end = points.at(-1);
    if (end) set_attributes(tip, { cx: scales.x(end[across]), cy: scales.y(end[up]) });
  };
  return { element, show };
}

/** @param {Object[]} cases @returns {Object|undefined} the one at the present pressures */
function present_case(cases, pressures) {
  return cases.find(
    (one) =>
      list(one.pressures_kPa).length === pressures.length && pressures.every((p, i) => p === one.pressures_kPa[i]),
  );
}

/** @param {Object[]} cases @returns {HTMLElement} shut when there are more than a few */
function case_table(cases) {
  const make = () =>
    table_of(
      "Load cases",
      [
        { head: "Pressures", unit: "kPa", cell: (c) => list(c.pressures_kPa).map(given).join(" / ") },
        ...["x", "y", "z"].map((axis, i) => ({
          head: `Tip ${axis}`,
          unit: "mm",
          number: true,
          cell: (c) => measured(list(c.tip_mm)[i]),
        })),
        { head: "Tilt", unit: "°", number: true, cell: (c) => measured(c.tilt_deg) },
        { head: "Twist", unit: "°", number: true, cell: (c) => measured(c.twist_deg) },
        { head: "Length", unit: "mm", number: true, cell: (c) => measured(c.length_mm) },
        {
          head: "State",
          cell: (c) => (c.exists === false ? "does not exist" : c.stable === false ? "unstable" : "stable"),
        },
      ],
      cases,
    );
  return made_when_opened(`Table of ${counted(cases.length, "load case")}`, make, cases.length <= 6);
}

/** @returns {number[][]} the centre line now: that of the load case, where it was computed, else arcs */
function present_line(found, actuator) {
  const computed = list(found?.centre_line_mm);
  if (computed.length) return computed;
  return actuator.segments.length ? actuator.centre_line() : [];
}

/** @returns {string} what the points and the line of the pictures are */
function plane_note(found, pressures, with_tips) {
  const points = with_tips ? "Small points: tips of all load cases. " : "";
  const made = list(found?.centre_line_mm).length ? "as computed" : "arcs between interpolated ends of segments";
  return `${points}Line: the centre line at ${pressures.map(given).join(" / ")} kPa, ${made}; its end is the tip.`;
}

/** @param {Object[]} cases @param {Actuator} actuator @param {PresentPressures} present @returns {HTMLElement[]} */
function plane_pictures(cases, actuator, present) {
  const tips = tips_of(cases);
  const lines = [...cases.map((one) => list(one.centre_line_mm)), present_line(null, actuator)];
  if (tips.length === 0 && lines.every((line) => line.length === 0)) return [];
  const pictures = PLANES.map((plane) => plane_picture(plane, tips, lines));
  const note = h("p", { class: "note" });
  present.follow((pressures) => {
    const found = present_case(cases, pressures);
    pictures.forEach((picture) => picture.show(present_line(found, actuator)));
    note.textContent = plane_note(found, pressures, tips.length > 0);
  });
  const elements = pictures.map((picture) => picture.element);
  return [note, h("div", { class: "charts" }, elements)];
}

/** @param {Object} report @param {Actuator} actuator @param {PresentPressures} present */
function show_chain(report, actuator, present) {
  const cases = list(report.prediction?.chain?.cases);
  if (cases.length < 2 && list(report.design?.segments).length < 2) return;
  const box = by_id("chain-content");
  if (report.prediction?.chain?.summary) box.append(h("p", {}, report.prediction.chain.summary));
  box.append(...plane_pictures(cases, actuator, present));
  if (cases.length) box.append(case_table(cases));
}
