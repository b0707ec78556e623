// The explorer's picture: draws the state when it has changed.

import {
  Color,
  DoubleSide,
  Group,
  MeshBasicMaterial,
  MeshStandardMaterial,
  ShadowMaterial,
  Vector3,
} from "three";
import { isOutsideLimits, estimateReach } from "../../judge/geometry/arm.js";
import { goneness } from "./dragging.js";
import {
  movingRows,
  linkFrames,
  minus,
  norm,
  plus,
  scaled,
} from "../../judge/geometry/kinematics.js";
import { Labels } from "./labels.js";
import { isThere } from "./motion.js";
import { branchColour, LOOK } from "./look.js";
import { nearest, piecesOf } from "./picking.js";
import { emptied, Figure, freed } from "./renderer.js";
import {
  along,
  ArmShape,
  Arrow,
  ball,
  Ellipsoid,
  floor,
  ghostMaterial,
  rod,
  square,
  Triads,
  tube,
  wall,
} from "./shapes.js";
import { leftBehind } from "./state.js";

const FORCE_HALF = 10; // N: drawn half as long as the longest arrow,
const FORCE_LONGEST = 0.36; // which is this share of the arm

export class ArmPicture {
  constructor(host, labels, options = {}) {
    this.figure = new Figure(host, { onDraw: () => this.place(), onLost: options.onLost });
    this.labels = new Labels(labels);
    this.onPlace = options.onPlace ?? (() => {});
    /** @type {any} */
    this.world = null;
    this.arm = null;
    this.frames = null;
    /** @type {boolean[]} */
    this.drawn = []; // which frames have their axes drawn
    this.first = options.first ?? 0; // the number of the first of them
    this.shown = /** @type {any} */ ({});
  }

  // Build everything that does not move with the joints.
  build(arm, dark) {
    const look = LOOK[dark ? "dark" : "light"];
    if (this.world) freed(this.world);
    this.arm = arm;
    this.dark = dark;
    this.look = look;
    this.size = estimateReach(arm);
    this.shown = {};
    this.tints = { lit: new Color(look.lit), bad: new Color(look.bad) };
    this.body = bodyOf(arm, look);
    this.axis = rod(new MeshBasicMaterial({ color: look.lit, transparent: true, opacity: 0.75 }));
    this.triads = new Triads(dark, arm.rows.length + 1);
    this.barrier = barrierOf(this.size, look);
    this.path = new Group();
    this.ghosts = new Group();
    this.reference = new Group();
    this.world = new Group();
    this.world.add(
      this.body,
      floor(this.size, look.grid, look.gridStrength),
      shadeOf(this.size, look),
      this.triads,
      this.axis,
      ...this.marks(look),
      this.barrier,
      this.path,
      this.ghosts,
      this.reference,
    );
    this.figure.scene.add(this.world);
    this.figure.resetLights({ size: this.size, sky: look.sky, sun: look.sun });
  }

  // What shows forces, directions and places.
  marks(look) {
    const force = new MeshBasicMaterial({ color: look.force });
    const bad = new MeshBasicMaterial({ color: look.bad });
    this.ellipsoid = new Ellipsoid(look.ellipsoid);
    this.force = new Arrow(force);
    this.handle = ball(force);
    this.handle.scale.setScalar(0.022 * this.size);
    this.spot = ball(bad);
    this.spot.scale.setScalar(0.014 * this.size);
    this.fading = new Group();
    for (let i = 0; i < 6; i++) this.fading.add(new Arrow(bad));
    return [this.ellipsoid, this.force, this.handle, this.spot, this.fading];
  }

  // Bring the picture up to date with the state; only what changed is built anew.
  draw(state, derived, theme) {
    const dark = theme === "dark";
    const first = !this.body;
    const other = this.arm !== state.arm;
    if (other || this.dark !== dark) this.build(state.arm, dark);
    const { frames } = derived;
    this.frames = frames;
    this.body.pose(frames);
    this.tintJoints(state);
    this.drawAxis(frames[state.lit]);
    this.drawFrames(frames, state.frames);
    this.ellipsoid.visible = state.view === "jacobian";
    if (this.ellipsoid.visible) {
      const scale = (0.15 * this.size) / Math.max(derived.linear.values[0], 1e-6);
      this.ellipsoid.pose(frames.at(-1).o, derived.linear, scale, 0.003 * this.size);
    }
    this.drawForce(frames.at(-1).o, state);
    this.drawPath(state);
    this.drawGhosts(state, derived);
    this.drawReference(state);
    this.drawBarrier(frames.at(-1).o, state.hold);
    this.drawFading(frames.at(-1).o, state.hold?.fading ?? []);
    this.drawMark(state.mark);
    if (first) this.fit();
    this.figure.request();
  }

  tintJoints({ lit, q, arm }) {
    const past = movingRows(arm).filter((row, k) => isOutsideLimits(arm.rows[row], q[k]));
    const tinted = [lit, ...past].join();
    if (this.shown.tinted === tinted) return;
    this.shown.tinted = tinted;
    this.body.tint((row) =>
      row === lit ? this.tints.lit : past.includes(row) ? this.tints.bad : null,
    );
  }

