// The arm beside the judge: at the pose that is asked about, with what is wrong in red. Where a
// column of a Jacobian is wrong, its joint moves a little, the arm truly and a ghost of its tip as
// the column claims.

import { calm, h } from "../dom.js";
import { reachOf } from "../../../judge/geometry/arm.js";
import { joints, linkFrames, minus, plus, scaled } from "../../../judge/geometry/kinematics.js";
import { freed } from "../renderer.js";
import { along, ArmShape, ball, ghostMaterial, paint, rod, Triads, tube } from "../shapes.js";
import { claimWords, moved } from "./claim.js";
import { makeLever, makeLive } from "./live.js";

const STEPS = 24; // of a drawn way
const NONE = [0, 0, 0, 0, 0, 0];
const PLAYED = 1600; // ms, from the pose to the farthest

/**
 * What is shown. The page puts it on the host as `answer`, and sends it an event "answer" when it
 * has changed.
 * @typedef {object} Shown
 * @property {import("../../../judge/geometry/arm.js").Arm} arm
 * @property {number[]} q its pose
 * @property {number[]} axes rows, from 0, whose joints are wrong
 * @property {number[]} links rows that are wrong in a table
 * @property {number[]} [wrench]
 * @property {{ arm: import("../../../judge/geometry/arm.js").Arm, q: number[] }[]} ghosts
 * @property {number[][]} [path] of the tip
 * @property {number[][]} points that the tip should reach
 * @property {{ k: number, twist: number[] }[]} claims of wrong columns
 * @property {string} words
 */

export function answer(host) {
  const shown = new Answer(host);
  return () => shown.dispose();
}

/** The picture of one answer: which claim of it is at work, and how far. */
class Answer {
  constructor(host) {
    this.abort = new AbortController();
    const { signal } = this.abort;
    /** @type {Shown} */
    this.shown = host.answer;
    this.claim = null;
    this.share = 0;
    this.frame = 0;
    this.lever = makeLever("how far", [-1, 1], 0, {
      put: (value) => (cancelAnimationFrame(this.frame), this.move(value)),
      text: (value) => `${Math.round(100 * value)} %`,
      signal,
    });
    this.buttons = h("div.row", { role: "group", "aria-label": "See a column at work" });
    this.side = h("div", {}, this.buttons, this.lever.root);
    const { arm, q } = this.shown;
    const made = { hold: false, side: [this.side], words: () => this.words() };
    this.live = makeLive(host, { arm, q }, made);
    this.overlay = this.live.picture && new Overlay(this.live.picture);
    this.live.follow(() => this.overlay?.draw(this.shown, this.claim, this.share));
    const changed = () => ((this.shown = host.answer), this.show());
    host.addEventListener("answer", changed, { signal });
    this.show();
  }

  // The arm where the claim takes it.
  moved() {
    const { arm, q } = this.shown;
    return moved(arm, q, this.claim, this.share);
  }

  words() {
    if (!this.claim || !this.share) return this.shown.words;
    return claimWords(this.moved(), this.numberOf(this.claim));
  }

  numberOf({ k }) {
    return joints(this.shown.arm)[k] + 1;
  }

  move(value) {
    this.share = value;
    this.live.store.dispatch({ type: "set", q: this.claim ? this.moved().q : this.shown.q });
    this.live.refresh();
  }

  run(claim) {
    cancelAnimationFrame(this.frame);
    this.claim = claim;
    const begin = performance.now();
    const step = (now) => {
      const part = calm() ? 1 : Math.max(0, Math.min(1, (now - begin) / PLAYED));
      this.lever.move((1 - Math.cos(Math.PI * part)) / 2);
      if (part < 1) this.frame = requestAnimationFrame(step);
    };
    step(begin);
  }

  show() {
    cancelAnimationFrame(this.frame);
    const { store, picture } = this.live;
    const { arm, q, wrench = NONE, claims } = this.shown;
    this.claim = claims[0] ?? null;
    if (arm !== store.state.arm) store.dispatch({ type: "select", arm, q });
    store.dispatch({ type: "set", wrench, view: wrench.some(Boolean) ? "torque" : "pose" });
    this.side.hidden = !this.claim;
    this.buttons.replaceChildren(...claims.map((claim) => this.button(claim)));
    this.lever.move(0);
    picture?.figure.fit(extent(this.shown));
  }

