// The picture of the explorer; it redraws what changed in the state.

import { Color, DoubleSide, Group, MeshBasicMaterial, MeshStandardMaterial, Vector3 } from "three";
import { isOutsideLimits, estimateReach } from "../../judge/geometry/arm.js";
import { getFadingStrength } from "./dragging.js";
import {
  movingRows,
  linkFrames,
  minus,
  norm,
  plus,
  scaled,
} from "../../judge/geometry/kinematics.js";
import { getPlaneView } from "../../judge/geometry/task_rows.js";
import { AxisLabels } from "./labels.js";
import { isAtPose } from "./motion.js";
import { getBranchColour, PALETTES } from "./look.js";
import { findNearestSegment, getBarrelSegments, getLinkSegments } from "./picking.js";
import { disposeChildren, Figure, INITIAL_VIEW, removeAndDispose } from "./renderer.js";
import {
  placeRod,
  ArmShape,
  Arrow,
  makeBall,
  Ellipsoid,
  floor,
  makeGhostMaterial,
  makeRod,
  makeShadow,
  makeSquare,
  LINK_RADIUS,
  Triads,
  makeTube,
  makeWall,
} from "./shapes.js";
import { measureTipOffset } from "./state.js";
import { TipView } from "./tip_view.js";

const HALF_LENGTH_FORCE = 10; // N; a force of this size is drawn at half the largest length
const MAX_ARROW_SHARE = 0.36; // largest length of the force arrow as a share of the arm's reach

export class ArmPicture {
  constructor(host, labels, options = {}) {
    const onDraw = () => this.place();
    this.figure = new Figure(host, { ...options, onDraw, onResize: () => this.placeGrip() });
    this.labels = new AxisLabels(labels);
    this.options = options;
    /** @type {any} */
    this.world = null;
    this.arm = null;
    this.frames = null;
    /** @type {boolean[]} */
    this.drawn = []; // whether the axes of each frame are drawn
    this.first = options.first ?? 0; // number of the first frame
    this.tipView = new TipView(this);
    this.shown = /** @type {any} */ ({});
  }

