// SPDX-License-Identifier: GPL-3.0-or-later
// What lies over the 3-D picture: axes, scale bar, centre line, tip and the pins of findings.
"use strict";

/** More of them are drawn small, lest they hide the actuator. */
const MANY_PINS = 24;

/** @param {number} most @returns {number} the largest of 1, 2, 5, 10, ... that is not larger */
function pleasant_length(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  return [5, 2, 1].map((factor) => factor * power).find((length) => length <= most) ?? power;
}

/** @param {number} height of the picture @returns {SVGElement[]} the three axes, in its lower left corner */
function axis_marks(viewer, height) {
  const [cx, cy, length] = [44, height - 40, 26];
  return [
    ["x", [1, 0, 0]],
    ["y", [0, 1, 0]],
    ["z", [0, 0, 1]],
  ]
    .map(([name, axis]) => {
      const [right, up] = viewer.axis_on_screen(axis);
      const [x, y] = [cx + length * right, cy - length * up];
      return [
        svg("line", { class: `axis ${name}`, x1: cx, y1: cy, x2: x, y2: y }),
        svg("text", { class: "axis-name", x: cx + (length + 10) * right, y: cy - (length + 10) * up + 4 }, name),
      ];
    })
    .flat();
}

/** @returns {SVGElement[]} a bar of a round length, true at the depth of the middle of the picture */
function scale_bar(viewer, width, height) {
  const mm = pleasant_length(110 * viewer.mm_per_pixel());
  const pixels = mm / viewer.mm_per_pixel();
  const [x, y] = [width - 20 - pixels, height - 22];
  return [
    svg("path", { class: "scale", d: `M${x} ${y - 5}v5h${pixels}v-5` }),
    svg("text", { class: "scale-text", x: x + pixels / 2, y: y - 10 }, `${given(mm)} mm`),
    svg("text", { class: "grid-text", x: x - 16, y }, `grid ${given(viewer.grid_mm)} mm`),
  ];
}

/** @param {number[][]} points_mm @returns {SVGElement[]} the centre line and its tip */
function centre_line_marks(viewer, points_mm) {
  const seen = points_mm.map(viewer.project).filter((point) => point !== null);
  if (seen.length < 2) return [];
  const [x, y] = seen.at(-1);
  return [
    svg("polyline", { class: "centre-line", points: seen.map((p) => p.join(",")).join(" ") }),
    svg("circle", { class: "tip", cx: x, cy: y, r: 5 }),
  ];
}

/** Draws the overlay anew. @param {SVGElement} layer @param {number[][]} line_mm empty when it is not to be shown */
function draw_overlay(layer, viewer, line_mm) {
  const { clientWidth: width, clientHeight: height } = layer.parentElement;
  layer.setAttribute("viewBox", `0 0 ${width} ${height}`);
  layer.replaceChildren(
    ...centre_line_marks(viewer, line_mm),
    ...axis_marks(viewer, height),
    ...scale_bar(viewer, width, height),
  );
}

/**
 * Pins of the findings that have a place.
 * @param {Object[]} markers of the view
 * @param {Object[]} findings
 * @param {function(number)} on_choose called with a finding's index
 * @returns {{element: HTMLElement, draw: function, choose: function(number|null)}}
 */
function finding_pins(markers, findings, on_choose) {
  const pins = markers.map((marker) => {
    const finding = findings[marker.finding] ?? {};
    return h(
      "button",
      {
        type: "button",
        class: `pin ${finding.severity ?? "note"}`,
        "data-finding": marker.finding,
        "aria-label": `Finding ${marker.finding + 1}, ${finding.severity ?? "note"}: ${finding.message ?? ""}`,
        title: finding.message ?? "",
        onclick: () => on_choose(marker.finding),
      },
      String(marker.finding + 1),
    );
  });
  const element = h("div", { class: pins.length > MANY_PINS ? "pins many" : "pins" }, pins);
  /** @param {function(Object): number[]} place_of where a marker is now */
  const draw = (viewer, place_of) =>
    pins.forEach((pin, i) => {
      const seen = viewer.project(place_of(markers[i]));
      const { clientWidth: width, clientHeight: height } = element;
      pin.hidden = seen === null || seen[0] < 0 || seen[0] > width || seen[1] < 0 || seen[1] > height;
      if (!pin.hidden) pin.style.transform = `translate(${seen[0]}px, ${seen[1]}px)`;
    });
  const choose = (index) =>
    pins.forEach((pin, i) => {
      pin.classList.toggle("chosen", markers[i].finding === index);
    });
  return { element, draw, choose };
}
