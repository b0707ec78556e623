// The explorer's state in the fragment of a link, and back.

import {
  fits,
  homeOf,
  KINDS,
  LONGEST as FARTHEST,
  rowsFault,
  typedArm,
} from "../../judge/geometry/arm.js";
import { joints } from "../../judge/geometry/kinematics.js";
import { runFrom, runText } from "./runs.js";

const LONGEST = 4000; // characters of a fragment
const LETTERS = Object.fromEntries(KINDS.map((kind) => [kind[0].toUpperCase(), kind]));
const MOST_FORCE = 1e5;
const MOST_RUNS = 8;

const numbers = (text) =>
  text ? text.split(",").map((part) => (part.trim() ? Number(part) : NaN)) : [];
const written = (values) => values.map((v) => Number(v.toFixed(6)) + 0).join(",");
const oneOf = (text, known) => (known.includes(text) ? text : null);

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
  const fault = rows && rowsFault(rows);
  const arm = rows && !fault ? typedArm(rows, base) : base;
  const words = fault ? [fault] : [];
  const patch = { arm, base, reference: base };
  const q = numbers(fields.get("q"));
  patch.q = fits(arm, q) ? q : homeOf(arm);
  if (fields.has("q") && patch.q !== q && !fault)
    words.push(`${arm.name} has ${joints(arm).length} joint values`);
  const wrench = numbers(fields.get("wrench"));
  if (wrench.length === 6 && wrench.every((v) => Math.abs(v) <= MOST_FORCE)) patch.wrench = wrench;
  else if (fields.has("wrench")) words.push("its wrench is not six numbers in N and N m");
  const mark = numbers(fields.get("mark"));
  patch.mark = mark.length === 3 && mark.every((v) => Math.abs(v) <= FARTHEST) ? mark : null;
  if (!patch.mark && fields.has("mark")) words.push("its mark is no place in metres");
  const runs = (fields.get("runs")?.split(";") ?? []).map(runFrom);
  if (runs.length > MOST_RUNS || runs.includes(null))
    words.push("its runs are none that the homework could make");
  else if (runs.length) patch.runs = runs;
  const chosen = {
    view: oneOf(fields.get("view"), views),
    unit: oneOf(fields.get("unit"), ["deg", "rad"]),
    frames: oneOf(fields.get("frames"), ["all", "ends"]),
  };
  for (const [key, value] of Object.entries(chosen)) if (value) patch[key] = value;
  return words.length ? { ...refused(words.join("; ")), patch } : { patch, words: "" };
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
    async copy() {
      history.replaceState(null, "", toFragment(store.state));
      const copied = navigator.clipboard?.writeText(location.href).then(
        () => true,
        () => false,
      );
      return (await copied) ?? false;
    },
  };
}
