// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the meshes out of the page's binary glTF file, and their vertices at a pressure.
"use strict";

const GLB_MAGIC = 0x46546c67;
const COMPONENTS = { 5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };

/** @param {string} text base64 @returns {Uint8Array} */
function bytes_of_base64(text) {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < characters.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}

/** @param {Uint8Array} bytes of the file @returns {{json: Object, data: Uint8Array}} its two chunks */
function glb_chunks(bytes) {
  const words = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 20 || words.getUint32(0, true) !== GLB_MAGIC)
    throw new Error("the meshes are no binary glTF file");
  const json_end = 20 + words.getUint32(12, true);
  return {
    json: JSON.parse(new TextDecoder().decode(bytes.subarray(20, json_end))),
    data: bytes.subarray(json_end + 8),
  };
}

/** @returns {TypedArray} values of an accessor, copied so that they are aligned */
function accessor_values({ json, data }, index) {
  const accessor = json.accessors[index];
  const Component = COMPONENTS[accessor.componentType];
  const view = json.bufferViews[accessor.bufferView];
  const width = { SCALAR: 1, VEC3: 3 }[accessor.type];
  const row = width * Component.BYTES_PER_ELEMENT;
  const start = (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
  const stride = view.byteStride ?? row;
  const bytes = new Uint8Array(accessor.count * row);
  if (stride === row) bytes.set(data.subarray(start, start + bytes.length));
  else
    for (let i = 0; i < accessor.count; ++i)
      bytes.set(data.subarray(start + i * stride, start + i * stride + row), i * row);
  return new Component(bytes.buffer);
}

/**
 * @typedef {Object} Body
 * @property {string} node
 * @property {Float32Array} rest       positions in mm, in the frame of its segment
 * @property {Float32Array[]} targets  what each state but the rest adds
 * @property {Float32Array} present    positions at the present pressure
 * @property {TypedArray} indices      of triangles
 */

/** @param {Uint8Array} bytes @returns {Map<string, Body>} by the names of their nodes */
function read_glb(bytes) {
  const chunks = glb_chunks(bytes);
  const bodies = new Map();
  for (const node of list(chunks.json.nodes).filter((n) => n.mesh !== undefined)) {
    const primitive = chunks.json.meshes[node.mesh].primitives[0];
    const rest = accessor_values(chunks, primitive.attributes.POSITION);
    bodies.set(node.name, {
      node: node.name,
      rest,
      present: rest.slice(),
      indices: accessor_values(chunks, primitive.indices),
      targets: list(primitive.targets).map((target) => accessor_values(chunks, target.POSITION)),
    });
  }
  return bodies;
}

/** Puts a body's vertices at its segment's pose. @param {Object} segment of the view */
function morph(body, segment, pose) {
  const { rest, present, targets } = body;
  const lower = targets[target_of_state(segment, pose.lower)];
  const upper = targets[target_of_state(segment, pose.upper)];
  for (let i = 0; i < rest.length; ++i) {
    present[i] = rest[i] + (1 - pose.t) * (lower ? lower[i] : 0) + pose.t * (upper ? upper[i] : 0);
  }
}

/** @returns {Float32Array} the body's vertices in the frame of the chain */
function placed_vertices({ present }, { base }) {
  const [ox, oy, oz] = base.origin_mm;
  const [ex, ey, ez] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ].map((axis) => turned(base.quaternion, axis));
  const result = new Float32Array(present.length);
  for (let i = 0; i < result.length; i += 3) {
    const [x, y, z] = [present[i], present[i + 1], present[i + 2]];
    result[i] = ox + x * ex[0] + y * ey[0] + z * ez[0];
    result[i + 1] = oy + x * ex[1] + y * ey[1] + z * ez[1];
    result[i + 2] = oz + x * ex[2] + y * ey[2] + z * ez[2];
  }
  return result;
}

/** @param {Iterable<Float32Array>} arrays of points @returns {{min: number[], max: number[]}} */
function bounds_of(arrays) {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (const array of arrays) {
    for (let i = 0; i < array.length; ++i) {
      if (array[i] < min[i % 3]) min[i % 3] = array[i];
      if (array[i] > max[i % 3]) max[i % 3] = array[i];
    }
  }
  return { min, max };
}
