// What the explorer shows now, what follows from it, and who wants to know. Every state is the
// result of one transition, which drops what depends on what changed.

import {
  carryOverJoints,
  isJointVector,
  homePose,
  findRowsFault,
  isSameRow,
  makeTypedArm,
} from "../../judge/geometry/arm.js";
import {
  gravityTorque,
  jacobianColumns,
  potentialEnergy,
  linkFrames,
  minus,
  norm,
  wrenchTorque,
} from "../../judge/geometry/kinematics.js";
import { determinant, simplifyBasis, decomposeSingular } from "../../judge/geometry/linear.js";
import { asked, rankOf } from "./verdicts.js";

/** @typedef {import("../../judge/geometry/arm.js").Arm} Arm */
/** @typedef {{ x: number[], y: number[], z: number[], o: number[] }} Frame */
/**
 * @typedef {object} Ways
 * @property {{ q: number[], label?: string }[]} list
 * @property {{ moving: number[], q: number[] }[]} families those of the list that stand for
 *   infinitely many
 * @property {number} held the joint, as its index in q, that was held; -1 for none
 * @property {Frame} target where they lead
 * @property {boolean} whole whether the tool's direction counts
 */
/**
 * @typedef {object} State
 * @property {Arm} arm the arm shown
 * @property {Arm} base the arm of the list that it is, or that its table began as
 * @property {Arm} reference the arm behind the table, as a ghost
 * @property {number[]} q joint values, rad or m
 * @property {number[]} wrench force and moment on the tool, by the world, at the tip, base axes
 * @property {"deg" | "rad"} unit of the angles shown
 * @property {string} view the open tab
 * @property {"all" | "ends"} frames which frames are drawn
 * @property {{ normal: "x" | "y" | "z", radius: number }} circle that Play draws
 * @property {number[][] | null} trace joint vectors along a path
 * @property {number[][] | null} wanted the points that the tip was to go through, all the way round
 * @property {number} at the place along the trace, 0 to 1
 * @property {import("./homework_run.js").Run[]} runs of the homework's circle
 * @property {{ points: number[][], colour: string }[] | null} paths of the tip, drawn beside the
 *   trace
 * @property {boolean} playing
 * @property {Ways | null} ways
 * @property {number | null} highlighted the way under the reader's hand
 * @property {number | null} lit the row under the reader's hand
 * @property {boolean} dragging whether the picture is held by a pointer
 * @property {any} hold what is being dragged, and why it stops
 * @property {number[] | null} mark a point that a link asks the reader to compare the tip with
 * @property {boolean} keepTurn whether a dragged tip keeps its orientation
 * @property {object[]} past
 * @property {object[]} future
 */

export const EMPTY = {
  trace: null,
  wanted: null,
  paths: null,
  at: 0,
  playing: false,
  ways: null,
  highlighted: null,
  lit: null,
  hold: null,
  mark: null,
};
// What a field takes with it when it changes: those fields go back to EMPTY, unless the event sets
// them.
const ALONG = ["wanted", "at", "playing"];
const DROPS = {
  arm: Object.keys(EMPTY),
  circle: ["trace", ...ALONG],
  trace: ALONG,
  ways: ["highlighted"],
  view: ["playing", "highlighted", "lit"],
};

const KEPT = ["arm", "base", "reference", "q", "wrench"]; // what undo brings back
const STEPS = 200; // that can be undone

// The patch that each kind of event makes; null where the event makes no sense in this state.
const EVENTS = {
  select: (state, { arm, q, reference = arm }) => selectArm(state, arm, q, reference),
  edit: (state, { rows, q, rowBefore }) => editTable(state, rows, q, rowBefore),
  move: (state, { q, hold = null }) =>
    isJointVector(state.arm, q) ? { q, hold, playing: false } : null,
  glide: (state, { q }) => (isJointVector(state.arm, q) ? { q } : null),
  play: (state, { at }) => along(state, at),
  playing: (state, { on }) => (on && !state.trace ? null : { playing: on }),
  push: (state, { wrench }) =>
    wrench.length === 6 && wrench.every(Number.isFinite) ? { wrench } : null,
  circle: (state, { type: _, ...circle }) => ({ circle: { ...state.circle, ...circle } }),
  traced: (state, { arm, circle, path, wanted }) =>
    arm === state.arm && circle === state.circle
      ? { trace: path, wanted, at: 0, q: path[0] }
      : null,
  ways: (state, { arm, ways }) => (arm === state.arm ? { ways } : null),
  show: (state, { type: _, ...patch }) => patch,
  set: (state, { type: _, ...patch }) =>
    isJointVector(patch.arm ?? state.arm, patch.q ?? state.q) ? patch : null,
  undo: (state) => travel(state, "past", "future"),
  redo: (state) => travel(state, "future", "past"),
};

/**
 * The state after an event { type, … }. What the reader can undo is remembered; events with the
 * same `gesture` that follow one another are one step.
 * @param {State} state
 * @param {any} event
 * @returns {State}
 */
function transition(state, event) {
  const patch = EVENTS[event.type](state, event);
  if (!patch) return state;
  const changed = Object.keys(patch).filter((key) => patch[key] !== state[key]);
  if (!changed.length) return state;
  const dropped = changed.flatMap((key) => DROPS[key] ?? []).filter((key) => !(key in patch));
  const next = {
    ...state,
    ...Object.fromEntries(dropped.map((key) => [key, EMPTY[key]])),
    ...patch,
  };
  return remembered(state, next, event);
}

function remembered(state, next, { type, gesture = null }) {
  if (["undo", "redo", "play"].includes(type) || KEPT.every((key) => state[key] === next[key]))
    return next;
  if (gesture !== null && state.past.at(-1)?.gesture === gesture) {
    next.future = [];
    return next;
  }
  const step = { gesture, ...Object.fromEntries(KEPT.map((key) => [key, state[key]])) };
  return { ...next, past: [...state.past, step].slice(-STEPS), future: [] };
}

