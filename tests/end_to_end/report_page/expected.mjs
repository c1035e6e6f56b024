// SPDX-License-Identifier: GPL-3.0-or-later
// What a page must show, from the blocks of data in its file, computed here once more: rotation matrices where the
// page uses quaternions, glTF's own node names and target names where it goes by order.

import { readFileSync } from "node:fs";

/** @returns {string} text of the script element with an id */
function block(html, id) {
  const open = html.match(new RegExp(`<script[^>]* id="${id}">`));
  const start = open.index + open[0].length;
  return html.slice(start, html.indexOf("</script>", start));
}

/** @param {string} file @returns {{html: string, report: Object, view: Object, meshes: Map}} */
export function read_page(file) {
  const html = readFileSync(file, "utf8");
  const model = Buffer.from(block(html, "model"), "base64");
  return {
    html,
    report: JSON.parse(block(html, "report")),
    view: JSON.parse(block(html, "view")),
    meshes: model.length ? read_meshes(model) : new Map(),
  };
}

/** @returns {Map<string, {rest: number[], targets: Map<number, number[]>}>} by node, targets by their pressure */
function read_meshes(file) {
  const length = file.readUInt32LE(12);
  const gltf = JSON.parse(file.subarray(20, 20 + length).toString());
  const data = file.subarray(28 + length);
  const values = (index) => {
    const { bufferView, byteOffset = 0, count } = gltf.accessors[index];
    const start = (gltf.bufferViews[bufferView].byteOffset ?? 0) + byteOffset;
    return Array.from({ length: 3 * count }, (_, i) => data.readFloatLE(start + 4 * i));
  };
  return new Map(
    gltf.nodes
      .filter((node) => node.mesh !== undefined)
      .map((node) => {
        const {
          primitives: [primitive],
          extras,
        } = gltf.meshes[node.mesh];
        const targets = new Map(
          (primitive.targets ?? []).map((target, i) => [parseFloat(extras.targetNames[i]), values(target.POSITION)]),
        );
        return [node.name, { rest: values(primitive.attributes.POSITION), targets }];
      }),
  );
}

function matrix_of([x, y, z, w]) {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
    [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
    [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
  ];
}

const times_vector = (m, v) => m.map((row) => row.reduce((sum, value, i) => sum + value * v[i], 0));
const times_matrix = (a, b) =>
  a.map((row) => [0, 1, 2].map((j) => row.reduce((sum, value, k) => sum + value * b[k][j], 0)));

/** Turning from a to b by a part of their angle, as a product of a and a rotation about one axis (Rodrigues). */
function matrix_between(a, b, t) {
  const [ma, mb] = [matrix_of(a), matrix_of(b)];
  const relative = times_matrix(
    [0, 1, 2].map((i) => ma.map((row) => row[i])),
    mb,
  );
  const angle = Math.acos(Math.max(-1, Math.min(1, (relative[0][0] + relative[1][1] + relative[2][2] - 1) / 2)));
  if (angle < 1e-7) return ma;
  const [x, y, z] = [
    [2, 1],
    [0, 2],
    [1, 0],
  ].map(([i, j]) => (relative[i][j] - relative[j][i]) / (2 * Math.sin(angle)));
  const [c, s] = [Math.cos(t * angle), Math.sin(t * angle)];
  const part = [
    [c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s],
    [y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s],
    [z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)],
  ];
  return times_matrix(ma, part);
}

/** @returns the states around a pressure and the weight of the upper one */
function around(states, pressure) {
  const upper = states.find((state) => state.pressure_kPa >= pressure) ?? states.at(-1);
  const lower = states.findLast((state) => state.pressure_kPa <= pressure) ?? states[0];
  const span = upper.pressure_kPa - lower.pressure_kPa;
  return { lower, upper, t: span > 0 ? (pressure - lower.pressure_kPa) / span : 0 };
}

/**
 * @param {Object} data of read_page()
 * @param {number[]} pressures_kPa of the segments
 * @returns {Map<string, number[]>} x, y, z in mm of every body's vertices
 */
export function expected_vertices({ view, meshes }, pressures_kPa) {
  const result = new Map();
  let origin = [0, 0, 0];
  let turn = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  view.segments.forEach((segment, index) => {
    const { lower, upper, t } = around(segment.states, pressures_kPa[index]);
    for (const { node } of segment.bodies) {
      const { rest, targets } = meshes.get(node);
      const [a, b] = [targets.get(lower.pressure_kPa), targets.get(upper.pressure_kPa)];
      const own = rest.map((value, i) => value + (1 - t) * (a?.[i] ?? 0) + t * (b?.[i] ?? 0));
      const placed = [];
      for (let i = 0; i < own.length; i += 3)
        placed.push(...times_vector(turn, own.slice(i, i + 3)).map((v, k) => v + origin[k]));
      result.set(node, placed);
    }
    const end = lower.end.origin_mm.map((value, i) => value + t * (upper.end.origin_mm[i] - value));
    origin = times_vector(turn, end).map((value, i) => value + origin[i]);
    turn = times_matrix(turn, matrix_between(lower.end.quaternion, upper.end.quaternion, t));
  });
  return result;
}
