// The picture of the explorer. It redraws the parts whose state changed.

import { Color, Group, MeshBasicMaterial, MeshStandardMaterial, Vector3 } from "three";
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
import { Barrier } from "./barrier.js";
import { ComparedArrows } from "./compared_arrows.js";
import { AxisLabels } from "./labels.js";
import { isAtBranch } from "./motion.js";
import { getBranchColour, PALETTES } from "./look.js";
import { findNearestSegment, getBarrelSegments, getLinkSegments } from "./picking.js";
import { disposeChildren, Figure, INITIAL_VIEW, removeAndDispose } from "./renderer.js";
import {
  placeRod,
  ArmShape,
  Arrow,
  makeBall,
  Ellipsoid,
  makeFloor,
  makeGhostMaterial,
  makeRod,
  makeShadow,
  LINK_RADIUS,
  Triads,
} from "./shapes.js";
import { measureTipOffset } from "./state.js";
import { makeTipPaths } from "./tip_paths.js";

const HALF_LENGTH_FORCE = 10; // N; a force of this size is drawn at half the largest length
const MAX_ARROW_SHARE = 0.36; // largest length of the force arrow as a share of the arm's reach

export class ArmPicture {
  constructor(host, labels, options) {
    const onDraw = () => this.placeOverlays();
    this.figure = new Figure(host, { ...options, onDraw, onResize: () => this.placeGrip() });
    this.labels = new AxisLabels(labels);
    this.options = options;
    /** @type {any} */
    this.world = null;
    this.arm = null;
    this.frames = null;
    /** @type {boolean[]} */
    this.hasDrawnAxes = []; // for each frame
    this.lastDrawn = /** @type {any} */ ({}); // the state that the parts were last drawn from
    this.pathLabels = []; // of the axes of a drawn circle
  }

  // Build the objects that do not depend on the joint values.
  buildWorld(arm, dark) {
    const look = PALETTES[dark ? "dark" : "light"];
    if (this.world) removeAndDispose(this.world);
    this.arm = arm;
    this.dark = dark;
    this.look = look;
    this.size = estimateReach(arm);
    this.lastDrawn = {};
    this.tints = { highlight: new Color(look.highlight), bad: new Color(look.bad) };
    this.body = makeBody(arm, look);
    this.jointAxis = makeRod(
      new MeshBasicMaterial({ color: look.highlight, transparent: true, opacity: 0.75 }),
    );
    this.triads = new Triads(dark, arm.rows.length + 1);
    this.barrier = new Barrier(this.size, look);
    this.pathGroup = new Group();
    this.ghostGroup = new Group();
    this.referenceGroup = new Group();
    this.world = new Group();
    this.world.add(
      this.body,
      makeFloor(this.size, look.grid, look.gridStrength),
      makeShadow(this.size, look),
      this.triads,
      this.jointAxis,
      ...this.makeMarkers(look),
      this.barrier,
      this.pathGroup,
      this.ghostGroup,
      this.referenceGroup,
    );
    this.figure.scene.add(this.world);
    this.figure.setLights(this.size, look);
  }

  // Make the objects that show forces, directions and points.
  makeMarkers(look) {
    const force = new MeshBasicMaterial({ color: look.force });
    const bad = new MeshBasicMaterial({ color: look.bad });
    this.ellipsoid = new Ellipsoid(look.ellipsoid);
    this.forceArrow = new Arrow(force);
    this.forceBall = makeBall(force);
    this.forceBall.scale.setScalar(0.022 * this.size);
    this.comparedArrows = new ComparedArrows(force, bad);
    this.pointMarker = makeBall(bad);
    this.pointMarker.scale.setScalar(0.014 * this.size);
    this.fadingArrows = new Group();
    for (let i = 0; i < 6; i++) this.fadingArrows.add(new Arrow(bad));
    return [
      this.ellipsoid,
      this.forceArrow,
      this.forceBall,
      this.pointMarker,
      this.fadingArrows,
      this.comparedArrows,
    ];
  }

