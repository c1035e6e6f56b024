// SPDX-License-Identifier: GPL-3.0-or-later
// Fills the page from its data. The last of the plain scripts.
"use strict";

const LEFT_OUT = "3-D view left out: the program was built without npm.";

/** Leaves out a section that nothing was put into. @param {string} id */
function leave_out_empty(id) {
  if (by_id(`${id}-content`).children.length > 0) return;
  by_id(id).remove();
  document.querySelector(`nav a[href="#${id}"]`)?.closest("li").remove();
}

/** @param {string} theme "light" or "dark" */
function set_theme(theme, button) {
  document.documentElement.dataset.theme = theme;
  button.textContent = theme === "dark" ? "☀ Light" : "☾ Dark";
  button.setAttribute("aria-label", theme === "dark" ? "Switch to light colours" : "Switch to dark colours");
}

/** @returns {HTMLElement} the button that switches between light and dark; at first as the system says */
function theme_button() {
  const button = h("button", { type: "button", class: "small theme" });
  const dark = window.matchMedia("(prefers-color-scheme: dark)");
  set_theme(dark.matches ? "dark" : "light", button);
  dark.addEventListener("change", () => set_theme(dark.matches ? "dark" : "light", button));
  button.addEventListener("click", () =>
    set_theme(document.documentElement.dataset.theme === "dark" ? "light" : "dark", button),
  );
  return button;
}

/** @param {PageData} data @param {Set<number>} placed @param {function(number)} choose a finding */
function show_sections({ report }, actuator, present, placed, choose) {
  by_id("tools").append(theme_button());
  show_facts(report);
  show_response(report, actuator.segments, present);
  show_dimensions(report);
  show_checks(report, placed, choose);
  show_pieces(report);
  show_chain(report, actuator, present);
  show_plan(report);
  show_errors_and_times(report);
}

/** The panel beside the picture. @returns {HTMLElement} */
function view_panel({ report, view }, segments, present) {
  const sliders = sliders_for(segments, present);
  const note = "Shapes were computed at the ticks; between them they are interpolated.";
  return h(
    "div",
    { class: "panel" },
    sliders,
    sliders.length
      ? [
          h("div", { class: "play" }, play_button(present), case_choice(list(view.cases), present)),
          live_numbers(report, segments, present),
          h("p", { class: "note" }, note),
        ]
      : null,
    list(segments).length && sliders.length === 0
      ? h("p", { class: "note" }, "Only the shape at rest was computed.")
      : null,
    view.note ? h("p", { class: "note" }, view.note) : null,
  );
}

/** @returns {string} why there is no picture, or "" */
function missing_picture(actuator, create_viewer) {
  if (actuator.shown.length === 0) return actuator.problem || "There is no mesh to show.";
  return create_viewer ? "" : LEFT_OUT;
}

/** Everything that the page shows and does. @returns {Object} what window.latticast offers */
function build_page(data) {
  const actuator = new Actuator(data);
  const present = new PresentPressures(actuator.segments);
  present.follow((pressures) => actuator.set(pressures));
  const findings = list(data.report.checks?.findings);
  const numbers = new Set(actuator.segments.map((segment) => segment.number));
  const markers = list(data.view.markers).filter((marker) => numbers.has(marker.segment) && findings[marker.finding]);
  const stage = view_stage(data.report);
  const tools = h("div", { class: "view-tools" });
  let viewer = null;

  const choose = (index, from_view = false) => {
    mark_finding(index);
    pins.choose(index);
    const marker = markers.find((one) => one.finding === index);
    if (from_view) by_id(`finding-${index}`).scrollIntoView({ block: "center" });
    else if (viewer && marker) {
      viewer.look_at(viewer.place_of(marker));
      stage.element.scrollIntoView({ block: "nearest" });
    }
    if (from_view) by_id(`finding-${index}`).focus({ preventScroll: true });
  };
  const pins = finding_pins(markers, findings, (index) => choose(index, true));
  stage.element.append(pins.element);

  by_id("shape-content").append(
    h(
      "div",
      { class: "view" },
      h("div", { class: "picture" }, stage.element, tools),
      view_panel(data, actuator.segments, present),
    ),
  );
  show_sections(data, actuator, present, new Set(markers.map((marker) => marker.finding)), choose);
  ["chain", "plan", "response"].forEach(leave_out_empty);

  const start = (create_viewer) => {
    let missing = missing_picture(actuator, create_viewer);
    try {
      if (!missing)
        viewer = start_view(create_viewer, {
          stage,
          actuator,
          present,
          report: data.report,
          pins: markers.length ? pins : null,
          tools,
        });
    } catch (error) {
      missing = `No 3-D view: ${error.message}.`;
    }
    stage.message.textContent = missing;
    stage.message.hidden = !missing;
    stage.element.classList.toggle("empty", Boolean(missing));
    return viewer !== null;
  };
  return { actuator, present, start };
}

/** @param {PresentPressures} present @param {number|number[]} pressure_kPa of all segments, or of each */
function set_pressure(present, pressure_kPa) {
  if (Array.isArray(pressure_kPa)) present.set_all(pressure_kPa);
  else present.set_same(pressure_kPa);
}

/** Lets tables and curves be seen before the picture is prepared; a hidden page paints nothing and does not wait. */
function after_painting(act) {
  if (document.hidden) act();
  else requestAnimationFrame(() => setTimeout(act));
}

/**
 * window.latticast, for tests and for those who take numbers from the page:
 *   ready              a promise of {viewer: boolean}, fulfilled when the page can be used
 *   setPressure(kPa)   of all segments, or of each when it is an array; held within their states
 *   vertices(node)     Float32Array of x, y, z in mm, morphed and placed, at the present pressure
 *   bounds()           {min: [x, y, z], max: [x, y, z]} of all bodies, mm
 *   attachViewer(f)    how the bundled 3-D view makes itself known
 */
function start_page() {
  let create_viewer = null;
  let done = null;
  window.latticast = {
    ready: new Promise((resolve) => {
      done = resolve;
    }),
    attachViewer: (create) => {
      create_viewer = create;
    },
  };
  let page = null;
  try {
    page = build_page(read_data());
  } catch (error) {
    by_id("main").prepend(
      h("p", { class: "alarm", role: "alert" }, `The data of this page cannot be read: ${error.message}`),
    );
    done({ viewer: false });
    return;
  }
  const { actuator, present, start } = page;
  Object.assign(window.latticast, {
    setPressure: (kPa) => set_pressure(present, kPa),
    vertices: (node) => actuator.vertices(node),
    bounds: () => actuator.bounds(),
  });
  document.addEventListener("DOMContentLoaded", () => after_painting(() => done({ viewer: start(create_viewer) })));
}

start_page();
