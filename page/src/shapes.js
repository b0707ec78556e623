// Solids that the 3D view is made of.

import {
  Color,
  ConeGeometry,
  CylinderGeometry,
  DoubleSide,
  DynamicDrawUsage,
  Group,
  InstancedMesh,
  LineBasicMaterial,
  LineLoop,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  BufferGeometry,
  PlaneGeometry,
  Quaternion,
  ShaderMaterial,
  ShadowMaterial,
  SphereGeometry,
  BoxGeometry,
  Vector3,
  CatmullRomCurve3,
  TubeGeometry,
  Matrix4,
} from "three";
import { estimateReach } from "../../judge/geometry/arm.js";
import { cross, minus, norm, plus, scaled } from "../../judge/geometry/kinematics.js";
import { AXIS_COLOURS } from "./look.js";

const UP = new Vector3(0, 1, 0); // the axis of three.js cylinders
const ROD = new CylinderGeometry(1, 1, 1, 28, 1, true);
const BARREL = new CylinderGeometry(1, 1, 1, 36);
const BALL = new SphereGeometry(1, 28, 18);
const BOX = new BoxGeometry(1, 1, 1);
const CONE = new ConeGeometry(1, 1, 24);
const SQUARE = new PlaneGeometry(1, 1);
const RINGS = [
  ["x", 0],
  ["x", Math.PI / 2],
  ["y", Math.PI / 2],
];
const RING = new BufferGeometry().setFromPoints(
  Array.from(
    { length: 64 },
    (_, i) => new Vector3(Math.cos((i * Math.PI) / 32), Math.sin((i * Math.PI) / 32), 0),
  ),
);
const SHARED = new Set([ROD, BARREL, BALL, BOX, CONE, SQUARE, RING]);

/** Return whether all figures share a geometry, which must not be disposed then. */
export const isSharedGeometry = (geometry) => SHARED.has(geometry);

export const makeBall = (material) => new Mesh(BALL, material);
export const makeRod = (material) => new Mesh(BARREL, material);

// Make a square of a size (m) that faces z.
export function makeSquare(size, material) {
  const mesh = new Mesh(SQUARE, material);
  mesh.scale.setScalar(size);
  return mesh;
}

// Make the ground that shows only the arm's shadow.
export function makeShadow(size, look) {
  const shade = makeSquare(4 * size, new ShadowMaterial({ opacity: look.shadow }));
  shade.receiveShadow = true;
  shade.position.z = -0.001 * size;
  return shade;
}

const toVector = (v) => new Vector3().fromArray(v);

const ORIGIN = [0, 0, 0];
const WHITE = new Color(1, 1, 1);

/**
 * Solids of the same shape and material, drawn in a single call. Size 0 hides a solid.
 */
class InstancedSolids extends InstancedMesh {
  constructor(geometry, material, count) {
    super(geometry, material, count);
    this.frustumCulled = false; // the instances move, and their bounding sphere is not updated
    this.instanceMatrix.setUsage(DynamicDrawUsage);
    for (let i = 0; i < count; i++) this.hide(i);
  }

  // Place a solid by its scaled x, y and z axes and its middle.
  placeByAxes(i, x, y, z, middle) {
    [x, y, z, middle].forEach((column, k) => this.instanceMatrix.array.set(column, 16 * i + 4 * k));
    this.instanceMatrix.array[16 * i + 15] = 1;
    this.instanceMatrix.needsUpdate = true;
  }

  // Place a solid between two points, with its x axis along `side`. Returns whether it is visible.
  placeBetween(i, start, end, radius, side = null) {
    const direction = minus(end, start);
    const length = norm(direction);
    if (length <= 1e-6) {
      this.hide(i);
      return false;
    }
    const x = side ?? findPerpendicular(direction, length);
    const size = radius / norm(x);
    this.placeByAxes(
      i,
      scaled(size, x),
      direction,
      scaled(size / length, cross(x, direction)),
      plus(start, scaled(0.5, direction)),
    );
    return true;
  }

  placeBall(i, middle, radius) {
    this.placeByAxes(i, [radius, 0, 0], [0, radius, 0], [0, 0, radius], middle);
  }

  hide(i) {
    this.placeBall(i, ORIGIN, 0);
  }

  /** @param {(i: number) => Color} getColour */
  setColours(getColour) {
    for (let i = 0; i < this.count; i++) this.setColorAt(i, getColour(i));
    this.instanceColor.needsUpdate = true;
  }
}

// Return a vector perpendicular to `direction`, from the base axis that is least parallel to it.
function findPerpendicular(direction, length) {
  return cross(direction, Math.abs(direction[2]) < 0.7 * length ? [0, 0, 1] : [1, 0, 0]);
}

// Place a rod of unit length between two points.
export function placeRod(mesh, start, end, radius) {
  const direction = toVector(minus(end, start));
  const length = direction.length();
  mesh.visible = length > 1e-6;
  if (!mesh.visible) return;
  mesh.position.copy(toVector(start)).addScaledVector(direction, 0.5);
  mesh.quaternion.copy(new Quaternion().setFromUnitVectors(UP, direction.divideScalar(length)));
  mesh.scale.set(radius, length, radius);
}

