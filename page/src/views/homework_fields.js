// The levers of one run of the homework.

import { joints } from "../../../judge/geometry/kinematics.js";
import { h, select, write } from "../dom.js";
import { BOUNDS } from "../runs.js";
import { fixed } from "../text.js";
import { NAMES, SLIPS } from "./homework_words.js";

/**
 * A lever: the run's field, its name, whether it goes by powers of ten, how a value is written, and
 * how it is rounded.
 * @type {[string, string, boolean, (v: number) => string, (v: number) => number][]}
 */
const LEVERS = [
  ["steps", "N", true, String, Math.round],
  ["seconds", "T", false, (v) => `${fixed(v, 0)} s`, Math.round],
  ["radius", "Radius", false, (v) => `${fixed(100 * v, 1)} cm`, (v) => Number(v.toFixed(3))],
  ["gain", "Feedback", false, (v) => `${fixed(v, 1)} /s`, (v) => Number(v.toFixed(1))],
  [
    "cutoff",
    "Cut-off",
    true,
    (v) => v.toExponential(0).replace("-", "−"),
    (v) => Number(v.toPrecision(1)),
  ],
  ["damping", "Damping", true, (v) => fixed(v, 3), (v) => Number(v.toPrecision(2))],
];

/** @param {(patch: Partial<import("../runs.js").Run>) => void} edit */
export function makeFields(edit) {
  const choice = (label, key, words) => select(label, words, (v) => edit({ [key]: v }));
  const named = (keys) => Object.fromEntries(keys.map((key) => [key, NAMES[key]]));
  const method = choice("Method", "method", named(["euler", "rk4", "exact"]));
  const rates = choice("Rates", "rates", named(["inverse", "pseudo", "damped"]));
  const slip = choice("Mistake", "slip", SLIPS);
  const [ofMethod, ofRates, ofSlip] = [method, rates, slip].map((one) =>
    h("label", {}, `${one.getAttribute("aria-label")} `, one),
  );
  const lock = h("input", {
    type: "checkbox",
    onchange: (e) => edit({ locked: e.target.checked ? 2 : -1 }),
  });
  const locked = h("label.check", {}, lock, " joint 3 locked");
  const levers = LEVERS.map((lever) => makeSlider(lever, edit));
  const parts = [ofMethod, ofRates, ofSlip, locked, ...levers.map(({ root: part }) => part)];

  function update(run, arm) {
    if (!run) return;
    method.value = run.method;
    rates.value = run.rates;
    slip.value = run.slip;
    lock.checked = run.locked === 2;
    locked.hidden = joints(arm).length < 7;
    for (const { key, root: part, show } of levers) {
      show(run[key]);
      part.hidden = isIdle(key, run);
    }
    for (const one of [ofRates, ofSlip]) one.hidden = run.method === "exact";
  }
  return { root: h("div.levers", {}, parts), update };
}

// Whether a lever changes nothing of such a run.
const isIdle = (key, { method, rates }) =>
  (method === "exact" && !["radius", "steps", "seconds"].includes(key)) ||
  (key === "cutoff" && rates !== "pseudo") ||
  (key === "damping" && rates !== "damped");

function makeSlider([key, label, logarithmic, text, rounded], edit) {
  const [low, high] = BOUNDS[key].map((v) => (logarithmic ? Math.log10(v) : v));
  const value = (input) => rounded(logarithmic ? 10 ** Number(input.value) : Number(input.value));
  const output = h("output");
  const input = h("input", {
    type: "range",
    min: low,
    max: high,
    step: "any",
    "aria-label": label,
    oninput: (e) => write(output, text(value(e.target))),
    onchange: (e) => edit({ [key]: value(e.target) }),
  });
  const show = (v) => {
    input.value = String(logarithmic ? Math.log10(v) : v);
    input.setAttribute("aria-valuetext", text(v));
    write(output, text(v));
  };
  return { key, root: h("label.lever", {}, `${label} `, input, output), show };
}
