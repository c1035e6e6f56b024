// SPDX-License-Identifier: GPL-3.0-or-later
// What the 3-D view shows: bodies, a grid under them, and light that comes with the eye.

import {
  BufferAttribute,
  BufferGeometry,
  DirectionalLight,
  DoubleSide,
  FrontSide,
  GridHelper,
  HemisphereLight,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  Plane,
  Quaternion,
  Scene,
  Vector3,
  WebGLRenderer,
} from "three";

const ONE = new Vector3(1, 1, 1);

function material_of(colour) {
  return new MeshLambertMaterial({ color: colour, flatShading: true, side: DoubleSide });
}

/** @returns {Mesh} whose vertices are those of the body, not a copy */
function mesh_of(body, material) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(body.present, 3));
  geometry.setIndex(new BufferAttribute(body.indices, 1));
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  return mesh;
}

/** @param {{min: number[], max: number[]}} room @returns {number} a distance of lines that gives some twenty, mm */
function grid_step(room) {
  return [10, 20, 50, 100, 200, 500].find((step) => reach_of(room) < 12 * step) ?? 1000;
}

/** @returns {number} how far the room goes from the axis */
function reach_of({ min, max }) {
  return Math.max(...[min, max].flatMap((corner) => corner.slice(0, 2)).map(Math.abs));
}

/** @returns {GridHelper} lines at z = 0 */
function grid_under(room, colour) {
  const step = grid_step(room);
  const cells = Math.ceil(reach_of(room) / step) + 2;
  const grid = new GridHelper(2 * cells * step, 2 * cells, colour, colour);
  grid.rotation.x = Math.PI / 2;
  grid.material.transparent = true;
  grid.material.opacity = 0.5;
  return grid;
}

function add_lights(scene) {
  scene.add(new HemisphereLight(0xffffff, 0x8a8f99, 1.5));
  for (const [x, y, z, strength] of [
    [-2, -3, 4, 1.9],
    [3, 1, 2, 0.7],
  ]) {
    const light = new DirectionalLight(0xffffff, strength);
    light.position.set(x, y, z);
    scene.add(light);
  }
}

/** @returns the scene and what the page may change of it */
export function create_scene({ canvas, context, bodies, colours, room }) {
  const renderer = new WebGLRenderer({ canvas, context });
  renderer.setClearColor(0, 0);
  const scene = new Scene();
  add_lights(scene);
  const materials = { lattice: material_of(colours.lattice), liner: material_of(colours.liner) };
  const meshes = bodies.map((body) => mesh_of(body, materials[body.role] ?? materials.lattice));
  scene.add(...meshes);
  let grid = grid_under(room, colours.grid);
  scene.add(grid);
  const front = new Plane(new Vector3(0, 1, 0), 0);

  return {
    renderer,
    scene,
    grid_mm: grid_step(room),
    set_poses(poses) {
      meshes.forEach((mesh, i) => {
        const { origin_mm, quaternion } = poses[bodies[i].segment].base;
        mesh.matrix.copy(new Matrix4().compose(new Vector3(...origin_mm), new Quaternion(...quaternion), ONE));
        mesh.matrixWorldNeedsUpdate = true;
        mesh.geometry.attributes.position.needsUpdate = true;
      });
    },
    set_visible(role, visible) {
      meshes.forEach((mesh, i) => {
        if (bodies[i].role === role) mesh.visible = visible;
      });
    },
    set_translucent(role, translucent) {
      Object.assign(materials[role], {
        transparent: translucent,
        opacity: translucent ? 0.38 : 1,
        depthWrite: !translucent,
        side: translucent ? FrontSide : DoubleSide,
        needsUpdate: true,
      });
    },
    set_cut(cut) {
      renderer.clippingPlanes = cut ? [front] : [];
    },
    set_colours(next) {
      materials.lattice.color.set(next.lattice);
      materials.liner.color.set(next.liner);
      scene.remove(grid);
      grid = grid_under(room, next.grid);
      scene.add(grid);
    },
  };
}