  // The axis about or along which the joint under the reader's hand moves.
  drawAxis(frame) {
    const half = frame ? scaled(0.16 * this.size, frame.z) : [0, 0, 0];
    const [start, end] = frame ? [minus(frame.o, half), plus(frame.o, half)] : [half, half];
    along(this.axis, start, end, 0.0025 * this.size);
  }

  drawFrames(frames, which) {
    const length = 0.1 * this.size;
    const shared = new Map();
    this.drawn = frames.map((_, i) => which === "all" || i === 0 || i === frames.length - 1);
    this.triads.pose(frames, length, this.drawn);
    frames.forEach((frame, i) => {
      if (!this.drawn[i]) return;
      for (const axis of ["x", "z"]) {
        const tip = plus(frame.o, scaled(1.22 * length, frame[axis]));
        const key = axis + tip.map((v) => Math.round((v / this.size) * 500)).join();
        const indices = [...(shared.get(key)?.indices ?? []), i + this.first];
        shared.set(key, { tip, root: frame.o, letter: axis, index: indices.join(",") });
      }
    });
    this.labels.set([...shared.values()].reverse());
  }

  drawForce(tip, { view, wrench }) {
    const force = wrench.slice(0, 3);
    const shown = view === "torque";
    const size = norm(force);
    const way = size ? scaled((FORCE_LONGEST * this.size) / (size + FORCE_HALF), force) : [0, 0, 0];
    this.force.point(minus(tip, way), way, 0.007 * this.size);
    this.force.visible &&= shown;
    this.handle.visible = shown;
    this.handle.position.fromArray(minus(tip, way));
    this.tip = tip;
    if (shown && !this.shown.force) this.fit();
    this.shown.force = shown;
  }

  // The force whose arrow comes from a point.
  forceFrom(point) {
    const way = minus(this.tip, point);
    const length = Math.min(norm(way), FORCE_LONGEST * this.size * (100 / (100 + FORCE_HALF)));
    if (length < 0.015 * this.size) return [0, 0, 0];
    const size = (FORCE_HALF * length) / (FORCE_LONGEST * this.size - length);
    return scaled(size / norm(way), way);
  }

  drawPath(state) {
    const { view, trace } = state;
    const path = ["trace", "torque", "homework"].includes(view) ? trace : null;
    const paths = view === "homework" ? state.paths : null;
    if (this.shown.path === path && this.shown.paths === paths) return;
    Object.assign(this.shown, { path, paths });
    emptied(this.path);
    if (path || paths) this.path.add(...this.waysOfTip(state, path, paths));
  }

  // The way of the tip along a path, those of other runs in their colours, and their plane.
  waysOfTip({ arm, wanted }, path, paths) {
    const { size, look } = this;
    const points = path?.map((q) => linkFrames(arm, q).at(-1).o) ?? paths[0]?.points ?? [];
    const pieces = paths
      ? paths.map((one) => tube(one.points, 0.003 * size, one.colour))
      : [tube(points, 0.0035 * size, look.path)];
    if (wanted?.length > path?.length) pieces.push(tube(wanted, 0.0018 * size, look.wanted));
    const pane = paneOf(look.ghost, this.dark ? 0.16 : 0.1);
    if (points.length > 2) pieces.push(wall(wanted ?? points, pane));
    return pieces.filter(Boolean);
  }

  // The other ways as thin arms of one colour each; the one under the hand is as thick as the arm.
  drawGhosts(state, derived) {
    const { view, ways, q, highlighted } = state;
    const hidden = leftBehind(state, derived) && highlighted === null;
    const shown = view === "branches" && !hidden ? ways : null;
    if (this.shown.ways !== shown) this.ghostArms(state.arm, shown);
    this.ghosts.children.forEach((/** @type {any} */ shape, way) => {
      shape.visible = !isThere(shown.list[way].q, q);
      shape.pose(shape.userData, way === highlighted ? 0.97 : 0.3);
    });
  }

  ghostArms(arm, ways) {
    emptied(this.ghosts);
    (ways?.list ?? []).forEach(({ q }, i) => {
      const material = new MeshStandardMaterial({ color: branchColour(i), roughness: 0.7 });
      const shape = new ArmShape(arm, { link: material, joint: material, ghost: true });
      shape.userData = linkFrames(arm, q);
      this.ghosts.add(shape);
    });
    this.shown.ways = ways;
    if (ways && !this.shown.fitted) this.fit();
    this.shown.fitted = Boolean(ways);
  }

  drawReference({ view, reference, q, arm }) {
    const differs = view === "table" && reference && reference !== arm;
    const shown = differs && movingRows(reference).length === q.length ? reference : null;
    if (this.shown.reference !== shown) {
      emptied(this.reference);
      this.shown.reference = shown;
      if (shown) {
        const material = ghostMaterial(this.look.ghost, 0.26);
        this.reference.add(new ArmShape(shown, { link: material, joint: material, ghost: true }));
      }
    }
    if (shown) /** @type {any} */ (this.reference.children[0]).pose(linkFrames(shown, q));
  }

