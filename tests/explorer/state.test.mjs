// The explorer's state after each event: fields that depend on a change are reset.

import assert from "node:assert/strict";
import { test } from "node:test";
import { homeConfiguration, MAX_ROWS, TYPED_ARM_NAME } from "../../judge/geometry/arm.js";
import { EMPTY, measureTipOffset, makeInitialState, Store } from "../../page/src/state.js";
import { DEFAULT_RUN } from "../../page/src/homework_run.js";
import { makeStartingRun } from "../../page/src/views/homework_words.js";
import { findBranches } from "../../page/src/motion.js";
import { describeRank, describeTable } from "../../page/src/statements.js";
import { ELBOW, PANDA, STANFORD } from "./arms.mjs";

const start = (arm = PANDA) => new Store(makeInitialState({ arm, q: [...arm.home] }));
const path = [PANDA.home, PANDA.home.map((v) => v + 0.1)];

// Return a store whose Panda is playing a circle, with each field that a change resets.
function playing() {
  const store = start();
  const { arm, circle } = store.state;
  store.dispatch({ type: "setTrace", arm, circle, path, wantedPath: [[0, 0, 0]] });
  store.dispatch({ type: "setBranches", arm, branches: findBranches(PANDA, PANDA.home) });
  store.dispatch({ type: "setPlaying", on: true });
  store.dispatch({ type: "setFields", highlightedRow: 6, highlightedBranch: 0, tipPaths: [], mark: [0, 0, 1], answer: [1, 2, 3, 4, 5, 6, 7], blended: { rows: PANDA.rows, share: 0.5 }, progress: 0.5, tipHold: { moving: true }, runs: [DEFAULT_RUN, DEFAULT_RUN], chosenRun: 1, runStart: PANDA.home });
  for (const [key, none] of Object.entries(EMPTY)) assert.notDeepEqual(store.state[key], none, key);
  return store;
}

const getResettable = (state) => Object.fromEntries(Object.keys(EMPTY).map((key) => [key, state[key]]));

for (const [how, event] of [
  ["chosen", { type: "selectArm", arm: ELBOW }],
  ["linked to", { type: "replaceState", arm: ELBOW, base: ELBOW, reference: ELBOW, q: ELBOW.home }],
]) {
  test(`an arm that is ${how} resets the dependent fields`, () => {
    const store = playing();
    store.dispatch(event);
    const { base, reference, q } = store.state;
    assert.deepEqual(getResettable(store.state), EMPTY);
    assert.deepEqual([base, reference, q], [ELBOW, ELBOW, ELBOW.home]);
  });
}

test("a new radius resets the drawn circle", () => {
  const store = playing();
  store.dispatch({ type: "setCircle", radius: 0.2 });
  const { trace, wantedPath, progress, playing: on } = store.state;
  assert.deepEqual({ trace, wantedPath, progress, playing: on }, { trace: null, wantedPath: null, progress: 0, playing: false });
  assert.deepEqual(store.state.circle, { normal: "x", radius: 0.2 });
});

test("moving a joint stops playback and keeps the path", () => {
  const store = playing();
  store.dispatch({ type: "moveJoints", q: PANDA.home.map((v) => v + 0.2) });
  assert.deepEqual([store.state.playing, store.state.trace], [false, path]);
});

test("a typed answer is compared at its configuration and load only", () => {
  for (const event of [{ type: "moveJoints", q: PANDA.home.map((v) => v + 0.2) }, { type: "setWrench", wrench: [1, 0, 0, 0, 0, 0] }]) {
    const store = playing();
    store.dispatch(event);
    assert.equal(store.state.answer, null);
  }
});

test("playback ends at the last configuration of the trace", () => {
  const store = playing();
  store.dispatch({ type: "seek", progress: 1 });
  store.state.q.forEach((v, k) => assert.ok(Math.abs(v - path[1][k]) < 1e-12));
});

test("a gesture after an undo clears the redo steps", () => {
  const store = start();
  const move = (by, gesture) => store.dispatch({ type: "moveJoints", q: PANDA.home.map((v) => v + by), gesture });
  move(0.1, "first");
  move(0.2, "second");
  store.dispatch({ type: "undo" });
  assert.equal(store.state.future.length, 1);
  move(0.15, "first");
  assert.deepEqual(store.state.future, []);
});

