// Explorer links: they restore the state, and invalid parts are left out with a message.

import assert from "node:assert/strict";
import { test } from "node:test";
import { parseFragment, formatFragment } from "../../page/src/link.js";
import { DEFAULT_RUN } from "../../page/src/homework_run.js";
import { makeInitialState, Store } from "../../page/src/state.js";
import { ARMS, PANDA } from "./arms.mjs";

const VIEWS = ["table", "pose", "torque", "homework"];
const read = (fragment) => parseFragment(fragment, ARMS, VIEWS);

test("a link restores the explorer's state", () => {
  const runs = [DEFAULT_RUN, { ...DEFAULT_RUN, method: "rk4", mistake: "z_i", steps: 100, radius: 0.05, gain: 5 }];
  const q = [0.1, 0.2, 0.3, 1.4, 0.5, 1.6, 0.7];
  const store = new Store(makeInitialState({ arm: PANDA, q, view: "homework", unit: "rad", frames: "all", runs, chosenRun: 1 }));
  store.dispatch({ type: "editTable", rows: PANDA.rows.map((r, i) => (i ? r : { ...r, d: 0.4 })) });
  store.dispatch({ type: "setFields", runs, chosenRun: 1, runStart: PANDA.home });
  store.dispatch({ type: "setFields", mark: [0.1, -0.2, 0.3], wrench: [-5, 0, 0, 0, 0, 0.5] });
  const { patch, message } = read(formatFragment(store.state));
  assert.equal(message, "");
  for (const key of ["q", "wrench", "view", "unit", "frames", "base", "mark", "runs", "chosenRun"]) assert.deepEqual(patch[key], store.state[key], key);
  patch.runStart.forEach((v, k) => assert.ok(Math.abs(v - PANDA.home[k]) < 1e-6));
  const shown = ({ name, rows }) => [name, rows.map((r) => r.d)];
  assert.deepEqual(shown(patch.arm), shown(store.state.arm));
});

test("a link keeps a table while the slider shows an arm before it", () => {
  const rows = PANDA.rows.map((row, i) => (i ? row : { ...row, d: 0.5, alpha: row.alpha + 3 }));
  const store = new Store(makeInitialState({ arm: PANDA, q: PANDA.home, view: "table" }));
  store.dispatch({ type: "editTable", rows });
  const typed = formatFragment(store.state);
  for (const share of [0, 0.25]) {
    store.dispatch({ type: "blendTables", rows, share });
    const { patch, message } = read(formatFragment(store.state));
    assert.deepEqual([message, patch.blended.share, patch.blended.rows[0].d], ["", share, 0.5]);
    const { d, alpha } = patch.arm.rows[0];
    assert.ok(Math.abs(d - (0.333 + share * 0.167)) < 1e-6 && Math.abs(alpha - PANDA.rows[0].alpha - 3 * share) < 1e-5);
  }
  store.dispatch({ type: "blendTables", rows, share: 1 });
  assert.equal(formatFragment(store.state), typed);
});

test("a link to an arm between tables of other joints shows the typed one", () => {
  const { patch, message } = read("#arm=Panda&rows=R,0,0,1,0&blend=0.5");
  assert.match(message, /no arm between them/);
  assert.deepEqual([patch.arm.rows.length, patch.blended], [1, null]);
});

const table = (...rows) => `#arm=Panda&rows=${rows.join(";")}`;
const cases = {
  "an object's own name": table("constructor,0,0,0,0"),
  "a kind that is none": table("X,0,0,0,0"),
  "too large": table("R,1e308,0,0,0"),
  "too many rows": table(...Array(17).fill("R,0,0,1,0")),
  "too few entries": table("R,0,0"),
  "no number": table("R,0,zero,0,0"),
  "too long": table(...Array(2000).fill("R,0,0,1,0")),
  "an arm that is not here": "#arm=Nobody&q=1",
  "an answer that does not fit": "#arm=Panda&answer=1,2,3",
  "a wrench that is none": "#arm=Panda&wrench=1",
  "joint values that do not fit": "#arm=Panda&q=1,2",
  "an empty joint value": "#arm=Elbow+arm&q=1,,2",
  "a mark that is no place": "#arm=Panda&mark=1,2",
  "a mark too far away": "#arm=Panda&mark=0,0,1e9",
  "an arm beyond both tables": "#arm=Panda&blend=1.5",
};
for (const [name, fragment] of Object.entries(cases)) {
  test(`refused with a message: ${name}`, () => {
    const { patch, message } = read(fragment);
    assert.match(message, /^Part of the link was left out: .+\.$/);
    if (patch.arm) assert.ok(ARMS.includes(patch.arm), "the arm is one of the list");
    assert.equal(patch.wrench, undefined);
  });
}

test("a link refuses invalid runs", () => {
  const valid = "euler_inverse_1000_5_0.1_x_0_1e-9_0.02_2_";
  for (const bad of ["euler", valid.replace("1000", "1e9"), valid.replace("inverse", "constructor"), valid.replace("0.1_", "_"), Array(9).fill(valid).join(";")]) {
    const { message, patch } = read(`#arm=Panda&view=homework&runs=${bad}`);
    assert.match(message, /its runs cannot come from the homework/, bad);
    assert.equal(patch.runs, undefined);
  }
});

test("a link refuses an unsuitable run or start", () => {
  const run = "runs=euler_inverse_1000_5_0.1_x_0_1e-9_0.02_2_";
  for (const [part, fault] of [["run=2", /it plays a run that it does not have/], ["start=1,2", /its runs begin at joint values that the Panda does not have/]]) {
    const { patch, message } = read(`#arm=Panda&view=homework&${run}&${part}`);
    assert.match(message, fault);
    assert.deepEqual([patch.chosenRun, patch.runStart], [0, undefined]);
  }
});

test("fragments of the page change nothing", () => {
  for (const fragment of ["", "#the-instrument", "#fig-1"]) assert.deepEqual(read(fragment), { patch: {}, message: "" });
});
