// Handles pointers on the picture. A dragged link turns its joint, the arm follows a dragged tip,
// the ball at the tip sets the force, and any other drag turns the view. Each drawn frame solves
// once, however often the pointer moves.

import {
  cross,
  jacobianColumns,
  movingRows,
  linkFrames,
  minus,
  norm,
  pointInFrame,
} from "../../judge/geometry/kinematics.js";
import { movableLinearRows } from "../../judge/geometry/task_rows.js";
import { runBeforeDrawing, cancelStep } from "./renderer.js";
import {
  dragLink,
  dragTip,
  findFadingDirections,
  swingElbow,
  findStopReasons,
} from "./dragging.js";

const FORCE_BALL_RADIUS = 22; // px
const GRAB_RADIUS = { mouse: 11, touch: 20, pen: 16 }; // px, by type of pointer
const CLICK_TOLERANCE = 4; // px that the pointer may move during a click

let dragCount = 0;

/**
 * Let the reader grab the arm in a picture.
 * @param {import("./scene.js").ArmPicture} picture
 * @param {import("./state.js").Store} store
 * @param {{ grip: HTMLElement, goTo: (q: number[]) => void }} tools
 */
export function enableGrabbing(picture, store, { grip, goTo }) {
  const grabber = new Grabber(picture, store, goTo);
  const { figure } = picture;
  const { canvas } = figure;
  const handleDown = (event) => grabber.handlePointerDown(event);
  figure.addListener(canvas, "pointerdown", handleDown, { capture: true });
  figure.addListener(grip, "pointerdown", (event) => {
    if (!event.button) grabber.startDrag(event, { kind: "tip" });
  });
  for (const target of [canvas, grip]) {
    figure.addListener(target, "pointermove", (event) => grabber.handlePointerMove(event));
    figure.addListener(target, "pointerup", (event) => grabber.handlePointerUp(event));
    figure.addListener(target, "pointercancel", (event) => grabber.handlePointerUp(event));
  }
  figure.addListener(canvas, "pointerleave", () => grabber.drag || grabber.highlightPart(null));
  // A touch on a part that can be grabbed drags it in every direction; elsewhere a touch may scroll
  // the page.
  const handleTouch = (event) => {
    const [{ clientX, clientY }] = event.touches;
    const isSingle = event.touches.length === 1;
    if (isSingle && grabber.findPartUnder({ clientX, clientY, pointerType: "touch" }))
      event.preventDefault();
  };
  figure.addListener(canvas, "touchstart", handleTouch, { passive: false });
  figure.signal.addEventListener("abort", () => cancelStep(grabber.step));
}

/**
 * A part of the picture under the pointer. A branch can be clicked, the others can be dragged.
 * @typedef {object} Part
 * @property {"force" | "branch" | "link" | "elbow" | "tip"} kind
 * @property {number} [branch] index of a branch
 * @property {number} [row] of a grabbed link or elbow
 * @property {number[]} [local] grabbed point, in the frame of its row
 * @property {number} [highlightedRow] row of the joint that a grabbed link turns
 */
/**
 * @typedef {object} DragState
 * @property {number} id of the pointer
 * @property {PointerEvent} event the latest one
 * @property {[number, number]} [pixel] position in the picture of what the pointer drags
 * @property {number[]} offset in pixels from the pointer to that position, because the view has
 *   followed the tip
 * @property {string} gesture name of the undo step
 * @property {number[]} rest joint values when the drag began
 * @property {import("./state.js").Frame} tip pose of the tip when the drag began
 * @property {number[]} [from] point at the tip's depth where the drag of the tip began
 */

/** Holds the part that the pointer has grabbed, and computes each frame of the drag. */
class Grabber {
  /**
   * @param {import("./scene.js").ArmPicture} picture
   * @param {import("./state.js").Store} store
   * @param {(q: number[]) => void} goTo
   */
  constructor(picture, store, goTo) {
    this.picture = picture;
    this.figure = picture.figure;
    this.store = store;
    this.goTo = goTo;
    /** @type {(Part & DragState) | null} */
    this.drag = null;
    /** @type {{ x: number, y: number, part: Part | null } | null} position and part of a press */
    this.press = null;
    this.step = () => {
      if (this.drag && !this.dragOneFrame()) runBeforeDrawing(this.step);
    };
  }

  isOnForceBall(pixel) {
    const { forceBall } = this.picture;
    if (!forceBall?.visible) return false;
    const [x, y] = this.figure.projectToPixel(forceBall.position.toArray());
    return Math.hypot(x - pixel[0], y - pixel[1]) < FORCE_BALL_RADIUS;
  }

