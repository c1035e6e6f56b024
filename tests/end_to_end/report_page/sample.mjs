// SPDX-License-Identifier: GPL-3.0-or-later
// sample.mjs FOLDER [--hostile | --bare | --large]: the parts of a report (report.json, view.json, model.glb) of a
// chain that was made up: two segments, one that twists and one that bends.
//   --hostile  texts that try to leave their place
//   --bare     nothing that can be left out: no load, no lattice, no meshes, empty lists and nulls
//   --large    12 segments, 2000 load cases, 60 findings

import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { glb_of } from "./glb_writer.mjs";
import {
  deed,
  end_frame,
  INNER_MM,
  lattice_shape,
  LENGTH_MM,
  liner_shape,
  LINER_MM,
  OUTER_MM,
  placed,
} from "./sample_shape.mjs";

const STATES_KPA = [
  [-10, 0, 10, 25, 40],
  [0, 10, 20, 30, 40],
];
const HOSTILE = "</script><script>window.broken = 1</script><!-- <b>&amp; \"quoted\" 'ö' \u2028";

function body(node, shape, segment) {
  const at = (pressure) => shape.points.map((point) => placed(point, segment, pressure)).flat();
  const rest = at(0);
  const pressures = STATES_KPA[segment - 1].filter((p) => p !== 0);
  return {
    node,
    positions: Float32Array.from(rest),
    indices: Uint32Array.from(shape.triangles),
    targets: pressures.map((p) => Float32Array.from(at(p), (value, i) => value - rest[i])),
    names: pressures.map((p) => `${p} kPa`),
  };
}

function segment_view(number) {
  return {
    number,
    rest_length_mm: LENGTH_MM,
    bodies: [
      { node: `segment-${number}-lattice`, role: "lattice" },
      { node: `segment-${number}-liner`, role: "liner" },
    ],
    states: STATES_KPA[number - 1].map((pressure_kPa) => ({
      pressure_kPa,
      end: end_frame(number, pressure_kPa),
      lattice_strain_max: 0.002 * Math.abs(pressure_kPa),
    })),
  };
}

function marker(finding, segment, point) {
  return { finding, segment, positions_mm: STATES_KPA[segment - 1].map((p) => placed(point, segment, p)) };
}

function curve_point(segment, pressure_kPa) {
  const { stretch, twist_deg, bend_deg, widening } = deed(segment, pressure_kPa);
  return {
    pressure_kPa,
    asked: pressure_kPa % 10 === 0,
    stretch,
    twist_deg,
    bend_deg,
    bend_direction_deg: 0,
    inner_radius_mm: INNER_MM * widening,
    outer_radius_mm: OUTER_MM * widening,
    length_mm: LENGTH_MM * stretch,
    stable: pressure_kPa < 35,
    residual: 1.2e-15,
    error_estimate: 4e-13,
  };
}

function branch(segment, factor, from) {
  return Array.from({ length: 21 }, (_, i) => {
    const pressure_kPa = from + (i * (40 - from)) / 20;
    const { stretch, twist_deg, bend_deg, widening } = deed(segment, pressure_kPa * factor);
    return { pressure_kPa, stretch, twist_deg, bend_deg, outer_radius_mm: OUTER_MM * widening };
  });
}

function prediction_segment(segment) {
  const from = STATES_KPA[segment - 1][0];
  return {
    segment,
    curve: Array.from({ length: 40 - from + 1 }, (_, i) => curve_point(segment, from + i)),
    band: {
      low_factor: 0.87,
      high_factor: 1.13,
      softest: branch(segment, 1 / 0.87, from),
      stiffest: branch(segment, 1 / 1.13, from),
    },
    limit_points:
      segment === 1
        ? [
            {
              kind: "limit-point",
              pressure_kPa: 35,
              text: "limit point (ballooning) at 35 kPa: the wall's volume grows without more pressure",
            },
          ]
        : [],
    turning_points:
      segment === 2
        ? [
            {
              quantity: "bend",
              pressure_kPa: 38,
              value_deg: deed(2, 38).bend_deg,
              text: "bending is largest at 38 kPa",
            },
          ]
        : [],
    stable_from_kPa: from,
    stable_to_kPa: segment === 1 ? 35 : null,
    message: "",
  };
}

