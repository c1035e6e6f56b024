// SPDX-License-Identifier: GPL-3.0-or-later
// What every segment does at its present pressure, linear between the points of its curve.
"use strict";

/** @param {Object[]} curve @returns {Object|null} the point at a pressure; null beyond the curve */
function curve_at(curve, pressure_kPa) {
  const pressures = curve.map((point) => point.pressure_kPa);
  if (curve.length === 0 || pressure_kPa < pressures[0] - 1e-9 || pressure_kPa > pressures.at(-1) + 1e-9) return null;
  const { lower, upper, t } = neighbours(pressures, pressure_kPa);
  const between = (key) =>
    is_number(curve[lower][key]) && is_number(curve[upper][key])
      ? curve[lower][key] + t * (curve[upper][key] - curve[lower][key])
      : null;
  return {
    stretch: between("stretch"),
    length_mm: between("length_mm"),
    twist_deg: between("twist_deg"),
    bend_deg: between("bend_deg"),
    outer_radius_mm: between("outer_radius_mm"),
    stable: curve[lower].stable !== false && curve[upper].stable !== false,
  };
}

/** @param {Object|null} point @param {Object} segment of the view @returns {string} how far it can be trusted */
function trust_text(point, segment, pressure_kPa) {
  if (point === null) return "beyond the prediction";
  const computed = segment.states.some((state) => state.pressure_kPa === pressure_kPa);
  return (computed ? "computed" : "interpolated") + (point.stable ? "" : ", unstable");
}

/** @param {Object|null} point @returns {Array<[string, string]>} names and values */
function shown_numbers(point) {
  return [
    ["Stretch", measured(point?.stretch)],
    ["Length", with_unit(point?.length_mm, "mm")],
    ["Twist", with_unit(point?.twist_deg, "°")],
    ["Bend", with_unit(point?.bend_deg, "°")],
    ["Outer diameter", with_unit(is_number(point?.outer_radius_mm) ? 2 * point.outer_radius_mm : null, "mm")],
  ];
}

/** @param {Object} report @param {Object} segment of the view @returns {{column: Object, show: function(number)}} */
function number_column(report, segment) {
  const curve = list(prediction_of(report, segment.number)?.curve);
  const cells = shown_numbers(null).map(() => h("td", { class: "number" }));
  const trust = h("td", { class: "number trust" });
  const show = (pressure_kPa) => {
    const point = curve_at(curve, pressure_kPa);
    shown_numbers(point).forEach(([, text], i) => {
      cells[i].textContent = text;
    });
    const text = trust_text(point, segment, pressure_kPa);
    trust.textContent = text;
    trust.classList.toggle("warning", /unstable|beyond/.test(text));
  };
  return { cells: [...cells, trust], show };
}

/** @param {Object[]} segments of the view @param {PresentPressures} present @returns {HTMLElement|null} */
function live_numbers(report, segments, present) {
  if (predicted_segments(report).length === 0) return null;
  const columns = segments.map((segment) => number_column(report, segment));
  const names = [...shown_numbers(null).map(([name]) => name), "This state"];
  present.follow((pressures) => columns.forEach((column, i) => column.show(pressures[i])));
  const caption = "At this pressure";
  return scrolling(
    caption,
    h(
      "table",
      { class: "live" },
      h("caption", {}, caption),
      segments.length > 1
        ? h(
            "thead",
            {},
            h(
              "tr",
              {},
              h("th", { scope: "col" }, "Segment"),
              segments.map((s) => h("th", { scope: "col", class: "number" }, String(s.number))),
            ),
          )
        : null,
      h(
        "tbody",
        {},
        names.map((name, row) =>
          h(
            "tr",
            {},
            h("th", { scope: "row" }, name),
            columns.map((column) => column.cells[row]),
          ),
        ),
      ),
    ),
  );
}
