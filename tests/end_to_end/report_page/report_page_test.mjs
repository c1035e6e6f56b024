// SPDX-License-Identifier: GPL-3.0-or-later
// report_page_test.mjs FILE [--screenshots FOLDER]: opens a report.html in Chromium and checks what it shows and does.
// What is expected is read from the data in the file, so that any report can be given.

import { createHash } from "node:crypto";
import { mkdirSync, mkdtempSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import assert from "node:assert/strict";

import { launch, open, settle } from "./browser.mjs";
import { read_page } from "./expected.mjs";
import * as pages from "./page_checks.mjs";
import * as views from "./view_checks.mjs";

let failed = 0;

/** Runs one check; a failure is told and the others go on. */
async function check(name, act) {
  try {
    const told = await act();
    console.log(`ok      ${name}${told ? `: ${told}` : ""}`);
  } catch (error) {
    failed += 1;
    console.log(`FAILED  ${name}: ${error.message}`);
  }
}

/** A view has something to show when there are a mesh and more than one state. */
function moves(data) {
  return data.meshes.size > 0 && data.view.segments.some((segment) => segment.states.length > 1);
}

async function check_whole_page(browser, file, data) {
  const opened = await open(browser, file);
  const { page, state } = opened;
  console.log(
    `figure  ${(statSync(file).size / 1e6).toFixed(2)} MB, ready ${Math.round(state.milliseconds)} ms after navigation`,
  );
  const has_view = state.viewer;
  if (data.meshes.size && data.html.includes("three.js")) await check("3-D view is there", () => assert.ok(has_view));
  if (has_view && moves(data)) {
    await check("sliders move vertices", () => views.check_sliders(page, data));
    await check("common slider", () => views.check_common_slider(page, data));
    await check("load case", () => views.check_load_case(page, data));
    await check("picture follows the pressure", () => views.check_picture(page));
    await check("drawn on demand, turned by keys", () => views.check_drawing_on_demand(page));
    await check("findings and pins", () => views.check_findings(page, data));
    await check("play", () => views.check_play(page));
  }
  await check("texts stay texts", () => pages.check_texts(page, data));
  await check("outline", () => pages.check_outline(page));
  await check("curves", () => pages.check_curves(page, data));
  await check("contrast, light", () => pages.check_contrast(page));
  await check("accessibility, light", () => pages.check_accessibility(page));
  await check("keys", () => pages.check_keys(page));
  for (const width of [360, 320, 900]) await check(`width ${width}`, () => pages.check_width(page, width));
  await check("print", () => pages.check_print(page, has_view));
  await check("silence", () => pages.check_silence(opened, pathToFileURL(file).href));
  await page.close();
}

async function check_dark(browser, file) {
  const opened = await open(browser, file, { colorScheme: "dark" });
  await check("contrast, dark", () => pages.check_contrast(opened.page));
  await check("accessibility, dark", () => pages.check_accessibility(opened.page));
  await check("the button switches colours", async () => {
    const theme = () => opened.page.evaluate(() => document.documentElement.dataset.theme);
    assert.equal(await theme(), "dark");
    await opened.page.locator("#tools button").click();
    assert.equal(await theme(), "light");
  });
  await check("silence, dark", () => pages.check_silence(opened, pathToFileURL(file).href));
  await opened.page.close();
}

async function check_phone(browser, file) {
  const opened = await open(browser, file, { viewport: { width: 360, height: 740 }, isMobile: true, hasTouch: true });
  await check("width on a phone", () => pages.check_width(opened.page, 360));
  await opened.page.close();
}

/** Everything but the picture works where there is no picture. */
async function check_without_view(browser, file, data, what, message) {
  const opened = await open(browser, file);
  await check(what, async () => {
    assert.equal(opened.state.viewer, false);
    if (data.meshes.size) assert.match(await opened.page.locator(".stage .message").textContent(), message);
    await pages.check_texts(opened.page, data);
    await pages.check_outline(opened.page);
    pages.check_silence(opened, pathToFileURL(file).href);
    return moves(data) ? views.check_sliders(opened.page, data) : "";
  });
  await opened.page.close();
}

/** @returns {string} the page with other contents of one of its blocks of data */
function with_block(html, id, contents) {
  return html.replace(new RegExp(`(<script[^>]* id="${id}">)[^<]*`), (_, open_tag) => open_tag + contents);
}

/** Damaged meshes cost the picture alone; damaged data are said to be so. */
async function check_damaged(browser, data, work) {
  const opened = async (name, html) => {
    const file = join(work, name);
    writeFileSync(file, html);
    return open(browser, file);
  };
  await check("damaged meshes", async () => {
    const { page, said } = await opened(
      "meshes.html",
      with_block(data.html, "model", Buffer.from("glTF, but no more of it").toString("base64")),
    );
    assert.match(await page.locator(".stage .message").textContent(), /^The meshes cannot be read/);
    assert.ok((await page.locator("#dimensions table").count()) > 0, "tables are gone");
    assert.deepEqual(said, []);
    await page.close();
  });
  await check("damaged data", async () => {
    const { page, said } = await opened("data.html", with_block(data.html, "report", "{"));
    assert.match(await page.getByRole("alert").textContent(), /cannot be read/);
    assert.deepEqual(said, []);
    await page.close();
  });
}

/** @returns {string} the page as a build without npm writes it: its last script is empty, and its policy knows that one */
function without_bundle(html) {
  const hash = createHash("sha256").update("\n\n").digest("base64");
  const policy = html.match(/script-src ([^;]*);/)[1].split(" ");
  return `${html.slice(0, html.lastIndexOf("<script>"))}<script>\n\n</script>\n</body>\n</html>\n`.replace(
    policy.at(-1),
    `'sha256-${hash}'`,
  );
}

/** Whatever gets into the page beside its own scripts does not run. */
async function check_policy(browser, data, work) {
  await check("foreign scripts do not run", async () => {
    const policy = data.html.match(/script-src ([^;]*);/)[1].split(" ");
    assert.ok(policy.length >= 3 && policy.every((source) => /^'sha256-[A-Za-z0-9+/]{43}='$/.test(source)), policy.join(" "));
    const file = join(work, "foreign.html");
    const foreign = '<script>window.foreign = 1</script><img src="data:," onerror="window.foreign = 2">';
    writeFileSync(file, data.html.replace("<main", `${foreign}<main`));
    const { page, said } = await open(browser, file);
    await page.evaluate(() => document.querySelector("#name").setAttribute("onclick", "window.foreign = 3"));
    await page.locator("#name").click();
    assert.equal(await page.evaluate(() => window.foreign), undefined);
    assert.ok(said.some((line) => line.includes("Content Security Policy")), "nothing was refused");
    await page.close();
  });
}

async function screenshots(browser, file, data, folder) {
  mkdirSync(folder, { recursive: true });
  const middle = data.view.segments.map(
    (segment) => segment.states[Math.ceil((segment.states.length - 1) * 0.75)].pressure_kPa,
  );
  const shot = async (name, settings, act, whole = false) => {
    const { page } = await open(browser, file, settings);
    await page.evaluate((pressures) => window.latticast.setPressure(pressures), middle);
    await page.evaluate(act);
    await settle(page);
    await page.screenshot({ path: join(folder, `${name}.png`), fullPage: whole });
    await page.close();
  };
  const to = (id) => `document.getElementById("${id}")?.scrollIntoView()`;
  await shot("report-light", {}, "0");
  await shot("report-dark", { colorScheme: "dark" }, "0");
  await shot("report-curves", {}, to("response"));
  await shot("report-chain", {}, to("chain"));
  await shot("report-phone", { viewport: { width: 360, height: 740 }, deviceScaleFactor: 2 }, to("shape"));
  await shot("report-whole", {}, "0", true);
}

async function main([given, option, folder]) {
  if (!given) throw new Error("usage: report_page_test.mjs FILE [--screenshots FOLDER]");
  const file = resolve(given);
  const data = read_page(file);
  const work = mkdtempSync(join(tmpdir(), "report-page-"));
  const browser = await launch();
  const blind = await launch(false);
  try {
    await check_whole_page(browser, file, data);
    await check_dark(browser, file);
    await check_phone(browser, file);
    await check_damaged(browser, data, work);
    await check_policy(browser, data, work);
    const bare = join(work, "bare.html");
    writeFileSync(bare, without_bundle(data.html));
    await check_without_view(
      browser,
      bare,
      data,
      "built without npm",
      /^3-D view left out: the program was built without npm\.$/,
    );
    if (data.html.includes("three.js")) await check_without_view(blind, file, data, "browser without WebGL", /WebGL/);
    if (option === "--screenshots") await screenshots(browser, file, data, folder);
  } finally {
    await Promise.all([browser.close(), blind.close()]);
    rmSync(work, { recursive: true });
  }
  console.log(failed ? `${failed} checks failed` : "all checks passed");
  process.exitCode = failed ? 1 : 0;
}

await main(process.argv.slice(2));
