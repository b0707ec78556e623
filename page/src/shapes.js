// The solids of which the 3D view is made.

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
  SphereGeometry,
  BoxGeometry,
  Vector3,
  CatmullRomCurve3,
  TubeGeometry,
  Matrix4,
} from "three";
import { estimateReach } from "../../judge/geometry/arm.js";
import { cross, minus, norm, plus, scaled } from "../../judge/geometry/kinematics.js";

const UP = new Vector3(0, 1, 0); // along which three.js builds its cylinders
const ROD = new CylinderGeometry(1, 1, 1, 28, 1, true);
const BARREL = new CylinderGeometry(1, 1, 1, 36);
const BALL = new SphereGeometry(1, 28, 18);
const BOX = new BoxGeometry(1, 1, 1);
const POINT = new ConeGeometry(1, 1, 24);
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
const SHARED = new Set([ROD, BARREL, BALL, BOX, POINT, SQUARE, RING]);

// Whether a geometry belongs to all figures of the page, and so to none of them.
export const isShared = (geometry) => SHARED.has(geometry);

export const ball = (material) => new Mesh(BALL, material);
export const rod = (material) => new Mesh(BARREL, material);

// A square of this size (m), facing z.
export function square(size, material) {
  const mesh = new Mesh(SQUARE, material);
  mesh.scale.setScalar(size);
  return mesh;
}

const vector = (v) => new Vector3().fromArray(v);

const NOWHERE = [0, 0, 0];
const WHITE = new Color(1, 1, 1);

/**
 * Solids of one shape and material that are drawn in one call, however many there are. Each takes
 * its place by its number; one without a size is not seen.
 */
class Solids extends InstancedMesh {
  constructor(geometry, material, count) {
    super(geometry, material, count);
    this.frustumCulled = false; // they move, and no sphere around them is kept up to date
    this.instanceMatrix.setUsage(DynamicDrawUsage);
    for (let i = 0; i < count; i++) this.hide(i);
  }

  // The place of one: where its x, y and z axes lead to, and its middle.
  put(i, x, y, z, middle) {
    [x, y, z, middle].forEach((column, k) => this.instanceMatrix.array.set(column, 16 * i + 4 * k));
    this.instanceMatrix.array[16 * i + 15] = 1;
    this.instanceMatrix.needsUpdate = true;
  }

  // Between two points; of what lies across the way, `side` leads towards x.
  between(i, start, end, radius, side = null) {
    const way = minus(end, start);
    const length = norm(way);
    const seen = length > 1e-6;
    if (!seen) return (this.hide(i), false);
    const x = side ?? across(way, length);
    const size = radius / norm(x);
    this.put(
      i,
      scaled(size, x),
      way,
      scaled(size / length, cross(x, way)),
      plus(start, scaled(0.5, way)),
    );
    return true;
  }

  ball(i, middle, radius) {
    this.put(i, [radius, 0, 0], [0, radius, 0], [0, 0, radius], middle);
  }

  hide(i) {
    this.ball(i, NOWHERE, 0);
  }

  /** @param {(i: number) => Color} pick */
  colour(pick) {
    for (let i = 0; i < this.count; i++) this.setColorAt(i, pick(i));
    this.instanceColor.needsUpdate = true;
  }
}

// A vector across another one: away from the axis of the base along which that one leads least.
function across(way, length) {
  return cross(way, Math.abs(way[2]) < 0.7 * length ? [0, 0, 1] : [1, 0, 0]);
}

// Put a rod of unit length between two points.
export function along(mesh, start, end, radius) {
  const way = vector(minus(end, start));
  const length = way.length();
  mesh.visible = length > 1e-6;
  if (!mesh.visible) return;
  mesh.position.copy(vector(start)).addScaledVector(way, 0.5);
  mesh.quaternion.copy(new Quaternion().setFromUnitVectors(UP, way.divideScalar(length)));
  mesh.scale.set(radius, length, radius);
}

/**
 * An arm as capsules along d and a of each row, with a barrel where a joint turns and a box where
 * it slides. `hue` is the colour of its joints where they are to be tinted one by one; their
 * material is white then.
 */
export class ArmShape extends Group {
  constructor(arm, { link, joint, ghost = false, hue = null }) {
    super();
    this.arm = arm;
    this.size = estimateReach(arm);
    this.ghost = ghost;
    this.hue = hue;
    const n = arm.rows.length;
    const add = (geometry, material, count) => {
      const solids = new Solids(geometry, material, count);
      solids.castShadow = solids.receiveShadow = !ghost;
      this.add(solids);
      return solids;
    };
    this.rods = add(ROD, link, 2 * n);
    this.balls = add(BALL, link, 2 * n);
    this.barrels = add(BARREL, joint, n + 1); // the last is the pedestal
    this.boxes = arm.rows.some((row) => row.kind === "prismatic") ? add(BOX, joint, n) : null;
    if (!ghost)
      this.barrels.between(
        n,
        [0, 0, -0.004 * this.size],
        [0, 0, 0.012 * this.size],
        0.05 * this.size,
      );
    if (!hue) return;
    // or shadows change programs midway
    for (const solids of [this.rods, this.balls]) solids.colour(() => WHITE);
    this.tint(() => null);
  }

  // Joints in the colour that `pick` gives for their row, or in their own.
  tint(pick) {
    const colour = (i) => pick(i) ?? this.hue;
    this.barrels.colour(colour);
    this.boxes?.colour(colour);
  }

