// Pointers on the picture: a link turns its joint, the tip is followed, the ball of the force
// pushes, and what is nothing of these turns the view. One solve for each frame that is drawn,
// however many times the pointer moves.

import {
  cross,
  jacobianColumns,
  joints,
  linkFrames,
  minus,
  norm,
} from "../../judge/geometry/kinematics.js";
import { beforeDrawing, forget } from "./renderer.js";
import { dragLink, dragTip, fadingWays, inFrame, swingElbow, whyStopped } from "./hold.js";

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
  const { figure } = picture;
  const { canvas } = figure;
  let drag = null;
  let down = null;

  const ballAt = (pixel) => {
    if (!picture.handle?.visible) return false;
    const [x, y] = figure.pixel(picture.handle.position.toArray());
    return Math.hypot(x - pixel[0], y - pixel[1]) < BALL;
  };

  // What a pointer would take hold of.
  function under(event) {
    const pixel = figure.place(event);
    const { state, derived } = store;
    if (ballAt(pixel)) return { kind: "force" };
    const way = state.view === "branches" ? picture.wayAt(pixel) : null;
    if (way !== null) return { kind: "way", way };
    const hit = picture.linkAt(pixel, HAND[event.pointerType] ?? HAND.touch, picture.grips());
    if (!hit) return null;
    if (state.hold?.pinned) return { kind: "elbow", ...held(hit, derived.frames) };
    const row = turnedBy(state.arm, derived.frames, hit, 0.02 * picture.size);
    return row === null ? null : { kind: "link", lit: row, ...held(hit, derived.frames) };
  }

  const held = ({ row, point }, frames) => ({ row, local: inFrame(frames[row + 1], point) });

  function begin(event, what) {
    const pixel = figure.place(event);
    const { state, derived } = store;
    const tip = derived.frames.at(-1);
    drag = {
      ...what,
      id: event.pointerId,
      box: null, // where the canvas is, asked for once: the answer lays the page out
      to: pixel,
      gesture: `drag ${++count}`,
      rest: state.q,
      tip,
      point: tip.o,
    };
    if (what.kind === "tip") drag.from = figure.onFacingPlane(pixel, tip.o);
    event.target.setPointerCapture(event.pointerId);
    store.dispatch({
      type: "show",
      dragging: true,
      ...(what.lit === undefined ? {} : { lit: what.lit }),
    });
    canvas.classList.add("held");
  }

  function step() {
    if (drag && !STEPS[drag.kind](store.state)) beforeDrawing(step);
  }

  // One frame of each kind of drag; false where another frame is needed with the pointer at rest.
  const STEPS = {
    force: () => {
      const point = figure.onFacingPlane(drag.to, picture.handle.position.toArray());
      const wrench = point && [...picture.forceFrom(point), ...store.state.wrench.slice(3)];
      if (wrench) store.dispatch({ type: "push", wrench, gesture: drag.gesture });
      return true;
    },
    link: ({ arm, q }) => {
      const { row, local, to, lit } = drag;
      const joint = joints(arm).indexOf(lit);
      const next = dragLink(arm, q, { row, local, to, joint, pixel: (p) => figure.pixel(p) });
      store.dispatch({ type: "move", q: next, gesture: drag.gesture });
      return true;
    },
    elbow: ({ arm, q, hold }) => {
      const { row, local, to } = drag;
      const grab = { row, local, to, pixel: (p) => figure.pixel(p) };
      const { q: next, free } = swingElbow(arm, q, grab, hold.pinned, { turns: hold.turns });
      store.dispatch({ type: "move", q: next, hold: { ...hold, free }, gesture: drag.gesture });
      return true;
    },
    tip: (state) => {
      const point = figure.onFacingPlane(drag.to, drag.point);
      if (!point) return true;
      const target = drag.tip.o.map((v, i) => v + point[i] - drag.from[i]);
      return followTip(store, state, { ...drag.tip, o: target }, drag.rest, drag.gesture);
    },
  };

  const move = (event) => {
    if (drag && event.pointerId === drag.id) {
      drag.box ??= canvas.getBoundingClientRect();
      drag.to = figure.place(event, drag.box);
      beforeDrawing(step);
    } else if (!drag && event.buttons === 0 && event.target === canvas) {
      hover(under(event));
    }
  };

  function hover(what) {
    canvas.style.cursor = what ? "pointer" : "grab";
    const lit = what?.kind === "link" ? what.lit : null;
    if (store.state.lit !== lit) store.dispatch({ type: "show", lit });
    const highlighted = what?.kind === "way" ? what.way : null;
    if (store.state.highlighted !== highlighted) store.dispatch({ type: "show", highlighted });
  }

  function release(event) {
    if (drag && event.pointerId !== drag.id) return;
    const still = down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < CLICK;
    if (still && down[2]?.kind === "way") goTo(store.state.ways.list[down[2].way].q);
    if (drag) {
      if (forget(step)) STEPS[drag.kind](store.state); // the pointer's last motion counts too
      const { hold } = store.state;
      store.dispatch({
        type: "show",
        dragging: false,
        lit: null,
        hold: hold?.pinned ? hold : null,
      });
    }
    [drag, down] = [null, null];
    canvas.classList.remove("held");
  }

  figure.listen(
    canvas,
    "pointerdown",
    (event) => {
      if (event.button) return;
      const what = under(event);
      down = [event.clientX, event.clientY, what];
      if (!what || what.kind === "way") return;
      event.stopImmediatePropagation(); // the view does not turn
      begin(event, what);
    },
    { capture: true },
  );
  figure.listen(grip, "pointerdown", (event) => {
    if (!event.button) begin(event, { kind: "tip" });
  });
  for (const target of [canvas, grip]) {
    figure.listen(target, "pointermove", move);
    figure.listen(target, "pointerup", release);
    figure.listen(target, "pointercancel", release);
  }
  figure.listen(window, "scroll", () => drag && (drag.box = null), { capture: true });
  figure.listen(canvas, "pointerleave", () => drag || hover(null));
  // A touch that takes hold of something drags it in every direction; the others may scroll the
  // page.
  figure.listen(
    canvas,
    "touchstart",
    (event) => {
      const touch = event.touches[0];
      if (event.touches.length === 1 && under({ ...point(touch), pointerType: "touch" }))
        event.preventDefault();
    },
    { passive: false },
  );
  figure.signal.addEventListener("abort", () => forget(step));
}

const point = ({ clientX, clientY }) => ({ clientX, clientY });

// The row of the joint that a grabbed point is turned by: the last one before it that moves it at
// all.
function turnedBy(arm, frames, { row, point }, least) {
  const moving = joints(arm).filter((index) => index <= row);
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
export function followTip(store, { arm, q, keepTurn }, target, rest, gesture) {
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
    if (followTip(store, store.state, target, rest, gesture)) break;
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
