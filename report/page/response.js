// SPDX-License-Identifier: GPL-3.0-or-later
// The response of every segment: one small chart for each quantity that is not nothing.
"use strict";

const QUANTITIES = [
  { key: "stretch", name: "Stretch", unit: "", none: 1, silent: "does not stretch" },
  { key: "twist_deg", name: "Twist", unit: "°", none: 0, silent: "does not twist", turning: "twist" },
  { key: "bend_deg", name: "Bend", unit: "°", none: 0, silent: "does not bend", turning: "bend" },
  { key: "outer_radius_mm", name: "Outer radius", unit: "mm", none: null, silent: "keeps its outer radius" },
];

const MARK_NAMES = {
  "limit-point": "limit point",
  asymptote: "asymptote",
  closure: "closure",
  bifurcation: "bifurcation",
};

/** @returns {boolean} whether the quantity has a value anywhere but that of rest */
function says_something(quantity, curve) {
  const values = curve.map((point) => point[quantity.key]).filter(is_number);
  const none = quantity.none ?? values[0];
  return values.some((value) => Math.abs(value - none) > 1e-6 * Math.max(1, Math.abs(none)));
}

/** @returns {ChartContent} of a quantity of a segment */
function chart_content(quantity, segment) {
  const at = (point) => ({ x: point.pressure_kPa, y: point[quantity.key], asked: point.asked, stable: point.stable });
  const band = segment.band ? [list(segment.band.softest).map(at), list(segment.band.stiffest).map(at)] : null;
  return {
    name: quantity.name,
    unit: quantity.unit,
    points: segment.curve.map(at),
    band,
    stable: [segment.stable_from_kPa, segment.stable_to_kPa],
    marks: list(segment.limit_points)
      .filter((mark) => is_number(mark.pressure_kPa))
      .map((mark) => ({
        x: mark.pressure_kPa,
        label: `${MARK_NAMES[mark.kind] ?? mark.kind} ${given(mark.pressure_kPa)} kPa`,
      })),
    turning: list(segment.turning_points)
      .filter((point) => point.quantity === quantity.turning && is_number(point.value_deg))
      .map((point) => ({ x: point.pressure_kPa, y: point.value_deg })),
  };
}

/** @returns {HTMLElement} what the marks of the charts mean */
function chart_legend(segment) {
  const key = (kind, text) =>
    h(
      "li",
      {},
      svg(
        "svg",
        { class: "key", viewBox: "0 0 28 12", "aria-hidden": "true" },
        {
          curve: svg("path", { class: "curve", d: "M1 6H27" }),
          unstable: svg("path", { class: "curve unstable", d: "M1 6H27" }),
          asked: svg("circle", { class: "asked", cx: 14, cy: 6, r: 3.2 }),
          band: svg("rect", { class: "band", x: 1, y: 1, width: 26, height: 10 }),
          stable: svg("rect", { class: "stable", x: 1, y: 1, width: 26, height: 10 }),
          turning: svg("path", { class: "turning", d: "M14 0l6 6l-6 6l-6-6z" }),
          reading: svg("circle", { class: "reading-dot", cx: 14, cy: 6, r: 4.5 }),
        }[kind],
      ),
      ` ${text}`,
    );
  const { band, curve } = segment;
  return h(
    "ul",
    { class: "legend" },
    key("curve", "computed"),
    curve.some((p) => p.stable === false) ? key("unstable", "unstable") : null,
    curve.some((p) => p.asked) ? key("asked", "asked pressures") : null,
    is_number(segment.stable_from_kPa) || is_number(segment.stable_to_kPa) ? key("stable", "stable range") : null,
    band ? key("band", `moduli × ${given(band.low_factor)} to × ${given(band.high_factor)}`) : null,
    list(segment.turning_points).length ? key("turning", "turning point") : null,
    key("reading", "present pressure"),
  );
}

