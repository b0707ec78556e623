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
  const abort = new AbortController();
  /** @type {Shown} */
  let shown = host.answer;
  let [claim, share, frame] = [null, 0, 0];
  const lever = makeLever("how far", [-1, 1], 0, {
    put: (value) => (cancelAnimationFrame(frame), move(value)),
    text: (value) => `${Math.round(100 * value)} %`,
    signal: abort.signal,
  });
  const buttons = h("div.row", { role: "group", "aria-label": "See a column at work" });
  const side = h("div", {}, buttons, lever.root);
  const live = makeLive(
    host,
    { arm: shown.arm, q: shown.q },
    {
      hold: false,
      side: [side],
      words: () =>
        claim && share
          ? claimWords(moved(shown.arm, shown.q, claim, share), numberOf(claim))
          : shown.words,
    },
  );
  const { store, picture } = live;
  const overlay = picture && new Overlay(picture);
  const numberOf = ({ k }) => joints(shown.arm)[k] + 1;

  function move(value) {
    share = value;
    store.dispatch({ type: "set", q: claim ? moved(shown.arm, shown.q, claim, share).q : shown.q });
    live.refresh();
  }
  function run(chosen) {
    cancelAnimationFrame(frame);
    claim = chosen;
    const begin = performance.now();
    const step = (now) => {
      const part = calm() ? 1 : Math.max(0, Math.min(1, (now - begin) / PLAYED));
      lever.move((1 - Math.cos(Math.PI * part)) / 2);
      if (part < 1) frame = requestAnimationFrame(step);
    };
    step(begin);
  }
  function show() {
    cancelAnimationFrame(frame);
    const { arm, q, wrench = NONE, claims } = shown;
    claim = claims[0] ?? null;
    if (arm !== store.state.arm) store.dispatch({ type: "select", arm, q });
    store.dispatch({ type: "set", wrench, view: wrench.some(Boolean) ? "torque" : "pose" });
    side.hidden = !claim;
    buttons.replaceChildren(
      ...claims.map((one) => {
        const verb = arm.rows[joints(arm)[one.k]].kind === "prismatic" ? "Slide" : "Turn";
        return h(
          "button",
          { type: "button", onclick: () => run(one) },
          `${verb} joint ${numberOf(one)}`,
        );
      }),
    );
    lever.move(0);
    picture?.figure.fit(extent(shown));
  }
  live.follow(() => overlay?.draw(shown, claim, share));
  host.addEventListener("answer", () => ((shown = host.answer), show()), { signal: abort.signal });
  show();
  return () => (cancelAnimationFrame(frame), abort.abort(), live.dispose());
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
