// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of the page as a page: what it asks for, its width, its colours, its keys.

import assert from "node:assert/strict";

import { axe_source } from "./browser.mjs";

/** Nothing but the file itself is asked for, and the console stays silent. */
export function check_silence({ said, asked }, file_url) {
  assert.deepEqual(said, [], "console");
  assert.deepEqual(
    asked.filter((url) => url !== file_url && !url.startsWith("data:")),
    [],
    "requests",
  );
}

/** No text of the data became script or markup. */
export async function check_texts(page, data) {
  assert.equal(await page.evaluate(() => window.broken), undefined, "a text of the data ran");
  const spaceless = (text) => text.replace(/\s+/g, " ").trim();
  assert.equal(spaceless(await page.locator("h1").textContent()), spaceless(data.report.name || "Actuator"));
  assert.equal(await page.locator("main b").count(), 0, "a text of the data became an element");
}

/** @param {number} width */
export async function check_width(page, width) {
  await page.setViewportSize({ width, height: 800 });
  await page.waitForTimeout(150);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= width, `the page is ${wide} wide in a window of ${width}`);
}

/** Headings go down one step at a time, tables have captions and heads. */
export async function check_outline(page) {
  const levels = await page.$$eval("h1, h2, h3, h4", (heads) => heads.map((head) => Number(head.tagName[1])));
  assert.equal(levels[0], 1);
  levels.forEach((level, i) => assert.ok(i === 0 || level <= levels[i - 1] + 1, `headings ${levels.join(" ")}`));
  const bare = await page.$$eval(
    "table",
    (tables) => tables.filter((table) => !table.caption?.textContent || !table.querySelector("th[scope]")).length,
  );
  assert.equal(bare, 0, "tables without caption or heads");
}

/** Runs in the page. @returns {string[]} texts whose contrast with what lies behind them is too small */
function weak_texts() {
  // A canvas turns any colour into red, green, blue and opacity.
  const pen = Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d", {
    willReadFrequently: true,
  });
  const rgba = (colour) => {
    pen.clearRect(0, 0, 1, 1);
    pen.fillStyle = colour;
    pen.fillRect(0, 0, 1, 1);
    return [...pen.getImageData(0, 0, 1, 1).data];
  };
  const luminance = (colour) =>
    colour
      .slice(0, 3)
      .map((c) => c / 255)
      .map((c) => (c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4))
      .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
  const behind = (element) => {
    for (let e = element; e; e = e.parentElement) {
      const colour = rgba(getComputedStyle(e).backgroundColor);
      if (colour[3] === 255) return colour;
    }
    return [255, 255, 255, 255];
  };
  const weak = [];
  for (const element of document.querySelectorAll("body *")) {
    const own = [...element.childNodes].some((node) => node.nodeType === 3 && node.textContent.trim());
    if (!own || !element.checkVisibility() || element.closest("script, noscript, .skip")) continue;
    const style = getComputedStyle(element);
    // A text in a chart may lie on the field of the stable range, which is darker or lighter than the page.
    const fields = element.closest("svg.chart")
      ? [behind(element), rgba(getComputedStyle(document.documentElement).getPropertyValue("--stable"))]
      : [behind(element)];
    const ink = luminance(rgba(element instanceof SVGElement ? style.fill : style.color));
    for (const field of fields) {
      const other = luminance(field);
      const ratio = (Math.max(ink, other) + 0.05) / (Math.min(ink, other) + 0.05);
      const large = parseFloat(style.fontSize) >= 24;
      if (ratio < (large ? 3 : 4.5))
        weak.push(
          `${ratio.toFixed(2)} <${element.tagName} class="${element.getAttribute("class")}"> ${element.textContent.trim().slice(0, 40)}`,
        );
    }
  }
  return weak;
}

export async function check_contrast(page) {
  await page.$$eval("details", (all) =>
    all.forEach((one) => {
      one.open = true;
    }),
  );
  await page.waitForFunction(() => [...document.querySelectorAll("details")].every((one) => one.children.length > 1));
  assert.deepEqual(await page.evaluate(weak_texts), [], "contrast");
  await page.$$eval("details", (all) =>
    all.forEach((one) => {
      one.open = false;
    }),
  );
}

/** Tab reaches every control, and each shows that it has the focus. */
export async function check_keys(page) {
  const controls = await page.$$eval(
    "a[href], button, input, select, summary, [tabindex='0']",
    (all) => all.filter((e) => e.checkVisibility()).length,
  );
  await page.evaluate(() => {
    document.activeElement.blur();
    window.scrollTo(0, 0);
    window.reached = new Set();
  });
  const unseen = [];
  for (let i = 0; i < controls + 5; ++i) {
    await page.keyboard.press("Tab");
    const state = await page.evaluate(() => {
      const element = document.activeElement;
      if (element === document.body) return null;
      window.reached.add(element);
      const style = getComputedStyle(element);
      return {
        name: element.outerHTML.slice(0, 80),
        outlined: style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 1,
      };
    });
    if (state && !state.outlined) unseen.push(state.name);
  }
  assert.deepEqual(unseen, [], "no visible focus");
  const missed = await page.$$eval("a[href], button, input, select, summary, [tabindex='0']", (all) =>
    all.filter((e) => e.checkVisibility() && !window.reached.has(e)).map((e) => e.outerHTML.slice(0, 80)),
  );
  assert.deepEqual(missed, [], "not reached by Tab");
  return `${controls} controls`;
}

/** The accessibility rules of axe-core. */
export async function check_accessibility(page) {
  await page.evaluate(axe_source);
  const violations = await page.evaluate(async () =>
    (await window.axe.run(document)).violations.map(({ id, impact, nodes }) => ({
      id,
      impact,
      where: nodes.map((node) => node.target.join(" ")).slice(0, 3),
    })),
  );
  const serious = violations.filter(({ impact }) => impact === "serious" || impact === "critical");
  assert.deepEqual(serious, [], "axe-core");
  return violations.length ? `others: ${violations.map(({ id }) => id).join(", ")}` : "";
}

/** The curves can be read by keys; each says its value. */
export async function check_curves(page, data) {
  const curves = (data.report.prediction?.segments ?? []).filter((segment) => segment.curve.length > 1);
  const charts = page.locator("#response svg.chart");
  if (curves.length === 0) return assert.equal(await charts.count(), 0);
  assert.ok((await charts.count()) >= curves.length, "a segment has no chart");
  await charts.first().focus();
  await page.keyboard.press("End");
  const last = curves[0].curve.at(-1);
  const text = await charts.first().getAttribute("aria-valuetext");
  assert.ok(text.startsWith(`${String(Number(last.pressure_kPa.toFixed(2)))}\u00a0kPa`), text);
  return undefined;
}

/** On paper: light colours, and the picture as it stands. */
export async function check_print(page, with_picture) {
  await page.emulateMedia({ media: "print", colorScheme: "dark" });
  const paper = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.equal(paper, "rgb(255, 255, 255)");
  const bytes = await page.pdf({ format: "A4" });
  assert.equal(bytes.subarray(0, 5).toString(), "%PDF-");
  if (with_picture) assert.match(await page.locator(".printed").getAttribute("src"), /^data:image\/png/);
  await page.emulateMedia({ media: "screen" });
}
