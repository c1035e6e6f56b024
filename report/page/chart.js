// SPDX-License-Identifier: GPL-3.0-or-later
// A small chart of one quantity against pressure, as SVG in the page's own colours.
"use strict";

const CHART = { width: 380, height: 256, left: 58, right: 16, top: 24, bottom: 44 };

/** @returns {number[]} about `wanted` round values that lie between low and high */
function round_ticks(low, high, wanted) {
  const rough = (high - low) / wanted;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 2.5, 5, 10].map((factor) => factor * power).find((one) => one >= rough * 0.999);
  const first = Math.ceil(low / step - 1e-9);
  const last = Math.floor(high / step + 1e-9);
  return Array.from({ length: last - first + 1 }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

/** @param {number[]} ticks @returns {string[]} all with as many decimals as the finest needs */
function tick_texts(ticks) {
  const decimals = Math.max(0, ...ticks.map((value) => (String(value).split(".")[1] ?? "").length));
  return ticks.map((value) => with_minus(value.toFixed(decimals)));
}

/** @param {number[]} values @returns {[number, number]} their range, a little wider; never empty */
function wide_range(values) {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const margin = Math.max((high - low) * 0.06, Math.abs(high) * 1e-3, 1e-6);
  return [low - margin, high + margin];
}

/**
 * @typedef {Object} ChartContent
 * @property {string} name          of the quantity
 * @property {string} unit
 * @property {Object[]} points      {x, y, asked, stable}, ascending in x
 * @property {Object[][]|null} band softest and stiffest branch, {x, y}
 * @property {Array} stable         pressures from and to, null where there is no bound
 * @property {Object[]} marks       {x, label}: limit points
 * @property {Object[]} turning     {x, y}
 */

/** @param {ChartContent} content @returns {Object} scales of both axes */
function chart_scales({ points, band, marks, turning }) {
  const known = [...points, ...list(band).flat(), ...turning].filter((p) => is_number(p.y));
  const xs = points.map((p) => p.x);
  const reach = Math.max(...xs) - Math.min(...xs) || 1;
  const near = marks
    .map((mark) => mark.x)
    .filter((x) => x > Math.min(...xs) - 0.25 * reach && x < Math.max(...xs) + 0.25 * reach);
  const [x0, x1] = [Math.min(...xs, ...near), Math.max(...xs, ...near) + (xs.length === 1 ? 1 : 0)];
  const [y0, y1] = wide_range(known.map((p) => p.y));
  const { width, height, left, right, top, bottom } = CHART;
  return {
    x0,
    x1,
    y0,
    y1,
    x: (value) => left + ((value - x0) / (x1 - x0)) * (width - left - right),
    y: (value) => height - bottom - ((value - y0) / (y1 - y0)) * (height - top - bottom),
  };
}

/** @returns {SVGElement[]} lines, ticks and names of both axes */
function chart_axes(scales, unit) {
  const { width, height, left, right, top, bottom } = CHART;
  const [xs, ys] = [round_ticks(scales.x0, scales.x1, 5), round_ticks(scales.y0, scales.y1, 5)];
  const [x_texts, y_texts] = [tick_texts(xs), tick_texts(ys)];
  const across = xs.map((value, i) => [
    svg("line", { class: "grid", x1: scales.x(value), y1: top, x2: scales.x(value), y2: height - bottom }),
    svg(
      "text",
      { class: "tick-text", x: scales.x(value), y: height - bottom + 16, "text-anchor": "middle" },
      x_texts[i],
    ),
  ]);
  const up = ys.map((value, i) => [
    svg("line", { class: "grid", x1: left, y1: scales.y(value), x2: width - right, y2: scales.y(value) }),
    svg("text", { class: "tick-text", x: left - 7, y: scales.y(value) + 4, "text-anchor": "end" }, y_texts[i]),
  ]);
  return [
    ...across.flat(),
    ...up.flat(),
    svg("path", { class: "axis-line", d: `M${left} ${top}V${height - bottom}H${width - right}` }),
    svg(
      "text",
      { class: "axis-text", x: (left + width - right) / 2, y: height - 8, "text-anchor": "middle" },
      "Pressure, kPa",
    ),
    unit ? svg("text", { class: "axis-text", x: left - 7, y: top - 9, "text-anchor": "end" }, unit) : null,
  ];
}

/** @param {Object[]} points @returns {string} a path through those that have a value */
function path_through(points, scales) {
  return points
    .filter((p) => is_number(p.y))
    .map((p, i) => `${i ? "L" : "M"}${scales.x(p.x).toFixed(2)} ${scales.y(p.y).toFixed(2)}`)
    .join("");
}

/** @returns {Array<[boolean, Object[]]>} runs of points that are stable or not, each with its neighbour */
function runs_of_stability(points) {
  const runs = [];
  for (const point of points) {
    const stable = point.stable !== false;
    if (runs.length === 0 || runs.at(-1)[0] !== stable) {
      const before = runs.at(-1)?.[1].at(-1);
      runs.push([stable, before ? [before] : []]);
    }
    runs.at(-1)[1].push(point);
  }
  return runs;
}

/** @returns {SVGElement[]} the stable range as a field, its name in the corner that the curve leaves free */
function stable_field(scales, { stable: [from, to], points }) {
  if (!is_number(from) && !is_number(to)) return [];
  const low = Math.max(scales.x0, from ?? scales.x0);
  const high = Math.min(scales.x1, to ?? scales.x1);
  if (high <= low) return [];
  const { height, top, bottom } = CHART;
  const span = scales.x(high) - scales.x(low);
  const first = value_at(points, low) ?? points[0].y;
  const y = is_number(first) && scales.y(first) > height / 2 ? top + 15 : height - bottom - 7;
  return [
    svg("rect", { class: "stable", x: scales.x(low), y: top, width: span, height: height - top - bottom }),
    span > 50 ? svg("text", { class: "field-text", x: scales.x(low) + 6, y }, "stable") : null,
  ];
}

/** @param {Object[]} marks @returns {SVGElement[]} lines at limit points with their names */
function limit_lines(scales, marks) {
  const { width, height, top, right, bottom } = CHART;
  return marks
    .filter((mark) => mark.x >= scales.x0 && mark.x <= scales.x1)
    .flatMap((mark, i) => {
      const at = scales.x(mark.x);
      const left = at > width / 2;
      return [
        svg("line", { class: "limit", x1: at, y1: top, x2: at, y2: height - bottom }),
        svg(
          "text",
          {
            class: "limit-text",
            x: left ? Math.min(at + 2, width - right) : at - 2,
            y: top - 9 - 12 * (i % 2),
            "text-anchor": left ? "end" : "start",
          },
          mark.label,
        ),
      ];
    });
}

/** @returns {SVGElement|null} the band between the branches of the softest and the stiffest material */
function band_field(scales, band) {
  if (!band) return null;
  const [softest, stiffest] = band.map((branch) =>
    branch.filter((p) => is_number(p.y) && p.x >= scales.x0 && p.x <= scales.x1),
  );
  if (softest.length === 0 || stiffest.length === 0) return null;
  return svg("path", {
    class: "band",
    d: `${path_through(softest, scales)}${path_through([...stiffest].reverse(), scales).replace("M", "L")}Z`,
  });
}

/** @param {ChartContent} content @returns {SVGElement[]} everything that stands still */
function chart_body(content, scales) {
  const { points, band, marks, turning, unit } = content;
  return [
    ...stable_field(scales, content),
    ...chart_axes(scales, unit),
    band_field(scales, band),
    ...runs_of_stability(points).map(([steady, run]) =>
      svg("path", { class: steady ? "curve" : "curve unstable", d: path_through(run, scales) }),
    ),
    ...limit_lines(scales, marks),
    ...turning.map((p) =>
      svg("path", { class: "turning", d: `M${scales.x(p.x)} ${scales.y(p.y) - 6}l6 6l-6 6l-6-6z` }),
    ),
    ...points
      .filter((p) => p.asked && is_number(p.y))
      .map((p) => svg("circle", { class: "asked", cx: scales.x(p.x), cy: scales.y(p.y), r: 3.2 })),
  ];
}

/** @returns {number|null} y between the points at x */
function value_at(points, x) {
  const xs = points.map((p) => p.x);
  if (x < xs[0] - 1e-9 || x > xs.at(-1) + 1e-9) return null;
  const { lower, upper, t } = neighbours(xs, x);
  const [a, b] = [points[lower].y, points[upper].y];
  return is_number(a) && is_number(b) ? a + t * (b - a) : null;
}

/** A line that reads the curve where the pointer, the keys or the present pressure are. */
function reading_line(content, scales) {
  const { height, top, bottom, width } = CHART;
  const line = svg("line", { class: "reading", y1: top, y2: height - bottom });
  const dot = svg("circle", { class: "reading-dot", r: 4.5 });
  const text = svg("text", { class: "reading-text", y: top + 13 });
  const element = svg("g", {}, line, dot, text);
  const words = (x, y) => `${pressure_text(x)}: ${with_unit(y, content.unit)}`;
  const show = (x, label) => {
    const y = value_at(content.points, x);
    element.toggleAttribute("hidden", y === null);
    element.setAttribute("visibility", y === null ? "hidden" : "visible");
    if (y === null) return "";
    set_attributes(line, { x1: scales.x(x), x2: scales.x(x), visibility: label ? "visible" : "hidden" });
    set_attributes(dot, { cx: scales.x(x), cy: scales.y(y) });
    const right = scales.x(x) > width / 2;
    set_attributes(text, { x: scales.x(x) + (right ? -7 : 7), "text-anchor": right ? "end" : "start" });
    text.textContent = label ? words(x, y) : "";
    return words(x, y);
  };
  return { element, show };
}

/** Lets pointer and keys read the curve; without them the present pressure is marked. */
function follow_reader(picture, content, scales, reading, present) {
  const [low, high] = [content.points[0].x, content.points.at(-1).x];
  const step = pleasant_step(high - low || 1);
  let now = present.x;
  const read = (x) => {
    now = Math.min(high, Math.max(low, x));
    set_attributes(picture, { "aria-valuenow": now, "aria-valuetext": reading.show(now, true) });
  };
  const rest = () => {
    now = Math.min(high, Math.max(low, present.x));
    set_attributes(picture, {
      "aria-valuenow": now,
      "aria-valuetext": reading.show(present.x, false) || "beyond the curve",
    });
  };
  picture.addEventListener("pointermove", (event) => {
    const box = picture.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * CHART.width;
    read(scales.x0 + ((x - CHART.left) / (CHART.width - CHART.left - CHART.right)) * (scales.x1 - scales.x0));
  });
  picture.addEventListener("pointerleave", rest);
  picture.addEventListener("blur", rest);
  picture.addEventListener("keydown", (event) => {
    const next = value_after_key(event.key, now, {
      low,
      high,
      stops: content.points.filter((p) => p.asked).map((p) => p.x),
      step,
    });
    if (next === null) return;
    event.preventDefault();
    read(next);
  });
  return rest;
}

/** @param {ChartContent} content @returns {{element: HTMLElement, set_present: function(number)}} */
function chart(content, label) {
  const scales = chart_scales(content);
  const reading = reading_line(content, scales);
  const present = { x: 0 };
  const picture = svg(
    "svg",
    {
      class: "chart",
      viewBox: `0 0 ${CHART.width} ${CHART.height}`,
      role: "slider",
      tabindex: "0",
      "aria-label": `${label}: read the curve at a pressure`,
      "aria-orientation": "horizontal",
      "aria-valuemin": content.points[0].x,
      "aria-valuemax": content.points.at(-1).x,
    },
    chart_body(content, scales),
    reading.element,
  );
  const rest = follow_reader(picture, content, scales, reading, present);
  rest();
  const element = h("figure", { class: "chart-box" }, h("figcaption", {}, content.name), picture);
  return {
    element,
    set_present: (x) => {
      present.x = x;
      rest();
    },
  };
}
