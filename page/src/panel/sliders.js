// One line for each joint: its name, a slider over its range, a field to type in, its limits.

import { outside, range } from "../../../judge/geometry/arm.js";
import { attribute, h, indexed, write } from "../dom.js";
import { readEntry, unfinished } from "../../../judge/reading/entry.js";
import { joints } from "../../../judge/geometry/kinematics.js";
import { relativeRail } from "../rail.js";
import { isAngle, jointText, limitText, quantityOf, spokenJoint } from "../text.js";

let drags = 0;

export function makeSliders(store, { say, signal }) {
  const root = h("div.sliders", { role: "group", "aria-label": "Joints" });
  const error = h("p.error");
  let lines = [];
  let shown = /** @type {any} */ ({});

  const put = (i, value, gesture = null) => {
    store.dispatch({
      type: "move",
      q: store.state.q.map((v, k) => (k === i ? value : v)),
      gesture,
    });
  };

  function typed(i, row, input, last) {
    const { unit, q } = store.state;
    const { value, error: fault } = readEntry(input.value, quantityOf(row), unit);
    const wrong = fault && (last || !unfinished(input.value));
    attribute(input, "aria-invalid", String(Boolean(wrong)));
    error.textContent = wrong ? `${input.dataset.joint} ${fault}.` : "";
    if (wrong) say(() => error.textContent);
    if (!last) return;
    if (!fault) put(i, value);
    input.value = jointText(row, fault ? q[i] : value, unit);
    input.setAttribute("aria-invalid", "false");
  }

  function lay({ arm, unit }) {
    shown.abort?.abort();
    const abort = new AbortController();
    signal.addEventListener("abort", () => abort.abort(), { signal: abort.signal });
    lines = joints(arm).map((index, i) => line(arm.rows[index], index, i, unit, abort.signal));
    const none = h("p.words", {}, "No joint moves this arm.");
    root.replaceChildren(...(lines.length ? lines.map((one) => one.root) : [none]), error);
    shown = { rows: arm.rows, unit, abort };
  }

  function line(row, index, i, unit, lifetime) {
    const [lower, upper] = range(row);
    const label = `Joint ${index + 1}, ${row.kind === "revolute" ? "angle" : "slide"}`;
    const slider = h("input", {
      type: "range",
      min: lower,
      max: upper,
      step: "any",
      "aria-label": label,
      "data-joint": index + 1,
      oninput: (e) => put(i, Number(e.target.value), `slider ${index}`),
      onkeydown: (e) => nudge(e, row, i),
    });
    const field = h("input.value", {
      type: "text",
      spellcheck: "false",
      autocomplete: "off",
      "aria-label": `${label}, typed`,
      "data-joint": label,
      oninput: (e) => typed(i, row, e.target, false),
      onchange: (e) => typed(i, row, e.target, true),
    });
    const limit = (value) =>
      h("span", {}, (value ?? null) === null ? "" : limitText(row, value, unit));
    const past = h("span.past");
    const bounds = h("span.bounds", {}, limit(row.lower), past, limit(row.upper));
    const light = (lit) => () => store.state.lit !== lit && store.dispatch({ type: "show", lit });
    const rail = h("div.rail", {}, slider, bounds);
    let gesture = null;
    const start = () => (gesture = `rail ${++drags}`);
    relativeRail(rail, slider, { start, put: (value) => put(i, value, gesture), signal: lifetime });
    const lights = {
      onpointerenter: light(index),
      onpointerleave: light(null),
      onfocusin: light(index),
      onfocusout: light(null),
    };
    const lineRoot = h(
      "div.joint",
      lights,
      h("span.label", {}, indexed("q", index + 1)),
      rail,
      field,
    );
    return { root: lineRoot, slider, field, past, row, index };
  }

  // Native steps of a slider with step="any" are a hundredth of its range; these are whole degrees
  // and millimetres. Shift is finer.
  function nudge(event, row, i) {
    const sign = {
      ArrowLeft: -1,
      ArrowDown: -1,
      ArrowRight: 1,
      ArrowUp: 1,
      PageUp: 10,
      PageDown: -10,
    }[event.key];
    const [lower, upper] = range(row);
    const end = { Home: lower, End: upper }[event.key];
    if (!sign && end === undefined) return;
    event.preventDefault();
    const step = (isAngle(row) ? Math.PI / 180 : 0.005) * (event.shiftKey ? 0.1 : 1);
    put(i, end ?? Math.min(upper, Math.max(lower, store.state.q[i] + sign * step)), `keys ${i}`);
  }

  function update(state) {
    if (shown.rows !== state.arm.rows || shown.unit !== state.unit) lay(state);
    lines.forEach(({ root: part, slider, field, past, row, index }, i) => {
      part.classList.toggle("lit", state.lit === index);
      const value = state.q[i];
      const [lower, upper] = range(row);
      slider.value = String(value);
      attribute(slider, "aria-valuetext", spokenJoint(row, value, state.unit));
      const [at, zero] = [value, 0].map(
        (v) => 100 * Math.min(1, Math.max(0, (v - lower) / (upper - lower || 1))),
      );
      slider.style.setProperty("--low", `${Math.min(at, zero).toFixed(2)}%`);
      slider.style.setProperty("--high", `${Math.max(at, zero).toFixed(2)}%`);
      if (field.getRootNode().activeElement !== field) {
        const text = jointText(row, value, state.unit);
        if (field.value !== text) field.value = text;
      }
      const beyond = outside(row, value);
      part.classList.toggle("past", beyond);
      write(past, beyond ? "past its limit" : "");
    });
  }
  return { root, update };
}