  // Update the picture to the state. Only changed parts are rebuilt.
  draw(state, derived, theme) {
    const dark = theme === "dark";
    const [isFirst, previousArm] = [!this.body, this.arm];
    const isNewArm = previousArm !== state.arm;
    const wasTipInView = this.frames && this.figure.isInView(this.frames.at(-1).o);
    if (isNewArm || this.dark !== dark) this.buildWorld(state.arm, dark);
    const { frames } = derived;
    const tip = frames.at(-1).o;
    this.frames = frames;
    this.body.placeAtFrames(frames);
    this.tintJoints(state);
    this.drawAxis(frames[state.highlightedRow]);
    this.ellipsoid.visible = state.view === "jacobian";
    if (this.ellipsoid.visible) {
      const scale = (0.15 * this.size) / Math.max(derived.linearAxes.values[0], 1e-6);
      this.ellipsoid.placeAt(tip, derived.linearAxes, scale, 0.003 * this.size);
    }
    this.drawComparison(tip, state, derived.columns);
    this.drawForce(tip, state);
    this.drawPath(state);
    this.drawFrames(frames, state.frames);
    this.drawGhosts(state, derived);
    this.drawReference(state);
    this.drawBarrier(tip, state.tipHold);
    this.drawFading(tip, state.tipHold?.fading ?? []);
    this.drawMark(state.mark);
    const hasOtherJoints =
      isNewArm && movingRows(previousArm ?? state.arm).length !== movingRows(state.arm).length;
    if (isFirst || hasOtherJoints || (isNewArm && !wasTipInView)) this.fitView();
    else if (wasTipInView) this.figure.widenView(tip);
    this.figure.requestDrawing();
  }

  tintJoints({ highlightedRow, q, arm }) {
    const past = movingRows(arm).filter((row, k) => isOutsideLimits(arm.rows[row], q[k]));
    const tinted = [highlightedRow, ...past].join();
    if (this.lastDrawn.tinted === tinted) return;
    this.lastDrawn.tinted = tinted;
    this.body.tintJoints((row) =>
      row === highlightedRow ? this.tints.highlight : past.includes(row) ? this.tints.bad : null,
    );
  }

  // Draw the axis of the joint under the pointer.
  drawAxis(frame) {
    const half = frame ? scaled(0.16 * this.size, frame.z) : [0, 0, 0];
    const [start, end] = frame ? [minus(frame.o, half), plus(frame.o, half)] : [half, half];
    placeRod(this.jointAxis, start, end, 0.0025 * this.size);
  }

  drawFrames(frames, choice) {
    const length = 0.1 * this.size;
    const labels = new Map();
    this.hasDrawnAxes = frames.map(
      (_, i) => choice === "all" || i === 0 || i === frames.length - 1,
    );
    this.triads.placeAtFrames(frames, length, this.hasDrawnAxes);
    frames.forEach((frame, i) => {
      if (!this.hasDrawnAxes[i]) return;
      for (const axis of ["x", "z"]) {
        const end = plus(frame.o, scaled(1.22 * length, frame[axis]));
        const key = axis + end.map((v) => Math.round((v / this.size) * 500)).join();
        const indices = [...(labels.get(key)?.indices ?? []), i + this.options.firstFrame];
        labels.set(key, { end, letter: axis, index: indices.join(",") });
      }
    });
    this.labels.setLabels([...this.pathLabels, ...[...labels.values()].reverse()]);
  }

  drawComparison(tip, state, columns) {
    this.comparedEnds = this.comparedArrows.place(tip, state, columns, this.size);
    const isShown = this.comparedEnds.length > 0;
    if (isShown && !this.lastDrawn.compared) this.fitView();
    this.lastDrawn.compared = isShown;
  }

  drawForce(tip, { view, wrench }) {
    const force = wrench.slice(0, 3);
    const isShown = view === "torque";
    const size = norm(force);
    const direction = size
      ? scaled((MAX_ARROW_SHARE * this.size) / (size + HALF_LENGTH_FORCE), force)
      : [0, 0, 0];
    this.forceArrow.placeAlong(minus(tip, direction), direction, 0.007 * this.size);
    this.forceArrow.visible &&= isShown;
    this.forceBall.visible = isShown;
    this.forceBall.position.fromArray(minus(tip, direction));
    this.tip = tip;
    if (isShown && !this.lastDrawn.force) this.fitView();
    this.lastDrawn.force = isShown;
  }

