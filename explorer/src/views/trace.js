// A path played back: where the tip goes, and what each joint does meanwhile.

import { h, indexed, svg, calm } from "../dom.js";
import { gravityTorque, jacobianColumns, joints, linkFrames, wrenchTorque } from "../kinematics.js";
import { outside, traceCircle } from "../motion.js";
import { fixed, isAngle, jointText, listed } from "../text.js";

export const title = "Circle trace";

const [WIDTH, HEIGHT] = [220, 54];

export function build(store) {
  const play = h("button.main", { type: "button", onclick: toggle }, "Play");
  const scrub = h("input", { type: "range", min: 0, max: 1000, value: 0, "aria-label": "Place along the path", oninput: (e) => pause(() => goTo(e.target.value / 1000)) });
  const place = h("output.place");
  const plane = h("select", { "aria-label": "Plane of the circle" }, ["x", "y", "z"].map((axis) => h("option", { value: axis }, `${axis} = const`)));
  const radius = h("input.small", { type: "text", inputmode: "decimal", value: "0.1", "aria-label": "Radius of the circle, m" });
  const quantity = h("select", { "aria-label": "What the plots show", onchange: () => lay() }, h("option", { value: "joint" }, "joint values"), h("option", { value: "torque" }, "static torques"));
  const verdict = h("p.verdict", { role: "status" });
  const plots = h("div.plots");
  const root = h("div.trace", {},
    h("div.row.transport", {}, play, scrub, place),
    h("div.row", {}, h("label", {}, "Plane ", plane), h("label", {}, "Radius ", radius, " m"), h("button", { type: "button", onclick: draw }, "Draw a circle from here"), h("label.right", {}, "Plots ", quantity)),
    verdict, plots);
  let [shown, cursors, timer, at] = [null, [], null, 0];

  function draw() {
    const size = Number(radius.value.replace(",", "."));
    const good = size > 0 && size <= 5;
    radius.setAttribute("aria-invalid", String(!good));
    if (!good) return (verdict.textContent = `The radius “${radius.value}” is no length above 0; write metres, as 0.1.`);
    pause();
    const { path, stray } = traceCircle(store.state.arm, store.state.q, { normal: plane.value, radius: size });
    at = 0;
    store.set({ trace: path, stray, q: path[0] });
  }

  // The joint vector a share of the way along the path.
  function goTo(share) {
    const { trace } = store.state;
    if (!trace) return;
    at = share;
    const k = Math.min(trace.length - 2, Math.floor(share * (trace.length - 1)));
    const rest = share * (trace.length - 1) - k;
    store.set({ q: trace[k].map((v, i) => v + rest * (trace[k + 1][i] - v)) }, "trace");
    mark();
  }

  function mark() {
    scrub.value = Math.round(1000 * at);
    scrub.style.setProperty("--high", `${100 * at}%`);
    scrub.setAttribute("aria-valuetext", `${Math.round(100 * at)} percent`);
    place.textContent = `${Math.round(100 * at)} %`;
    for (const { line, value, text } of cursors) {
      line.setAttribute("x1", at * WIDTH);
      line.setAttribute("x2", at * WIDTH);
      value.textContent = text(at);
    }
  }

  function toggle() {
    if (timer) return pause();
    if (!store.state.trace) draw();
    if (at >= 1) at = 0;
    play.textContent = "Pause";
    const [seconds, start, from] = [calm() ? 16 : 8, performance.now(), at];
    const tick = (now) => {
      const share = Math.min(1, from + Math.max(0, now - start) / 1000 / seconds);
      goTo(share);
      if (share < 1 && root.isConnected) timer = requestAnimationFrame(tick);
      else pause();
    };
    timer = requestAnimationFrame(tick);
  }

  function pause(then) {
    cancelAnimationFrame(timer);
    timer = null;
    play.textContent = "Play";
    then?.();
  }

  function lay() {
    const { arm, trace, unit, wrench } = store.state;
    shown = { arm, trace, unit, wrench };
    root.classList.toggle("empty", !trace);
    cursors = [];
    plots.replaceChildren();
    verdict.textContent = verdictText(store.state);
    if (!trace) return;
    const torques = quantity.value === "torque";
    const rows = torques ? trace.map((q) => heldBy(arm, q, wrench)) : trace;
    plots.append(...joints(arm).map((row, i) => plot(row, rows.map((r) => r[i]), torques)));
    mark();
  }

  function plot(row, values, torques) {
    const joint = store.state.arm.rows[row];
    const [lower, upper] = torques ? [-(joint.effort ?? Infinity), joint.effort ?? Infinity] : [joint.lower ?? -Infinity, joint.upper ?? Infinity];
    const [low, high] = [Math.min(...values), Math.max(...values)];
    const least = torques ? 0.5 : isAngle(joint) ? 0.1 : 0.02;
    const middle = (low + high) / 2;
    const half = Math.max((high - low) / 2, least) * 1.15;
    const y = (v) => HEIGHT * (0.5 - (v - middle) / (2 * half));
    const points = values.map((v, k) => `${((k * WIDTH) / (values.length - 1)).toFixed(1)},${y(v).toFixed(1)}`);
    const beyond = (from, to) => svg("rect", { x: 0, width: WIDTH, y: Math.max(0, from), height: Math.max(0, Math.min(HEIGHT, to) - Math.max(0, from)), class: "beyond" });
    const line = svg("line", { y1: 0, y2: HEIGHT, x1: 0, x2: 0, class: "cursor" });
    const picture = svg("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: "none", "aria-hidden": "true" },
      ...(upper < Infinity ? [beyond(-1, y(upper))] : []), ...(lower > -Infinity ? [beyond(y(lower), HEIGHT)] : []),
      svg("polyline", { points: points.join(" ") }), line);
    const text = (v) => (torques ? `${fixed(v, 2)} ${joint.kind === "revolute" ? "N m" : "N"}` : jointText(joint, v, store.state.unit));
    const value = h("span.now");
    cursors.push({ line, value, text: (share) => text(values[Math.round(share * (values.length - 1))]) });
    const past = values.some((v) => v < lower - 1e-9 || v > upper + 1e-9);
    return h(past ? "figure.past" : "figure", {},
      h("figcaption", {}, h("b", {}, indexed(torques ? "τ" : "q", row + 1)), value, h("span.span", {}, `${text(low)} … ${text(high)}`)), picture);
  }

  function update(state) {
    const changed = !shown || ["arm", "trace", "unit"].some((key) => shown[key] !== state[key]);
    if (changed || (quantity.value === "torque" && shown.wrench !== state.wrench)) {
      if (shown && shown.trace !== state.trace) at = 0;
      lay();
    }
  }
  return { root, update };
}

function heldBy(arm, q, wrench) {
  const frames = linkFrames(arm, q);
  const push = wrenchTorque(jacobianColumns(arm, frames), wrench);
  return gravityTorque(arm, frames).map((g, i) => g - push[i]);
}

function verdictText({ arm, trace, stray }) {
  if (!trace) return "Play draws a circle of this radius from where the tip is now; the tool keeps its orientation.";
  const past = joints(arm).flatMap((row, i) => (trace.some((q) => outside(arm.rows[row], q[i])) ? [`joint ${row + 1}`] : []));
  const limits = past.length ? `${listed(past)} would have to pass ${past.length > 1 ? "their limits" : "its limit"} (tinted).` : "All joints stay within their limits.";
  if (stray > 1e-3) return `The whole circle is not within reach: the tip strays by up to ${fixed(1000 * stray, 0)} mm.`;
  return limits[0].toUpperCase() + limits.slice(1);
}
