// A path played back: where the tip goes, and what each joint does meanwhile.

import { outside } from "../arm.js";
import { attribute, calm, h, indexed, svg, write } from "../dom.js";
import { readEntry, unfinished } from "../entry.js";
import { latest } from "../jobs.js";
import { gravityTorque, jacobianColumns, joints, linkFrames, wrenchTorque } from "../kinematics.js";
import { fixed, isAngle, jointText, listed, short } from "../text.js";

export const title = "Circle trace";

const [WIDTH, HEIGHT] = [220, 54];
const MOST_RADIUS = 5; // m

export function build(store, { say, signal }) {
  const play = h("button.main", { type: "button", onclick: toggle }, "Play");
  const scrub = h("input", {
    type: "range", min: 0, max: 1000, value: 0, "aria-label": "Place along the path",
    oninput: (e) => scrubTo(e.target.value / 1000),
  }); // prettier-ignore
  const place = h("output.place");
  const axes = ["x", "y", "z"].map((axis) => h("option", { value: axis }, `${axis} = const`));
  const chosen = (normal) => store.dispatch({ type: "circle", normal });
  const plane = h(
    "select",
    { "aria-label": "Plane of the circle", onchange: (e) => chosen(e.target.value) },
    axes,
  );
  const radius = h("input.small", {
    type: "text", spellcheck: "false", autocomplete: "off", "aria-label": "Radius of the circle, m",
    oninput: (e) => sized(e.target, false), onchange: (e) => sized(e.target, true),
  }); // prettier-ignore
  const quantity = h("select", { "aria-label": "What the plots show", onchange: () => lay() },
    h("option", { value: "joint" }, "joint values"),
    h("option", { value: "torque" }, "static torques")); // prettier-ignore
  const drawing = h("button", { type: "button", onclick: () => draw() }, "Draw a circle from here");
  const verdict = h("p.verdict");
  const error = h("p.error");
  const plots = h("div.plots");
  const root = h("div.trace", {},
    h("div.row.transport", {}, play, scrub, place),
    h("div.row", {}, h("label", {}, "Plane ", plane), h("label", {}, "Radius ", radius, " m"), drawing,
      h("label.right", {}, "Plots ", quantity)),
    error, verdict, plots); // prettier-ignore
  const ask = latest("circle");
  let [shown, cursors, timer] = [null, [], null];
  let last = 0; // the time of the frame before, ms
  signal.addEventListener("abort", () => cancelAnimationFrame(timer));

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
    const words = fault ?? (small ? `“${input.value}” is no length above 0 and up to ${MOST_RADIUS} m` : "");
    const wrong = words && (whole || !unfinished(input.value));
    attribute(input, "aria-invalid", String(Boolean(wrong)));
    error.textContent = wrong ? `The radius ${words}.` : "";
    if (wrong) say(() => error.textContent);
    if (!words && value !== store.state.circle.radius) store.dispatch({ type: "circle", radius: value });
    return !words;
  }

  function scrubTo(share) {
    store.dispatch({ type: "playing", on: false });
    store.dispatch({ type: "play", at: share });
  }

  function mark(at) {
    scrub.value = String(Math.round(1000 * at));
    scrub.style.setProperty("--high", `${(100 * at).toFixed(1)}%`);
    attribute(scrub, "aria-valuetext", `${Math.round(100 * at)} percent`);
    write(place, `${Math.round(100 * at)} %`);
    for (const { line, value, text } of cursors) {
      attribute(line, "x1", String(at * WIDTH));
      attribute(line, "x2", String(at * WIDTH));
      write(value, text(at));
    }
  }

  function toggle() {
    const { trace, playing, at } = store.state;
    if (playing) return store.dispatch({ type: "playing", on: false });
    if (!trace) return draw(start);
    if (at >= 1) store.dispatch({ type: "play", at: 0 });
    return start();
  }

  const start = () => store.dispatch({ type: "playing", on: true });

  // While it plays, each frame takes the arm on; the state says when it stops.
  function tick(now) {
    timer = null;
    const { playing, at } = store.state;
    if (!playing || !root.isConnected) return;
    const share = Math.min(1, at + Math.max(0, Math.min(100, now - last)) / 1000 / (calm() ? 16 : 8));
    last = now;
    store.dispatch({ type: "play", at: share });
    if (share === 1) store.dispatch({ type: "playing", on: false });
    else timer = requestAnimationFrame(tick);
  }

  function lay() {
    const { arm, trace, unit, wrench } = store.state;
    shown = { arm, trace, unit, wrench };
    root.classList.toggle("empty", !trace);
    cursors = [];
    plots.replaceChildren();
    write(verdict, verdictText(store.state));
    if (!trace) return;
    const torques = quantity.value === "torque";
    const rows = torques ? trace.map((q) => heldBy(arm, q, wrench)) : trace;
    plots.append(
      ...joints(arm).map((row, i) =>
        plot(
          row,
          rows.map((r) => r[i]),
          torques,
        ),
      ),
    );
    mark(store.state.at);
  }

  function plot(row, values, torques) {
    const joint = store.state.arm.rows[row];
    const [lower, upper] = torques
      ? [-(joint.effort ?? Infinity), joint.effort ?? Infinity]
      : [joint.lower ?? -Infinity, joint.upper ?? Infinity];
    const [low, high] = [Math.min(...values), Math.max(...values)];
    const least = torques ? 0.5 : isAngle(joint) ? 0.1 : 0.02;
    const middle = (low + high) / 2;
    const half = Math.max((high - low) / 2, least) * 1.15;
    const y = (v) => HEIGHT * (0.5 - (v - middle) / (2 * half));
    const points = values.map(
      (v, k) => `${((k * WIDTH) / (values.length - 1)).toFixed(1)},${y(v).toFixed(1)}`,
    );
    const beyond = (from, to) =>
      svg("rect", {
        x: 0,
        width: WIDTH,
        y: Math.max(0, from),
        height: Math.max(0, Math.min(HEIGHT, to) - Math.max(0, from)),
        class: "beyond",
      });
    const line = svg("line", { y1: 0, y2: HEIGHT, x1: 0, x2: 0, class: "cursor" });
    const picture = svg(
      "svg",
      { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: "none", "aria-hidden": "true" },
      ...(upper < Infinity ? [beyond(-1, y(upper))] : []),
      ...(lower > -Infinity ? [beyond(y(lower), HEIGHT)] : []),
      svg("polyline", { points: points.join(" ") }),
      line,
    );
    const text = (v) =>
      torques
        ? `${fixed(v, 2)} ${joint.kind === "revolute" ? "N m" : "N"}`
        : jointText(joint, v, store.state.unit);
    const value = h("span.now");
    cursors.push({ line, value, text: (share) => text(values[Math.round(share * (values.length - 1))]) });
    const past = values.some((v) => v < lower - 1e-9 || v > upper + 1e-9);
    return h(
      past ? "figure.past" : "figure",
      {},
      h(
        "figcaption",
        {},
        h("b", {}, indexed(torques ? "τ" : "q", row + 1)),
        value,
        h("span.span", {}, `${text(low)} … ${text(high)}`),
      ),
      picture,
    );
  }

  function update(state) {
    const changed = !shown || ["arm", "trace", "unit"].some((key) => shown[key] !== state[key]);
    if (changed || (quantity.value === "torque" && shown.wrench !== state.wrench)) lay();
    else if (state.trace) mark(state.at);
    plane.value = state.circle.normal;
    const typing = radius.getRootNode().activeElement === radius;
    if (!typing && !error.textContent) radius.value = short(state.circle.radius, 4);
    write(play, state.playing ? "Pause" : "Play");
    scrub.disabled = !state.trace;
    if (state.playing && !timer) {
      last = performance.now();
      timer = requestAnimationFrame(tick);
    }
  }
  return { root, update, summary: () => verdict.textContent };
}

function heldBy(arm, q, wrench) {
  const frames = linkFrames(arm, q);
  const push = wrenchTorque(jacobianColumns(arm, frames), wrench);
  return gravityTorque(arm, frames).map((g, i) => g - push[i]);
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
