// SPDX-License-Identifier: GPL-3.0-or-later
// What was made and what was skipped, and what it cost in error and time.
"use strict";

/** @param {Object} report */
function show_plan(report) {
  const plan = list(report.plan);
  const box = by_id("plan-content");
  if (plan.length) {
    box.append(
      table_of(
        "Stages, done or skipped",
        [
          { head: "Stage", cell: (p) => p.stage },
          { head: "Result", cell: (p) => (p.runs ? "✓ done" : "— skipped") },
          { head: "Why", cell: (p) => p.reason || null },
        ],
        plan,
      ),
    );
  }
  const files = list(report.files);
  if (files.length) {
    box.append(
      h(
        "details",
        {},
        h("summary", {}, `${counted(files.length, "file")} written`),
        h(
          "ul",
          { class: "columns" },
          files.map((file) => h("li", {}, file)),
        ),
      ),
    );
  }
}

/** @param {Object[]} pieces @returns {HTMLElement} */
function mesh_error_table(pieces) {
  return table_of(
    "Meshes against the exact solids",
    [
      { head: "Piece", cell: (p) => p.name },
      { head: "Triangles", number: true, cell: (p) => count(p.triangles) },
      { head: "Components", number: true, cell: (p) => count(p.components) },
      { head: "Genus", number: true, cell: (p) => count(p.genus) },
      { head: "Surface error, at most", unit: "mm", number: true, cell: (p) => measured(p.surface_error_mm, 2) },
      { head: "Volume error, at most", unit: "mm³", number: true, cell: (p) => measured(p.volume_error_mm3, 2) },
    ],
    pieces,
  );
}

/** @param {Object[]} segments predictions @returns {HTMLElement} largest errors of each */
function prediction_error_table(segments) {
  const largest = (segment, key) => {
    const values = segment.curve.map((point) => point[key]).filter(is_number);
    return values.length ? scientific(Math.max(...values)) : MISSING;
  };
  return table_of(
    "Prediction: largest over the computed pressures",
    [
      { head: "Segment", cell: (s) => String(s.segment) },
      { head: "Points", number: true, cell: (s) => count(s.curve.length) },
      { head: "Residual", number: true, cell: (s) => largest(s, "residual") },
      { head: "Estimated error", number: true, cell: (s) => largest(s, "error_estimate") },
    ],
    segments,
  );
}

/** @param {Object[]} times @returns {HTMLElement} */
function time_table(times) {
  const total = times.reduce((sum, time) => sum + (time.seconds ?? 0), 0);
  return table_of(
    "Run time",
    [
      { head: "Stage", cell: (t) => t.stage },
      { head: "Time", unit: "s", number: true, cell: (t) => (is_number(t.seconds) ? t.seconds.toFixed(3) : MISSING) },
    ],
    [...times, { stage: "sum", seconds: total }],
  );
}

/** @param {Object} report */
function show_errors_and_times(report) {
  const box = by_id("errors-content");
  const pieces = list(report.pieces);
  const segments = predicted_segments(report);
  const times = list(report.times);
  if (pieces.length) box.append(mesh_error_table(pieces));
  if (segments.length) box.append(prediction_error_table(segments));
  if (times.length) box.append(time_table(times));
  const model = Object.entries(report.design?.model ?? {}).map(([key, value]) => `${key} ${value}`);
  if (model.length) box.append(h("p", { class: "note" }, `Model: ${model.join(", ")}.`));
  if (box.children.length === 0) box.append(h("p", {}, "Nothing was measured."));
}
