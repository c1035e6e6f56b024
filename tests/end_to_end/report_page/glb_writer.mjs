// SPDX-License-Identifier: GPL-3.0-or-later
// Writes bodies with morph targets as a binary glTF file, laid out as latticast lays it out.

const FLOAT = 5126;
const UNSIGNED_INT = 5125;

/** mm with z up to m with y up, by columns. */
const MM_TO_M = [1e-3, 0, 0, 0, 0, 0, -1e-3, 0, 0, 1e-3, 0, 0, 0, 0, 0, 1];

/** Collects arrays into one buffer and hands out accessors of them. */
class Buffer3d {
  chunks = [];
  bytes = 0;
  views = [];
  accessors = [];

  /** @param {Float32Array|Uint32Array} array @param {string} type @param {number} target */
  add(array, type, target) {
    const width = type === "VEC3" ? 3 : 1;
    const accessor = {
      bufferView: this.views.length,
      componentType: array instanceof Float32Array ? FLOAT : UNSIGNED_INT,
      count: array.length / width,
      type,
    };
    if (type === "VEC3") Object.assign(accessor, bounds_of(array));
    this.views.push({ buffer: 0, byteOffset: this.bytes, byteLength: array.byteLength, ...(target ? { target } : {}) });
    this.chunks.push(Buffer.from(array.buffer, array.byteOffset, array.byteLength));
    this.bytes += array.byteLength;
    this.accessors.push(accessor);
    return this.accessors.length - 1;
  }
}

function bounds_of(array) {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < array.length; ++i) {
    min[i % 3] = Math.min(min[i % 3], array[i]);
    max[i % 3] = Math.max(max[i % 3], array[i]);
  }
  return { min, max };
}

/** @param {{node: string, positions: Float32Array, indices: Uint32Array, targets: Float32Array[], names: string[]}} body */
function mesh_of(buffer, body) {
  const primitive = {
    attributes: { POSITION: buffer.add(body.positions, "VEC3", 34962) },
    indices: buffer.add(body.indices, "SCALAR", 34963),
  };
  if (body.targets.length) primitive.targets = body.targets.map((t) => ({ POSITION: buffer.add(t, "VEC3", 34962) }));
  return {
    name: body.node,
    primitives: [primitive],
    extras: { targetNames: body.names },
    ...(body.targets.length ? { weights: body.targets.map(() => 0) } : {}),
  };
}

/** @param {Buffer} chunk @param {number} filler @returns {Buffer} of whole words */
function padded(chunk, filler) {
  return Buffer.concat([chunk, Buffer.alloc((4 - (chunk.length % 4)) % 4, filler)]);
}

function header_of(length, kind) {
  const header = Buffer.alloc(8);
  header.writeUInt32LE(length, 0);
  header.writeUInt32LE(kind, 4);
  return header;
}

/** @param {Object[]} bodies as of mesh_of() @returns {Buffer} the file */
export function glb_of(bodies) {
  const buffer = new Buffer3d();
  const meshes = bodies.map((body) => mesh_of(buffer, body));
  const nodes = [
    { name: "actuator", matrix: MM_TO_M, children: bodies.map((_, i) => i + 1) },
    ...bodies.map((body, i) => ({ name: body.node, mesh: i })),
  ];
  const json = padded(
    Buffer.from(
      JSON.stringify({
        asset: { version: "2.0" },
        scene: 0,
        scenes: [{ nodes: [0] }],
        nodes,
        meshes,
        accessors: buffer.accessors,
        bufferViews: buffer.views,
        buffers: [{ byteLength: buffer.bytes }],
      }),
    ),
    0x20,
  );
  const data = padded(Buffer.concat(buffer.chunks), 0);
  const file = Buffer.alloc(12);
  file.write("glTF", 0, "latin1");
  file.writeUInt32LE(2, 4);
  file.writeUInt32LE(12 + 8 + json.length + 8 + data.length, 8);
  return Buffer.concat([file, header_of(json.length, 0x4e4f534a), json, header_of(data.length, 0x004e4942), data]);
}
