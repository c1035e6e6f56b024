// SPDX-License-Identifier: GPL-3.0-or-later
// A headless Chromium that watches what a page says and asks for.
// LATTICAST_NODE_MODULES names the folder of the packages, CHROMIUM the browser (Debian's by default).

import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const require = createRequire(join(resolve(process.env.LATTICAST_NODE_MODULES ?? "node_modules"), "here"));
const SOFTWARE_GL = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
const NO_GL = ["--disable-gpu", "--disable-3d-apis"];

export const axe_source = require("axe-core").source;

/** @param {boolean} with_gl whether WebGL is there */
export async function launch(with_gl = true) {
  const { chromium } = require("playwright-core");
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--headless=new", "--no-sandbox", ...(with_gl ? SOFTWARE_GL : NO_GL)],
  });
}

/**
 * Opens a file and waits until it is ready.
 * @param {Object} settings of the browser's page, such as its viewport and colorScheme
 * @returns {{page, said: string[], asked: string[], seconds: Object}} what the console and errors said, and all requests
 */
export async function open(browser, file, settings = {}) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 }, ...settings });
  const said = [];
  const asked = [];
  page.on("console", (message) => {
    if (message.type() !== "log") said.push(`${message.type()}: ${message.text()}`);
  });
  page.on("pageerror", (error) => said.push(`error: ${error.message}`));
  page.on("request", (request) => asked.push(request.url()));
  await page.addInitScript(count_drawings);
  await page.goto(pathToFileURL(file).href);
  const state = await page.evaluate(async () => {
    const ready = await Promise.race([
      window.latticast.ready,
      new Promise((_, fail) => setTimeout(() => fail(new Error("not ready after 60 s")), 60000)),
    ]);
    return { ...ready, milliseconds: performance.now() };
  });
  return { page, said, asked, state };
}

/** Runs in the page, before its scripts. */
function count_drawings() {
  window.drawings = 0;
  if (typeof WebGL2RenderingContext === "undefined") return;
  for (const name of ["drawElements", "drawArrays"]) {
    const drawn = WebGL2RenderingContext.prototype[name];
    WebGL2RenderingContext.prototype[name] = function counted(...parameters) {
      window.drawings += 1;
      return drawn.apply(this, parameters);
    };
  }
}

/** Waits until what was asked for is drawn. */
export async function settle(page) {
  await page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 30)))),
  );
}

/**
 * @param {Buffer} a @param {Buffer} b pictures of one size, PNG
 * @param {number[][]} fields  [x, y, width, height] in parts of the picture
 * @returns {number[]} part of each field's pixels that differ
 */
export async function difference(page, a, b, fields) {
  return page.evaluate(
    async ([first, second, places]) => {
      const pixels = await Promise.all(
        [first, second].map(async (text) => {
          const image = new Image();
          image.src = `data:image/png;base64,${text}`;
          await image.decode();
          const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
          const pen = canvas.getContext("2d");
          pen.drawImage(image, 0, 0);
          return pen.getImageData(0, 0, image.width, image.height);
        }),
      );
      const [p, q] = pixels;
      return places.map(([x, y, w, h]) => {
        const [x0, x1, y0, y1] = [x * p.width, (x + w) * p.width, y * p.height, (y + h) * p.height].map(Math.floor);
        let other = 0;
        for (let j = y0; j < y1; ++j)
          for (let i = x0; i < x1; ++i)
            if (
              [0, 1, 2].some((c) => Math.abs(p.data[4 * (j * p.width + i) + c] - q.data[4 * (j * p.width + i) + c]) > 8)
            )
              ++other;
        return other / ((x1 - x0) * (y1 - y0));
      });
    },
    [a.toString("base64"), b.toString("base64"), fields],
  );
}
