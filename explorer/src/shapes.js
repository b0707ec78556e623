// The solids of which the 3D view is made.

import {
  Color,
  ConeGeometry,
  CylinderGeometry,
  DoubleSide,
  Group,
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
import { reachOf } from "./arm.js";
import { minus, norm, plus, scaled } from "./kinematics.js";

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

export const paint = (colour) => new MeshBasicMaterial({ color: colour });
export const ball = (material) => new Mesh(BALL, material);
export const rod = (material) => new Mesh(BARREL, material);

// A square of this size (m), facing z.
export function square(size, material) {
  const mesh = new Mesh(SQUARE, material);
  mesh.scale.setScalar(size);
  return mesh;
}

const vector = (v) => new Vector3().fromArray(v);

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

function at(mesh, point, radius) {
  mesh.position.fromArray(point);
  mesh.scale.setScalar(radius);
}

// An arm as capsules along d and a of each row, with a barrel where a joint turns and a box where it slides.
export class ArmShape extends Group {
  constructor(arm, { link, joint, ghost = false, girth = ghost ? 0.97 : 1 }) {
    super();
    this.arm = arm;
    this.size = reachOf(arm);
    this.girth = girth * this.size; // a ghost hides inside the arm where both are
    const add = (geometry, material) => {
      const mesh = new Mesh(geometry, material);
      mesh.castShadow = mesh.receiveShadow = !ghost;
      this.add(mesh);
      return mesh;
    };
    this.parts = arm.rows.map((row) => ({
      rise: add(ROD, link),
      bend: add(BALL, link),
      reach: add(ROD, link),
      end: add(BALL, link),
      joint: row.kind === "fixed" ? null : add(row.kind === "prismatic" ? BOX : BARREL, joint),
    }));
    this.pedestal = add(BARREL, joint);
    this.pedestal.scale.setScalar(0);
    this.stands = !ghost;
    this.joint = joint;
  }

  // Joints in the material that `pick` gives for their row, or in their own.
  tint(pick) {
    this.parts.forEach((part, i) => part.joint && (part.joint.material = pick(i) ?? this.joint));
  }

  pose(frames) {
    const { arm, size, parts } = this;
    parts.forEach((part, i) => {
      const [before, after] = [frames[i], frames[i + 1]];
      const corner = minus(after.o, scaled(arm.rows[i].a, after.x));
      const radius = this.radius(i);
      const slides = arm.rows[i].kind === "prismatic";
      along(part.rise, before.o, corner, slides ? 0.6 * radius : radius);
      along(part.reach, corner, after.o, radius);
      at(part.bend, corner, slides ? 0.6 * radius : radius);
      at(part.end, after.o, i === parts.length - 1 ? 0.8 * radius : radius);
      part.end.visible = part.bend.visible = part.rise.visible || part.reach.visible;
      if (part.joint) this.barrel(part.joint, before, radius, slides);
    });
    if (this.stands) along(this.pedestal, [0, 0, -0.004 * size], [0, 0, 0.012 * size], 0.05 * size);
  }

  barrel(mesh, { o, z }, radius, slides) {
    const half = scaled(slides ? 2.2 * radius : 1.45 * radius, z);
    along(mesh, minus(o, half), plus(o, half), slides ? 2 * radius : 1.28 * radius);
  }

  // Links grow thinner towards the tip, and the last one is a pen.
  radius(i) {
    const n = this.parts.length;
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

export const AXES = { x: "#D55E00", y: "#009E73", z: "#0072B2" };
const AXES_DARK = { x: "#F58A3C", y: "#3CC79B", z: "#5AB4EC" };

// The three axes of a frame.
export class Triad extends Group {
  constructor(dark) {
    super();
    const colours = dark ? AXES_DARK : AXES;
    this.arrows = ["x", "y", "z"].map((axis) => new Arrow(new MeshBasicMaterial({ color: colours[axis] })));
    this.add(...this.arrows);
  }

  pose(frame, length) {
    ["x", "y", "z"].forEach((axis, i) =>
      this.arrows[i].point(frame.o, scaled(length, frame[axis]), 0.022 * length),
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
      varying vec2 p; uniform vec3 colour; uniform float size; uniform float step; uniform float strength;
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
