// What the explorer shows after each event: whatever depends on what changed is dropped.

import assert from "node:assert/strict";
import { test } from "node:test";
import { MAX_ROWS, TYPED_ARM_NAME } from "../../judge/geometry/arm.js";
import { EMPTY, measureTipOffset, makeInitialState, Store } from "../../page/src/state.js";
import { findBranches } from "../../page/src/motion.js";
import { describeRank } from "../../page/src/verdicts.js";
import { ELBOW, PANDA, STANFORD } from "./arms.mjs";

const start = (arm = PANDA) => new Store(makeInitialState({ arm, q: [...arm.home] }));
const path = [PANDA.home, PANDA.home.map((v) => v + 0.1)];

// A Panda that plays a circle, with all that is said of it.
function playing() {
  const store = start();
  const { arm, circle } = store.state;
  store.dispatch({ type: "setTrace", arm, circle, path, wantedPath: [[0, 0, 0]] });
  store.dispatch({ type: "setBranches", arm, branches: findBranches(PANDA, PANDA.home, 20) });
  store.dispatch({ type: "setPlaying", on: true });
  store.dispatch({ type: "setFields", highlightedRow: 6, highlightedBranch: 0, tipPaths: [], mark: [0, 0, 1], progress: 0.5, hold: { kind: "tip" } });
  for (const [key, none] of Object.entries(EMPTY)) assert.notDeepEqual(store.state[key], none, key);
  return store;
}

const said = (state) => Object.fromEntries(Object.keys(EMPTY).map((key) => [key, state[key]]));

for (const [how, event] of [
  ["chosen", { type: "selectArm", arm: ELBOW }],
  ["linked to", { type: "replaceState", arm: ELBOW, base: ELBOW, reference: ELBOW, q: ELBOW.home }],
]) {
  test(`another arm that is ${how} drops what was said of the one before`, () => {
    const store = playing();
    store.dispatch(event);
    const { base, reference, q } = store.state;
    assert.deepEqual(said(store.state), EMPTY);
    assert.deepEqual([base, reference, q], [ELBOW, ELBOW, ELBOW.home]);
  });
}

test("another radius drops the circle that was drawn with the old one", () => {
  const store = playing();
  store.dispatch({ type: "setCircle", radius: 0.2 });
  const { trace, wantedPath, progress, playing: on } = store.state;
  assert.deepEqual({ trace, wantedPath, progress, playing: on }, { trace: null, wantedPath: null, progress: 0, playing: false });
  assert.deepEqual(store.state.circle, { normal: "x", radius: 0.2 });
});

test("a joint that the reader moves stops the play, and the path stays", () => {
  const store = playing();
  store.dispatch({ type: "moveJoints", q: PANDA.home.map((v) => v + 0.2) });
  assert.deepEqual([store.state.playing, store.state.trace], [false, path]);
});

test("a play ends at the trace's last pose", () => {
  const store = playing();
  store.dispatch({ type: "seek", progress: 1 });
  store.state.q.forEach((v, k) => assert.ok(Math.abs(v - path[1][k]) < 1e-12));
});

test("a gesture that goes on after an undo leaves nothing to redo", () => {
  const store = start();
  const move = (by, gesture) => store.dispatch({ type: "moveJoints", q: PANDA.home.map((v) => v + by), gesture });
  move(0.1, "first");
  move(0.2, "second");
  store.dispatch({ type: "undo" });
  assert.equal(store.state.future.length, 1);
  move(0.15, "first");
  assert.deepEqual(store.state.future, []);
});

test("what makes no sense here changes nothing", () => {
  const { home, rows: [row, ...rows] } = PANDA; // prettier-ignore
  const store = start();
  const { circle } = store.state;
  const tables = [[], [{ ...row, kind: "constructor" }, ...rows], [{ ...row, a: 1e308 }], [{ ...row, theta: NaN }], Array(MAX_ROWS + 1).fill(row)];
  for (const event of [
    { type: "setPlaying", on: true },
    { type: "setTrace", arm: ELBOW, circle, path: [ELBOW.home], wantedPath: [] }, // asked for before
    { type: "setBranches", arm: ELBOW, branches: { list: [] } },
    { type: "replaceState", arm: ELBOW, q: home },
    ...[[1, 2], home.map(() => NaN), null].map((q) => ({ type: "moveJoints", q })),
    ...tables.map((table) => ({ type: "editTable", rows: table })),
    { type: "undo" },
  ])
    assert.equal(store.dispatch(event), false, event.type);
  store.dispatch({ type: "replaceState", trace: [[0, 0, 0], [1, 1, 1]] });
  assert.equal(store.dispatch({ type: "seek", progress: 0.5 }), false, "a trace of another arm");
});

test("a typed arm has a name of its own and nothing that was not typed", () => {
  const store = start();
  store.dispatch({ type: "editTable", rows: PANDA.rows.map((row, i) => (i === 2 ? { ...row, a: 0.088 } : row)) });
  const { arm, reference, q } = store.state;
  assert.deepEqual([arm.name, reference.name, q], [TYPED_ARM_NAME, "Panda", PANDA.home]);
  for (const row of arm.rows) {
    for (const key of ["lower", "upper", "effort", "speed"]) assert.equal(row[key], null);
    assert.equal(row.body, undefined);
  }
  store.dispatch({ type: "editTable", rows: PANDA.rows.map((row) => ({ ...row })) });
  assert.equal(store.state.arm, PANDA, "typed back it is the Panda again, limits and masses with it");
});

test("ways are marked once the tip has left the pose, and come back with it", () => {
  const q = [0.2, 1.2, -0.9];
  const store = start(ELBOW);
  store.dispatch({ type: "moveJoints", q });
  store.dispatch({ type: "setBranches", arm: ELBOW, branches: findBranches(ELBOW, q) });
  const left = (values) => {
    store.dispatch({ type: "moveJoints", q: values });
    return measureTipOffset(store.state, store.derived);
  };
  assert.ok(left([0.2, 1.2, -0.8]).distance > 0.02);
  for (const way of store.state.branches.list) assert.equal(left(way.q), null);
});

test("undo and redo walk through what the reader did, a drag as one step", () => {
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
  assert.deepEqual(store.state.future, [], "another way was taken");
  move(8);
  store.dispatch({ type: "undo" });
  assert.equal(store.state.q[0], 9, "what belongs to no gesture is a step of its own");
});

test("views of one store hear the same, and no more once they are gone", () => {
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

test("an arm without a joint has numbers too", () => {
  const still = { name: "post", home: [], rows: [{ ...ELBOW.rows[0], kind: "fixed" }] };
  const { derived } = start(still);
  assert.equal(describeRank(derived).text, "No joint moves this arm.");
  assert.deepEqual([derived.torque, derived.manipulability, findBranches(still, []).list], [[], 1, []]);
});
