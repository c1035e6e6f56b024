// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of the 3-D view and of what moves it.

import assert from "node:assert/strict";

import { difference, settle } from "./browser.mjs";
import { expected_vertices } from "./expected.mjs";

const CORNERS = [
  [0, 0, 0.08, 0.08],
  [0.92, 0, 0.08, 0.08],
  [0, 0.92, 0.08, 0.08],
  [0.92, 0.92, 0.08, 0.08],
];

/** @returns {number} largest distance of a coordinate from what the data say, mm */
async function largest_error(page, data, pressures) {
  let largest = 0;
  for (const [node, expected] of expected_vertices(data, pressures)) {
    const shown = await page.evaluate((name) => [...window.latticast.vertices(name)], node);
    assert.equal(shown.length, expected.length, `vertices of ${node}`);
    shown.forEach((value, i) => {
      largest = Math.max(largest, Math.abs(value - expected[i]));
    });
  }
  return largest;
}

/** @returns sliders of the segments, without the one of all */
function segment_sliders(page, data) {
  const sliders = page.locator(".panel input[type=range]");
  const first = data.view.segments.length > 1 ? 1 : 0;
  return data.view.segments.map((_, i) => sliders.nth(first + i));
}

const slider_value = (slider) => slider.evaluate((input) => input.valueAsNumber);

/** Keys move the sliders, the sliders move the vertices to where the data say. */
export async function check_sliders(page, data) {
  const sliders = segment_sliders(page, data);
  const at_rest = await page.evaluate(() => window.latticast.bounds());
  let largest = 0;
  for (const keys of [["End"], ["PageDown", "ArrowLeft", "ArrowLeft", "ArrowLeft"], ["Home", "ArrowRight"]]) {
    const pressures = [];
    for (const slider of sliders) {
      await slider.focus();
      for (const key of keys) await page.keyboard.press(key);
      pressures.push(await slider_value(slider));
      const text = await slider.getAttribute("aria-valuetext");
      assert.match(text, /^\u2212?[\d.]+\u00a0kPa$/, "value in words");
      assert.ok(
        Math.abs(parseFloat(text.replace("\u2212", "-")) - pressures.at(-1)) < 0.006,
        `${text} for ${pressures.at(-1)}`,
      );
    }
    if (keys[0] === "End") {
      assert.deepEqual(
        pressures,
        data.view.segments.map((segment) => segment.states.at(-1).pressure_kPa),
      );
      assert.notDeepEqual(await page.evaluate(() => window.latticast.bounds()), at_rest, "nothing moved");
    }
    largest = Math.max(largest, await largest_error(page, data, pressures));
  }
  await page.evaluate(() => window.latticast.setPressure(0));
  largest = Math.max(
    largest,
    await largest_error(
      page,
      data,
      data.view.segments.map(() => 0),
    ),
  );
  assert.ok(largest < 1e-3, `vertices are ${largest} mm from the data`);
  return `vertices within ${largest.toExponential(1)} mm of the data`;
}

/** The common slider moves every segment. */
export async function check_common_slider(page, data) {
  if (data.view.segments.length < 2) return "one segment";
  const common = page.locator(".panel input[type=range]").first();
  await common.focus();
  await page.keyboard.press("End");
  const highest = Math.max(...data.view.segments.map((segment) => segment.states.at(-1).pressure_kPa));
  for (const [i, slider] of segment_sliders(page, data).entries())
    assert.equal(await slider_value(slider), Math.min(highest, data.view.segments[i].states.at(-1).pressure_kPa));
  await page.evaluate(() => window.latticast.setPressure(0));
  return "";
}

const picture = async (page) => {
  await settle(page);
  return page.locator(".stage").screenshot();
};

/** The picture changes with pressure, and only where the actuator is. */
export async function check_picture(page) {
  const full = () => page.evaluate(() => window.latticast.setPressure(1e9));
  const rest = () => page.evaluate(() => window.latticast.setPressure(0));
  await page.mouse.move(2, 2);
  const before = await picture(page);
  await full();
  const after = await picture(page);
  const [whole, ...corners] = await difference(page, before, after, [[0, 0, 1, 1], ...CORNERS]);
  assert.ok(whole > 0.01, `only ${whole} of the picture changed`);
  assert.deepEqual(corners, [0, 0, 0, 0], "corners changed");
  // With the bodies, the centre line and the pins away, nothing of the picture moves: neither grid nor eye.
  const boxes = ["Lattice", "Liner", "Centre line", "Pins"];
  for (const label of boxes) await tick(page, label, false);
  const empty_full = await picture(page);
  await rest();
  const [moved] = await difference(page, empty_full, await picture(page), [[0, 0, 1, 1]]);
  assert.equal(moved, 0, "what is not the actuator moved");
  for (const label of boxes) await tick(page, label, true);
  return `${(100 * whole).toFixed(1)} % of the picture changes`;
}

