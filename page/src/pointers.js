// Pointers on the picture: a dragged link turns its joint, the arm follows a dragged tip, the ball
// at the tip sets the force, and any other drag turns the view. Each drawn frame solves once,
// however often the pointer moves.

import {
  cross,
  jacobianColumns,
  movingRows,
  linkFrames,
  minus,
  norm,
} from "../../judge/geometry/kinematics.js";
import { movableLinearRows } from "../../judge/geometry/task_rows.js";
import { beforeDrawing, cancelStep } from "./renderer.js";
import {
  dragLink,
  dragTip,
  findFadingDirections,
  toFrame,
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
  const hand = new Grabber(picture, store, goTo);
  const { figure } = picture;
  const { canvas } = figure;
  const begins = (event) => hand.takes(event);
  figure.listen(canvas, "pointerdown", begins, { capture: true });
  figure.listen(grip, "pointerdown", (event) => {
    if (!event.button) hand.begin(event, { kind: "tip" });
  });
  for (const target of [canvas, grip]) {
    figure.listen(target, "pointermove", (event) => hand.move(event));
    figure.listen(target, "pointerup", (event) => hand.release(event));
    figure.listen(target, "pointercancel", (event) => hand.release(event));
  }
  figure.listen(canvas, "pointerleave", () => hand.drag || hand.hover(null));
  // A touch on something that can be grabbed drags it in every direction; any other touch may
  // scroll the page.
  const touched = (event) => {
    const [{ clientX, clientY }] = event.touches;
    if (event.touches.length === 1 && hand.under({ clientX, clientY, pointerType: "touch" }))
      event.preventDefault();
  };
  figure.listen(canvas, "touchstart", touched, { passive: false });
  figure.signal.addEventListener("abort", () => cancelStep(hand.step));
}

/** The object that the pointer has grabbed, and the work of one frame of the drag. */
class Grabber {
  constructor(picture, store, goTo) {
    this.picture = picture;
    this.figure = picture.figure;
    this.store = store;
    this.goTo = goTo;
    /** @type {any} */
    this.drag = null;
    this.down = null; // where the pointer went down, and on what
    this.step = () => {
      if (this.drag && !this.follow()) beforeDrawing(this.step);
    };
  }

  ballAt(pixel) {
    const { handle } = this.picture;
    if (!handle?.visible) return false;
    const [x, y] = this.figure.pixel(handle.position.toArray());
    return Math.hypot(x - pixel[0], y - pixel[1]) < FORCE_BALL_RADIUS;
  }

  // Return what the pointer would grab, or null.
  under(event) {
    const { picture, store } = this;
    const pixel = this.figure.place(event);
    const { state, derived } = store;
    if (this.ballAt(pixel)) return { kind: "force" };
    const branch = state.view === "branches" ? picture.findBranchAt(pixel) : null;
    if (branch !== null) return { kind: "branch", branch };
    const hit = picture.findLinkAt(
      pixel,
      GRAB_RADIUS[event.pointerType] ?? GRAB_RADIUS.touch,
      picture.grips(),
    );
    if (!hit) return null;
    const { frames } = derived;
    const held = { row: hit.row, local: toFrame(frames[hit.row + 1], hit.point) };
    if (state.hold?.pinned) return { kind: "elbow", ...held };
    const row = findTurningRow(state.arm, frames, hit, 0.02 * picture.size);
    return row === null ? null : { kind: "link", highlightedRow: row, ...held };
  }

  takes(event) {
    if (event.button) return;
    const what = this.under(event);
    this.down = [event.clientX, event.clientY, what];
    if (!what || what.kind === "branch") return;
    event.stopImmediatePropagation(); // keeps the view from turning
    this.begin(event, what);
  }

