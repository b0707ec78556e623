// The explorer's state in the fragment of a link, and back.

import {
  isJointVector,
  homePose,
  ROW_KINDS,
  MAX_LENGTH as FARTHEST,
  findRowsFault,
  makeTypedArm,
} from "../../judge/geometry/arm.js";
import { movingRows } from "../../judge/geometry/kinematics.js";
import { copied } from "./dom.js";
import { runFrom, runText } from "./homework_run.js";

const LONGEST = 4000; // characters of a fragment
const LETTERS = Object.fromEntries(ROW_KINDS.map((kind) => [kind[0].toUpperCase(), kind]));
const MOST_FORCE = 1e5;
const MOST_RUNS = 8;

const numbers = (text) =>
  text ? text.split(",").map((part) => (part.trim() ? Number(part) : NaN)) : [];
const written = (values) => values.map((v) => Number(v.toFixed(6)) + 0).join(",");

/** @param {import("./state.js").State} state */
export function toFragment({ arm, base, q, wrench, unit, view, frames, mark, runs = [] }) {
  const fields = { arm: base.name, q: written(q), view, unit, frames };
  if (wrench.some(Boolean)) fields.wrench = written(wrench);
  if (arm !== base) {
    const row = (r) => `${r.kind[0].toUpperCase()},${written([r.a, r.alpha, r.d, r.theta])}`;
    fields.rows = arm.rows.map(row).join(";");
  }
  if (mark) fields.mark = written(mark);
  if (view === "homework" && runs.length) fields.runs = runs.map(runText).join(";");
  return `#${new URLSearchParams(fields)}`;
}

/**
 * What a fragment says, as { patch, words }: the fields of the state that it holds, and what was
 * refused, in words.
 * @param {string} fragment
 * @param {import("../../judge/geometry/arm.js").Arm[]} arms
 * @param {string[]} views
 */
export function fromFragment(fragment, arms, views) {
  const text = fragment.replace(/^#/, "");
  if (!text || !/(^|&)arm=/.test(text)) return { patch: {}, words: "" };
  if (text.length > LONGEST)
    return refused(`it has ${text.length} characters; ${LONGEST} are the most`);
  const fields = new URLSearchParams(text);
  const base = arms.find((arm) => arm.name === fields.get("arm"));
  if (!base) return refused(`there is no arm called “${fields.get("arm").slice(0, 40)}” here`);
  const rows = rowsOf(fields.get("rows"));
  const fault = rows && findRowsFault(rows);
  const arm = rows && !fault ? makeTypedArm(rows, base) : base;
  const parts = [
    { patch: { arm, base, reference: base }, fault },
    jointsIn(fields, arm, Boolean(fault)),
    wrenchIn(fields),
    markIn(fields),
    runsIn(fields),
    { patch: chosenIn(fields, views) },
  ];
  const patch = Object.assign({}, ...parts.map((part) => part.patch));
  const faults = parts.flatMap((part) => part.fault || []);
  return faults.length ? { ...refused(faults.join("; ")), patch } : { patch, words: "" };
}

// What one field says: what it makes of the state, and what is wrong with it.

function jointsIn(fields, arm, otherArm) {
  const q = numbers(fields.get("q"));
  if (isJointVector(arm, q)) return { patch: { q } };
  const wrong = fields.has("q") && !otherArm;
  const fault = wrong && `${arm.name} has ${movingRows(arm).length} joint values`;
  return { patch: { q: homePose(arm) }, fault };
}

function wrenchIn(fields) {
  if (!fields.has("wrench")) return {};
  const wrench = numbers(fields.get("wrench"));
  const good = wrench.length === 6 && wrench.every((v) => Math.abs(v) <= MOST_FORCE);
  return good ? { patch: { wrench } } : { fault: "its wrench is not six numbers in N and N m" };
}

function markIn(fields) {
  if (!fields.has("mark")) return { patch: { mark: null } };
  const mark = numbers(fields.get("mark"));
  const good = mark.length === 3 && mark.every((v) => Math.abs(v) <= FARTHEST);
  return { patch: { mark: good ? mark : null }, fault: !good && "its mark is no place in metres" };
}

function runsIn(fields) {
  if (!fields.has("runs")) return {};
  const runs = fields.get("runs").split(";").map(runFrom);
  const good = runs.length <= MOST_RUNS && !runs.includes(null);
  return good ? { patch: { runs } } : { fault: "its runs are none that the homework could make" };
}

function chosenIn(fields, views) {
  const known = { view: views, unit: ["deg", "rad"], frames: ["all", "ends"] };
  const keys = Object.keys(known).filter((key) => known[key].includes(fields.get(key)));
  return Object.fromEntries(keys.map((key) => [key, fields.get(key)]));
}

const refused = (why) => ({ patch: {}, words: `Part of the link was left out: ${why}.` });

// Rows as they stand in a link, unchecked; null where there are none.
function rowsOf(text) {
  if (text === null) return null;
  return text.split(";").map((line) => {
    const [letter, ...entries] = line.split(",");
    const [a, alpha, d, theta] = entries.length === 4 ? numbers(entries.join(",")) : [];
    return { kind: Object.hasOwn(LETTERS, letter) ? LETTERS[letter] : null, a, alpha, d, theta };
  });
}

// Keep the page's own address in step with the state.
export function keepLink(store, arms, views, tell, signal) {
  const read = () => {
    const { patch, words } = fromFragment(location.hash, arms, views);
    store.dispatch({ type: "set", ...patch }, "link");
    tell(words);
  };
  let timer;
  read();
  addEventListener("hashchange", read, { signal });
  store.listen((_, by) => {
    if (store.state.dragging) return;
    clearTimeout(timer);
    if (by !== "link")
      timer = setTimeout(() => history.replaceState(null, "", toFragment(store.state)), 400);
  }, signal);
  signal.addEventListener("abort", () => clearTimeout(timer));
  return {
    // Whether the link could be put on the clipboard; it stands in the address bar in any case.
    copy() {
      history.replaceState(null, "", toFragment(store.state));
      return copied(location.href);
    },
  };
}
