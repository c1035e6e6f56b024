// SPDX-License-Identifier: GPL-3.0-or-later
// The head of the page: what the design is, of what, and what it does at its largest pressure.
"use strict";

/** @param {string} name @param {string} value @param {string} detail */
function fact(name, value, detail = "") {
  return h(
    "div",
    { class: "fact" },
    h("dt", {}, name),
    h("dd", {}, value, detail ? h("span", { class: "detail" }, detail) : null),
  );
}

/** @param {Object[]} segments of the design @returns {HTMLElement[]} */
function size_facts(segments) {
  if (segments.length === 0) return [];
  const length = segments.reduce((sum, segment) => sum + (segment.length_mm ?? 0), 0);
  const outer = Math.max(...segments.map((segment) => segment.outer_radius_mm ?? 0));
  const inner = Math.min(...segments.map((segment) => segment.inner_radius_mm ?? Infinity));
  return [
    fact("Length", with_unit(length, "mm", given), segments.length > 1 ? `${segments.length} segments` : ""),
    fact("Outer diameter", with_unit(2 * outer, "mm", given), `bore ${with_unit(2 * inner, "mm", given)}`),
  ];
}

/** @param {Object} report @param {string} role @returns {string} materials that have it */
function materials_for(report, role) {
  return listed(
    list(report.materials)
      .filter((material) => list(material.role).includes(role))
      .map((material) => material.name),
  );
}

/** @param {Object} report @returns {HTMLElement[]} */
function material_facts(report) {
  return [
    ["Lattice", "lattice"],
    ["Liner", "liner"],
  ]
    .map(([name, role]) => [name, materials_for(report, role)])
    .filter(([, text]) => text)
    .map(([name, text]) => fact(name, text));
}

/** @param {Object} point of a curve @returns {string} "stretch 1.234, twist 20°", less what is none */
function deed(point) {
  const words = [`stretch ${measured(point.stretch)}`];
  if (Math.abs(point.twist_deg ?? 0) > 5e-4) words.push(`twist ${with_unit(point.twist_deg, "°")}`);
  if (Math.abs(point.bend_deg ?? 0) > 5e-4) words.push(`bend ${with_unit(point.bend_deg, "°")}`);
  return listed(words);
}

/** @param {Object} report @returns {HTMLElement[]} what each segment does, at most three of them */
function deed_facts(report) {
  const segments = predicted_segments(report);
  return segments.slice(0, 3).map((segment) => {
    const point = largest_point(segment.curve);
    const name = segments.length > 1 ? `Segment ${segment.segment} at ` : "At ";
    return fact(
      name + with_unit(point.pressure_kPa, "kPa", given),
      capital(deed(point)),
      point.stable === false ? "▲ unstable" : "",
    );
  });
}

/** @param {Object} checks @returns {string} "1 error, 2 warnings" or "no findings" */
function checks_summary(checks) {
  const words = [
    ["error", checks?.errors],
    ["warning", checks?.warnings],
    ["note", checks?.notes],
  ]
    .filter(([, n]) => n > 0)
    .map(([name, n]) => counted(n, name));
  return words.length ? listed(words) : "no findings";
}

/** @param {Object} report */
function show_facts(report) {
  by_id("name").textContent = report.name || "Actuator";
  by_id("facts").append(
    ...size_facts(list(report.design?.segments)),
    ...material_facts(report),
    ...deed_facts(report),
    fact("Checks", capital(checks_summary(report.checks))),
  );
  by_id("made-by").textContent = `Latticast ${report.program_version ?? ""}`;
}