export const LINK_RADIUS = 0.021; // share of the arm's reach, for the first link

/**
 * An arm made of capsules along d and a of each row, and of a barrel or box at each joint.
 *
 * Revolute joints are barrels, prismatic joints boxes. With `jointColour` joints can be tinted
 * singly; their material must be white then.
 */
export class ArmShape extends Group {
  constructor(arm, { link, joint, ghost = false, jointColour = null }) {
    super();
    this.arm = arm;
    this.size = estimateReach(arm);
    this.ghost = ghost;
    this.jointColour = jointColour;
    const n = arm.rows.length;
    const add = (geometry, material, count) => {
      const solids = new InstancedSolids(geometry, material, count);
      solids.castShadow = solids.receiveShadow = !ghost;
      this.add(solids);
      return solids;
    };
    this.rods = add(ROD, link, 2 * n);
    this.balls = add(BALL, link, 2 * n);
    this.barrels = add(BARREL, joint, n + 1); // the last barrel is the pedestal
    this.boxes = arm.rows.some((row) => row.kind === "prismatic") ? add(BOX, joint, n) : null;
    if (!ghost)
      this.barrels.placeBetween(
        n,
        [0, 0, -0.004 * this.size],
        [0, 0, 0.012 * this.size],
        0.05 * this.size,
      );
    if (!jointColour) return;
    // Colours are set from the start; adding them later would compile another shadow program.
    for (const solids of [this.rods, this.balls]) solids.setColours(() => WHITE);
    this.tintJoints(() => null);
  }

  // Tint each joint with `getTint(row)`, or not at all where that is null.
  tintJoints(getTint) {
    const getColour = (i) => getTint(i) ?? this.jointColour;
    this.barrels.setColours(getColour);
    this.boxes?.setColours(getColour);
  }

  // Place the links at frames. A ghost is thinner, so that an arm in its place hides it.
  placeAtFrames(frames, thickness = this.ghost ? 0.97 : 1) {
    this.radiusScale = thickness * this.size;
    this.arm.rows.forEach((row, i) => {
      const [before, after] = [frames[i], frames[i + 1]];
      const corner = minus(after.o, scaled(row.a, after.x));
      const radius = this.getLinkRadius(i);
      const isPrismatic = row.kind === "prismatic";
      const hasOffset = this.rods.placeBetween(
        2 * i,
        before.o,
        corner,
        isPrismatic ? 0.6 * radius : radius,
      );
      const hasLength = this.rods.placeBetween(2 * i + 1, corner, after.o, radius);
      const ends = [corner, after.o];
      const widths = [isPrismatic ? 0.6 : 1, i === this.arm.rows.length - 1 ? 0.8 : 1];
      ends.forEach((end, k) => {
        if (hasOffset || hasLength) this.balls.placeBall(2 * i + k, end, widths[k] * radius);
        else this.balls.hide(2 * i + k);
      });
      if (row.kind !== "fixed") this.placeJoint(i, before, radius, isPrismatic);
    });
  }

  placeJoint(i, { o, x, z }, radius, isPrismatic) {
    const half = scaled(isPrismatic ? 2.2 * radius : 1.45 * radius, z);
    const [from, to] = [minus(o, half), plus(o, half)];
    if (isPrismatic) this.boxes.placeBetween(i, from, to, 2 * radius, x);
    else this.barrels.placeBetween(i, from, to, 1.28 * radius);
  }

  // Links grow thinner towards the tip, and the last link is a pen.
  getLinkRadius(i) {
    const n = this.arm.rows.length;
    return this.radiusScale * (i === n - 1 ? 0.008 : LINK_RADIUS - (0.008 * i) / n);
  }
}

// An arrow from a point along a vector.
export class Arrow extends Group {
  constructor(material) {
    super();
    this.shaft = new Mesh(BARREL, material);
    this.head = new Mesh(CONE, material);
    this.add(this.shaft, this.head);
  }

  placeAlong(start, vector, thickness) {
    const length = norm(vector);
    this.visible = length > 1e-9;
    if (!this.visible) return;
    const neck = Math.max(0, length - 5 * thickness);
    placeRod(this.shaft, start, plus(start, scaled(neck / length, vector)), thickness);
    placeRod(
      this.head,
      plus(start, scaled(neck / length, vector)),
      plus(start, vector),
      2.4 * thickness,
    );
  }
}

// The three axes of several frames.
export class Triads extends Group {
  constructor(dark, count) {
    super();
    const colours = Object.values(AXIS_COLOURS[dark ? "dark" : "light"]).map(
      (colour) => new Color(colour),
    );
    this.shafts = new InstancedSolids(BARREL, new MeshBasicMaterial(), 3 * count);
    this.heads = new InstancedSolids(CONE, new MeshBasicMaterial(), 3 * count);
    for (const solids of [this.shafts, this.heads]) solids.setColours((i) => colours[i % 3]);
    this.add(this.shafts, this.heads);
  }

