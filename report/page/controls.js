// SPDX-License-Identifier: GPL-3.0-or-later
// Sliders of pressure, the button that sweeps them, and the numbers beside them.
"use strict";

/** @param {number} range @returns {number} a step of 1, 2 or 5 times a power of ten, about 1/80 of it */
function pleasant_step(range) {
  const rough = range / 80;
  const power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map((factor) => factor * power).find((step) => step >= rough) ?? 10 * power;
}

/** @param {number} pressure_kPa @returns {string} "23.5 kPa" */
function pressure_text(pressure_kPa) {
  return with_unit(Math.round(pressure_kPa * 1000) / 1000, "kPa", (value) =>
    with_minus(String(Number(value.toFixed(2)))),
  );
}

/** @param {string} key @returns {number|null} the slider's value after the key; null when it is none of its keys */
function value_after_key(key, value, { low, high, stops, step }) {
  const next = {
    ArrowRight: value + step,
    ArrowUp: value + step,
    ArrowLeft: value - step,
    ArrowDown: value - step,
    Home: low,
    End: high,
    PageUp: stops.find((stop) => stop > value + 1e-9) ?? high,
    PageDown: stops.findLast((stop) => stop < value - 1e-9) ?? low,
  }[key];
  if (next === undefined) return null;
  const kept = key.startsWith("Arrow") ? Math.round(next / step) * step : next;
  return Math.min(high, Math.max(low, kept));
}

/** @param {number[]} stops @returns {SVGElement} a tick below the slider for every computed pressure */
function slider_ticks(stops, low, high) {
  const ticks = stops.map((stop) =>
    h("span", {
      class: stop === 0 ? "tick rest" : "tick",
      style: `--at:${high > low ? (stop - low) / (high - low) : 0}`,
    }),
  );
  return h("div", { class: "ticks", "aria-hidden": "true" }, ticks);
}

/**
 * @param {string} label
 * @param {number[]} stops  computed pressures, ascending
 * @param {function(number)} on_input
 * @returns {{element: HTMLElement, show: function(number), differ: function()}}
 */
function pressure_slider(label, stops, on_input) {
  const [low, high] = [stops[0], stops.at(-1)];
  const limits = { low, high, stops, step: pleasant_step(high - low || 1) };
  const output = h("output", { class: "pressure" });
  const input = h("input", { type: "range", min: low, max: high, step: "any", "aria-label": `Pressure, ${label}` });
  const text = h("span", { class: "label" }, capital(label));
  output.setAttribute("aria-hidden", "true");
  input.addEventListener("input", () => {
    const near = stops.find((stop) => Math.abs(stop - input.valueAsNumber) < 0.012 * (high - low));
    on_input(near ?? input.valueAsNumber);
  });
  input.addEventListener("keydown", (event) => {
    const next = value_after_key(event.key, input.valueAsNumber, limits);
    if (next === null || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    on_input(next);
  });
  const show = (pressure_kPa) => {
    input.value = pressure_kPa;
    input.setAttribute("aria-valuetext", pressure_text(pressure_kPa));
    output.textContent = pressure_text(pressure_kPa);
  };
  const differ = () => {
    input.setAttribute("aria-valuetext", "the segments differ");
    output.textContent = "differ";
  };
  const element = h(
    "div",
    { class: "slider" },
    h("div", { class: "slider-head" }, text, output),
    input,
    slider_ticks(stops, low, high),
  );
  return { element, show, differ };
}

/** @param {Object} segment of the view @returns {number[]} */
function computed_pressures(segment) {
  return segment.states.map((state) => state.pressure_kPa);
}

/** @param {Object[]} segments of the view @param {PresentPressures} present @returns {HTMLElement[]} */
function sliders_for(segments, present) {
  const moved = segments.map((segment, i) => [segment, i]).filter(([segment]) => segment.states.length > 1);
  if (moved.length === 0) return [];
  const own = moved.map(([segment, i]) => {
    const slider = pressure_slider(
      segments.length > 1 ? `segment ${segment.number}` : "pressure",
      computed_pressures(segment),
      (value) => present.set_one(i, value),
    );
    present.follow((pressures) => slider.show(pressures[i]));
    return slider.element;
  });
  if (segments.length === 1) return own;
  const all = [...new Set(moved.flatMap(([segment]) => computed_pressures(segment)))].sort((a, b) => a - b);
  let asked = 0;
  const common = pressure_slider("all segments", all, (value) => {
    asked = value;
    present.set_same(value);
  });
  present.follow((pressures) => {
    if (pressures.every((value) => value === pressures[0])) asked = pressures[0];
    const same = pressures.every((value, i) => value === present.held(i, asked));
    if (same) common.show(asked);
    else common.differ();
  });
  return [common.element, h("div", { class: own.length > 4 ? "sliders many" : "sliders" }, own)];
}

/** @param {Object[]} cases of the view @returns {HTMLElement|null} a choice that sets all sliders of a chain */
function case_choice(cases, present) {
  if (cases.length === 0 || present.ranges.length < 2) return null;
  const name = (one) => `${list(one.pressures_kPa).map(given).join(" / ")} kPa`;
  const choice = h(
    "select",
    { id: "load-case" },
    h("option", { value: "" }, "by the sliders"),
    cases.map((one, i) => h("option", { value: i }, name(one))),
  );
  choice.addEventListener("change", () => {
    if (choice.value !== "") present.set_all(list(cases[Number(choice.value)].pressures_kPa));
  });
  present.follow((pressures) => {
    const found = cases.findIndex((one) => pressures.every((value, i) => value === one.pressures_kPa[i]));
    choice.value = found < 0 ? "" : String(found);
  });
  return h("div", { class: "choice" }, h("label", { for: "load-case" }, "Load case"), choice);
}

/**
 * Sweeps the pressure of all segments from rest to its end and back, once. Where less motion is asked for, it goes in
 * eight steps.
 * @param {PresentPressures} present
 * @returns {HTMLElement}
 */
function play_button(present) {
  const button = h("button", { type: "button", "aria-pressed": "false" }, "▶ Play");
  const still = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
  const [low, high] = [Math.min(...present.ranges.flat()), Math.max(...present.ranges.flat())];
  const end = high > 0 ? high : low;
  let timer = null;
  const stop = () => {
    timer = null;
    button.setAttribute("aria-pressed", "false");
    button.textContent = "▶ Play";
  };
  const step = (start, now) => {
    if (timer === null) return;
    const phase = Math.min(1, (now - start) / 6000);
    const part = still ? Math.floor(phase * 8) / 8 : phase;
    present.set_same(end * (1 - Math.abs(1 - 2 * part)));
    if (phase < 1) timer = requestAnimationFrame((next) => step(start, next));
    else stop();
  };
  button.addEventListener("click", () => {
    if (timer !== null) return stop();
    button.setAttribute("aria-pressed", "true");
    button.textContent = "■ Stop";
    timer = requestAnimationFrame((now) => step(now, now));
  });
  return button;
}
