// SPDX-License-Identifier: GPL-3.0-or-later
// Where every segment is at its present pressure. Lengths mm, quaternions [x, y, z, w].
"use strict";

/** @typedef {{origin_mm: number[], quaternion: number[]}} Frame */

/** @returns {Frame} of the chain's base */
function base_frame() {
  return { origin_mm: [0, 0, 0], quaternion: [0, 0, 0, 1] };
}

/** @param {number[]} q @param {number[]} v @returns {number[]} v turned by q */
function turned([qx, qy, qz, qw], [x, y, z]) {
  const tx = 2 * (qy * z - qz * y);
  const ty = 2 * (qz * x - qx * z);
  const tz = 2 * (qx * y - qy * x);
  return [x + qw * tx + qy * tz - qz * ty, y + qw * ty + qz * tx - qx * tz, z + qw * tz + qx * ty - qy * tx];
}

/** @param {number[]} a @param {number[]} b @returns {number[]} first b, then a */
function quaternion_product([ax, ay, az, aw], [bx, by, bz, bw]) {
  return [
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
    aw * bw - ax * bx - ay * by - az * bz,
  ];
}

/** @param {Frame} frame @param {number[]} point in the frame @returns {number[]} where the frame stands */
function placed_point(frame, point) {
  return turned(frame.quaternion, point).map((value, i) => value + frame.origin_mm[i]);
}

/** @param {Frame} outer @param {Frame} inner given in outer @returns {Frame} */
function composed(outer, inner) {
  return {
    origin_mm: placed_point(outer, inner.origin_mm),
    quaternion: quaternion_product(outer.quaternion, inner.quaternion),
  };
}

/** @param {number} t from 0 to 1 @returns {number[]} between a and b, along the shorter way */
function slerp(a, b, t) {
  const dot = a.reduce((sum, value, i) => sum + value * b[i], 0);
  const angle = Math.acos(Math.min(1, Math.abs(dot)));
  const [wa, wb] =
    angle < 1e-6 ? [1 - t, t] : [Math.sin((1 - t) * angle) / Math.sin(angle), Math.sin(t * angle) / Math.sin(angle)];
  const mixed = a.map((value, i) => wa * value + (dot < 0 ? -wb : wb) * b[i]);
  const size = Math.hypot(...mixed);
  return mixed.map((value) => value / size);
}

/**
 * @param {number[]} values ascending, at least one
 * @returns {{lower: number, upper: number, t: number}} neighbours of value; the nearest one outside
 */
function neighbours(values, value) {
  const above = values.findIndex((other) => other >= value);
  if (above === 0 || values.length === 1) return { lower: 0, upper: 0, t: 0 };
  if (above < 0) return { lower: values.length - 1, upper: values.length - 1, t: 0 };
  if (values[above] === value) return { lower: above, upper: above, t: 0 };
  return { lower: above - 1, upper: above, t: (value - values[above - 1]) / (values[above] - values[above - 1]) };
}

/** @param {Object} end_a @param {Object} end_b end frames of two states @returns {Frame} */
function frame_between(end_a, end_b, t) {
  return {
    origin_mm: end_a.origin_mm.map((value, i) => value + t * (end_b.origin_mm[i] - value)),
    quaternion: slerp(end_a.quaternion, end_b.quaternion, t),
  };
}

/**
 * @typedef {Object} Pose  one segment at its present pressure
 * @property {number} lower  state at or below
 * @property {number} upper  state at or above
 * @property {number} t      weight of the upper one
 * @property {Frame} base    in the frame of the chain
 * @property {Frame} end     in the frame of the chain
 */

/**
 * @param {Object[]} segments of the view
 * @param {number[]} pressures_kPa one for each
 * @returns {Pose[]}
 */
function chain_poses(segments, pressures_kPa) {
  let base = base_frame();
  return segments.map((segment, i) => {
    const states = segment.states;
    const place = neighbours(
      states.map((state) => state.pressure_kPa),
      pressures_kPa[i],
    );
    const own = frame_between(states[place.lower].end, states[place.upper].end, place.t);
    const pose = { ...place, base, end: composed(base, own) };
    base = pose.end;
    return pose;
  });
}

/** @param {Object} segment of the view @returns {number} index of its state at rest */
function rest_state(segment) {
  return Math.max(
    0,
    segment.states.findIndex((state) => state.pressure_kPa === 0),
  );
}

/** The rest has no morph target, so that those of later states move up by one; null for the rest. */
function target_of_state(segment, state) {
  const rest = rest_state(segment);
  return state === rest ? null : state - (state > rest ? 1 : 0);
}

/** @param {number[][]} positions one for each state @param {Pose} pose @returns {number[]} in the chain */
function marker_place(positions, pose) {
  const [a, b] = [positions[pose.lower], positions[pose.upper]];
  return placed_point(
    pose.base,
    a.map((value, i) => value + pose.t * (b[i] - value)),
  );
}

/** @param {Pose} pose @returns {number[][]} points of the arc between the segment's ends, which lies along both axes */
function arc_points(pose, pieces = 16) {
  const [a, b] = [pose.base.origin_mm, pose.end.origin_mm];
  const [ta, tb] = [turned(pose.base.quaternion, [0, 0, 1]), turned(pose.end.quaternion, [0, 0, 1])];
  const angle = Math.acos(
    Math.max(
      -1,
      Math.min(
        1,
        ta.reduce((sum, v, i) => sum + v * tb[i], 0),
      ),
    ),
  );
  const chord = Math.hypot(...a.map((v, i) => b[i] - v));
  const handle = angle < 1e-3 ? chord / 3 : (chord * (4 / 3) * Math.tan(angle / 4)) / (2 * Math.sin(angle / 2));
  return Array.from({ length: pieces + 1 }, (_, k) => {
    const t = k / pieces;
    const s = 1 - t;
    return a.map(
      (_, i) =>
        s * s * s * a[i] +
        3 * s * s * t * (a[i] + handle * ta[i]) +
        3 * s * t * t * (b[i] - handle * tb[i]) +
        t * t * t * b[i],
    );
  });
}