  // Build everything that does not depend on the joint values.
  build(arm, dark) {
    const look = PALETTES[dark ? "dark" : "light"];
    if (this.world) removeAndDispose(this.world);
    this.arm = arm;
    this.dark = dark;
    this.look = look;
    this.size = estimateReach(arm);
    this.shown = {};
    this.tints = { highlight: new Color(look.highlight), bad: new Color(look.bad) };
    this.body = makeBody(arm, look);
    this.axis = makeRod(
      new MeshBasicMaterial({ color: look.highlight, transparent: true, opacity: 0.75 }),
    );
    this.triads = new Triads(dark, arm.rows.length + 1);
    this.barrier = makeBarrier(this.size, look);
    this.path = new Group();
    this.ghosts = new Group();
    this.reference = new Group();
    this.world = new Group();
    this.world.add(
      this.body,
      floor(this.size, look.grid, look.gridStrength),
      makeShadow(this.size, look),
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

  // Make the objects that show forces, directions and points.
  marks(look) {
    const force = new MeshBasicMaterial({ color: look.force });
    const bad = new MeshBasicMaterial({ color: look.bad });
    this.ellipsoid = new Ellipsoid(look.ellipsoid);
    this.force = new Arrow(force);
    this.handle = makeBall(force);
    this.handle.scale.setScalar(0.022 * this.size);
    this.spot = makeBall(bad);
    this.spot.scale.setScalar(0.014 * this.size);
    this.fading = new Group();
    for (let i = 0; i < 6; i++) this.fading.add(new Arrow(bad));
    return [this.ellipsoid, this.force, this.handle, this.spot, this.fading];
  }

  // Update the picture to the state; only what changed is rebuilt.
  draw(state, derived, theme) {
    const dark = theme === "dark";
    const [first, before] = [!this.body, this.arm];
    const other = before !== state.arm;
    this.tipView.beginMotion();
    if (other || this.dark !== dark) this.build(state.arm, dark);
    const { frames } = derived;
    this.frames = frames;
    this.body.pose(frames);
    this.tintJoints(state);
    this.drawAxis(frames[state.highlightedRow]);
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
    if (first || (other && this.tipView.needsFitAfter(before))) this.fit();
    this.figure.request();
  }

  tintJoints({ highlightedRow, q, arm }) {
    const past = movingRows(arm).filter((row, k) => isOutsideLimits(arm.rows[row], q[k]));
    const tinted = [highlightedRow, ...past].join();
    if (this.shown.tinted === tinted) return;
    this.shown.tinted = tinted;
    this.body.tint((row) =>
      row === highlightedRow ? this.tints.highlight : past.includes(row) ? this.tints.bad : null,
    );
  }

  // Draw the axis of the joint under the pointer.
  drawAxis(frame) {
    const half = frame ? scaled(0.16 * this.size, frame.z) : [0, 0, 0];
    const [start, end] = frame ? [minus(frame.o, half), plus(frame.o, half)] : [half, half];
    placeRod(this.axis, start, end, 0.0025 * this.size);
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
    const direction = size
      ? scaled((MAX_ARROW_SHARE * this.size) / (size + HALF_LENGTH_FORCE), force)
      : [0, 0, 0];
    this.force.point(minus(tip, direction), direction, 0.007 * this.size);
    this.force.visible &&= shown;
    this.handle.visible = shown;
    this.handle.position.fromArray(minus(tip, direction));
    this.tip = tip;
    if (shown && !this.shown.force) this.fit();
    this.shown.force = shown;
  }

  // Return the force whose arrow starts at a point.
  forceFrom(point) {
    const direction = minus(this.tip, point);
    const length = Math.min(
      norm(direction),
      MAX_ARROW_SHARE * this.size * (100 / (100 + HALF_LENGTH_FORCE)),
    );
    if (length < 0.015 * this.size) return [0, 0, 0];
    const size = (HALF_LENGTH_FORCE * length) / (MAX_ARROW_SHARE * this.size - length);
    return scaled(size / norm(direction), direction);
  }

  drawPath(state) {
    const { view, trace } = state;
    const path = ["trace", "torque", "homework"].includes(view) ? trace : null;
    const tipPaths = view === "homework" ? state.tipPaths : null;
    if (this.shown.path === path && this.shown.tipPaths === tipPaths) return;
    Object.assign(this.shown, { path, tipPaths });
    disposeChildren(this.path);
    if (path || tipPaths) this.path.add(...this.makeTipPaths(state, path, tipPaths));
  }

  // Make the tip's path, the paths of other runs in their colours, and the plane behind them.
  makeTipPaths({ arm, wantedPath }, path, tipPaths) {
    const { size, look } = this;
    const points = path?.map((q) => linkFrames(arm, q).at(-1).o) ?? tipPaths[0]?.points ?? [];
    const pieces = tipPaths
      ? tipPaths.map((one) => makeTube(one.points, 0.003 * size, one.colour))
      : [makeTube(points, 0.0035 * size, look.path)];
    if (wantedPath?.length > path?.length)
      pieces.push(makeTube(wantedPath, 0.0018 * size, look.wantedPath));
    const pane = makePaneMaterial(look.ghost, this.dark ? 0.16 : 0.1);
    if (points.length > 2) pieces.push(makeWall(wantedPath ?? points, pane));
    return pieces.filter(Boolean);
  }

  // Draw the other branches as thin arms; the one under the pointer is as thick as the arm.
  drawGhosts(state, derived) {
    const { view, branches, q, highlightedBranch } = state;
    const hidden = measureTipOffset(state, derived) && highlightedBranch === null;
    const shown = view === "branches" && !hidden ? branches : null;
    if (this.shown.branches !== shown) this.ghostArms(state.arm, shown);
    this.ghosts.children.forEach((/** @type {any} */ shape, i) => {
      shape.visible = !isAtPose(shown.list[i].q, q);
      shape.pose(shape.userData, i === highlightedBranch ? 0.97 : 0.3);
    });
  }

  ghostArms(arm, branches) {
    disposeChildren(this.ghosts);
    (branches?.list ?? []).forEach(({ q }, i) => {
      const material = new MeshStandardMaterial({ color: getBranchColour(i), roughness: 0.7 });
      const shape = new ArmShape(arm, { link: material, joint: material, ghost: true });
      shape.userData = linkFrames(arm, q);
      this.ghosts.add(shape);
    });
    this.shown.branches = branches;
    if (branches && !this.shown.fitted) this.fit();
    this.shown.fitted = Boolean(branches);
  }

  drawReference({ view, reference, q, arm }) {
    const differs = view === "table" && reference && reference !== arm;
    const shown = differs && movingRows(reference).length === q.length ? reference : null;
    if (this.shown.reference !== shown) {
      disposeChildren(this.reference);
      this.shown.reference = shown;
      if (shown) {
        const material = makeGhostMaterial(this.look.ghost, 0.26);
        this.reference.add(new ArmShape(shown, { link: material, joint: material, ghost: true }));
      }
    }
    if (shown) /** @type {any} */ (this.reference.children[0]).pose(linkFrames(shown, q));
  }

  // Draw arrows both ways along each direction that a dragged tip is losing; they grow as it is
  // lost.
  drawFading(tip, fading) {
    this.fading.children.forEach((/** @type {any} */ arrow, i) => {
      const lost = fading[Math.floor(i / 2)];
      const side = i % 2 ? -this.size : this.size;
      const vector = lost
        ? scaled(side * (0.04 + 0.1 * getFadingStrength(lost)), lost.direction)
        : [0, 0, 0];
      arrow.point(
        lost ? plus(tip, scaled(0.03 * side, lost.direction)) : tip,
        vector,
        0.004 * this.size,
      );
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
    const direction = new Vector3(...minus(hold.target, tip)).normalize();
    placeRod(barrier.rod, tip, hold.target, 0.002 * this.size);
    barrier.spot.position.set(...hold.target);
    barrier.wallPart.position.set(...plus(tip, scaled(0.006 * this.size, direction.toArray())));
    barrier.wallPart.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), direction);
  }

  // Fit the whole arm and the tips of its frames into the view.
  fit() {
    const reach = 0.13 * this.size;
    const ends = this.frames.flatMap(({ x, z, o }) => [
      o,
      ...[x, z].map((axis) => plus(o, scaled(reach, axis))),
    ]);
    const ghosts = (this.shown.branches?.list ?? []).flatMap(({ q }) =>
      linkFrames(this.arm, q).map((frame) => frame.o),
    );
    const seen = [this.handle, this.spot]
      .filter((one) => one.visible)
      .map((one) => one.position.toArray());
    const view = getPlaneView(this.arm);
    const above = view ? [] : [[0, 0, 0.3 * this.size]];
    this.figure.fit([...ends, ...ghosts, ...seen, [0, 0, 0], ...above], view ?? INITIAL_VIEW);
  }

  // Return the camera's axes in the world: right, up, and towards the viewer.
  cameraAxes() {
    return [0, 1, 2].map((i) =>
      new Vector3().setFromMatrixColumn(this.figure.camera.matrixWorld, i).toArray(),
    );
  }

  // Place labels and handles after each drawing.
  place() {
    const pixel = (point) => this.figure.pixel(point);
    const segments = [
      ...getLinkSegments(this.arm, this.frames),
      ...getBarrelSegments(this.arm, this.frames, this.size),
    ];
    const links = segments.map(({ from, to }) => ({ from: pixel(from), to: pixel(to) }));
    const thickness = this.figure.measurePixels(LINK_RADIUS * this.size, this.frames[0].o);
    this.labels.host.hidden = false;
    this.labels.place(pixel, this.figure, links, thickness);
    this.placeGrip();
    this.options.onDrawn?.();
  }

  // Place the tip's handle, before the first drawing too.
  placeGrip() {
    if (this.frames) this.options.onPlace?.(this.figure.pixel(this.frames.at(-1).o));
  }

  // Return the segments that can be grabbed: the links, and the x axes of drawn frames with the row
  // that carries each.
  grips() {
    const axes = this.frames.flatMap(({ o, x }, i) => {
      if (!this.drawn[i] || i === 0) return [];
      const [from, to] = [0.05, 0.1].map((share) => plus(o, scaled(share * this.size, x)));
      return [{ row: i - 1, from, to }];
    });
    return [...axes, ...getLinkSegments(this.arm, this.frames)];
  }

  // Return the point on the links nearest to a pixel, or null if none is within the distance.
  findLinkAt(pixel, within = 14, pieces = getLinkSegments(this.arm, this.frames)) {
    return findNearestSegment(pieces, pixel, within, (point) => this.figure.pixel(point));
  }

  // Return the index of the ghost under a pixel, or null.
  findBranchAt(pixel) {
    const gaps = this.ghosts.children.flatMap(({ visible, userData }, i) => {
      const hit = visible && this.findLinkAt(pixel, 7, getLinkSegments(this.arm, userData));
      return hit ? [{ i, gap: hit.gap }] : [];
    });
    return gaps.sort((p, q) => p.gap - q.gap)[0]?.i ?? null;
  }

  dispose() {
    this.tipView.dispose();
    this.labels.dispose();
    if (this.world) removeAndDispose(this.world);
    this.figure.dispose();
  }
}

function makeBody(arm, look) {
  const link = new MeshStandardMaterial({ color: look.link, roughness: 0.45, metalness: 0.02 });
  // white, because each joint sets its own colour
  const joint = new MeshStandardMaterial({ roughness: 0.4, metalness: 0.1 });
  return new ArmShape(arm, { link, joint, hue: new Color(look.joint) });
}

// Make the barrier between a dragged tip and the pointer: a wall, and a rod along the missing
// distance.
function makeBarrier(size, look) {
  const group = /** @type {any} */ (new Group());
  const ink = new MeshBasicMaterial({ color: look.bad });
  const wallPart = makeSquare(0.16 * size, makePaneMaterial(look.bad, 0.3));
  const [rod, spot] = [makeRod(ink), makeBall(ink)];
  spot.scale.setScalar(0.01 * size);
  Object.assign(group, { wallPart, rod, spot, visible: false });
  group.add(wallPart, rod, spot);
  return group;
}

const makePaneMaterial = (color, opacity) =>
  new MeshBasicMaterial({ color, transparent: true, opacity, side: DoubleSide, depthWrite: false });
