// A path played back: where the tip goes, and what each joint does meanwhile.

import { outside } from "../../../judge/geometry/arm.js";
import { attribute, h, write } from "../dom.js";
import { readEntry, unfinished } from "../../../judge/reading/entry.js";
import { latest } from "../jobs.js";
import { joints } from "../../../judge/geometry/kinematics.js";
import { torquesAlong } from "../runs.js";
import { fixed, listed, short } from "../text.js";
import { makePlots } from "./plots.js";
import { makeTransport } from "./transport.js";

export const title = "Circle trace";

const MOST_RADIUS = 5; // m

export function build(store, { say, signal }) {
  const axes = ["x", "y", "z"].map((axis) => h("option", { value: axis }, `${axis} = const`));
  const chosen = (normal) => store.dispatch({ type: "circle", normal });
  const plane = h(
    "select",
    { "aria-label": "Plane of the circle", onchange: (e) => chosen(e.target.value) },
    axes,
  );
  const radius = h("input.small", {
    type: "text",
    spellcheck: "false",
    autocomplete: "off",
    "aria-label": "Radius of the circle, m",
    oninput: (e) => sized(e.target, false),
    onchange: (e) => sized(e.target, true),
  });
  const quantity = h(
    "select",
    { "aria-label": "What the plots show", onchange: () => lay() },
    h("option", { value: "joint" }, "joint values"),
    h("option", { value: "torque" }, "static torques"),
  );
  const drawing = h("button", { type: "button", onclick: () => draw() }, "Draw a circle from here");
  const verdict = h("p.verdict");
  const error = h("p.error");
  const plots = makePlots();
  const transport = makeTransport(store, { signal, begin: (then) => draw(then) });
  const root = h(
    "div.trace",
    {},
    transport.root,
    h(
      "div.row",
      {},
      h("label", {}, "Plane ", plane),
      h("label", {}, "Radius ", radius, " m"),
      drawing,
      h("label.right", {}, "Plots ", quantity),
    ),
    error,
    verdict,
    plots.root,
  );
  const ask = latest("circle");
  let shown = null;

  // A circle from where the tip is; `then` once it is drawn.
  async function draw(then = () => {}) {
    const { arm, q, circle } = store.state;
    if (!sized(radius, true)) return;
    drawing.disabled = true;
    await ask({ arm, q, circle }, ({ path, stray, wanted }) => {
      store.dispatch({ type: "traced", arm, circle, path, stray, wanted });
      say(() => verdict.textContent, true);
      then();
    });
    drawing.disabled = false;
  }

  // Whether the radius that is typed is one; it goes into the state as soon as it is.
  function sized(input, whole) {
    const { value, error: fault } = readEntry(input.value, "length");
    const small = !fault && !(value > 0 && value <= MOST_RADIUS);
    const words =
      fault ?? (small ? `“${input.value}” is no length above 0 and up to ${MOST_RADIUS} m` : "");
    const wrong = words && (whole || !unfinished(input.value));
    attribute(input, "aria-invalid", String(Boolean(wrong)));
    error.textContent = wrong ? `The radius ${words}.` : "";
    if (wrong) say(() => error.textContent);
    if (!words && value !== store.state.circle.radius)
      store.dispatch({ type: "circle", radius: value });
    return !words;
  }

  function lay() {
    const { arm, trace, unit, wrench } = store.state;
    shown = { arm, trace, unit, wrench };
    root.classList.toggle("empty", !trace);
    write(verdict, verdictText(store.state));
    if (!trace) return plots.clear();
    const torques = quantity.value === "torque";
    plots.lay(store.state, torques ? torquesAlong(arm, trace, wrench) : trace, torques);
    return plots.mark(store.state.at);
  }

  function update(state) {
    const changed = !shown || ["arm", "trace", "unit"].some((key) => shown[key] !== state[key]);
    if (changed || (quantity.value === "torque" && shown.wrench !== state.wrench)) lay();
    else if (state.trace) plots.mark(state.at);
    plane.value = state.circle.normal;
    const typing = radius.getRootNode().activeElement === radius;
    if (!typing && !error.textContent) radius.value = short(state.circle.radius, 4);
    transport.update(state);
  }
  return { root, update, summary: () => verdict.textContent };
}

function verdictText({ arm, trace, stray }) {
  if (!trace)
    return "Play draws a circle of this radius from where the tip is now; the tool keeps its orientation.";
  const past = joints(arm).flatMap((row, i) =>
    trace.some((q) => outside(arm.rows[row], q[i])) ? [`joint ${row + 1}`] : [],
  );
  const limits = past.length
    ? `${listed(past)} would have to pass ${past.length > 1 ? "their limits" : "its limit"} (tinted).`
    : "All joints stay within their limits.";
  if (stray > 1e-3)
    return `The whole circle is not within reach: the tip strays by up to ${fixed(1000 * stray, 0)} mm.`;
  return limits[0].toUpperCase() + limits.slice(1);
}
