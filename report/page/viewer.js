// SPDX-License-Identifier: GPL-3.0-or-later
// The 3-D view: draws the bodies that the page hands over, in mm with z up, and draws anew only when
// something changed. The page keeps the vertices; this module shows them.

import { CanvasTexture, Points, PointsMaterial, BufferGeometry, BufferAttribute, Vector3 } from "three";

import { create_camera } from "./viewer_camera.js";
import { create_scene } from "./viewer_scene.js";

/** @returns {WebGL2RenderingContext} @throws {Error} where there is none */
function context_of(canvas) {
  const context = canvas.getContext("webgl2", { alpha: true, antialias: true, powerPreference: "low-power" });
  if (!context) throw new Error("this browser offers no WebGL 2 here");
  return context;
}

/** @returns {CanvasTexture} a disc, so that points are round */
function disc_texture() {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 32;
  const pen = canvas.getContext("2d");
  pen.fillStyle = "#fff";
  pen.arc(16, 16, 14, 0, 2 * Math.PI);
  pen.fill();
  return new CanvasTexture(canvas);
}

/** @param {Float32Array} points_mm @returns {Points} of equal size on the screen */
function cloud_of(points_mm, colour) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points_mm, 3));
  return new Points(
    geometry,
    new PointsMaterial({ color: colour, size: 5, sizeAttenuation: false, map: disc_texture(), alphaTest: 0.5 }),
  );
}

/**
 * @typedef {Object} ShownBody
 * @property {string} role           "lattice" or "liner"
 * @property {number} segment        index from 0
 * @property {Float32Array} present  vertices in the frame of the segment; the page changes them in place
 * @property {TypedArray} indices
 */

/**
 * @param {HTMLCanvasElement} canvas
 * @param {ShownBody[]} bodies
 * @param {{lattice: string, liner: string, grid: string, cloud: string}} colours
 * @param {{min: number[], max: number[]}} room  what the camera must hold, in every state
 * @param {function()} on_drawn  called after each drawing
 */
function create_viewer({ canvas, bodies, colours, room, on_drawn }) {
  const context = context_of(canvas);
  const world = create_scene({ canvas, context, bodies, colours, room });
  const eye = create_camera(canvas, room, request);
  let waiting = false;
  let cloud = null;

  function draw() {
    waiting = false;
    eye.before_drawing();
    world.renderer.render(world.scene, eye.camera);
    on_drawn();
  }

  function request() {
    if (!waiting) requestAnimationFrame(() => waiting && draw());
    waiting = true;
  }

  function set_size() {
    const { clientWidth: width, clientHeight: height } = canvas;
    if (width === 0 || height === 0) return;
    world.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    world.renderer.setSize(width, height, false);
    eye.set_shape(width, height);
  }

  /** @param {number[]} point_mm @returns {number[]|null} pixels of the canvas; null behind the eye */
  function project(point_mm) {
    const seen = new Vector3(...point_mm).project(eye.camera);
    if (seen.z > 1) return null;
    return [((seen.x + 1) / 2) * canvas.clientWidth, ((1 - seen.y) / 2) * canvas.clientHeight];
  }

  canvas.addEventListener("webglcontextrestored", request);
  set_size();
  return {
    draw,
    request,
    project,
    /** To be called when the canvas has another size. It draws at once, lest the picture flickers. */
    resize: () => {
      set_size();
      draw();
    },
    fit: eye.fit,
    look_from: eye.look_from,
    turn: eye.turn,
    zoom: eye.zoom,
    look_at: eye.look_at,
    grid_mm: world.grid_mm,
    mm_per_pixel: eye.mm_per_pixel,
    axis_on_screen: eye.axis_on_screen,
    set_poses: (poses) => {
      world.set_poses(poses);
      request();
    },
    set_visible: (role, visible) => {
      world.set_visible(role, visible);
      request();
    },
    set_translucent: (role, translucent) => {
      world.set_translucent(role, translucent);
      request();
    },
    set_cut: (cut) => {
      world.set_cut(cut);
      request();
    },
    set_colours: (next) => {
      world.set_colours(next);
      cloud?.material.color.set(next.cloud);
      request();
    },
    set_cloud: (points_mm) => {
      if (cloud) world.scene.remove(cloud);
      cloud = points_mm ? cloud_of(points_mm, colours.cloud) : null;
      if (cloud) world.scene.add(cloud);
      request();
    },
    picture: () => {
      draw();
      return canvas.toDataURL("image/png");
    },
  };
}

window.latticast?.attachViewer(create_viewer);
