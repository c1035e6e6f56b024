// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks of data that the page carries. Every list may be empty and every value null.
"use strict";

/** @param {string} id of a script element @returns {Object} its JSON */
function json_block(id) {
  return JSON.parse(by_id(id).textContent);
}

/** @param {Array|null|undefined} value @returns {Array} */
function list(value) {
  return Array.isArray(value) ? value : [];
}

/**
 * @typedef {Object} PageData
 * @property {Object} report   as docs/report.md describes it
 * @property {Object} view     bodies, states and markers
 * @property {string} model    base64 of the binary glTF file; empty without meshes
 */

/** @returns {PageData} */
function read_data() {
  return {
    report: json_block("report"),
    view: json_block("view"),
    model: by_id("model").textContent.trim(),
  };
}

/** @param {Object} report @returns {Object[]} predictions of the segments, in their order */
function predicted_segments(report) {
  return list(report.prediction?.segments).filter((segment) => list(segment.curve).length > 0);
}

/** @param {Object} report @param {number} number from 1 @returns {Object|undefined} its prediction */
function prediction_of(report, number) {
  return predicted_segments(report).find((segment) => segment.segment === number);
}

/** @param {Object[]} curve @returns {Object|undefined} the asked point of largest pressure, or the last */
function largest_point(curve) {
  return curve.filter((point) => point.asked).at(-1) ?? curve.at(-1);
}

/** @param {Object} report @param {number} number @returns {string} " of segment 2", or "" when there is one */
function of_segment(report, number) {
  return list(report.design?.segments).length > 1 && number > 0 ? ` of segment ${number}` : "";
}
