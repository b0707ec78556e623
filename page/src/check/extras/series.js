// Questions without end, by number: question n of a series is the same for everybody, so that a
// link can name it. A course's own questions and their keys are drawn from a secret in Python
// (helpers/course), never here.

import { homeOf, range } from "../../../../judge/geometry/arm.js";
import { joints, jacobianColumns, linkFrames } from "../../../../judge/geometry/kinematics.js";
import { singular } from "../../../../judge/geometry/linear.js";
import { traceCircle } from "../../motion.js";
import { OWN } from "../question.js";

export const LAST = 999_999; // the last question of a series
const TRIES = 500;
const SMALLEST = 0.06; // no question is asked nearer to a singular pose than this singular value
const WIDEST = 2.4; // rad or m, of a joint
// arms of which all branches are known
const CLOSED = ["UR10E", "UR10E_HOMEWORK", "STANFORD", "ELBOW"];

/**
 * The numbers in [0, 1) that belong to a text: mulberry32 (Tommy Ettinger), started with the text's
 * 32-bit FNV-1a hash.
 * @param {string} text
 * @returns {() => number}
 */
export function rolls(text) {
  let state = 0x811c9dc5;
  for (const sign of text) state = Math.imul(state ^ sign.charCodeAt(0), 0x01000193);
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

const rounded = (x, digits) => Number(x.toFixed(digits)) + 0;
const between = (roll, low, high) => low + (high - low) * roll();
const whole = (roll, low, high) => Math.floor(between(roll, low, high + 1));
const one = (roll, list) => list[whole(roll, 0, list.length - 1)];

// The least that the joints can do in any direction that they are for: six rows, or the place
// alone.
function smallest(arm, q) {
  const columns = jacobianColumns(arm, linkFrames(arm, q));
  const rows = columns.length >= 6 ? 6 : 3;
  return singular(columns, rows).values[rows - 1];
}

/**
 * Joint values to two decimals, well inside their ranges and away from singular poses.
 * @param {import("../../../../judge/geometry/arm.js").Arm} arm
 * @param {() => number} roll
 */
export function drawPose(arm, roll) {
  for (let i = 0; i < TRIES; i++) {
    const q = joints(arm).map((row) => {
      const [low, high] = range(arm.rows[row]).map((limit) =>
        Math.max(-WIDEST, Math.min(WIDEST, limit)),
      );
      return rounded(low + (high - low) * between(roll, 0.1, 0.9), 2);
    });
    if (smallest(arm, q) > SMALLEST) return q;
  }
  return homeOf(arm);
}

const text = (values) => values.join(", ");
const rowsOf = ({ x, y, z, o }) =>
  [0, 1, 2].map((i) => [x[i], y[i], z[i], o[i]].map((v) => rounded(v, 8)));
const tipOf = (arm, q) => linkFrames(arm, q).at(-1);

// What each series asks: the arms that suit it, and how its fields are drawn.
const SERIES = {
  jacobian: { suits: () => true, draw: (arm, roll) => ({ q: text(drawPose(arm, roll)) }) },
  torques: {
    suits: (arm) => arm.rows.every((row) => row.body),
    draw(arm, roll) {
      const q = drawPose(arm, roll);
      const force = [0, 0, 0];
      force[whole(roll, 0, 2)] = (one(roll, [-1, 1]) * whole(roll, 10, 40)) / 2;
      return { q: text(q), wrench: text([...force, 0, 0, 0]) };
    },
  },
  branches: { suits: ({ key }) => CLOSED.includes(key), draw: drawTarget },
  pose: { suits: () => true, draw: drawTarget },
  trace: { suits: (arm) => joints(arm).length === 6, draw: drawCircle },
};

function drawTarget(arm, roll) {
  const tip = tipOf(arm, drawPose(arm, roll));
  const asked = joints(arm).length >= 6 ? rowsOf(tip) : [tip.o.map((v) => rounded(v, 6))];
  return { target: asked.map(text).join("\n") };
}

function drawCircle(arm, roll) {
  for (let i = 0; i < 50; i++) {
    const q = drawPose(arm, roll);
    const radius = whole(roll, 5, 10) / 100;
    const plane = one(roll, ["zy", "zx"]);
    const run = traceCircle(arm, q, { normal: plane === "zy" ? "x" : "y", radius, count: 61 });
    if (run.stray < 1e-4) return { q: text(q), radius: String(radius), plane };
  }
  return { q: text(homeOf(arm)), radius: "0.05" };
}

/**
 * Question n of a series: the fields of the judge's question, and where it is about an arm of its
 * own, that arm.
 * @param {string} ask
 * @param {number} n
 * @param {any[]} arms the judge's
 * @returns {{ asked: Partial<import("../question.js").Question>, arm: any, along?: number[] }}
 */
export function questionOf(ask, n, arms) {
  const roll = rolls(`${ask} ${n}`);
  if (ask === "table") return drawTable(roll);
  const { suits, draw } = SERIES[ask];
  const arm = one(roll, arms.filter(suits));
  return { asked: { ask, arm: arm.key, ...draw(arm, roll) }, arm };
}

export const TOPICS = ["jacobian", "torques", "table", "branches", "pose", "trace"];

// An arm of four joints, to be described by its axes; each joint moves the tip in a way of its own.
function drawTable(roll) {
  for (;;) {
    const rows = Array.from({ length: 4 }, (_, i) => drawRow(roll, i === 3));
    const along = rows.map(() => rounded(0.05 * whole(roll, -4, 4), 2));
    const arm = { name: "Arm of the question", home: [0, 0, 0, 0], rows };
    const slides = rows.filter(({ kind }) => kind === "prismatic").length;
    const bent = rows.slice(0, 3).every(({ alpha, a }) => alpha || a);
    const columns = jacobianColumns(arm, linkFrames(arm, [0.3, 0.5, 0.7, 0.9]));
    if (slides < 2 && bent && singular(columns).values[3] > 0.05) {
      return { asked: { ask: "table", arm: OWN, table: tableText(arm) }, arm, along };
    }
  }
}

const RIGHT = Math.PI / 2;
const drawRow = (roll, last) => ({
  kind: one(roll, ["revolute", "revolute", "prismatic"]),
  a: one(roll, [0, 0, 0.2, 0.3, 0.4, 0.5]),
  alpha: last ? 0 : one(roll, [0, RIGHT, -RIGHT]),
  d: one(roll, [0, 0, 0.1, 0.2, 0.3]),
  theta: one(roll, [0, 0, RIGHT, -RIGHT]),
  lower: null,
  upper: null,
});

// A table as the judge reads it: a α d θ, with the joints' variables.
const tableText = ({ rows }) =>
  rows
    .map(({ kind, a, alpha, d, theta }, i) => {
      const entries = [a, angle(alpha), d, angle(theta)];
      const at = kind === "revolute" ? 3 : 2;
      entries[at] = `q${i + 1}${entries[at] === "0" || entries[at] === 0 ? "" : `+${entries[at]}`}`;
      return entries.join(", ");
    })
    .join("\n");

/** @type {[number, string][]} */
const NAMES = [
  [0, "0"],
  [RIGHT, "pi/2"],
  [-RIGHT, "-pi/2"],
  [Math.PI, "pi"],
  [-Math.PI, "-pi"],
];
export const angle = (value) =>
  NAMES.find(([known]) => Math.abs(known - value) < 1e-12)?.[1] ?? String(rounded(value, 4));
