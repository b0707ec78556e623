// The lines of the joints. Each has a name, a slider, a text field and the limits.

import { isOutsideLimits, jointRange } from "../../../judge/geometry/arm.js";
import { updateAttribute, h, makeIndexedSymbol, makeRangeInput, setText } from "../dom.js";
import { readField, refillField, makeTextField } from "../entry.js";
import { movingRows } from "../../../judge/geometry/kinematics.js";
import { clamp } from "../../../judge/geometry/planar.js";
import { makeRail } from "../rail.js";
import {
  isAngle,
  formatJointValue,
  formatLimit,
  getQuantity,
  replaceAt,
  formatSpokenValue,
} from "../text.js";

const KEY_STEPS = {
  ArrowLeft: -1,
  ArrowDown: -1,
  ArrowRight: 1,
  ArrowUp: 1,
  PageUp: 10,
  PageDown: -10,
};

export function makeSliders(store, { announce, point, signal }) {
  const root = h("div.sliders", { role: "group", "aria-label": "Joints" });
  const error = h("p.error");
  let lines = [];
  let rendered = /** @type {any} */ ({});

  const actions = { ...makeJointActions(store, error, announce), point };

  function rebuild({ arm, unit }) {
    rendered.abort?.abort();
    const abort = new AbortController();
    signal.addEventListener("abort", () => abort.abort(), { signal: abort.signal });
    lines = movingRows(arm).map((index, i) =>
      makeJointLine(arm.rows[index], { index, i, unit, signal: abort.signal }, actions),
    );
    const none = h("p.words", {}, "No joint moves this arm.");
    root.replaceChildren(...(lines.length ? lines.map((line) => line.root) : [none]), error);
    rendered = { rows: arm.rows, unit, abort };
  }

  function update(state) {
    if (rendered.rows !== state.arm.rows || rendered.unit !== state.unit) rebuild(state);
    lines.forEach((line, i) => showJoint(line, state.q[i], state));
  }
  return { root, update };
}

// Return the actions of a joint's line; `i` is the joint's index in q.
function makeJointActions(store, error, announce) {
  const actions = {
    setValue: (i, value, gesture = null) =>
      store.dispatch({ type: "moveJoints", q: replaceAt(store.state.q, i, value), gesture }),
    readTyped: (i, row, field, whole) => {
      const { unit, q } = store.state;
      const { value, message } = readField(field, getQuantity(row), { unit, whole });
      setText(error, message && `${field.dataset.joint} ${message}.`);
      if (message) announce(() => error.textContent);
      if (!whole) return;
      if (value !== undefined) actions.setValue(i, value);
      field.value = formatJointValue(row, value ?? q[i], unit);
      field.setAttribute("aria-invalid", "false");
    },
    handleKey: (event, row, i) => {
      const value = getValueAfterKey(event, row, store.state.q[i]);
      if (value === null) return;
      event.preventDefault();
      actions.setValue(i, value, `keys ${i}`);
    },
  };
  return actions;
}

// Make the line of one joint; `index` is its row and `i` its index in q.
function makeJointLine(row, { index, i, unit, signal }, { setValue, readTyped, handleKey, point }) {
  const label = `Joint ${index + 1}, ${row.kind === "revolute" ? "angle" : "slide"}`;
  const thumb = makeRangeInput(label, jointRange(row), {
    "data-joint": index + 1,
    onkeydown: (e) => handleKey(e, row, i),
  });
  const field = makeTextField(`${label}, typed`, (...args) => readTyped(i, row, ...args), {
    class: "value",
    "data-joint": label,
  });
  const past = h("span.past");
  const rail = makeRail(
    thumb,
    (...args) => setValue(i, ...args),
    signal,
    makeLimitLabels(row, past, unit),
  );
  const [on, off] = [() => point(index), () => point(null)];
  const lights = { onpointerenter: on, onpointerleave: off, onfocusin: on, onfocusout: off };
  const name = h("span.label", {}, makeIndexedSymbol("q", index + 1));
  return { root: h("div.joint", lights, name, rail, field), thumb, field, past, row, index };
}

// Make the labels of both limits, with a warning between them if the joint is past one.
function makeLimitLabels(row, past, unit) {
  const limit = (value) =>
    h("span", {}, (value ?? null) === null ? "" : formatLimit(row, value, unit));
  return h("span.bounds", {}, limit(row.lower), past, limit(row.upper));
}

// Return the joint value after a key, or null for other keys. A slider with step="any" would move
// by a hundredth of its range; these steps are whole degrees and millimetres, and a tenth with
// Shift.
function getValueAfterKey({ key, shiftKey }, row, value) {
  const [lower, upper] = jointRange(row);
  if (key === "Home") return lower;
  if (key === "End") return upper;
  if (!KEY_STEPS[key]) return null;
  const step = (isAngle(row) ? Math.PI / 180 : 0.005) * (shiftKey ? 0.1 : 1);
  return clamp(value + KEY_STEPS[key] * step, lower, upper);
}

function showJoint({ root, thumb, field, past, row, index }, value, { highlightedRow, unit }) {
  const [lower, upper] = jointRange(row);
  root.classList.toggle("lit", highlightedRow === index);
  thumb.value = String(value);
  updateAttribute(thumb, "aria-valuetext", formatSpokenValue(row, value, unit));
  const [at, zero] = [value, 0].map((v) => 100 * clamp((v - lower) / (upper - lower || 1), 0, 1));
  thumb.style.setProperty("--low", `${Math.min(at, zero).toFixed(2)}%`);
  thumb.style.setProperty("--high", `${Math.max(at, zero).toFixed(2)}%`);
  refillField(field, formatJointValue(row, value, unit));
  const beyond = isOutsideLimits(row, value);
  root.classList.toggle("past", beyond);
  setText(past, beyond ? "past its limit" : "");
}
