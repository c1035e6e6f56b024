// SPDX-License-Identifier: GPL-3.0-or-later
// The section with the 3-D view: bodies at their present pressures, and the tools around them.
"use strict";

const DIRECTIONS = { Oblique: [0.55, -1, 0.42], Front: [0, -1, 0], Side: [1, 0, 0], Top: [0, -1e-4, 1] };

/** The bodies of the view's segments, and where they are. */
class Actuator {
  /** @param {PageData} data */
  constructor({ view, model }) {
    this.segments = list(view.segments).filter((segment) => list(segment.states).length > 0);
    this.problem = "";
    this.bodies = this.readable_bodies(model);
    this.shown = this.segments.flatMap((segment, i) =>
      list(segment.bodies)
        .filter(({ node }) => this.bodies.has(node))
        .map(({ node, role }) => Object.assign(this.bodies.get(node), { role, segment: i })),
    );
    this.set(this.segments.map(() => 0));
  }

  /** Damaged meshes cost the picture, not the page. @param {string} model base64 */
  readable_bodies(model) {
    try {
      return model ? read_glb(bytes_of_base64(model)) : new Map();
    } catch (error) {
      this.problem = `The meshes cannot be read: ${error.message}.`;
      return new Map();
    }
  }

  /** @param {number[]} pressures_kPa one for each segment */
  set(pressures_kPa) {
    this.poses = chain_poses(this.segments, pressures_kPa);
    for (const body of this.shown) morph(body, this.segments[body.segment], this.poses[body.segment]);
  }

  /** @param {string} node @returns {Float32Array} x, y, z in mm of every vertex at the present pressure */
  vertices(node) {
    const body = this.bodies.get(node);
    if (body?.segment === undefined) throw new Error(`no body is named ${node}`);
    return placed_vertices(body, this.poses[body.segment]);
  }

  /** @returns {{min: number[], max: number[]}} of all bodies at the present pressure, mm */
  bounds() {
    return bounds_of(this.shown.map((body) => this.vertices(body.node)));
  }

  /** @param {PresentPressures} present @returns bounds over the ends of all ranges, so that the eye need not move */
  room(present) {
    const corners = [
      present.ranges.map(([low]) => low),
      present.ranges.map(([, high]) => high),
      present.pressures_kPa,
    ].map((pressures) => {
      this.set(pressures);
      return this.bounds();
    });
    return bounds_of(corners.flatMap(({ min, max }) => [min, max]));
  }

  /** @returns {number[][]} points of the centre line at the present pressure, arcs between the ends of segments */
  centre_line() {
    return this.poses.flatMap((pose) => arc_points(pose));
  }
}

/** @returns {Object} colours of the bodies from the page's style */
function view_colours() {
  const style = getComputedStyle(document.documentElement);
  const colour = (name) => style.getPropertyValue(`--${name}`).trim();
  return { lattice: colour("lattice"), liner: colour("liner"), grid: colour("grid"), cloud: colour("cloud") };
}

/** @returns {HTMLElement} a box to tick */
function tick_box(label, ticked, on_change) {
  const input = h("input", { type: "checkbox", checked: ticked, onchange: () => on_change(input.checked) });
  return h("label", { class: "tick-box" }, input, ` ${label}`);
}

/** @param {Set<string>} roles of bodies @param {Object} layers what lies over the picture @returns {HTMLElement} */
function view_tools(viewer, roles, layers) {
  const directions = Object.entries(DIRECTIONS).map(([name, from]) =>
    h("button", { type: "button", class: "small", onclick: () => viewer.look_from(from) }, name),
  );
  const boxes = [];
  if (roles.has("lattice")) boxes.push(tick_box("Lattice", true, (on) => viewer.set_visible("lattice", on)));
  if (roles.has("liner")) {
    boxes.push(
      tick_box("Liner", true, (on) => viewer.set_visible("liner", on)),
      tick_box("See through the liner", true, (on) => viewer.set_translucent("liner", on)),
    );
  }
  boxes.push(tick_box("Cut open", false, viewer.set_cut));
  for (const [label, layer] of Object.entries(layers)) boxes.push(tick_box(label, layer.on, layer.show));
  return h(
    "div",
    { class: "tools" },
    h(
      "div",
      { class: "buttons", role: "group", "aria-label": "Look from" },
      directions,
      h("button", { type: "button", class: "small", onclick: viewer.fit }, "Fit"),
    ),
    h("div", { class: "boxes", role: "group", "aria-label": "Show" }, boxes),
  );
}

