// Pointers on the picture: a link turns its joint, the tip is followed, the ball of the force
// pushes, and what is nothing of these turns the view. One solve for each frame that is drawn,
// however many times the pointer moves.

import {
  cross,
  jacobianColumns,
  movingRows,
  linkFrames,
  minus,
  norm,
} from "../../judge/geometry/kinematics.js";
import { beforeDrawing, forget } from "./renderer.js";
import { dragLink, dragTip, fadingWays, inFrame, swingElbow, whyStopped } from "./dragging.js";

const BALL = 22; // px around the ball of the force
const HAND = { mouse: 11, touch: 20, pen: 16 }; // px around a link
const CLICK = 4; // px that a click may move

let count = 0;

/**
 * @param {import("./scene.js").ArmPicture} picture
 * @param {import("./state.js").Store} store
 * @param {{ grip: HTMLElement, goTo: (q: number[]) => void }} tools
 */
export function makeGrabbable(picture, store, { grip, goTo }) {
  const hand = new Hand(picture, store, goTo);
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
  // A touch that takes hold of something drags it in every direction; the others may scroll the
  // page.
  const touched = (event) => {
    const [{ clientX, clientY }] = event.touches;
    if (event.touches.length === 1 && hand.under({ clientX, clientY, pointerType: "touch" }))
      event.preventDefault();
  };
  figure.listen(canvas, "touchstart", touched, { passive: false });
  figure.signal.addEventListener("abort", () => forget(hand.step));
}

/** What a pointer holds, and what one frame of its drag does. */
class Hand {
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
    return Math.hypot(x - pixel[0], y - pixel[1]) < BALL;
  }

  // What a pointer would take hold of.
  under(event) {
    const { picture, store } = this;
    const pixel = this.figure.place(event);
    const { state, derived } = store;
    if (this.ballAt(pixel)) return { kind: "force" };
    const way = state.view === "branches" ? picture.wayAt(pixel) : null;
    if (way !== null) return { kind: "way", way };
    const hit = picture.linkAt(pixel, HAND[event.pointerType] ?? HAND.touch, picture.grips());
    if (!hit) return null;
    const { frames } = derived;
    const held = { row: hit.row, local: inFrame(frames[hit.row + 1], hit.point) };
    if (state.hold?.pinned) return { kind: "elbow", ...held };
    const row = turnedBy(state.arm, frames, hit, 0.02 * picture.size);
    return row === null ? null : { kind: "link", lit: row, ...held };
  }

  takes(event) {
    if (event.button) return;
    const what = this.under(event);
    this.down = [event.clientX, event.clientY, what];
    if (!what || what.kind === "way") return;
    event.stopImmediatePropagation(); // the view does not turn
    this.begin(event, what);
  }

  begin(event, what) {
    const { figure, store } = this;
    const pixel = figure.place(event);
    const tip = store.derived.frames.at(-1);
    this.drag = {
      ...what,
      id: event.pointerId,
      at: event, // where the pointer is now
      gesture: `drag ${++count}`,
      rest: store.state.q,
      tip,
      point: tip.o,
    };
    if (what.kind === "tip") this.drag.from = figure.onFacingPlane(pixel, tip.o);
    event.target.setPointerCapture(event.pointerId);
    const lit = what.lit === undefined ? {} : { lit: what.lit };
    store.dispatch({ type: "show", dragging: true, ...lit });
    figure.canvas.classList.add("held");
  }

  // One frame of a drag; false where another frame is needed with the pointer at rest.
  follow() {
    const { drag, store } = this;
    drag.to = this.figure.place(drag.at);
    return this[drag.kind](store.state);
  }

  force() {
    const { picture, figure, store, drag } = this;
    const point = figure.onFacingPlane(drag.to, picture.handle.position.toArray());
    const wrench = point && [...picture.forceFrom(point), ...store.state.wrench.slice(3)];
    if (wrench) store.dispatch({ type: "push", wrench, gesture: drag.gesture });
    return true;
  }

  link({ arm, q }) {
    const { row, local, to, lit, gesture } = this.drag;
    const joint = movingRows(arm).indexOf(lit);
    const pixel = (p) => this.figure.pixel(p);
    const next = dragLink(arm, q, { row, local, to, joint, pixel });
    this.store.dispatch({ type: "move", q: next, gesture });
    return true;
  }

  elbow({ arm, q, hold }) {
    const { row, local, to, gesture } = this.drag;
    const grab = { row, local, to, pixel: (p) => this.figure.pixel(p) };
    const { q: next, free } = swingElbow(arm, q, grab, hold.pinned, { turns: hold.turns });
    this.store.dispatch({ type: "move", q: next, hold: { ...hold, free }, gesture });
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
    const lit = what?.kind === "link" ? what.lit : null;
    if (store.state.lit !== lit) store.dispatch({ type: "show", lit });
    const highlighted = what?.kind === "way" ? what.way : null;
    if (store.state.highlighted !== highlighted) store.dispatch({ type: "show", highlighted });
  }

  release(event) {
    const { drag, down, store } = this;
    if (drag && event.pointerId !== drag.id) return;
    const still = down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < CLICK;
    if (still && down[2]?.kind === "way") this.goTo(store.state.ways.list[down[2].way].q);
    if (drag) {
      if (forget(this.step)) this.follow(); // the pointer's last motion counts too
      const hold = store.state.hold?.pinned ? store.state.hold : null;
      store.dispatch({ type: "show", dragging: false, lit: null, hold });
    }
    [this.drag, this.down] = [null, null];
    this.figure.canvas.classList.remove("held");
  }
}