test("events that do not fit the state change nothing", () => {
  const { home, rows: [row, ...rows] } = PANDA; // prettier-ignore
  const store = start();
  const { circle } = store.state;
  const tables = [[], [{ ...row, kind: "constructor" }, ...rows], [{ ...row, a: 1e308 }], [{ ...row, theta: NaN }], Array(MAX_ROWS + 1).fill(row)];
  for (const event of [
    { type: "setPlaying", on: true },
    { type: "setTrace", arm: ELBOW, circle, path: [ELBOW.home], wantedPath: [] }, // for the previous arm
    { type: "setBranches", arm: ELBOW, branches: { list: [] } },
    { type: "replaceState", arm: ELBOW, q: home },
    ...[[1, 2], home.map(() => NaN), null].map((q) => ({ type: "moveJoints", q })),
    ...tables.map((table) => ({ type: "editTable", rows: table })),
    { type: "undo" },
  ])
    assert.equal(store.dispatch(event), false, event.type);
  store.dispatch({ type: "replaceState", trace: [[0, 0, 0], [1, 1, 1]] });
  assert.equal(store.dispatch({ type: "seek", progress: 0.5 }), false, "the trace belongs to another arm");
});

const LIMITS = ["lower", "upper", "effort", "speed"];
const changeRow = (arm, i, entries) => arm.rows.map((row, k) => (k === i ? { ...row, ...entries } : row));

test("a changed length keeps the limits, not the masses", () => {
  const store = start();
  store.dispatch({ type: "editTable", rows: changeRow(PANDA, 2, { a: 0.088 }) });
  const { arm, reference, q } = store.state;
  assert.deepEqual([arm.name, reference.name, q], [TYPED_ARM_NAME, "Panda", PANDA.home]);
  arm.rows.forEach((row, i) => {
    for (const key of LIMITS) assert.equal(row[key], PANDA.rows[i][key]);
    assert.equal(row.body, undefined);
  });
  assert.match(describeTable(store.state, store.derived), /Its joints keep the limits of the Panda\.$/);
});

test("a changed angle drops the limits with a message", () => {
  const store = start();
  store.dispatch({ type: "editTable", rows: changeRow(PANDA, 2, { theta: 0.1 }) });
  const { arm } = store.state;
  for (const row of arm.rows) for (const key of LIMITS) assert.equal(row[key], null);
  assert.match(describeTable(store.state, store.derived), /The limits of the Panda are not those of this table/);
});

test("a changed offset of a slide drops the limits", () => {
  const store = start(STANFORD);
  store.dispatch({ type: "editTable", rows: changeRow(STANFORD, 2, { d: 0.1 }) });
  assert.ok(store.state.arm.rows.every(({ lower }) => lower === null));
});

test("a pasted table sets all joints to 0", () => {
  const store = start();
  store.dispatch({ type: "replaceTable", rows: changeRow(PANDA, 0, { d: 0.5 }) });
  assert.deepEqual(
    store.state.q,
    PANDA.home.map(() => 0),
  );
  assert.deepEqual(
    homeConfiguration(store.state.arm),
    PANDA.home.map(() => 0),
  );
  store.dispatch({ type: "replaceTable", rows: [{ ...PANDA.rows[0], a: NaN }] });
  assert.equal(store.state.arm.rows[0].d, 0.5);
});

test("the first table restores limits and masses", () => {
  const store = start();
  store.dispatch({ type: "editTable", rows: changeRow(PANDA, 2, { alpha: 0.1 }) });
  store.dispatch({ type: "editTable", rows: PANDA.rows.map((row) => ({ ...row })) });
  assert.equal(store.state.arm, PANDA, "the original rows restore the Panda with limits and masses");
});

test("the tip's offset from the branches is measured", () => {
  const q = [0.2, 1.2, -0.9];
  const store = start(ELBOW);
  store.dispatch({ type: "moveJoints", q });
  store.dispatch({ type: "setBranches", arm: ELBOW, branches: findBranches(ELBOW, q) });
  const measureOffset = (values) => {
    store.dispatch({ type: "moveJoints", q: values });
    return measureTipOffset(store.state, store.derived);
  };
  assert.ok(measureOffset([0.2, 1.2, -0.8]).distance > 0.02);
  for (const branch of store.state.branches.list) assert.equal(measureOffset(branch.q), null);
});