/** @returns the place and frame of the chain's tip, and points of its centre line, at a load case */
function chain_case([p1, p2]) {
  const frame = end_frame(1, p1);
  const rotate = ([x, y, z]) => {
    const a = (deed(1, p1).twist_deg * Math.PI) / 180;
    return [x * Math.cos(a) - y * Math.sin(a), x * Math.sin(a) + y * Math.cos(a), z];
  };
  const second = (z) => rotate(placed([0, 0, z], 2, p2)).map((value, i) => value + frame.origin_mm[i]);
  const line = [0, 20, 40].map((z) => placed([0, 0, z], 1, p1));
  for (let z = 0; z <= LENGTH_MM; z += 10) line.push(second(z));
  const bend = (deed(2, p2).bend_deg * Math.PI) / 180;
  return {
    pressures_kPa: [p1, p2],
    exists: true,
    tip_mm: line.at(-1),
    tip_axis: rotate([Math.sin(bend), 0, Math.cos(bend)]),
    twist_deg: deed(1, p1).twist_deg,
    tilt_deg: deed(2, p2).bend_deg,
    length_mm: LENGTH_MM * (deed(1, p1).stretch + deed(2, p2).stretch),
    stable: p1 < 35,
    centre_line_mm: line,
  };
}

function design_segment(number) {
  return {
    number,
    length_mm: LENGTH_MM,
    inner_radius_mm: INNER_MM,
    liner_outer_radius_mm: LINER_MM,
    outer_radius_mm: OUTER_MM,
    liner: { thickness_mm: 4, material: "ecoflex-00-50" },
    lattice: {
      thickness_mm: 2,
      material: "hei-cast-8400",
      fillet_mm: 0,
      rings: number === 1 ? { count: 8, pitch_mm: null, width_mm: 2 } : null,
      grids: [
        { angle_deg: 36, count: 8, widths_mm: [2, 2, 2, 2, 2, 2, 2, 2], horseshoe: null },
        {
          angle_deg: -36,
          count: 4,
          widths_mm: [2, 2.5, 2, 2.5],
          horseshoe: { radius_mm: 2.656, arc_deg: 180, alternate: true },
        },
      ],
    },
  };
}

function piece(name, kind, segment, material, volume_mm3, mass_g) {
  return {
    name,
    kind,
    segment,
    files: [`${name}.stl`, `${name}.glb`],
    material,
    volume_mm3,
    mass_g,
    triangles: 123456,
    components: 1,
    genus: 57,
    size_mm: [36.002, 36.002, 60],
    surface_error_mm: 0.00894,
    volume_error_mm3: 1.21,
  };
}

function finding(code, severity, segment, message, rest = {}) {
  return {
    code,
    severity,
    segment,
    part: "lattice",
    theta_deg: null,
    z_mm: null,
    pressure_kPa: null,
    value: null,
    limit: null,
    unit: "",
    message,
    remedy: "",
    ...rest,
  };
}

/** @param {string} text put wherever a design may put one @returns the report as JSON values */
function sample_report(text) {
  const cases = [];
  for (let a = 0; a <= 40; a += 10) for (let b = 0; b <= 40; b += 10) cases.push(chain_case([a, b]));
  const name = text || "sample-chain";
  return {
    schema: "latticast-report",
    schema_version: 1,
    program_version: "0.1.0",
    name,
    design: {
      segments: [design_segment(1), design_segment(2)],
      model: { kind: "layered", columns: "distributed", joint: "clear-span" },
      tolerance_mm: 0.01,
    },
    materials: [
      {
        name: "ecoflex-00-50",
        role: ["liner"],
        law: "yeoh",
        parameters: { c1_mpa: 0.0172, c2_mpa: 0.00021 },
        density_g_per_cm3: 1.07,
        source: `Data sheet ${text}`,
      },
      {
        name: "hei-cast-8400",
        role: ["lattice"],
        law: "neo-hooke",
        parameters: { mu_mpa: 0.61 },
        density_g_per_cm3: null,
        source: "Tension tests",
      },
    ],
    plan: [
      { stage: "lattice", runs: true, reason: "[make] names lattice" },
      { stage: "liner-mold", runs: false, reason: `[make] does not name it ${text}` },
    ],
    prediction: {
      reason_missing: "",
      segments: [prediction_segment(1), prediction_segment(2)],
      chain: { cases, summary: `${cases.length} of ${cases.length} cases have an equilibrium.` },
    },
    checks: {
      errors: 1,
      warnings: 1,
      notes: 1,
      findings: [
        finding("limit-point", "error", 1, `The asked 40 kPa lies beyond the limit point at 35 kPa. ${text}`, {
          pressure_kPa: 35,
          value: 40,
          limit: 35,
          unit: "kPa",
          remedy: "Ask for less pressure, or make the lattice thicker.",
        }),
        finding("strand-too-thin", "warning", 2, "A strand is 1.82 mm wide near the base of segment 2.", {
          theta_deg: 60,
          z_mm: 30,
          value: 1.82,
          limit: 2,
          unit: "mm",
          remedy: "Widen the strand to 2 mm.",
        }),
        finding("liner-bulges", "note", 1, "The liner bulges 0.31 mm through the largest opening.", {
          part: "liner",
          theta_deg: 0,
          z_mm: 45,
          pressure_kPa: 40,
          value: 0.31,
          unit: "mm",
        }),
      ],
    },
    pieces: [
      piece(`${name}-1-lattice`, "lattice", 1, "hei-cast-8400", 7174.5, null),
      piece(`${name}-1-liner`, "liner", 1, "ecoflex-00-50", 21112.4, 22.59),
      piece(`${name}-2-lattice`, "lattice", 2, "hei-cast-8400", 6421.8, null),
      piece(`${name}-2-liner`, "liner", 2, "ecoflex-00-50", 21112.4, 22.59),
      piece(`${name}-1-lattice-mold`, "lattice-mold", 1, null, 52345.6, null),
    ],
    files: [`${name}-1-lattice.stl`, `${name}-1-liner.stl`, `${name}-report.json`],
    times: [
      { stage: `${name}-1-lattice`, seconds: 0.031 },
      { stage: "prediction", seconds: 0.214 },
      { stage: "checks", seconds: 1.118 },
    ],
  };
}

