// SPDX-License-Identifier: GPL-3.0-or-later
// Findings of the checks. One that has a place can be shown in the 3-D view.
"use strict";

const SEVERITY_SIGNS = { error: "✕", warning: "▲", note: "●" };

/** @param {string} severity @returns {HTMLElement} sign and word: colour alone tells nothing */
function severity_mark(severity) {
  return h(
    "span",
    { class: `severity ${severity}` },
    h("span", { "aria-hidden": "true" }, SEVERITY_SIGNS[severity] ?? "●"),
    ` ${severity}`,
  );
}

/** @param {Object} finding @returns {string} where on the actuator, as far as it is known */
function place_text(finding) {
  const words = [];
  if (finding.segment > 0) words.push(`segment ${finding.segment}`);
  if (finding.part) words.push(finding.part);
  if (is_number(finding.theta_deg)) words.push(`θ\u00a0${with_unit(finding.theta_deg, "°")}`);
  if (is_number(finding.z_mm)) words.push(`z\u00a0${with_unit(finding.z_mm, "mm")}`);
  if (is_number(finding.pressure_kPa)) words.push(`at ${with_unit(finding.pressure_kPa, "kPa")}`);
  return words.join(", ");
}

/** @param {Object} finding @returns {string} "3.2 of at most 2 mm" cannot be told apart from at least */
function value_text(finding) {
  if (!is_number(finding.value)) return MISSING;
  const limit = is_number(finding.limit) ? ` (limit ${measured(finding.limit)})` : "";
  return `${with_unit(finding.value, finding.unit ?? "")}${limit}`;
}

/** @param {number} index @param {function(number)} on_show @returns {HTMLElement} */
function show_button(index, on_show) {
  return h(
    "button",
    {
      type: "button",
      class: "small",
      "aria-label": `Show finding ${index + 1} in the 3-D view`,
      "aria-pressed": "false",
      "data-finding": index,
      onclick: () => on_show(index),
    },
    "Show",
  );
}

/**
 * @param {Object} report
 * @param {Set<number>} placed  findings that the view has a pin for
 * @param {function(number)} on_show  called with a finding's index
 */
function show_checks(report, placed, on_show) {
  const findings = list(report.checks?.findings);
  const box = by_id("checks-content");
  box.append(h("p", {}, `The checks gave ${checks_summary(report.checks)}.`));
  if (findings.length === 0) return;
  const table = table_of(
    "Findings of the checks",
    [
      { head: "No.", number: true, cell: (_, i) => String(i + 1) },
      { head: "Severity", cell: (f) => severity_mark(f.severity) },
      {
        head: "Finding",
        cell: (f) => [
          h("p", {}, capital(f.message ?? "")),
          f.remedy ? h("p", { class: "remedy" }, capital(f.remedy)) : "",
          h("code", {}, f.code),
        ],
      },
      { head: "Where", cell: place_text },
      { head: "Value", number: true, cell: value_text },
      ...(placed.size
        ? [{ head: "In the view", cell: (_, i) => (placed.has(i) ? show_button(i, on_show) : MISSING) }]
        : []),
    ],
    findings,
    (_, i) => ({ id: `finding-${i}`, tabindex: "-1" }),
  );
  box.append(h("div", { class: "findings" }, table));
}

/** Marks the finding that the view shows now. @param {number|null} index */
function mark_finding(index) {
  for (const line of document.querySelectorAll("#checks-content tbody tr")) {
    const chosen = line.id === `finding-${index}`;
    line.classList.toggle("chosen", chosen);
    line.querySelector("button")?.setAttribute("aria-pressed", String(chosen));
  }
}
