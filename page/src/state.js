// The explorer's state, the values derived from it, and the store that holds both. Every state
// comes from one event, which also resets the fields that depend on what it changed.

import {
  carryOverJoints,
  isJointVector,
  homeConfiguration,
  findRowsFault,
  isSameRow,
  makeTypedArm,
} from "../../judge/geometry/arm.js";
import {
  computeHoldingTorques,
  jacobianColumns,
  movingRows,
  potentialEnergy,
  linkFrames,
  minus,
  norm,
  computeWrenchTorques,
} from "../../judge/geometry/kinematics.js";
import { determinant, simplifyBasis, decomposeSingular } from "../../judge/geometry/linear.js";
import { pick, taskRows } from "../../judge/geometry/task_rows.js";
import { blendTables } from "./blend.js";
import { countRank } from "./statements.js";

/** @typedef {import("../../judge/geometry/arm.js").Arm} Arm */
/**
 * @typedef {object} Frame a coordinate frame: three unit axes and the origin, in base axes
 * @property {number[]} x
 * @property {number[]} y
 * @property {number[]} z
 * @property {number[]} o
 */
/**
 * @typedef {object} Branch one solution of inverse kinematics
 * @property {number[]} q
 * @property {string} [label] its name, if Python gave one
 */
/**
 * @typedef {object} BranchSet the solutions for one pose of the tip
 * @property {Branch[]} list
 * @property {{ moving: number[], q: number[] }[]} families members of the list that stand for
 *   infinitely many solutions, with the indices in q of the joints that can move
 * @property {number} lockedJoint index in q of the joint that was kept still; -1 for none
 * @property {Frame} target the pose of the tip
 * @property {boolean} hasOrientation false if only the position of the tip is solved for
 */
/**
 * @typedef {object} TipHold how the reader holds the tip: dragged towards a target, or pinned
 * @property {number[]} [target] point that a dragged tip follows
 * @property {boolean} [moving] whether a dragged tip is still on its way
 * @property {string[]} [stops] why a dragged tip cannot reach the target
 * @property {number} [short] distance in m from a stopped tip to the target
 * @property {{ direction: number[], share: number }[]} [fading] directions that are being lost
 * @property {Frame} [pinned] pose at which the tip is pinned
 * @property {boolean} [turns] whether a pinned tip keeps its orientation too
 * @property {number} [free] dimension of the null space of a pinned tip
 */
/**
 * @typedef {object} State
 * @property {Arm} arm
 * @property {Arm} base the listed arm that `arm` is, or from which its table was edited
 * @property {Arm} reference the arm drawn as a ghost behind an edited table
 * @property {number[]} q joint values, rad or m
 * @property {number[]} wrench force and moment of the world on the tool, at the tip, in base axes
 * @property {"deg" | "rad"} unit of displayed angles
 * @property {string} view name of the open tab
 * @property {"all" | "ends"} frames which frames are drawn
 * @property {{ normal: "x" | "y" | "z", radius: number }} circle the circle that Play draws
 * @property {number[][] | null} trace joint values along a path
 * @property {number[][] | null} wantedPath points of the whole path that the tip should follow
 * @property {number} progress position along the trace, 0 to 1
 * @property {import("./homework_run.js").Run[]} runs simulated runs of the homework's circle; if
 *   empty, the one that the homework asks for
 * @property {number} chosenRun index of the run that is played
 * @property {number[] | null} runStart joint values at which the runs begin
 * @property {{ points: number[][], colour: string }[] | null} tipPaths paths of the tip in the runs
 * @property {boolean} playing
 * @property {BranchSet | null} branches
 * @property {number | null} highlightedBranch index of the branch under the pointer
 * @property {number | null} highlightedRow row of the table under the pointer
 * @property {boolean} dragging whether a pointer drags something in the picture
 * @property {TipHold | null} tipHold
 * @property {number[] | null} answer numbers of a link to compare with those of the open tab, at
 *   these joint values: a Jacobian row by row, or torques
 * @property {number[] | null} mark point of a link to compare the tip with
 * @property {{ rows: Arm["rows"], share: number } | null} blended table towards which the arm is a
 *   share of the way from the reference
 * @property {boolean} keepOrientation whether a dragged tip keeps its orientation
 * @property {object[]} past undo steps
 * @property {object[]} future redo steps
 */