async function tick(page, label, on) {
  const box = page.locator(".boxes").getByLabel(label, { exact: true });
  if (await box.count()) await box.setChecked(on);
}

/** Nothing is drawn while nothing changes; arrow keys turn the view. */
export async function check_drawing_on_demand(page) {
  await settle(page);
  const drawings = () => page.evaluate(() => window.drawings);
  const before = await drawings();
  await page.waitForTimeout(400);
  assert.equal(await drawings(), before, "drawn although nothing changed");
  const first = await picture(page);
  await page.locator(".stage canvas").focus();
  for (const key of ["ArrowLeft", "ArrowLeft", "ArrowUp"]) await page.keyboard.press(key);
  const [turned] = await difference(page, first, await picture(page), [[0, 0, 1, 1]]);
  assert.ok(turned > 0.01, "arrow keys did not turn the view");
  await page.getByRole("button", { name: "Oblique" }).click();
  const [back] = await difference(page, first, await picture(page), [[0, 0.1, 0.8, 0.8]]);
  assert.ok(back < 0.01, "a standard view is not where the view began");
  return "";
}

/** A finding's button leads to its pin, a pin leads to its finding. */
export async function check_findings(page, data) {
  const placed = data.view.markers.map((marker) => marker.finding);
  if (placed.length === 0) return "no findings with a place";
  const index = placed[0];
  await page.locator(`#finding-${index} button`).click();
  const pin = page.locator(`.pin[data-finding="${index}"]`);
  await settle(page);
  assert.ok(await pin.evaluate((element) => element.classList.contains("chosen")), "the pin is not marked");
  assert.equal(await page.locator(`#finding-${index} button`).getAttribute("aria-pressed"), "true");
  const [box, stage] = [await pin.boundingBox(), await page.locator(".stage").boundingBox()];
  assert.ok(
    Math.abs(box.x + 12 - stage.x - stage.width / 2) < 3 && Math.abs(box.y + 12 - stage.y - stage.height / 2) < 3,
    "the pin is not in the middle",
  );
  await page.getByRole("button", { name: "Fit", exact: true }).click();
  await settle(page);
  const other = placed.at(-1);
  await page.locator(`.pin[data-finding="${other}"]`).focus();
  await page.keyboard.press("Enter");
  assert.equal(await page.evaluate(() => document.activeElement.id), `finding-${other}`, "a pin leads to its finding");
  assert.ok(await page.locator(`#finding-${other}`).evaluate((line) => line.classList.contains("chosen")));
  return "";
}

/** Play moves only when asked to, and stops. */
export async function check_play(page) {
  const value = () =>
    page
      .locator(".panel input[type=range]")
      .first()
      .evaluate((input) => input.valueAsNumber);
  assert.equal(await value(), 0, "the page began to move by itself");
  await page.getByRole("button", { name: "Play" }).click();
  await page.waitForFunction(() => document.querySelector(".panel input[type=range]").valueAsNumber > 0, null, {
    timeout: 20000,
  });
  await page.getByRole("button", { name: "Stop" }).click();
  const stopped = await value();
  await page.waitForTimeout(250);
  assert.equal(await value(), stopped, "it moves on after Stop");
  await page.evaluate(() => window.latticast.setPressure(0));
  return "";
}

/** A load case sets all sliders. */
export async function check_load_case(page, data) {
  if (data.view.cases.length === 0 || data.view.segments.length < 2) return "no choice of load cases";
  const index = data.view.cases.length - 1;
  await page.getByLabel("Load case", { exact: true }).selectOption(String(index));
  const values = [];
  for (const slider of segment_sliders(page, data)) values.push(await slider_value(slider));
  assert.deepEqual(values, data.view.cases[index].pressures_kPa);
  await page.evaluate(() => window.latticast.setPressure(0));
  return "";
}