  // To and fro along each direction that a dragged tip is losing, the longer the more of it is
  // lost.
  drawFading(tip, fading) {
    this.fading.children.forEach((/** @type {any} */ arrow, i) => {
      const lost = fading[Math.floor(i / 2)];
      const side = i % 2 ? -this.size : this.size;
      const way = lost ? scaled(side * (0.04 + 0.1 * goneness(lost)), lost.way) : [0, 0, 0];
      arrow.point(lost ? plus(tip, scaled(0.03 * side, lost.way)) : tip, way, 0.004 * this.size);
    });
  }

  drawMark(mark) {
    this.spot.visible = Boolean(mark);
    if (this.shown.mark === mark) return;
    this.shown.mark = mark;
    if (mark) this.spot.position.fromArray(mark);
    if (mark) this.fit();
  }

  drawBarrier(tip, hold) {
    const short = hold?.target ? norm(minus(hold.target, tip)) : 0;
    const { barrier } = this;
    barrier.visible = short > 0.004 * this.size && !hold.moving;
    if (!barrier.visible) return;
    const way = new Vector3(...minus(hold.target, tip)).normalize();
    along(barrier.way, tip, hold.target, 0.002 * this.size);
    barrier.spot.position.set(...hold.target);
    barrier.wallPart.position.set(...plus(tip, scaled(0.006 * this.size, way.toArray())));
    barrier.wallPart.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), way);
  }

  // Stand where the whole arm is in view, with the tips of its frames.
  fit() {
    const reach = 0.13 * this.size;
    const ends = this.frames.flatMap(({ x, z, o }) => [
      o,
      ...[x, z].map((axis) => plus(o, scaled(reach, axis))),
    ]);
    const ghosts = (this.shown.ways?.list ?? []).flatMap(({ q }) =>
      linkFrames(this.arm, q).map((frame) => frame.o),
    );
    const seen = [this.handle, this.spot]
      .filter((one) => one.visible)
      .map((one) => one.position.toArray());
    this.figure.fit([...ends, ...ghosts, ...seen, [0, 0, 0], [0, 0, 0.3 * this.size]]);
  }

  // The picture's axes in the world: right, up, and towards the eye.
  cameraAxes() {
    return [0, 1, 2].map((i) =>
      new Vector3().setFromMatrixColumn(this.figure.camera.matrixWorld, i).toArray(),
    );
  }

  // Labels and handles, after each drawing.
  place() {
    const { width, height } = this.figure;
    this.labels.host.hidden = false;
    this.labels.place((p) => this.figure.pixel(p), width, height);
    if (this.frames) this.onPlace(this.figure.pixel(this.frames.at(-1).o));
  }

  // What can be taken by the hand: the links, and the x axes of the frames drawn, each with the row
  // that carries it.
  grips() {
    const axes = this.frames.flatMap(({ o, x }, i) => {
      if (!this.drawn[i] || i === 0) return [];
      const [from, to] = [0.05, 0.1].map((share) => plus(o, scaled(share * this.size, x)));
      return [{ row: i - 1, from, to }];
    });
    return [...axes, ...piecesOf(this.arm, this.frames)];
  }

  // The place on the links nearest to a pixel, within `within` pixels, or null.
  linkAt(pixel, within = 14, pieces = piecesOf(this.arm, this.frames)) {
    return nearest(pieces, pixel, within, (point) => this.figure.pixel(point));
  }

  // The ghost of another way under a pixel, by its number, or null.
  wayAt(pixel) {
    const gaps = this.ghosts.children.flatMap(({ visible, userData }, way) => {
      const hit = visible && this.linkAt(pixel, 7, piecesOf(this.arm, userData));
      return hit ? [{ way, gap: hit.gap }] : [];
    });
    return gaps.sort((p, q) => p.gap - q.gap)[0]?.way ?? null;
  }

  dispose() {
    this.labels.dispose();
    if (this.world) freed(this.world);
    this.figure.dispose();
  }
}

function bodyOf(arm, look) {
  const link = new MeshStandardMaterial({ color: look.link, roughness: 0.45, metalness: 0.02 });
  // white: each joint has its colour
  const joint = new MeshStandardMaterial({ roughness: 0.4, metalness: 0.1 });
  return new ArmShape(arm, { link, joint, hue: new Color(look.joint) });
}

function shadeOf(size, look) {
  const shade = square(4 * size, new ShadowMaterial({ opacity: look.shadow }));
  shade.receiveShadow = true;
  shade.position.z = -0.001 * size;
  return shade;
}

// What stands between a dragged tip and the pointer: a wall across the way, and the way that is
// missing.
function barrierOf(size, look) {
  const group = /** @type {any} */ (new Group());
  const ink = new MeshBasicMaterial({ color: look.bad });
  const wallPart = square(0.16 * size, paneOf(look.bad, 0.3));
  const [way, spot] = [rod(ink), ball(ink)];
  spot.scale.setScalar(0.01 * size);
  Object.assign(group, { wallPart, way, spot, visible: false });
  group.add(wallPart, way, spot);
  return group;
}

const paneOf = (color, opacity) =>
  new MeshBasicMaterial({ color, transparent: true, opacity, side: DoubleSide, depthWrite: false });