  // Return the force whose arrow starts at a point.
  computeForceFrom(point) {
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
    if (this.lastDrawn.path === path && this.lastDrawn.tipPaths === tipPaths) return;
    Object.assign(this.lastDrawn, { path, tipPaths });
    disposeChildren(this.pathGroup);
    this.pathLabels = [];
    if (!path && !tipPaths?.length) return;
    const { parts, labels } = makeTipPaths({ ...state, trace: path, tipPaths }, this);
    this.pathGroup.add(...parts);
    this.pathLabels = labels;
  }

  // Draw the solution branches as thin arms. The branch under the pointer is as thick as the arm.
  drawGhosts(state, derived) {
    const { view, branches, q, highlightedBranch } = state;
    const hasMovedAway = measureTipOffset(state, derived) && highlightedBranch === null;
    const shownBranches = view === "branches" && !hasMovedAway ? branches : null;
    if (this.lastDrawn.branches !== shownBranches) this.makeGhosts(state.arm, shownBranches);
    this.ghostGroup.children.forEach((/** @type {any} */ shape, i) => {
      shape.visible = !isAtBranch(state.arm, shownBranches.list[i].q, q);
      shape.placeAtFrames(shape.userData, i === highlightedBranch ? 0.97 : 0.3);
    });
  }

  makeGhosts(arm, branches) {
    disposeChildren(this.ghostGroup);
    (branches?.list ?? []).forEach(({ q }, i) => {
      const material = new MeshStandardMaterial({ color: getBranchColour(i), roughness: 0.7 });
      const shape = new ArmShape(arm, { link: material, joint: material, ghost: true });
      shape.userData = linkFrames(arm, q);
      this.ghostGroup.add(shape);
    });
    this.lastDrawn.branches = branches;
    if (branches && !this.lastDrawn.hasBranches) this.fitView();
    this.lastDrawn.hasBranches = Boolean(branches);
  }

  drawReference({ view, reference, q, arm }) {
    const differs = view === "table" && reference && reference !== arm;
    const shown = differs && movingRows(reference).length === q.length ? reference : null;
    if (this.lastDrawn.reference !== shown) {
      disposeChildren(this.referenceGroup);
      this.lastDrawn.reference = shown;
      if (shown) {
        const material = makeGhostMaterial(this.look.ghost);
        this.referenceGroup.add(
          new ArmShape(shown, { link: material, joint: material, ghost: true }),
        );
      }
    }
    if (!shown) return;
    const shape = /** @type {any} */ (this.referenceGroup.children[0]);
    // Its width is that of the arm, which would not hide a ghost of longer reach.
    shape.placeAtFrames(linkFrames(shown, q), (0.97 * this.size) / shape.size);
  }

  // Draw arrows both ways along each direction that a dragged tip is losing; they grow as it is
  // lost.
  drawFading(tip, fading) {
    this.fadingArrows.children.forEach((/** @type {any} */ arrow, i) => {
      const lost = fading[Math.floor(i / 2)];
      const side = i % 2 ? -this.size : this.size;
      const vector = lost
        ? scaled(side * (0.04 + 0.1 * getFadingStrength(lost)), lost.direction)
        : [0, 0, 0];
      arrow.placeAlong(
        lost ? plus(tip, scaled(0.03 * side, lost.direction)) : tip,
        vector,
        0.004 * this.size,
      );
    });
  }

  drawMark(mark) {
    this.pointMarker.visible = Boolean(mark);
    if (this.lastDrawn.mark === mark) return;
    this.lastDrawn.mark = mark;
    if (mark) this.pointMarker.position.fromArray(mark);
    if (mark) this.fitView();
  }