  /**
   * Return the part that the pointer would grab or click, or null.
   * @param {Pick<PointerEvent, "clientX" | "clientY" | "pointerType">} event
   * @returns {Part | null}
   */
  findPartUnder(event) {
    const { picture, store } = this;
    const pixel = this.figure.getPointerPixel(event);
    const { state, derived } = store;
    if (this.isOnForceBall(pixel)) return { kind: "force" };
    const branch = state.view === "branches" ? picture.findBranchAt(pixel) : null;
    if (branch !== null) return { kind: "branch", branch };
    const radius = GRAB_RADIUS[event.pointerType] ?? GRAB_RADIUS.touch;
    const hit = picture.findLinkAt(pixel, radius, picture.listGrabbableSegments());
    if (!hit) return null;
    const { frames } = derived;
    const grabbed = { row: hit.row, local: pointInFrame(frames[hit.row + 1], hit.point) };
    if (state.tipHold?.pinned) return { kind: "elbow", ...grabbed };
    const row = findTurningRow(state.arm, frames, hit, 0.02 * picture.size);
    return row === null ? null : { kind: "link", highlightedRow: row, ...grabbed };
  }

  handlePointerDown(event) {
    if (event.button) return;
    const part = this.findPartUnder(event);
    this.press = { x: event.clientX, y: event.clientY, part };
    if (!part || part.kind === "branch") return;
    event.stopImmediatePropagation(); // keeps the view from turning
    this.startDrag(event, part);
  }

  /**
   * @param {PointerEvent & { target: HTMLElement }} event
   * @param {Part} part
   */
  startDrag(event, part) {
    const { figure, store } = this;
    const tip = store.derived.frames.at(-1);
    this.drag = {
      ...part,
      id: event.pointerId,
      event,
      offset: [0, 0],
      gesture: `drag ${++dragCount}`,
      rest: store.state.q,
      tip,
    };
    if (part.kind === "tip")
      this.drag.from = figure.projectToFacingPlane(figure.getPointerPixel(event), tip.o);
    event.target.setPointerCapture(event.pointerId);
    const { highlightedRow } = part;
    const highlight = highlightedRow === undefined ? {} : { highlightedRow };
    store.dispatch({ type: "setFields", dragging: true, ...highlight });
    figure.canvas.classList.add("held");
  }

  // Make one frame of the drag. Returns false if another frame is needed although the pointer
  // rests.
  dragOneFrame() {
    const { drag, figure } = this;
    const [x, y] = figure.getPointerPixel(drag.event);
    drag.pixel = [x + drag.offset[0], y + drag.offset[1]];
    const point = figure.projectToFacingPlane(drag.pixel, drag.tip.o);
    const isDone = this.dragPart();
    // A view that follows the tip must not move what the pointer holds.
    const [u, v] = point ? figure.projectToPixel(point) : drag.pixel;
    drag.offset = [u - x, v - y];
    return isDone;
  }

  // Drag the held part to the pointer. Returns false if another frame is needed.
  dragPart() {
    const { drag, store } = this;
    if (drag.kind === "tip") return this.dragTip(store.state);
    if (drag.kind === "force") this.dragForce();
    if (drag.kind === "link") this.dragLink(store.state);
    if (drag.kind === "elbow") this.dragElbow(store.state);
    return true;
  }

  dragForce() {
    const { picture, figure, store, drag } = this;
    const point = figure.projectToFacingPlane(drag.pixel, picture.forceBall.position.toArray());
    const wrench = point && [...picture.computeForceFrom(point), ...store.state.wrench.slice(3)];
    if (wrench) store.dispatch({ type: "setWrench", wrench, gesture: drag.gesture });
  }

  dragLink({ arm, q }) {
    const { row, local, pixel: to, highlightedRow, gesture } = this.drag;
    const joint = movingRows(arm).indexOf(highlightedRow);
    const pixel = (point) => this.figure.projectToPixel(point);
    const next = dragLink(arm, q, { row, local, to, joint, pixel });
    this.store.dispatch({ type: "moveJoints", q: next, gesture });
  }

  dragElbow({ arm, q, tipHold }) {
    const { row, local, pixel: to, gesture } = this.drag;
    const grab = { row, local, to, pixel: (point) => this.figure.projectToPixel(point) };
    const { q: next, free } = swingElbow(arm, q, grab, tipHold.pinned, { turns: tipHold.turns });
    this.store.dispatch({ type: "moveJoints", q: next, tipHold: { ...tipHold, free }, gesture });
  }

