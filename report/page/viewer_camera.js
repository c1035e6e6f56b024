// SPDX-License-Identifier: GPL-3.0-or-later
// The eye of the 3-D view: where it stands, and how hands and keys move it.

import { PerspectiveCamera, Sphere, Box3, Spherical, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

const FIELD_DEG = 26;

/** @param {{min: number[], max: number[]}} room @returns {Sphere} around it */
function sphere_around(room) {
  const box = new Box3(new Vector3(...room.min), new Vector3(...room.max));
  return box.getBoundingSphere(new Sphere());
}

/** @param {{min: number[], max: number[]}} room @returns {number[][]} its eight corners */
function corners_of({ min, max }) {
  return Array.from({ length: 8 }, (_, k) => [0, 1, 2].map((i) => ((k >> i) & 1 ? max : min)[i]));
}

/** @param {function()} changed called when the picture must be drawn anew */
export function create_camera(canvas, room, changed) {
  const camera = new PerspectiveCamera(FIELD_DEG, 1, 1, 1e4);
  camera.up.set(0, 0, 1);
  const controls = new OrbitControls(camera, canvas);
  const sphere = sphere_around(room);
  let direction = new Vector3(0.55, -1, 0.42).normalize();

  controls.minDistance = sphere.radius / 20;
  controls.maxDistance = sphere.radius * 20;
  // A wheel over the page scrolls it; over a view that was chosen before, it zooms. A finger that moves up or down
  // scrolls, too.
  controls.enableZoom = false;
  canvas.addEventListener("focus", () => {
    controls.enableZoom = true;
  });
  canvas.addEventListener("blur", () => {
    controls.enableZoom = false;
  });
  canvas.addEventListener("pointerdown", (event) => {
    if (event.pointerType === "touch") controls.enableZoom = true;
    canvas.focus({ preventScroll: true });
  });
  canvas.style.touchAction = "pan-y";
  controls.addEventListener("change", changed);

  function stand(at, distance) {
    controls.target.copy(at);
    camera.position.copy(at).addScaledVector(direction, distance);
    controls.update();
    changed();
  }

  /** Distance of the eye from which every corner of the room is seen. */
  function distance_for_room() {
    const up = Math.tan((FIELD_DEG * Math.PI) / 360);
    camera.position.copy(sphere.center).add(direction);
    camera.lookAt(sphere.center);
    camera.updateMatrixWorld();
    const turned = camera.matrixWorldInverse;
    return Math.max(
      ...corners_of(room).map((corner) => {
        const seen = new Vector3(...corner)
          .sub(sphere.center)
          .transformDirection(turned)
          .multiplyScalar(new Vector3(...corner).distanceTo(sphere.center));
        return seen.z + 1.12 * Math.max(Math.abs(seen.x) / (up * camera.aspect), Math.abs(seen.y) / up);
      }),
    );
  }

  function fit() {
    stand(sphere.center, distance_for_room());
  }

  /** @param {number} around @param {number} up radians */
  function turn(around, up) {
    const arm = camera.position.clone().sub(controls.target);
    const place = new Spherical().setFromVector3(new Vector3(arm.x, arm.z, -arm.y));
    place.theta += around;
    place.phi = Math.min(Math.PI - 1e-3, Math.max(1e-3, place.phi - up));
    const next = new Vector3().setFromSpherical(place);
    camera.position.copy(controls.target).add(new Vector3(next.x, -next.z, next.y));
    controls.update();
    changed();
  }

  let shaped = false;
  return {
    camera,
    fit,
    turn,
    before_drawing() {
      const distance = camera.position.distanceTo(controls.target);
      camera.near = distance / 100;
      camera.far = distance + 10 * sphere.radius;
      camera.updateProjectionMatrix();
    },
    set_shape(width, height) {
      camera.aspect = width / height;
      camera.updateProjectionMatrix();
      if (!shaped) fit();
      shaped = true;
    },
    /** @param {number[]} from direction in which the eye lies */
    look_from(from) {
      direction = new Vector3(...from).normalize();
      fit();
    },
    /** Moves the point around which the eye turns, and comes near. @param {number[]} point_mm */
    look_at(point_mm) {
      direction = camera.position.clone().sub(controls.target).normalize();
      stand(new Vector3(...point_mm), distance_for_room() / 2);
    },
    /** @param {number} factor of the distance */
    zoom(factor) {
      camera.position.sub(controls.target).multiplyScalar(factor).add(controls.target);
      controls.update();
      changed();
    },
    mm_per_pixel() {
      const distance = camera.position.distanceTo(controls.target);
      return (2 * distance * Math.tan((FIELD_DEG * Math.PI) / 360)) / canvas.clientHeight;
    },
    /** @param {number[]} axis @returns {number[]} how far it points right, up and towards the eye */
    axis_on_screen(axis) {
      return new Vector3(...axis).transformDirection(camera.matrixWorldInverse).toArray();
    },
  };
}