export const EMPTY = {
  trace: null,
  wantedPath: null,
  tipPaths: null,
  progress: 0,
  playing: false,
  branches: null,
  highlightedBranch: null,
  highlightedRow: null,
  tipHold: null,
  mark: null,
  answer: null,
  blended: null,
  runs: [],
  chosenRun: 0,
  runStart: null,
};
const PLAYBACK_FIELDS = ["wantedPath", "progress", "playing"];
// If a field changes, its dependent fields go back to EMPTY, unless the event sets them.
const DEPENDENT_FIELDS = {
  arm: Object.keys(EMPTY),
  q: ["answer"],
  wrench: ["answer"],
  circle: ["trace", ...PLAYBACK_FIELDS],
  trace: PLAYBACK_FIELDS,
  branches: ["highlightedBranch"],
  view: ["playing", "highlightedBranch", "highlightedRow"],
};

// the fields that undo restores
const UNDO_FIELDS = ["arm", "base", "reference", "q", "wrench", "runs", "chosenRun"];
const MAX_UNDO_STEPS = 200;

// The change that each kind of event makes to the state. A handler returns null for an event that
// the state does not allow.
const EVENT_HANDLERS = {
  selectArm: (_, { arm, q }) => selectArm(arm, q),
  editTable: (state, { rows, rowBefore }) => editTable(state, rows, rowBefore),
  replaceTable: (state, { rows }) => replaceTable(state, rows),
  blendTables: (state, { rows, share }) => blendTables(state, rows, share),
  moveJoints: (state, { q, tipHold = null }) =>
    isJointVector(state.arm, q) ? { q, tipHold, playing: false } : null,
  glide: (state, { q }) => (isJointVector(state.arm, q) ? { q } : null),
  seek: (state, { progress }) => moveAlongTrace(state, progress),
  setPlaying: (state, { on }) => (on && !state.trace ? null : { playing: on }),
  setWrench: (state, { wrench }) =>
    wrench.length === 6 && wrench.every(Number.isFinite) ? { wrench } : null,
  setCircle: (state, { type: _, ...circle }) => ({ circle: { ...state.circle, ...circle } }),
  setTrace: (state, { arm, circle, path, wantedPath }) =>
    arm === state.arm && circle === state.circle
      ? { trace: path, wantedPath, progress: 0, q: path[0] }
      : null,
  setBranches: (state, { arm, branches }) => (arm === state.arm ? { branches } : null),
  setFields: (state, { type: _, gesture: __, ...patch }) => requireKnownFields(state, patch),
  replaceState: (state, { type: _, ...patch }) =>
    isJointVector(patch.arm ?? state.arm, patch.q ?? state.q)
      ? requireKnownFields(state, patch)
      : null,
  undo: (state) => stepThroughHistory(state, "past", "future"),
  redo: (state) => stepThroughHistory(state, "future", "past"),
};

// Return the patch, or throw an error if the state has no field of one of its names.
function requireKnownFields(state, patch) {
  const unknown = Object.keys(patch).filter((key) => !Object.hasOwn(state, key));
  if (!unknown.length) return patch;
  const known = Object.keys(state).join(", ");
  throw new Error(`the state has no field ${unknown.join(", ")}; expected some of ${known}`);
}

/**
 * Return the state after an event.
 * An undo step is recorded for changes by the reader. Consecutive events with the same `gesture`
 * share one step.
 * @param {State} state
 * @param {any} event its `type` is a key of EVENT_HANDLERS
 * @returns {State}
 */