function sample_view(text) {
  return {
    segments: [segment_view(1), segment_view(2)],
    markers: [marker(1, 2, [OUTER_MM, Math.PI / 3, 30]), marker(2, 1, [OUTER_MM, 0, 45])],
    cases: [
      [0, 0],
      [20, 20],
      [40, 0],
      [0, 40],
      [40, 40],
    ].map((pressures_kPa) => ({ pressures_kPa })),
    tolerance_mm: 0.1,
    note: `Meshes of this view are coarser than the written ones. ${text}`,
  };
}

/** The least that a report can hold: every list is empty, every value that may be missing is null. */
function bare_report() {
  return {
    schema: "latticast-report",
    schema_version: 1,
    program_version: "0.1.0",
    name: "bare",
    design: { segments: [{ ...design_segment(1), lattice: null }], model: null, tolerance_mm: null },
    materials: [],
    plan: [],
    prediction: null,
    checks: { errors: 0, warnings: 0, notes: 0, findings: [] },
    pieces: [],
    files: [],
  };
}

/** As much as a design can ask for. */
function large_report() {
  const report = sample_report("");
  const numbers = Array.from({ length: 12 }, (_, i) => i + 1);
  const like = (number) => 1 + ((number - 1) % 2);
  report.design.segments = numbers.map((number) => ({ ...design_segment(like(number)), number }));
  report.prediction.segments = numbers.map((number) => ({ ...prediction_segment(like(number)), segment: number }));
  report.prediction.chain.cases = Array.from({ length: 2000 }, (_, i) => ({
    ...chain_case([(i % 40) + 1, Math.floor(i / 50)]),
    pressures_kPa: numbers.map((number) => (i * number) % 41),
    centre_line_mm: null,
  }));
  report.checks.findings = Array.from({ length: 60 }, (_, i) => report.checks.findings[i % 3]);
  return report;
}

function large_view() {
  const numbers = Array.from({ length: 12 }, (_, i) => i + 1);
  const view = sample_view("");
  return {
    ...view,
    segments: numbers.map((number) => ({
      ...segment_view(1 + ((number - 1) % 2)),
      number,
      bodies: [{ node: `segment-${number}-lattice`, role: "lattice" }],
    })),
    markers: Array.from({ length: 60 }, (_, i) => marker(i, 1 + (i % 2), [OUTER_MM, i, 30])),
    cases: Array.from({ length: 2000 }, (_, i) => ({ pressures_kPa: numbers.map((number) => (i * number) % 41) })),
  };
}

function sample_bodies() {
  return [1, 2].flatMap((segment) => [
    body(`segment-${segment}-lattice`, lattice_shape(), segment),
    body(`segment-${segment}-liner`, liner_shape(), segment),
  ]);
}

function large_bodies() {
  return Array.from({ length: 12 }, (_, i) => body(`segment-${i + 1}-lattice`, lattice_shape(), 1 + (i % 2)));
}

/** @returns {[Object, Object, Buffer]} report, view and model */
function parts_of(kind) {
  if (kind === "--bare")
    return [bare_report(), { segments: [], markers: [], cases: [], tolerance_mm: null, note: "" }, Buffer.alloc(0)];
  if (kind === "--large") return [large_report(), large_view(), glb_of(large_bodies())];
  const text = kind === "--hostile" ? HOSTILE : "";
  return [sample_report(text), sample_view(text), glb_of(sample_bodies())];
}

const [folder, kind] = process.argv.slice(2);
if (!folder) throw new Error("usage: sample.mjs FOLDER [--hostile | --bare | --large]");
const [report, view, model] = parts_of(kind);
mkdirSync(folder, { recursive: true });
writeFileSync(join(folder, "report.json"), JSON.stringify(report));
writeFileSync(join(folder, "view.json"), JSON.stringify(view));
writeFileSync(join(folder, "model.glb"), model);
