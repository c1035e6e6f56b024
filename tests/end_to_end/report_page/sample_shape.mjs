// SPDX-License-Identifier: GPL-3.0-or-later
// Tubes and helical strips that stretch, twist and bend by formulas: shapes of the sample report.

export const LENGTH_MM = 60;
export const INNER_MM = 12;
export const LINER_MM = 16;
export const OUTER_MM = 18;

/** @returns what segment 1 or 2 does at a pressure */
export function deed(segment, pressure_kPa) {
  const p = pressure_kPa / 40;
  return segment === 1
    ? { stretch: 1 + 0.18 * p + 0.06 * p * p, twist_deg: 38 * p, bend_deg: 0, widening: 1 + 0.03 * p }
    : { stretch: 1 + 0.1 * p, twist_deg: 0, bend_deg: 62 * p - 6 * p * p, widening: 1 + 0.05 * p };
}

/** Bends the straight, stretched actuator into an arc in the plane of x and z. */
function on_arc([x, y, z], length, bend) {
  if (Math.abs(bend) < 1e-9) return [x, y, z];
  const radius = length / bend;
  const angle = z / radius;
  return [radius - (radius - x) * Math.cos(angle), y, (radius - x) * Math.sin(angle)];
}

/** @returns the place of a point of the shape at rest, given in cylinder coordinates */
export function placed([r, theta, z], segment, pressure_kPa) {
  const { stretch, twist_deg, bend_deg, widening } = deed(segment, pressure_kPa);
  const turned = theta + ((twist_deg * Math.PI) / 180) * (z / LENGTH_MM);
  const point = [r * widening * Math.cos(turned), r * widening * Math.sin(turned), stretch * z];
  return on_arc(point, stretch * LENGTH_MM, (bend_deg * Math.PI) / 180);
}

/** @returns the frame of a segment's end: twist about the axis first, then the bend about y */
export function end_frame(segment, pressure_kPa) {
  const { twist_deg, bend_deg } = deed(segment, pressure_kPa);
  const [a, b] = [(twist_deg * Math.PI) / 360, (bend_deg * Math.PI) / 360];
  return {
    origin_mm: placed([0, 0, LENGTH_MM], segment, pressure_kPa),
    quaternion: [
      Math.sin(b) * Math.sin(a),
      Math.sin(b) * Math.cos(a),
      Math.cos(b) * Math.sin(a),
      Math.cos(b) * Math.cos(a),
    ],
  };
}

/** A closed strip of rings: `rings` places of four corners along z. */
function closed_bar(corners_at, rings) {
  const points = [];
  const triangles = [];
  for (let i = 0; i < rings; ++i) points.push(...corners_at(i / (rings - 1)));
  for (let i = 0; i + 1 < rings; ++i) {
    for (let j = 0; j < 4; ++j) {
      const [a, b, c, d] = [4 * i + j, 4 * i + ((j + 1) % 4), 4 * i + 4 + ((j + 1) % 4), 4 * i + 4 + j];
      triangles.push(a, b, c, a, c, d);
    }
  }
  const last = 4 * (rings - 1);
  triangles.push(0, 2, 1, 0, 3, 2, last, last + 1, last + 2, last, last + 2, last + 3);
  return { points, triangles };
}

/** @returns points in cylinder coordinates and triangles of eight strips that wind around the liner */
export function lattice_shape(strips = 8, turn_deg = 60) {
  const points = [];
  const triangles = [];
  for (let k = 0; k < strips; ++k) {
    for (const sense of [1, -1]) {
      const bar = closed_bar((t) => {
        const theta = (2 * Math.PI * k) / strips + (sense * t * turn_deg * Math.PI) / 180;
        return [
          [LINER_MM, theta - 0.06, t * LENGTH_MM],
          [OUTER_MM, theta - 0.06, t * LENGTH_MM],
          [OUTER_MM, theta + 0.06, t * LENGTH_MM],
          [LINER_MM, theta + 0.06, t * LENGTH_MM],
        ];
      }, 25);
      triangles.push(...bar.triangles.map((index) => index + points.length));
      points.push(...bar.points);
    }
  }
  return { points, triangles };
}

/** @returns points in cylinder coordinates and triangles of the liner, a thick tube open at its ends */
export function liner_shape(around = 48, along = 30) {
  const points = [];
  const triangles = [];
  const ring = [
    [INNER_MM, 0],
    ...Array.from({ length: along }, (_, i) => [LINER_MM, i / (along - 1)]),
    ...Array.from({ length: along }, (_, i) => [INNER_MM, 1 - i / (along - 1)]),
  ].slice(1);
  for (let j = 0; j < around; ++j)
    for (const [r, t] of ring) points.push([r, (2 * Math.PI * j) / around, t * LENGTH_MM]);
  for (let j = 0; j < around; ++j) {
    for (let i = 0; i < ring.length; ++i) {
      const [a, b] = [j * ring.length + i, j * ring.length + ((i + 1) % ring.length)];
      const next = (index) => (index + ring.length) % points.length;
      triangles.push(a, next(a), next(b), a, next(b), b);
    }
  }
  return { points, triangles };
}
