// The levers of one run of the homework.

import { h, select, slider, write } from "../dom.js";
import { BOUNDS } from "../homework_run.js";
import { fixed } from "../text.js";
import { named, NAMES, SLIPS } from "./homework_words.js";

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
];

/** @param {(patch: Partial<import("../homework_run.js").Run>) => void} edit */
export function makeFields(edit) {
  const choice = (label, key, words) => select(label, words, (v) => edit({ [key]: v }));
  const namesOf = (keys) => Object.fromEntries(keys.map((key) => [key, NAMES[key]]));
  const method = choice("Method", "method", namesOf(["euler", "rk4", "exact"]));
  const rates = choice("Rates", "rates", namesOf(["inverse", "pseudo", "damped"]));
  const slip = choice("Mistake", "slip", SLIPS);
  const [ofMethod, ofRates, ofSlip] = [method, rates, slip].map((one) =>
    h("label", {}, `${one.getAttribute("aria-label")} `, one),
  );
  const levers = LEVERS.map((lever) => makeSlider(lever, edit));
  const told = h("summary");
  const parts = [ofMethod, ofRates, ...levers.map(({ root: part }) => part)];

  function update(run) {
    if (!run) return;
    method.value = run.method;
    rates.value = run.rates;
    slip.value = run.slip;
    const circle = `radius ${fixed(100 * run.radius, 1)} cm in ${fixed(run.seconds, 0)} s`;
    write(told, `${named(run)}, ${circle}`);
    for (const { key, root: part, show } of levers) {
      show(run[key]);
      part.hidden = isIdle(key, run);
    }
    for (const one of [ofRates, ofSlip]) one.hidden = run.method === "exact";
  }
  const root = h("details", {}, told, h("div.levers", {}, parts));
  return { mistake: ofSlip, root, update };
}

// Whether a lever changes nothing of such a run.
const isIdle = (key, { method }) => method === "exact" && key === "gain";

function makeSlider([key, label, logarithmic, text, rounded], edit) {
  const bounds = BOUNDS[key].map((v) => (logarithmic ? Math.log10(v) : v));
  const value = (input) => rounded(logarithmic ? 10 ** Number(input.value) : Number(input.value));
  const output = h("output");
  const input = slider(label, bounds, {
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