// The row of the joint that a grabbed point is turned by: the last one before it that moves it at
// all.
function turnedBy(arm, frames, { row, point }, least) {
  const moving = movingRows(arm).filter((index) => index <= row);
  const moves = (index) => {
    const { z, o } = frames[index];
    return arm.rows[index].kind === "prismatic" || norm(cross(z, minus(point, o))) > least;
  };
  return moving.reverse().find(moves) ?? null;
}

/**
 * One frame of a tip that follows a target; true where it has arrived, or is stopped.
 * @param {import("./state.js").Store} store
 */
function followTip(store, { arm, q, keepTurn }, target, { rest, gesture }) {
  const { q: next, arrived } = dragTip(arm, q, target, rest, { turns: keepTurn });
  const still = next.every((v, i) => Math.abs(v - q[i]) < 1e-5);
  const done = arrived || still;
  const why = done ? whyStopped(arm, next, target.o) : { stops: [], short: 0 };
  const fading = fadingWays(jacobianColumns(arm, linkFrames(arm, next)), keepTurn);
  const hold = { kind: "tip", target: target.o, moving: !done, fading, ...why };
  store.dispatch({ type: "move", q: next, hold, gesture });
  return done;
}

/**
 * Bring the tip to a point as a drag would, all the way, within limits.
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
const TIP_STEP = 0.01; // m; a tenth of it with Shift

/**
 * Move the tip across the picture by a key, a tenth as far with Shift; whether the key was one.
 * @param {import("./scene.js").ArmPicture} picture
 * @param {import("./state.js").Store} store
 * @param {KeyboardEvent} event
 */
export function moveTipByKey(picture, store, event) {
  const way = TIP_KEYS[event.key];
  if (!way) return false;
  event.preventDefault();
  event.stopPropagation();
  const step = TIP_STEP * (event.shiftKey ? 0.1 : 1);
  const axes = picture.cameraAxes();
  const { o } = store.derived.frames.at(-1);
  moveTip(
    store,
    o.map((v, i) => v + step * way.reduce((sum, share, k) => sum + share * axes[k][i], 0)),
    "tip keys",
  );
  return true;
}