  drawBarrier(tip, tipHold) {
    const distance = tipHold?.target ? norm(minus(tipHold.target, tip)) : 0;
    const isStopped = distance > 0.004 * this.size && !tipHold.moving;
    this.barrier.visible = isStopped;
    if (isStopped) this.barrier.placeBetween(tip, tipHold.target);
  }

  // Fit the whole arm and the tips of its frames into the view.
  fitView() {
    const reach = 0.13 * this.size;
    const ends = this.frames.flatMap(({ x, z, o }) => [
      o,
      ...[x, z].map((axis) => plus(o, scaled(reach, axis))),
    ]);
    const ghosts = (this.lastDrawn.branches?.list ?? []).flatMap(({ q }) =>
      linkFrames(this.arm, q).map((frame) => frame.o),
    );
    const markers = [this.forceBall, this.pointMarker]
      .filter(({ visible }) => visible)
      .map(({ position }) => position.toArray());
    const view = getPlaneView(this.arm);
    const above = view ? [] : [[0, 0, 0.3 * this.size]];
    this.figure.fitView(
      [...ends, ...ghosts, ...markers, ...this.comparedEnds, [0, 0, 0], ...above],
      view ?? INITIAL_VIEW,
    );
  }

  // Return the camera's axes in the world: right, up, and towards the viewer.
  getCameraAxes() {
    return [0, 1, 2].map((i) =>
      new Vector3().setFromMatrixColumn(this.figure.camera.matrixWorld, i).toArray(),
    );
  }

  // Place the labels and the tip's handle after each drawing.
  placeOverlays() {
    const toPixel = (point) => this.figure.projectToPixel(point);
    const segments = [
      ...getLinkSegments(this.arm, this.frames),
      ...getBarrelSegments(this.arm, this.frames, this.size),
    ];
    const links = segments.map(({ from, to }) => ({ from: toPixel(from), to: toPixel(to) }));
    const radius = this.figure.measurePixels(LINK_RADIUS * this.size, this.frames[0].o);
    this.labels.host.hidden = false;
    this.labels.placeLabels(toPixel, this.figure, links, radius);
    this.placeGrip();
    this.options.onDrawn();
  }

  // Place the tip's handle, before the first drawing too.
  placeGrip() {
    if (this.frames) this.options.onPlace(this.figure.projectToPixel(this.frames.at(-1).o));
  }

  // Return the segments that can be grabbed with their rows: links and drawn x axes.
  listGrabbableSegments() {
    const axes = this.frames.flatMap(({ o, x }, i) => {
      if (!this.hasDrawnAxes[i] || i === 0) return [];
      const [from, to] = [0.05, 0.1].map((share) => plus(o, scaled(share * this.size, x)));
      return [{ row: i - 1, from, to }];
    });
    return [...axes, ...getLinkSegments(this.arm, this.frames)];
  }

  // Return the point on the links nearest to a pixel, or null if none is within the distance.
  findLinkAt(pixel, within = 14, segments = getLinkSegments(this.arm, this.frames)) {
    return findNearestSegment(segments, pixel, within, (point) =>
      this.figure.projectToPixel(point),
    );
  }

  // Return the index of the ghost under a pixel, or null.
  findBranchAt(pixel) {
    const gaps = this.ghostGroup.children.flatMap(({ visible, userData }, i) => {
      const hit = visible && this.findLinkAt(pixel, 7, getLinkSegments(this.arm, userData));
      return hit ? [{ i, gap: hit.gap }] : [];
    });
    return gaps.sort((p, q) => p.gap - q.gap)[0]?.i ?? null;
  }

  dispose() {
    this.labels.dispose();
    if (this.world) removeAndDispose(this.world);
    this.figure.dispose();
  }
}

function makeBody(arm, look) {
  const link = new MeshStandardMaterial({ color: look.link, roughness: 0.45, metalness: 0.02 });
  // white, because each joint sets its own colour
  const joint = new MeshStandardMaterial({ roughness: 0.4, metalness: 0.1 });
  return new ArmShape(arm, { link, joint, jointColour: new Color(look.joint) });
}
