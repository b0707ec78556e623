// Makes the controls of a run of the homework.

import { h, makeSelect, makeRangeInput, setText } from "../dom.js";
import { BOUNDS } from "../homework_run.js";
import { formatFixed } from "../text.js";
import { describeRun, METHOD_NAMES, MISTAKE_NAMES } from "./homework_words.js";

/**
 * The controls. Each has the run's field, its label, whether its scale is logarithmic, and the
 * functions that format and round a value.
 * @type {[string, string, boolean, (v: number) => string, (v: number) => number][]}
 */
const LEVER_KINDS = [
  ["steps", "N", true, String, Math.round],
  ["seconds", "T", false, (v) => `${formatFixed(v, 0)} s`, Math.round],
  ["radius", "Radius", false, (v) => `${formatFixed(100 * v, 1)} cm`, (v) => Number(v.toFixed(3))],
  ["gain", "Feedback", false, (v) => `${formatFixed(v, 1)} /s`, (v) => Number(v.toFixed(1))],
];

/**
 * Make the fields of a run.
 * @param {(patch: Partial<import("../homework_run.js").Run>) => void} edit
 */
export function makeFields(edit) {
  const choice = (label, key, words) => makeSelect(label, words, (v) => edit({ [key]: v }));
  const namesOf = (keys) => Object.fromEntries(keys.map((key) => [key, METHOD_NAMES[key]]));
  const method = choice("Method", "method", namesOf(["euler", "rk4", "exact"]));
  const rates = choice("Rates", "rates", namesOf(["inverse", "pseudo", "damped"]));
  const mistake = choice("Mistake", "mistake", MISTAKE_NAMES);
  const [methodLabel, ratesLabel, mistakeLabel] = [method, rates, mistake].map((list) =>
    h("label", {}, `${list.getAttribute("aria-label")} `, list),
  );
  const levers = LEVER_KINDS.map((lever) => makeLever(lever, edit));
  const summaryLine = h("summary");
  const parts = [methodLabel, ratesLabel, ...levers.map(({ root: part }) => part)];

  function update(run) {
    if (!run) return;
    method.value = run.method;
    rates.value = run.rates;
    mistake.value = run.mistake;
    const radius = `radius ${formatFixed(100 * run.radius, 1)} cm`;
    setText(summaryLine, `${describeRun(run)}, ${radius} in ${formatFixed(run.seconds, 0)} s`);
    for (const { key, root: part, show } of levers) {
      show(run[key]);
      part.hidden = isIdle(key, run);
    }
    for (const label of [ratesLabel, mistakeLabel]) label.hidden = run.method === "exact";
  }
  const root = h("details", {}, summaryLine, h("div.levers", {}, parts));
  return { mistake: mistakeLabel, root, update };
}

// Return whether a field has no effect on a run.
const isIdle = (key, { method }) => method === "exact" && key === "gain";

function makeLever([key, label, logarithmic, text, rounded], edit) {
  const bounds = BOUNDS[key].map((v) => (logarithmic ? Math.log10(v) : v));
  const value = (input) => rounded(logarithmic ? 10 ** Number(input.value) : Number(input.value));
  const output = h("output");
  const input = makeRangeInput(label, bounds, {
    oninput: (e) => setText(output, text(value(e.target))),
    onchange: (e) => edit({ [key]: value(e.target) }),
  });
  const show = (v) => {
    input.value = String(logarithmic ? Math.log10(v) : v);
    input.setAttribute("aria-valuetext", text(v));
    setText(output, text(v));
  };
  return { key, root: h("label.lever", {}, `${label} `, input, output), show };
}