function reduceState(state, event) {
  const patch = EVENT_HANDLERS[event.type](state, event);
  if (!patch) return state;
  const changed = Object.keys(patch).filter((key) => patch[key] !== state[key]);
  if (!changed.length) return state;
  const dropped = changed
    .flatMap((key) => DEPENDENT_FIELDS[key] ?? [])
    .filter((key) => !(key in patch));
  const next = {
    ...state,
    ...Object.fromEntries(dropped.map((key) => [key, EMPTY[key]])),
    ...patch,
  };
  return recordUndoStep(state, setRunStart(next), event);
}

// Let the homework's runs begin where the arm stands when their view opens. They keep that start
// while the arm is moved.
const setRunStart = (state) =>
  state.view === "homework" && !state.runStart ? { ...state, runStart: state.q } : state;

function recordUndoStep(state, next, { type, gesture = null }) {
  if (
    ["undo", "redo", "seek", "setTrace"].includes(type) ||
    UNDO_FIELDS.every((key) => state[key] === next[key])
  )
    return next;
  if (gesture !== null && state.past.at(-1)?.gesture === gesture) {
    next.future = [];
    return next;
  }
  const past = [...state.past, makeUndoStep(state, gesture)].slice(-MAX_UNDO_STEPS);
  return { ...next, past, future: [] };
}

const makeUndoStep = (state, gesture) => ({
  gesture,
  ...Object.fromEntries(UNDO_FIELDS.map((key) => [key, state[key]])),
});

function stepThroughHistory(state, from, to) {
  const step = state[from].at(-1);
  if (!step) return null;
  const { gesture: _, ...kept } = step;
  return {
    ...kept,
    playing: false,
    [from]: state[from].slice(0, -1),
    [to]: [...state[to], makeUndoStep(state, null)],
  };
}

// Select another arm of the list, at its home configuration unless q is given.
function selectArm(arm, q) {
  const joints = isJointVector(arm, q) ? q : homeConfiguration(arm);
  return { arm, base: arm, reference: arm, q: joints };
}

// Replace the rows of the arm. `rowBefore` maps each new row to its old index, so that joints keep
// their values.
function editTable(state, rows, rowBefore = (row) => row) {
  if (findRowsFault(rows)) return null;
  const { rows: before } = state.arm;
  if (rows.length === before.length && rows.every((row, i) => isSameRow(row, before[i])))
    return null;
  const arm = makeTypedArm(rows, state.base);
  return { arm, q: carryOverJoints(state.arm, state.q, arm, rowBefore) };
}

// Show the arm of a whole new table, with every joint at 0.
function replaceTable({ base }, rows) {
  if (findRowsFault(rows)) return null;
  const typed = makeTypedArm(rows, base);
  const arm = typed === base ? base : { ...typed, home: [] };
  return { arm, q: movingRows(arm).map(() => 0) };
}

function moveAlongTrace({ trace, arm }, progress) {
  if (!trace || !trace.every((q) => q.length === trace[0].length) || !isJointVector(arm, trace[0]))
    return null;
  const k = Math.min(trace.length - 2, Math.floor(progress * (trace.length - 1)));
  const rest = progress * (trace.length - 1) - k;
  return { progress, q: trace[k].map((v, i) => v + rest * (trace[k + 1][i] - v)) };
}

/**
 * Return the state of an explorer that has just been opened.
 * @param {Partial<State> & { arm: Arm, q: number[] }} fields
 * @returns {State}
 */
export const makeInitialState = (fields) =>
  setRunStart({
    base: fields.arm,
    reference: fields.arm,
    wrench: [0, 0, 0, 0, 0, 0],
    unit: "deg",
    view: "pose",
    frames: "ends",
    circle: { normal: "x", radius: 0.1 },
    keepOrientation: false,
    dragging: false,
    past: [],
    future: [],
    ...EMPTY,
    ...fields,
  });

/** Values computed from an arm, joint values and a wrench, each at its first use. */
class Derived {
  #computed = new Map();

  constructor(arm, q, wrench) {
    this.arm = arm;
    this.q = q;
    this.wrench = wrench;
  }

  #computeOnce(name, compute) {
    if (!this.#computed.has(name)) this.#computed.set(name, compute());
    return this.#computed.get(name);
  }

