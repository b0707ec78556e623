// What a column of a Jacobian claims: where the tip goes while one joint moves alone, and where it
// goes truly.

import {
  joints,
  linkFrames,
  minus,
  norm,
  plus,
  scaled,
} from "../../../judge/geometry/kinematics.js";
import { fixed } from "../text.js";

const TURN = 0.5; // rad: far enough to see, near enough for the picture
const SLIDE = 0.15; // m

/** @typedef {{ x: number[], y: number[], z: number[], o: number[] }} Frame */

const wedge = (w, u) => [
  w[1] * u[2] - w[2] * u[1],
  w[2] * u[0] - w[0] * u[2],
  w[0] * u[1] - w[1] * u[0],
];

// A vector turned by the angle |w| about w.
function turned(w, u) {
  const angle = norm(w);
  if (angle < 1e-9) return u;
  const about = wedge(w, u);
  const [s, c] = [Math.sin(angle) / angle, (1 - Math.cos(angle)) / angle ** 2];
  return plus(u, plus(scaled(s, about), scaled(c, wedge(w, about))));
}

// The way of a point that starts with v and turns along with w: the integral of the turned v.
function drawn(w, v) {
  const angle = norm(w);
  if (angle < 1e-9) return v;
  const about = wedge(w, v);
  const [first, second] = [
    (1 - Math.cos(angle)) / angle ** 2,
    (angle - Math.sin(angle)) / angle ** 3,
  ];
  return plus(v, plus(scaled(first, about), scaled(second, wedge(w, about))));
}

/**
 * A frame after a rigid body's motion for a time: its origin starts with v, and it turns with w all
 * the while. Of the true column of a joint it is where the joint takes the tip, however far.
 * @param {Frame} frame
 * @param {number[]} twist (v, w) in base axes
 * @param {number} time
 * @returns {Frame}
 */
export function carried({ x, y, z, o }, twist, time) {
  const [v, w] = [scaled(time, twist.slice(0, 3)), scaled(time, twist.slice(3))];
  const [nx, ny, nz] = [x, y, z].map((axis) => turned(w, axis));
  return { x: nx, y: ny, z: nz, o: plus(o, drawn(w, v)) };
}

/**
 * The joint of a claim moved by a share, -1 to 1, of what shows well: the arm's joints, and both
 * tips.
 * @param {import("../../../judge/geometry/arm.js").Arm} arm
 * @param {number[]} q
 * @param {{ k: number, twist: number[] }} claim on the joint at position k of q
 * @param {number} share
 */
export function moved(arm, q, { k, twist }, share) {
  const row = arm.rows[joints(arm)[k]];
  const by = share * (row.kind === "prismatic" ? SLIDE : TURN);
  const there = q.map((value, i) => (i === k ? value + by : value));
  const tip = linkFrames(arm, q).at(-1);
  return {
    by,
    row,
    q: there,
    tip,
    truly: linkFrames(arm, there).at(-1),
    claimed: carried(tip, twist, by),
  };
}

const AXES = ["x", "y", "z"];

function way(d) {
  const most = d.reduce((best, v, i) => (Math.abs(v) > Math.abs(d[best]) ? i : best), 0);
  return `${fixed(1000 * norm(d), 0)} mm, mostly along ${d[most] < 0 ? "−" : "+"}${AXES[most]}`;
}

// How far apart two frames are turned, in degrees.
function apart(one, other) {
  const trace = AXES.reduce(
    (sum, axis) => sum + one[axis].reduce((s, v, i) => s + v * other[axis][i], 0),
    0,
  );
  return (180 / Math.PI) * Math.acos(Math.min(1, Math.max(-1, (trace - 1) / 2)));
}

/**
 * The counterexample in words.
 * @param {ReturnType<typeof moved>} made
 * @param {number} number of the joint
 */
export function claimWords({ by, row, tip, truly, claimed }, number) {
  const [mine, right] = [claimed, truly].map(({ o }) => minus(o, tip.o));
  const joint =
    row.kind === "prismatic"
      ? `Joint ${number} slid by ${fixed(1000 * by, 0)} mm`
      : `Joint ${number} turned by ${fixed((180 / Math.PI) * by, 0)}°`;
  const still = (d) => norm(d) < 1e-3;
  const place =
    norm(minus(mine, right)) < 1e-3
      ? "your column takes the tip where the arm takes it"
      : "your column " +
        (still(mine) ? "leaves the tip where it is" : `takes the tip ${way(mine)}`) +
        `; the arm ${still(right) ? "leaves it there" : `takes it ${way(right)}`}`;
  const angle = apart(claimed, truly);
  const turn =
    angle > 0.5 ? ` The tool would end turned by ${fixed(angle, 0)}° from where it does.` : "";
  return `${joint}: ${place}.${turn}`;
}