/** Arrows turn the view, + and - zoom, F shows all. */
function follow_keys(canvas, viewer) {
  const step = Math.PI / 24;
  const moves = {
    ArrowLeft: () => viewer.turn(-step, 0),
    ArrowRight: () => viewer.turn(step, 0),
    ArrowUp: () => viewer.turn(0, step),
    ArrowDown: () => viewer.turn(0, -step),
    "+": () => viewer.zoom(1 / 1.15),
    "=": () => viewer.zoom(1 / 1.15),
    "-": () => viewer.zoom(1.15),
    f: viewer.fit,
    F: viewer.fit,
  };
  canvas.addEventListener("keydown", (event) => {
    const move = moves[event.key];
    if (!move || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    move();
  });
}

/** @param {Object} report @returns {string} what the picture shows, for those who do not see it */
function view_description(report) {
  const segments = list(report.design?.segments);
  return (
    `3-D view of ${report.name || "the actuator"}: ${counted(segments.length, "segment")}. ` +
    "Arrow keys turn it, plus and minus zoom, F fits it. The sliders set its pressure."
  );
}

/** The picture, what lies over it, and a place for a message. */
function view_stage(report) {
  const canvas = h("canvas", { tabindex: "0", role: "application", "aria-label": view_description(report) });
  const layer = svg("svg", { class: "overlay", "aria-hidden": "true" });
  const printed = h("img", { class: "printed", alt: view_description(report), hidden: true });
  const message = h("p", { class: "message", hidden: true });
  const element = h("div", { class: "stage" }, canvas, printed, layer, message);
  return { canvas, layer, printed, message, element };
}

/** @returns {string} the present picture in the light colours of paper */
function picture_for_paper(viewer) {
  const root = document.documentElement;
  const { theme } = root.dataset;
  root.dataset.theme = "light";
  viewer.set_colours(view_colours());
  const picture = viewer.picture();
  root.dataset.theme = theme;
  viewer.set_colours(view_colours());
  return picture;
}

/** The printed picture and what lies over it keep the shape that they have on the screen. */
function follow_printing(stage, viewer) {
  window.addEventListener("beforeprint", () => {
    stage.printing = true;
    stage.printed.src = picture_for_paper(viewer);
    stage.printed.hidden = false;
  });
  window.addEventListener("afterprint", () => {
    stage.printing = false;
    stage.printed.hidden = true;
  });
}

/** The observer's first call tells nothing new. */
function follow_size(stage, viewer) {
  const { canvas } = stage;
  let [width, height] = [canvas.clientWidth, canvas.clientHeight];
  new ResizeObserver(() => {
    if (stage.printing || (canvas.clientWidth === width && canvas.clientHeight === height)) return;
    [width, height] = [canvas.clientWidth, canvas.clientHeight];
    viewer.resize();
  }).observe(canvas);
}

/** @param {Object[]} cases of the report's chain @returns {Float32Array} tips that exist */
function workspace_points(cases) {
  return Float32Array.from(
    cases.filter((one) => one.exists !== false && list(one.tip_mm).length === 3).flatMap((one) => one.tip_mm),
  );
}

/**
 * Starts the 3-D view.
 * @param {function} create_viewer of the bundle
 * @param {Object} parts  stage, actuator, present, report, pins, and the element for the tools
 * @returns {Object} the viewer
 */
function start_view(create_viewer, { stage, actuator, present, report, pins, tools }) {
  const cases = list(report.prediction?.chain?.cases);
  const room = actuator.room(present);
  actuator.set(present.pressures_kPa);
  const layers = {};
  let line_shown = actuator.segments.length > 1;
  const place_of = (marker) => {
    const i = actuator.segments.findIndex((segment) => segment.number === marker.segment);
    return marker_place(marker.positions_mm, actuator.poses[i]);
  };
  const on_drawn = () => {
    if (!viewer || stage.printing) return;
    draw_overlay(stage.layer, viewer, line_shown ? actuator.centre_line() : []);
    pins?.draw(viewer, place_of);
  };
  let viewer = null;
  viewer = create_viewer({ canvas: stage.canvas, bodies: actuator.shown, colours: view_colours(), room, on_drawn });
  viewer.set_translucent("liner", true);
  viewer.place_of = place_of;
  layers["Centre line"] = {
    on: line_shown,
    show: (on) => {
      line_shown = on;
      viewer.request();
    },
  };
  const tips = workspace_points(cases);
  if (tips.length > 3) layers.Workspace = { on: false, show: (on) => viewer.set_cloud(on ? tips : null) };
  if (pins)
    layers.Pins = {
      on: true,
      show: (on) => {
        pins.element.hidden = !on;
      },
    };
  tools.append(view_tools(viewer, new Set(actuator.shown.map((body) => body.role)), layers));
  follow_keys(stage.canvas, viewer);
  follow_printing(stage, viewer);
  present.follow(() => viewer.set_poses(actuator.poses));
  follow_size(stage, viewer);
  new MutationObserver(() => viewer.set_colours(view_colours())).observe(document.documentElement, {
    attributeFilter: ["data-theme"],
  });
  viewer.draw();
  return viewer;
}