  // Move the tip towards the pointer. Returns false while it is on its way.
  dragTip(state) {
    const { pixel, from, tip, rest, gesture } = this.drag;
    const point = this.figure.projectToFacingPlane(pixel, tip.o);
    if (!point) return true;
    const o = tip.o.map((v, i) => v + point[i] - from[i]);
    return followTip(this.store, state, { ...tip, o }, { rest, gesture });
  }

  handlePointerMove(event) {
    const { drag, figure } = this;
    if (drag && event.pointerId === drag.id) {
      drag.event = event;
      runBeforeDrawing(this.step);
    } else if (!drag && event.buttons === 0 && event.target === figure.canvas) {
      this.highlightPart(this.findPartUnder(event));
    }
  }

  /** @param {Part | null} part */
  highlightPart(part) {
    const { store } = this;
    this.figure.canvas.style.cursor = part ? "pointer" : "grab";
    const highlightedRow = part?.kind === "link" ? part.highlightedRow : null;
    const highlightedBranch = part?.kind === "branch" ? part.branch : null;
    store.dispatch({ type: "setFields", highlightedRow, highlightedBranch });
  }

  // End a drag, or show the branch that was clicked.
  handlePointerUp(event) {
    const { drag, press, store } = this;
    if (drag && event.pointerId !== drag.id) return;
    const isClick =
      press && Math.hypot(event.clientX - press.x, event.clientY - press.y) < CLICK_TOLERANCE;
    if (isClick && press.part?.kind === "branch")
      this.goTo(store.state.branches.list[press.part.branch].q);
    if (drag) {
      if (cancelStep(this.step)) this.dragOneFrame(); // include the pointer's last motion
      const tipHold = store.state.tipHold?.pinned ? store.state.tipHold : null;
      store.dispatch({ type: "setFields", dragging: false, highlightedRow: null, tipHold });
    }
    [this.drag, this.press] = [null, null];
    this.figure.canvas.classList.remove("held");
  }
}

// Return the row of the last joint before a grabbed point that moves the point.
function findTurningRow(arm, frames, { row, point }, least) {
  const moving = movingRows(arm).filter((index) => index <= row);
  const moves = (index) => {
    const { z, o } = frames[index];
    return arm.rows[index].kind === "prismatic" || norm(cross(z, minus(point, o))) > least;
  };
  return moving.reverse().find(moves) ?? null;
}

/**
 * Move the tip one frame towards its target. Returns true once it has arrived or cannot move
 * further.
 * @param {import("./state.js").Store} store
 */
function followTip(store, { arm, q, keepOrientation }, target, { rest, gesture }) {
  const { q: next, arrived } = dragTip(arm, q, target, rest, { turns: keepOrientation });
  const still = next.every((v, i) => Math.abs(v - q[i]) < 1e-5);
  const done = arrived || still;
  const why = done ? findStopReasons(arm, next, target.o) : { stops: [], short: 0 };
  const columns = jacobianColumns(arm, linkFrames(arm, next));
  const fading = findFadingDirections(columns, keepOrientation, movableLinearRows(arm));
  const tipHold = { target: target.o, moving: !done, fading, ...why };
  store.dispatch({ type: "moveJoints", q: next, tipHold, gesture });
  return done;
}

/**
 * Move the tip to a point as far as the limits allow.
 * @param {import("./state.js").Store} store
 * @param {number[]} o
 */
export function moveTip(store, o, gesture = null) {
  const rest = store.state.q;
  const target = { ...store.derived.frames.at(-1), o };
  for (let step = 0; step < 60; step++)
    if (followTip(store, store.state, target, { rest, gesture })) break;
}

const TIP_KEYS = {
  ArrowLeft: [-1, 0, 0],
  ArrowRight: [1, 0, 0],
  ArrowUp: [0, 1, 0],
  ArrowDown: [0, -1, 0],
  PageUp: [0, 0, -1],
  PageDown: [0, 0, 1],
};
const TIP_STEP = 0.01; // m

/**
 * Move the tip across the picture by a key; Shift makes the step a tenth. Returns false for other
 * keys.
 * @param {import("./scene.js").ArmPicture} picture
 * @param {import("./state.js").Store} store
 * @param {KeyboardEvent} event
 */
export function moveTipByKey(picture, store, event) {
  const direction = TIP_KEYS[event.key];
  if (!direction) return false;
  event.preventDefault();
  event.stopPropagation();
  const step = TIP_STEP * (event.shiftKey ? 0.1 : 1);
  const axes = picture.getCameraAxes();
  const { o } = store.derived.frames.at(-1);
  moveTip(
    store,
    o.map((v, i) => v + step * direction.reduce((sum, share, k) => sum + share * axes[k][i], 0)),
    "tip keys",
  );
  return true;
}