  begin(event, what) {
    const { figure, store } = this;
    const pixel = figure.place(event);
    const tip = store.derived.frames.at(-1);
    this.drag = {
      ...what,
      id: event.pointerId,
      at: event, // the latest pointer event
      gesture: `drag ${++dragCount}`,
      rest: store.state.q,
      tip,
      point: tip.o,
    };
    if (what.kind === "tip") this.drag.from = figure.onFacingPlane(pixel, tip.o);
    event.target.setPointerCapture(event.pointerId);
    const highlightedRow =
      what.highlightedRow === undefined ? {} : { highlightedRow: what.highlightedRow };
    store.dispatch({ type: "setFields", dragging: true, ...highlightedRow });
    figure.canvas.classList.add("held");
  }

  // Make one frame of the drag. Returns false if another frame is needed although the pointer
  // rests.
  follow() {
    const { drag, store } = this;
    drag.to = this.figure.place(drag.at);
    return this[drag.kind](store.state);
  }

  force() {
    const { picture, figure, store, drag } = this;
    const point = figure.onFacingPlane(drag.to, picture.handle.position.toArray());
    const wrench = point && [...picture.forceFrom(point), ...store.state.wrench.slice(3)];
    if (wrench) store.dispatch({ type: "setWrench", wrench, gesture: drag.gesture });
    return true;
  }

  link({ arm, q }) {
    const { row, local, to, highlightedRow, gesture } = this.drag;
    const joint = movingRows(arm).indexOf(highlightedRow);
    const pixel = (p) => this.figure.pixel(p);
    const next = dragLink(arm, q, { row, local, to, joint, pixel });
    this.store.dispatch({ type: "moveJoints", q: next, gesture });
    return true;
  }

  elbow({ arm, q, hold }) {
    const { row, local, to, gesture } = this.drag;
    const grab = { row, local, to, pixel: (p) => this.figure.pixel(p) };
    const { q: next, free } = swingElbow(arm, q, grab, hold.pinned, { turns: hold.turns });
    this.store.dispatch({ type: "moveJoints", q: next, hold: { ...hold, free }, gesture });
    return true;
  }

  tip(state) {
    const { to, from, point: start, tip, rest, gesture } = this.drag;
    const point = this.figure.onFacingPlane(to, start);
    if (!point) return true;
    const o = tip.o.map((v, i) => v + point[i] - from[i]);
    return followTip(this.store, state, { ...tip, o }, { rest, gesture });
  }

  move(event) {
    const { drag, figure } = this;
    if (drag && event.pointerId === drag.id) {
      drag.at = event;
      beforeDrawing(this.step);
    } else if (!drag && event.buttons === 0 && event.target === figure.canvas) {
      this.hover(this.under(event));
    }
  }

  hover(what) {
    const { store } = this;
    this.figure.canvas.style.cursor = what ? "pointer" : "grab";
    const highlightedRow = what?.kind === "link" ? what.highlightedRow : null;
    if (store.state.highlightedRow !== highlightedRow)
      store.dispatch({ type: "setFields", highlightedRow });
    const highlightedBranch = what?.kind === "branch" ? what.branch : null;
    if (store.state.highlightedBranch !== highlightedBranch)
      store.dispatch({ type: "setFields", highlightedBranch });
  }

  release(event) {
    const { drag, down, store } = this;
    if (drag && event.pointerId !== drag.id) return;
    const still =
      down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < CLICK_TOLERANCE;
    if (still && down[2]?.kind === "branch") this.goTo(store.state.branches.list[down[2].branch].q);
    if (drag) {
      if (cancelStep(this.step)) this.follow(); // include the pointer's last motion
      const hold = store.state.hold?.pinned ? store.state.hold : null;
      store.dispatch({ type: "setFields", dragging: false, highlightedRow: null, hold });
    }
    [this.drag, this.down] = [null, null];
    this.figure.canvas.classList.remove("held");
  }
}

// Return the row of the joint that a grabbed point turns: the last one before it that moves it.
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
  const hold = { kind: "tip", target: target.o, moving: !done, fading, ...why };
  store.dispatch({ type: "moveJoints", q: next, hold, gesture });
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
  const axes = picture.cameraAxes();
  const { o } = store.derived.frames.at(-1);
  moveTip(
    store,
    o.map((v, i) => v + step * direction.reduce((sum, share, k) => sum + share * axes[k][i], 0)),
    "tip keys",
  );
  return true;
}