  // A ghost is thinner than the arm, and hides inside it where both are.
  pose(frames, girth = this.ghost ? 0.97 : 1) {
    this.girth = girth * this.size;
    this.arm.rows.forEach((row, i) => {
      const [before, after] = [frames[i], frames[i + 1]];
      const corner = minus(after.o, scaled(row.a, after.x));
      const radius = this.radius(i);
      const slides = row.kind === "prismatic";
      const rises = this.rods.between(2 * i, before.o, corner, slides ? 0.6 * radius : radius);
      const reaches = this.rods.between(2 * i + 1, corner, after.o, radius);
      const ends = [corner, after.o];
      const widths = [slides ? 0.6 : 1, i === this.arm.rows.length - 1 ? 0.8 : 1];
      ends.forEach((end, k) => {
        if (rises || reaches) this.balls.ball(2 * i + k, end, widths[k] * radius);
        else this.balls.hide(2 * i + k);
      });
      if (row.kind !== "fixed") this.joint(i, before, radius, slides);
    });
  }

  joint(i, { o, x, z }, radius, slides) {
    const half = scaled(slides ? 2.2 * radius : 1.45 * radius, z);
    const [from, to] = [minus(o, half), plus(o, half)];
    if (slides) this.boxes.between(i, from, to, 2 * radius, x);
    else this.barrels.between(i, from, to, 1.28 * radius);
  }

  // Links grow thinner towards the tip, and the last one is a pen.
  radius(i) {
    const n = this.arm.rows.length;
    return this.girth * (i === n - 1 ? 0.008 : 0.021 - (0.008 * i) / n);
  }
}

// An arrow from a point along a vector.
export class Arrow extends Group {
  constructor(material) {
    super();
    this.shaft = new Mesh(BARREL, material);
    this.head = new Mesh(POINT, material);
    this.add(this.shaft, this.head);
  }

  point(start, way, thickness) {
    const length = norm(way);
    this.visible = length > 1e-9;
    if (!this.visible) return;
    const neck = Math.max(0, length - 5 * thickness);
    along(this.shaft, start, plus(start, scaled(neck / length, way)), thickness);
    along(this.head, plus(start, scaled(neck / length, way)), plus(start, way), 2.4 * thickness);
  }
}

const AXES = { x: "#D55E00", y: "#009E73", z: "#0072B2" };
const AXES_DARK = { x: "#F58A3C", y: "#3CC79B", z: "#5AB4EC" };

// The three axes of each of some frames.
export class Triads extends Group {
  constructor(dark, count) {
    super();
    const colours = Object.values(dark ? AXES_DARK : AXES).map((colour) => new Color(colour));
    this.shafts = new Solids(BARREL, new MeshBasicMaterial(), 3 * count);
    this.heads = new Solids(POINT, new MeshBasicMaterial(), 3 * count);
    for (const solids of [this.shafts, this.heads]) solids.colour((i) => colours[i % 3]);
    this.add(this.shafts, this.heads);
  }

  /** @param {boolean[]} drawn which of the frames are */
  pose(frames, length, drawn) {
    const thickness = 0.022 * length;
    frames.forEach((frame, i) =>
      ["x", "y", "z"].forEach((axis, k) => {
        const [neck, tip] = [length - 5 * thickness, length].map((far) =>
          plus(frame.o, scaled(far, frame[axis])),
        );
        for (const [solids, from, to, radius] of [
          [this.shafts, frame.o, neck, thickness],
          [this.heads, neck, tip, 2.4 * thickness],
        ]) {
          if (drawn[i]) solids.between(3 * i + k, from, to, radius);
          else solids.hide(3 * i + k);
        }
      }),
    );
  }
}

// How fast the tip can go which way with joint rates of unit length.
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

  // Half axes `scale` times the singular values, and never too thin to be seen.
  pose(centre, { values, vectors }, scale, least) {
    const columns = vectors.map((v, i) => vector(scaled(Math.max(scale * values[i], least), v)));
    const [u, v, w] = columns;
    this.matrix.makeBasis(u, v, w).premultiply(new Matrix4().makeTranslation(vector(centre)));
  }
}

// A line through points, thick enough to be seen.
export function tube(points, radius, colour) {
  const gap = 1e-7;
  const apart = points.filter((p, i) => i === 0 || norm(minus(p, points[i - 1])) > gap);
  if (apart.length < 2) return new Group();
  const curve = new CatmullRomCurve3(apart.map(vector));
  return new Mesh(
    new TubeGeometry(curve, Math.min(400, apart.length * 2), radius, 8),
    new MeshBasicMaterial({ color: colour }),
  );
}

// A see-through square behind a flat path, or null where the path is not flat.
export function wall(points, material) {
  const n = points.length;
  const centre = scaled(1 / n, points.reduce(plus));
  const [p, q] = [points[0], points[Math.floor(n / 4)]].map((v) => vector(minus(v, centre)));
  const normal = p.clone().cross(q).normalize();
  const size = Math.max(...points.map((v) => norm(minus(v, centre))));
  const flat = points.every((v) => Math.abs(vector(minus(v, centre)).dot(normal)) < 0.02 * size);
  if (!(size > 1e-6 && normal.length() > 0.5 && flat)) return null;
  const mesh = square(3.4 * size, material);
  mesh.position.copy(vector(centre));
  const up = Math.abs(normal.z) > 0.9 ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1);
  mesh.quaternion.setFromRotationMatrix(new Matrix4().lookAt(normal, new Vector3(), up));
  return mesh;
}

// A floor of lines, a tenth of a metre or so apart, fading out.
export function floor(size, colour, strength) {
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
  return square(2 * size, material);
}

export function ghostMaterial(colour, opacity) {
  return new MeshStandardMaterial({
    color: colour,
    transparent: true,
    opacity,
    depthWrite: false,
    roughness: 0.7,
  });
}
