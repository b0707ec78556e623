// One line for each joint: its name, a slider over its range, a field to type in, its limits.

import { isOutsideLimits, jointRange } from "../../../judge/geometry/arm.js";
import { attribute, h, indexed, slider, write } from "../dom.js";
import { entered, refill, textField } from "../entry.js";
import { movingRows } from "../../../judge/geometry/kinematics.js";
import { makeRail } from "../rail.js";
import { isAngle, jointText, limitText, quantityOf, replaced, spokenJoint } from "../text.js";

const KEYS = {
  ArrowLeft: -1,
  ArrowDown: -1,
  ArrowRight: 1,
  ArrowUp: 1,
  PageUp: 10,
  PageDown: -10,
};

export function makeSliders(store, { say, signal }) {
  const root = h("div.sliders", { role: "group", "aria-label": "Joints" });
  const error = h("p.error");
  let lines = [];
  let shown = /** @type {any} */ ({});

  const acts = actsOf(store, error, say);

  function lay({ arm, unit }) {
    shown.abort?.abort();
    const abort = new AbortController();
    signal.addEventListener("abort", () => abort.abort(), { signal: abort.signal });
    lines = movingRows(arm).map((index, i) =>
      makeLine(arm.rows[index], { index, i, unit, signal: abort.signal }, acts),
    );
    const none = h("p.words", {}, "No joint moves this arm.");
    root.replaceChildren(...(lines.length ? lines.map((one) => one.root) : [none]), error);
    shown = { rows: arm.rows, unit, abort };
  }

  function update(state) {
    if (shown.rows !== state.arm.rows || shown.unit !== state.unit) lay(state);
    lines.forEach((line, i) => showJoint(line, state.q[i], state));
  }
  return { root, update };
}

// What a line does with its joint, the i-th of q.
function actsOf(store, error, say) {
  const acts = {
    put: (i, value, gesture = null) =>
      store.dispatch({ type: "move", q: replaced(store.state.q, i, value), gesture }),
    typed: (i, row, field, whole) => {
      const { unit, q } = store.state;
      const { value, words } = entered(field, quantityOf(row), { unit, whole });
      write(error, words && `${field.dataset.joint} ${words}.`);
      if (words) say(() => error.textContent);
      if (!whole) return;
      if (value !== undefined) acts.put(i, value);
      field.value = jointText(row, value ?? q[i], unit);
      field.setAttribute("aria-invalid", "false");
    },
    nudge: (event, row, i) => {
      const value = nudged(event, row, store.state.q[i]);
      if (value === null) return;
      event.preventDefault();
      acts.put(i, value, `keys ${i}`);
    },
    light: (lit) => store.state.lit !== lit && store.dispatch({ type: "show", lit }),
  };
  return acts;
}

// The line of one joint: `index` is its row, `i` its place in q.
function makeLine(row, { index, i, unit, signal }, { put, typed, nudge, light }) {
  const label = `Joint ${index + 1}, ${row.kind === "revolute" ? "angle" : "slide"}`;
  const thumb = slider(label, jointRange(row), {
    "data-joint": index + 1,
    onkeydown: (e) => nudge(e, row, i),
  });
  const field = textField(`${label}, typed`, (...now) => typed(i, row, ...now), {
    class: "value",
    "data-joint": label,
  });
  const past = h("span.past");
  const rail = makeRail(thumb, (...to) => put(i, ...to), signal, boundsOf(row, past, unit));
  const [on, off] = [() => light(index), () => light(null)];
  const lights = { onpointerenter: on, onpointerleave: off, onfocusin: on, onfocusout: off };
  const name = h("span.label", {}, indexed("q", index + 1));
  return { root: h("div.joint", lights, name, rail, field), thumb, field, past, row, index };
}

// The joint's limits, and between them whether it is past one.
function boundsOf(row, past, unit) {
  const limit = (value) =>
    h("span", {}, (value ?? null) === null ? "" : limitText(row, value, unit));
  return h("span.bounds", {}, limit(row.lower), past, limit(row.upper));
}

// Where a key takes a joint, or null for another key. Native steps of a slider with step="any" are
// a hundredth of its range; these are whole degrees and millimetres. Shift is finer.
function nudged({ key, shiftKey }, row, value) {
  const [lower, upper] = jointRange(row);
  if (key === "Home") return lower;
  if (key === "End") return upper;
  if (!KEYS[key]) return null;
  const step = (isAngle(row) ? Math.PI / 180 : 0.005) * (shiftKey ? 0.1 : 1);
  return Math.min(upper, Math.max(lower, value + KEYS[key] * step));
}

function showJoint({ root, thumb, field, past, row, index }, value, { lit, unit }) {
  const [lower, upper] = jointRange(row);
  root.classList.toggle("lit", lit === index);
  thumb.value = String(value);
  attribute(thumb, "aria-valuetext", spokenJoint(row, value, unit));
  const [at, zero] = [value, 0].map(
    (v) => 100 * Math.min(1, Math.max(0, (v - lower) / (upper - lower || 1))),
  );
  thumb.style.setProperty("--low", `${Math.min(at, zero).toFixed(2)}%`);
  thumb.style.setProperty("--high", `${Math.max(at, zero).toFixed(2)}%`);
  refill(field, jointText(row, value, unit));
  const beyond = isOutsideLimits(row, value);
  root.classList.toggle("past", beyond);
  write(past, beyond ? "past its limit" : "");
}