function travel(state, from, to) {
  const step = state[from].at(-1);
  if (!step) return null;
  const { gesture: _, ...kept } = step;
  const here = { gesture: null, ...Object.fromEntries(KEPT.map((key) => [key, state[key]])) };
  return { ...kept, playing: false, [from]: state[from].slice(0, -1), [to]: [...state[to], here] };
}

// Another arm of the list: where it stands first, and nothing that was said of the one before.
function selectArm(state, arm, q, reference) {
  return { arm, base: arm, reference, q: isJointVector(arm, q) ? q : homePose(arm) };
}

// The arm with other rows; joints keep their values by row.
function editTable(state, rows, q, rowBefore = (row) => row) {
  if (findRowsFault(rows)) return null;
  const { rows: before } = state.arm;
  if (rows.length === before.length && rows.every((row, i) => isSameRow(row, before[i])))
    return null;
  const arm = makeTypedArm(rows, state.base);
  return {
    arm,
    q: isJointVector(arm, q) ? q : carryOverJoints(state.arm, state.q, arm, rowBefore),
  };
}

function along({ trace, arm }, at) {
  if (!trace || !trace.every((q) => q.length === trace[0].length) || !isJointVector(arm, trace[0]))
    return null;
  const k = Math.min(trace.length - 2, Math.floor(at * (trace.length - 1)));
  const rest = at * (trace.length - 1) - k;
  return { at, q: trace[k].map((v, i) => v + rest * (trace[k + 1][i] - v)) };
}

/**
 * The state in which an explorer starts.
 * @param {Partial<State> & { arm: Arm, q: number[] }} given
 * @returns {State}
 */
export const startingState = (given) => ({
  base: given.arm,
  reference: given.arm,
  wrench: [0, 0, 0, 0, 0, 0],
  unit: "deg",
  view: "pose",
  frames: "ends",
  circle: { normal: "x", radius: 0.1 },
  keepTurn: false,
  dragging: false,
  runs: [],
  past: [],
  future: [],
  ...EMPTY,
  ...given,
});

// Everything that follows from an arm, a joint vector and a wrench, each computed when it is first
// asked for.
class Derived {
  #known = new Map();

  constructor(arm, q, wrench) {
    this.arm = arm;
    this.q = q;
    this.wrench = wrench;
  }

  #once(name, compute) {
    if (!this.#known.has(name)) this.#known.set(name, compute());
    return this.#known.get(name);
  }

  get frames() {
    return this.#once("frames", () => linkFrames(this.arm, this.q));
  }
  get columns() {
    return this.#once("columns", () => jacobianColumns(this.arm, this.frames));
  }
  // The columns' first rows.
  rows(count) {
    return this.columns.map((column) => column.slice(0, count));
  }
  // Singular values and left singular vectors of the rows that the arm is for: six, or v alone
  // below six joints.
  get task() {
    const rows = asked(this.arm);
    return this.#once("task", () => decomposeSingular(this.rows(rows), rows));
  }
  get linear() {
    return this.#once("linear", () => decomposeSingular(this.rows(3), 3));
  }
  get values() {
    return this.task.values;
  }
  get rank() {
    return rankOf(this.values);
  }
  // The motions that no joint rates give, as plain as they can be said.
  get lost() {
    return this.#once("lost", () =>
      simplifyBasis(this.task.vectors.slice(this.rank).map((v) => [...v, 0, 0, 0].slice(0, 6))),
    );
  }
  get determinant() {
    const rows = asked(this.arm);
    return this.#once("determinant", () => determinant(this.rows(rows)));
  }
  get manipulability() {
    const { values, columns } = this;
    return values.slice(0, Math.min(values.length, columns.length)).reduce((p, v) => p * v, 1);
  }
  get gravity() {
    return this.#once("gravity", () => gravityTorque(this.arm, this.frames));
  }
  // Potential energy of the links, J.
  get energy() {
    return potentialEnergy(this.arm, this.frames);
  }
  get push() {
    return this.#once("push", () => wrenchTorque(this.columns, this.wrench));
  }
  get torque() {
    return this.gravity.map((g, i) => g - this.push[i]);
  }
}

// How far the tip is from the pose that the ways lead to (m, rad), or null where it is there.
export function leftBehind({ ways }, { frames }) {
  if (!ways) return null;
  const { x, y, z, o } = frames.at(-1);
  const far = norm(minus(o, ways.target.o));
  const turned = ways.whole
    ? Math.max(...Object.entries({ x, y, z }).map(([k, v]) => norm(minus(v, ways.target[k]))))
    : 0;
  return far > 5e-4 || turned > 2e-3 ? { far, turned } : null;
}

export class Store {
  #listeners = new Set();

  /** @param {State} state */
  constructor(state) {
    this.state = state;
    this.derived = new Derived(state.arm, state.q, state.wrench);
  }

  // Let an event happen, and tell everyone which fields changed and who did it.
  dispatch(event, by = "reader") {
    const before = this.state;
    const state = transition(before, event);
    if (state === before) return false;
    const changed = new Set(Object.keys(state).filter((key) => state[key] !== before[key]));
    this.state = state;
    if (["arm", "q", "wrench"].some((key) => changed.has(key))) {
      this.derived = new Derived(state.arm, state.q, state.wrench);
    }
    for (const listener of [...this.#listeners]) listener(changed, by);
    return true;
  }

  // Hear of changes until the signal is aborted.
  listen(listener, signal) {
    this.#listeners.add(listener);
    signal?.addEventListener("abort", () => this.#listeners.delete(listener), { once: true });
  }
}