  /** @param {boolean[]} isDrawn whether each frame is drawn */
  placeAtFrames(frames, length, isDrawn) {
    const thickness = 0.022 * length;
    frames.forEach((frame, i) =>
      ["x", "y", "z"].forEach((axis, k) => {
        const [neck, tip] = [length - 5 * thickness, length].map((distance) =>
          plus(frame.o, scaled(distance, frame[axis])),
        );
        for (const [solids, from, to, radius] of [
          [this.shafts, frame.o, neck, thickness],
          [this.heads, neck, tip, 2.4 * thickness],
        ]) {
          if (isDrawn[i]) solids.placeBetween(3 * i + k, from, to, radius);
          else solids.hide(3 * i + k);
        }
      }),
    );
  }
}

// The tip's velocities for joint rates of unit length.
export class Ellipsoid extends Group {
  constructor(colour) {
    super();
    const material = new MeshStandardMaterial({
      color: colour,
      transparent: true,
      opacity: 0.2,
      depthWrite: false,
      side: DoubleSide,
    });
    this.add(new Mesh(BALL, material));
    for (const [axis, turn] of RINGS) {
      const loop = new LineLoop(RING, new LineBasicMaterial({ color: colour }));
      loop.rotation[axis] = turn;
      this.add(loop);
    }
    this.matrixAutoUpdate = false;
  }

  // Set the half axes to `scale` times the singular values, or to `shortest`, which is visible.
  placeAt(centre, { values, vectors }, scale, shortest) {
    const columns = vectors.map((v, i) =>
      toVector(scaled(Math.max(scale * values[i], shortest), v)),
    );
    const [u, v, w] = columns;
    this.matrix.makeBasis(u, v, w).premultiply(new Matrix4().makeTranslation(toVector(centre)));
  }
}

// Make a tube along points.
export function makeTube(points, radius, colour) {
  const gap = 1e-7;
  const apart = points.filter((p, i) => i === 0 || norm(minus(p, points[i - 1])) > gap);
  if (apart.length < 2) return new Group();
  const curve = new CatmullRomCurve3(apart.map(toVector));
  return new Mesh(
    new TubeGeometry(curve, Math.min(400, apart.length * 2), radius, 8),
    new MeshBasicMaterial({ color: colour }),
  );
}

/**
 * Make a transparent square behind a path that is flat, as a circle on a wall is.
 * @returns {{ wall: Mesh, centre: number[], radius: number, normal: number[] } | null} with the
 *   path's centre and its largest distance from it
 */
export function makeWall(points, material) {
  const isClosed = norm(minus(points[0], points.at(-1))) < norm(minus(points[0], points[1]));
  const corners = isClosed ? points.slice(1) : points;
  const n = corners.length;
  const centre = scaled(1 / n, corners.reduce(plus));
  const [p, q] = [corners[0], corners[Math.floor(n / 4)]].map((v) => toVector(minus(v, centre)));
  const normal = p.clone().cross(q).normalize();
  const size = Math.max(...points.map((v) => norm(minus(v, centre))));
  const flat = points.every((v) => Math.abs(toVector(minus(v, centre)).dot(normal)) < 0.02 * size);
  if (!(size > 1e-6 && normal.length() > 0.5 && flat)) return null;
  const mesh = makeSquare(3.4 * size, material);
  mesh.position.copy(toVector(centre));
  const up = Math.abs(normal.z) > 0.9 ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1);
  mesh.quaternion.setFromRotationMatrix(new Matrix4().lookAt(normal, new Vector3(), up));
  return { wall: mesh, centre, radius: size, normal: normal.toArray() };
}

// Make a floor of grid lines that fade out towards its edge.
export function makeFloor(size, colour, strength) {
  const step = size > 1.2 ? 0.2 : size > 0.4 ? 0.1 : 0.05;
  const material = new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    side: DoubleSide,
    uniforms: {
      colour: { value: new Color(colour) },
      size: { value: size },
      step: { value: step },
      strength: { value: strength },
    },
    vertexShader: `
      varying vec2 p; uniform float size;
      void main() {
        p = 2.0 * size * position.xy;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: `
      varying vec2 p; uniform vec3 colour;
      uniform float size; uniform float step; uniform float strength;
      void main() {
        vec2 g = abs(fract(p / step - 0.5) - 0.5) / fwidth(p / step);
        float line = 1.0 - min(min(g.x, g.y), 1.0);
        gl_FragColor = vec4(colour, strength * line * smoothstep(1.0, 0.2, length(p) / size));
      }`,
  });
  return makeSquare(2 * size, material);
}

export function makeGhostMaterial(colour) {
  return new MeshStandardMaterial({
    color: colour,
    transparent: true,
    opacity: 0.45, // less cannot be told from a dark ground
    depthWrite: false,
    roughness: 0.7,
  });
}

// Make the material of a transparent pane.
export const makePaneMaterial = (color, opacity) =>
  new MeshBasicMaterial({ color, transparent: true, opacity, side: DoubleSide, depthWrite: false });