  button(claim) {
    const { kind } = this.shown.arm.rows[this.numberOf(claim) - 1];
    const words = `${kind === "prismatic" ? "Slide" : "Turn"} joint ${this.numberOf(claim)}`;
    return h("button", { type: "button", onclick: () => this.run(claim) }, words);
  }

  dispose() {
    cancelAnimationFrame(this.frame);
    this.abort.abort();
    this.live.dispose();
  }
}

// The points that should be in view, with room for the axes at the tip.
function extent({ arm, q, ghosts, points, path = [] }) {
  const arms = [{ arm, q }, ...ghosts].map((one) => linkFrames(one.arm, one.q));
  const room = 0.12 * reachOf(arm);
  const ends = ["x", "z"].map((axis) => plus(arms[0].at(-1).o, scaled(room, arms[0].at(-1)[axis])));
  return [
    ...arms.flat().map(({ o }) => o),
    ...ends,
    ...points,
    ...path,
    [0, 0, 0],
    [0, 0, 3 * room],
  ];
}

// What is drawn over the explorer's picture.
class Overlay {
  constructor(picture) {
    this.picture = picture;
    /** @type {any[]} */
    this.drawn = [];
    this.made = [];
  }

  draw(shown, claim, share) {
    const { picture } = this;
    if (!picture.world) return;
    picture.body.tint((row) =>
      shown.axes.includes(row) || shown.links.includes(row) ? picture.tints.bad : null,
    );
    const now = [shown, claim, share, picture.world];
    if (now.every((one, i) => one === this.drawn[i])) return;
    this.drawn = now;
    this.made.forEach(freed);
    this.made = this.pieces(shown, claim, share);
    for (const piece of this.made) picture.world.add(piece);
    picture.figure.request();
  }

  pieces(shown, claim, share) {
    const { picture } = this;
    const [bad, ghost] = [picture.look.bad, picture.look.ghost];
    const frames = picture.frames;
    const made = shown.axes.map((row) =>
      this.line(axisOf(frames[row], 0.3 * picture.size), 0.004, bad),
    );
    made.push(...shown.links.map((row) => this.line(linkOf(frames, row), 0.02, bad)));
    for (const { arm, q } of shown.ghosts) {
      const material = ghostMaterial(bad, 0.4);
      const shape = new ArmShape(arm, { link: material, joint: material, ghost: true });
      shape.pose(linkFrames(arm, q));
      made.push(shape);
    }
    for (const point of shown.points) made.push(this.spot(point, bad));
    if (shown.path) made.push(tube(shown.path, 0.003 * picture.size, bad));
    return claim && share ? [...made, ...this.claim(shown, claim, share, bad, ghost)] : made;
  }

  // The tip as the column claims, and the ways of both.
  claim({ arm, q }, claim, share, bad, ghost) {
    const { picture } = this;
    const ways = Array.from({ length: STEPS + 1 }, (_, i) =>
      moved(arm, q, claim, (share * i) / STEPS),
    );
    const tip = new Triads(picture.dark, 1);
    tip.pose([ways.at(-1).claimed], 0.1 * picture.size);
    const spot = this.spot(ways.at(-1).claimed.o, bad);
    const thick = 0.005 * picture.size;
    return [
      tip,
      spot,
      tube(
        ways.map(({ claimed }) => claimed.o),
        thick,
        bad,
      ),
      tube(
        ways.map(({ truly }) => truly.o),
        thick,
        ghost,
      ),
    ];
  }

  spot(point, colour) {
    const made = ball(paint(colour));
    made.scale.setScalar(0.016 * this.picture.size);
    made.position.fromArray(point);
    return made;
  }

  line({ start, end }, thickness, colour) {
    const made = rod(paint(colour));
    along(made, start, end, thickness * this.picture.size);
    return made;
  }
}

const axisOf = ({ o, z }, half) => ({
  start: minus(o, scaled(half, z)),
  end: plus(o, scaled(half, z)),
});
const linkOf = (frames, row) => ({ start: frames[row].o, end: frames[row + 1].o });
