// One transition: whatever depends on what changed is dropped.

import assert from "node:assert/strict";
import { test } from "node:test";
import { MOST_ROWS, TYPED } from "../../judge/geometry/arm.js";
import { derive, DROPS, EMPTY, leftBehind, startingState, Store, transition } from "../../page/src/state.js";
import { otherWays } from "../../page/src/motion.js";
import { rankVerdict } from "../../page/src/verdicts.js";
import { ELBOW, PANDA, STANFORD } from "./arms.mjs";

const start = (arm = PANDA, more = {}) => startingState({ arm, q: [...arm.home], ...more });
const circle = { normal: "x", radius: 0.1 };
const traced = (state, path = [state.q, state.q.map((v) => v + 0.1)]) =>
  transition(state, { type: "traced", arm: state.arm, circle: state.circle, path, stray: 0.01, wanted: [[0, 0, 0]] });

test("another arm drops what was said of the one before", () => {
  let state = traced(start());
  state = transition(state, { type: "ways", arm: PANDA, ways: otherWays(PANDA, PANDA.home, 20) });
  state = transition(state, { type: "playing", on: true });
  state = transition(state, { type: "show", lit: 6, highlighted: 0, hold: { kind: "tip" } });
  const next = transition(state, { type: "select", arm: ELBOW });
  for (const key of DROPS.arm) assert.deepEqual(next[key], EMPTY[key], key);
  assert.equal(next.base, ELBOW);
  assert.equal(next.reference, ELBOW);
  assert.deepEqual(next.q, ELBOW.home);
});

test("a link to another arm keeps neither ways nor trace", () => {
  const state = transition(traced(start()), { type: "set", arm: ELBOW, base: ELBOW, reference: ELBOW, q: ELBOW.home });
  assert.equal(state.trace, null);
  assert.equal(state.ways, null);
});

test("a trace of another arm is not played", () => {
  const state = { ...start(), trace: [[0, 0, 0], [1, 1, 1]] };
  assert.equal(transition(state, { type: "play", at: 0.5 }), state);
  assert.equal(transition(start(), { type: "playing", on: true }).playing, false, "nothing to play");
});

test("answers that come after another arm was chosen are not taken", () => {
  const state = start(ELBOW);
  const late = { type: "traced", arm: PANDA, circle: state.circle, path: [PANDA.home], stray: 0, wanted: [] };
  assert.equal(transition(state, late), state);
  assert.equal(transition(state, { type: "ways", arm: PANDA, ways: { list: [] } }), state);
});

test("another radius drops the circle that was drawn with the old one", () => {
  const state = transition(traced(start()), { type: "circle", radius: 0.2 });
  assert.equal(state.trace, null);
  assert.deepEqual(state.circle, { normal: "x", radius: 0.2 });
});

test("a joint that the reader moves stops the play", () => {
  let state = transition(traced(start()), { type: "playing", on: true });
  assert.equal(state.playing, true);
  state = transition(state, { type: "move", q: state.q.map((v) => v + 0.2) });
  assert.equal(state.playing, false);
  assert.notEqual(state.trace, null, "the path stays, to be played again");
});

test("joint values that are none are refused", () => {
  const state = start();
  for (const q of [[1, 2], PANDA.home.map(() => NaN), null]) {
    assert.equal(transition(state, { type: "move", q }), state);
    assert.equal(transition(state, { type: "set", arm: ELBOW, q: PANDA.home }), state);
  }
});

test("a typed arm has a name of its own and nothing that was not typed", () => {
  const rows = PANDA.rows.map((row, i) => (i === 2 ? { ...row, a: 0.088 } : row));
  const state = transition(start(), { type: "edit", rows });
  assert.equal(state.arm.name, TYPED);
  assert.equal(state.reference.name, "Panda");
  for (const row of state.arm.rows) {
    for (const key of ["lower", "upper", "effort", "speed"]) assert.equal(row[key], null);
    assert.equal(row.body, undefined);
  }
  assert.deepEqual(state.q, PANDA.home, "it stands where the arm stood");
  const back = transition(state, { type: "edit", rows: PANDA.rows.map((row) => ({ ...row })) });
  assert.equal(back.arm, PANDA, "typed back it is the Panda again, limits and masses with it");
});

test("tables that are none are refused", () => {
  const state = start();
  const [row] = PANDA.rows;
  const bad = [[], [{ ...row, kind: "constructor" }], [{ ...row, a: 1e308 }], [{ ...row, theta: NaN }], Array(MOST_ROWS + 1).fill(row)];
  for (const rows of bad) assert.equal(transition(state, { type: "edit", rows }), state);
});

test("ways are marked once the tip has left the pose, and come back with it", () => {
  const q = [0.2, 1.2, -0.9];
  let state = transition(start(ELBOW), { type: "move", q });
  state = transition(state, { type: "ways", arm: ELBOW, ways: otherWays(ELBOW, q) });
  const left = (values) => leftBehind(state, derive(ELBOW, values));
  assert.equal(left(q), null);
  assert.ok(left([0.2, 1.2, -0.8]).far > 0.02);
  for (const way of state.ways.list) assert.equal(left(way.q), null);
});

test("undo and redo walk through what the reader did, a drag as one step", () => {
  let state = start(ELBOW);
  const at = (v) => [v, 0.8, -1.5];
  for (const v of [0.1, 0.2, 0.3]) state = transition(state, { type: "move", q: at(v), gesture: "drag 1" });
  state = transition(state, { type: "move", q: at(0.5), gesture: "drag 2" });
  state = transition(state, { type: "select", arm: STANFORD });
  const back = [0, 1, 2].map(() => (state = transition(state, { type: "undo" })));
  assert.deepEqual(back.map(({ arm, q }) => [arm.name, q[0]]), [["Elbow arm", 0.5], ["Elbow arm", 0.3], ["Elbow arm", 0]]);
  assert.equal(transition(state, { type: "undo" }), state, "nothing is left");
  state = transition(state, { type: "redo" });
  assert.equal(state.q[0], 0.3);
  state = transition(state, { type: "move", q: at(9) });
  assert.deepEqual(state.future, [], "another way was taken");
});

test("views of one store hear the same, and no more once they are gone", () => {
  const store = new Store(start());
  const heard = [];
  const [one, two] = [new AbortController(), new AbortController()];
  store.listen((changed) => heard.push(["one", ...changed]), one.signal);
  store.listen((changed, by) => heard.push(["two", by]), two.signal);
  store.dispatch({ type: "show", unit: "rad" });
  one.abort();
  store.dispatch({ type: "show", unit: "deg" }, "python");
  assert.deepEqual(heard, [["one", "unit"], ["two", "reader"], ["two", "python"]]);
});

test("an arm without a joint has numbers too", () => {
  const still = { name: "post", home: [], rows: [{ ...ELBOW.rows[0], kind: "fixed" }] };
  const store = new Store(startingState({ arm: still, q: [] }));
  assert.equal(rankVerdict(store.derived).text, "No joint moves this arm.");
  assert.deepEqual(store.derived.torque, []);
  assert.equal(store.derived.manipulability, 1);
  assert.deepEqual(otherWays(still, []).list, []);
});

test("the circle of the state is the one that is asked for", () => assert.deepEqual(start().circle, circle));