test("undo and redo treat a drag as one step", () => {
  const store = start(ELBOW);
  const move = (v, gesture) => store.dispatch({ type: "moveJoints", q: [v, 0.8, -1.5], gesture });
  for (const v of [0.1, 0.2, 0.3]) move(v, "drag 1");
  move(0.5, "drag 2");
  store.dispatch({ type: "selectArm", arm: STANFORD });
  for (const first of [0.5, 0.3, 0]) {
    store.dispatch({ type: "undo" });
    assert.deepEqual([store.state.arm, store.state.q[0]], [ELBOW, first]);
  }
  store.dispatch({ type: "redo" });
  assert.equal(store.state.q[0], 0.3);
  move(9);
  assert.deepEqual(store.state.future, [], "a new step clears the redo steps");
  move(8);
  store.dispatch({ type: "undo" });
  assert.equal(store.state.q[0], 9, "an event without a gesture is one step");
});

test("unknown fields are refused by name", () => {
  const store = start();
  for (const type of ["setFields", "replaceState"])
    assert.throws(() => store.dispatch({ type, veiw: "pose" }), /no field veiw; expected some of .*view/);
});

test("undo restores the chosen run and edited runs", () => {
  const store = start();
  const runs = [DEFAULT_RUN, { ...DEFAULT_RUN, steps: 250 }];
  store.dispatch({ type: "setFields", runs });
  store.dispatch({ type: "setFields", chosenRun: 1 });
  store.dispatch({ type: "undo" });
  assert.deepEqual([store.state.runs, store.state.chosenRun], [runs, 0]);
  store.dispatch({ type: "undo" });
  assert.deepEqual(store.state.runs, []);
  store.dispatch({ type: "redo" });
  assert.equal(store.state.runs, runs);
});

test("opening the homework records only its start", () => {
  const store = start();
  store.dispatch({ type: "setFields", view: "homework" });
  const { arm, circle } = store.state;
  store.dispatch({ type: "setTrace", arm, circle, path, wantedPath: null });
  store.dispatch({ type: "seek", progress: 1 });
  assert.deepEqual([store.state.runStart, store.state.past], [PANDA.home, []]);
});

test("listeners are called until their signal is aborted", () => {
  const store = start();
  const heard = [];
  const [one, two] = [new AbortController(), new AbortController()];
  store.listen((changed) => heard.push(["one", ...changed]), one.signal);
  store.listen((changed, by) => heard.push(["two", by]), two.signal);
  store.dispatch({ type: "setFields", unit: "rad" });
  one.abort();
  store.dispatch({ type: "setFields", unit: "deg" }, "python");
  assert.deepEqual(heard, [["one", "unit"], ["two", "reader"], ["two", "python"]]);
});

test("an arm without joints has derived values", () => {
  const still = { name: "post", home: [], rows: [{ ...ELBOW.rows[0], kind: "fixed" }] };
  const { derived } = start(still);
  assert.equal(describeRank(derived).text, "No joint moves this arm.");
  assert.deepEqual([derived.torques, derived.manipulability, findBranches(still, []).list], [[], 1, []]);
});

test("undoing the choice of an arm restores its base", () => {
  const store = start();
  store.dispatch({ type: "selectArm", arm: ELBOW });
  store.dispatch({ type: "undo" });
  assert.deepEqual([store.state.arm.name, store.state.base.name], [PANDA.name, PANDA.name]);
});

test("the starting run uses the arm's own circle", () => {
  const base = { ...PANDA, circle: { normal: "y", seconds: 20 } };
  assert.deepEqual(makeStartingRun(base, base), { ...DEFAULT_RUN, normal: "y", seconds: 20 });
  assert.equal(makeStartingRun({ ...base, rows: base.rows.slice(1) }, base), null);
  assert.equal(makeStartingRun(PANDA, PANDA), null);
});

test("a joint at half a turn gives no branch twice", () => {
  for (const joint of [0, 3, 5])
    for (const angle of [Math.PI, -Math.PI]) {
      const q = [0.3, -1.2, 1.1, -0.7, 0.9, 0.4].with(joint, angle);
      assert.equal(findBranches(STANFORD, q).list.length, 8, `${q}`);
    }
});