  get frames() {
    return this.#computeOnce("frames", () => linkFrames(this.arm, this.q));
  }
  get columns() {
    return this.#computeOnce("columns", () => jacobianColumns(this.arm, this.frames));
  }
  // Singular values of the task rows and the left singular vectors, as motions (v, ω).
  get taskAxes() {
    return this.#computeOnce("taskAxes", () => {
      const rows = taskRows(this.arm);
      const picked = this.columns.map((column) => pick(column, rows));
      const { values, vectors } = decomposeSingular(picked, rows.length);
      const asMotion = (vector) => [0, 1, 2, 3, 4, 5].map((i) => vector[rows.indexOf(i)] ?? 0);
      return { values, vectors: vectors.map(asMotion) };
    });
  }
  // Singular values and left singular vectors of the linear rows.
  get linearAxes() {
    const linearRows = () => this.columns.map((column) => column.slice(0, 3));
    return this.#computeOnce("linearAxes", () => decomposeSingular(linearRows(), 3));
  }
  get singularValues() {
    return this.taskAxes.values;
  }
  get rank() {
    return countRank(this.singularValues);
  }
  // Tip motions that no joint rates produce, in the basis with the most zeros.
  get lostMotions() {
    return this.#computeOnce("lostMotions", () =>
      simplifyBasis(this.taskAxes.vectors.slice(this.rank)),
    );
  }
  get determinant() {
    const rows = taskRows(this.arm);
    const picked = () => this.columns.map((column) => pick(column, rows));
    return this.#computeOnce("determinant", () => determinant(picked()));
  }
  get manipulability() {
    const { singularValues, columns } = this;
    const count = Math.min(singularValues.length, columns.length);
    return singularValues.slice(0, count).reduce((p, v) => p * v, 1);
  }
  // Torques that hold the links against gravity, in N m or N.
  get gravityTorques() {
    return this.#computeOnce("gravityTorques", () => computeHoldingTorques(this.arm, this.frames));
  }
  // Potential energy of the links in J.
  get potentialEnergy() {
    return potentialEnergy(this.arm, this.frames);
  }
  // Torques that the wrench of the world exerts, in N m or N.
  get wrenchTorques() {
    return this.#computeOnce("wrenchTorques", () =>
      computeWrenchTorques(this.columns, this.wrench),
    );
  }
  get torques() {
    return this.gravityTorques.map((g, i) => g - this.wrenchTorques[i]);
  }
}

// Return the distance (m) and turn (rad) from the tip to the pose of the branches, or null if the
// tip is there.
export function measureTipOffset({ branches }, { frames }) {
  if (!branches) return null;
  const { x, y, z, o } = frames.at(-1);
  const distance = norm(minus(o, branches.target.o));
  const turn = branches.hasOrientation
    ? Math.max(...Object.entries({ x, y, z }).map(([k, v]) => norm(minus(v, branches.target[k]))))
    : 0;
  return distance > 5e-4 || turn > 2e-3 ? { distance, turn } : null;
}

export class Store {
  #listeners = new Set();

  /** @param {State} state */
  constructor(state) {
    this.state = state;
    this.derived = new Derived(state.arm, state.q, state.wrench);
  }

  // Apply an event and notify every listener of the changed fields and their cause. Returns whether
  // anything changed.
  dispatch(event, by = "reader") {
    const before = this.state;
    const state = reduceState(before, event);
    if (state === before) return false;
    const changed = new Set(Object.keys(state).filter((key) => state[key] !== before[key]));
    this.state = state;
    if (["arm", "q", "wrench"].some((key) => changed.has(key))) {
      this.derived = new Derived(state.arm, state.q, state.wrench);
    }
    for (const listener of [...this.#listeners]) listener(changed, by);
    return true;
  }

  // Call `listener` after each change until the signal is aborted.
  listen(listener, signal) {
    this.#listeners.add(listener);
    signal?.addEventListener("abort", () => this.#listeners.delete(listener), { once: true });
  }
}