/** @returns {HTMLElement} all points of a segment's curve */
function number_details(segment, quantities, label) {
  return made_when_opened(`Table of numbers, ${label}`, () =>
    table_of(
      `Computed points, ${label}`,
      [
        { head: "Pressure", unit: "kPa", number: true, cell: (p) => given(p.pressure_kPa) },
        ...quantities.map(({ key, name, unit }) => ({ head: name, unit, number: true, cell: (p) => measured(p[key]) })),
        { head: "Length", unit: "mm", number: true, cell: (p) => measured(p.length_mm) },
        { head: "Inner radius", unit: "mm", number: true, cell: (p) => measured(p.inner_radius_mm) },
        { head: "Asked", cell: (p) => (p.asked ? "asked" : "") },
        { head: "State", cell: (p) => (p.stable === false ? "unstable" : "stable") },
      ],
      segment.curve,
      (point) => ({ class: point.asked ? "asked-line" : null }),
    ),
  );
}

/** @returns {HTMLElement?} what other kinds of model say at the asked pressures */
function kinds_table(segment, quantities, own, label) {
  const others = list(segment.other_kinds);
  if (others.length === 0) return null;
  const asked = segment.curve.filter((point) => point.asked);
  const at = (kind, pressure) => list(kind.states).find((state) => state.pressure_kPa === pressure);
  const shown = quantities.filter(({ key }) => key !== "outer_radius_mm");
  const answered = others.filter((kind) => list(kind.states).length > 0);
  const columns = shown.flatMap(({ key, name, unit }) => [
    { head: `${name}, ${own}`, unit, number: true, cell: (p) => measured(p[key]) },
    ...answered.map((kind) => ({
      head: `${name}, ${kind.kind}`,
      unit,
      number: true,
      cell: (p) => measured(at(kind, p.pressure_kPa)?.[key]),
    })),
  ]);
  return h(
    "div",
    {},
    table_of(
      `Kinds of model, ${label}`,
      [{ head: "Pressure", unit: "kPa", number: true, cell: (p) => given(p.pressure_kPa) }, ...columns],
      asked,
    ),
    others.filter((kind) => kind.refusal).map((kind) => h("p", {}, `${kind.kind} is left out: ${kind.refusal}`)),
  );
}

/** @returns {string[]} sentences about what the charts cannot say */
function segment_sentences(segment, silent, label) {
  const sentences = silent.length ? [`${capital(label)} ${listed(silent)}.`] : [];
  for (const mark of [...list(segment.limit_points), ...list(segment.turning_points)]) {
    if (mark.text) sentences.push(`${capital(mark.text)}${/[.!?]$/.test(mark.text) ? "" : "."}`);
  }
  if (segment.message) sentences.push(segment.message);
  return sentences;
}

/**
 * @param {Object} segment of the prediction
 * @param {boolean} alone
 * @param {PresentPressures} present
 * @param {number} index in the view; negative when it is not there
 * @param {string} own kind of the model
 */
function segment_response(segment, alone, present, index, own) {
  const told = QUANTITIES.filter((quantity) => says_something(quantity, segment.curve));
  const silent = QUANTITIES.filter((quantity) => !told.includes(quantity)).map((quantity) => quantity.silent);
  const label = alone ? "the actuator" : `segment ${segment.segment}`;
  const charts =
    segment.curve.length > 1
      ? told.map((quantity) => chart(chart_content(quantity, segment), `${quantity.name}, ${label}`))
      : [];
  if (index >= 0) present.follow((pressures) => charts.forEach((one) => one.set_present(pressures[index])));
  return h(
    "div",
    { class: "segment" },
    alone ? null : h("h3", {}, capital(label)),
    segment_sentences(segment, silent, label).map((text) => h("p", {}, text)),
    charts.length
      ? [
          chart_legend(segment),
          h(
            "div",
            { class: "charts" },
            charts.map((one) => one.element),
          ),
        ]
      : null,
    kinds_table(segment, told, own, label),
    number_details(segment, told, label),
  );
}

/** @param {Object} report @param {Object[]} view_segments @param {PresentPressures} present */
function show_response(report, view_segments, present) {
  const box = by_id("response-content");
  const segments = predicted_segments(report);
  if (segments.length === 0) {
    box.append(h("p", {}, report.prediction?.reason_missing || "No response was predicted: the design names no load."));
    return;
  }
  box.append(
    ...segments.map((segment) =>
      segment_response(
        segment,
        segments.length === 1,
        present,
        view_segments.findIndex((one) => one.number === segment.segment),
        report.design?.model?.kind ?? "",
      ),
    ),
  );
}
