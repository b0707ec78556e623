// One small plot for each joint along a path, with a cursor where the arm is and a tint beyond the
// joint's limits.

import { attribute, h, indexed, select, svg, write } from "../dom.js";
import { torquesAlong } from "../homework_run.js";
import { movingRows } from "../../../judge/geometry/kinematics.js";
import { fixed, isAngle, jointText } from "../text.js";

const [WIDTH, HEIGHT] = [220, 54];
const PLOTTED = { joint: "joint values", torque: "static torques" };

// The plots of the state's trace, and the choice of what they show.
export function makePlots(store) {
  const quantity = select("What the plots show", PLOTTED, () => update(store.state));
  const root = h("div.plots");
  let [cursors, shown] = [[], []];

  function lay({ arm, trace, unit, wrench }) {
    const torques = quantity.value === "torque";
    const rows = trace && (torques ? torquesAlong(arm, trace, wrench) : trace);
    const plotOf = (row, i) =>
      plot(
        row,
        rows.map((place) => place[i]),
        torques ? ofTorque(arm.rows[row]) : ofJoint(arm.rows[row], unit),
      );
    const made = rows ? movingRows(arm).map(plotOf) : [];
    cursors = made.map(({ cursor }) => cursor);
    root.replaceChildren(...made.map(({ figure }) => figure));
  }

  function update(state) {
    const { arm, trace, unit, wrench, at } = state;
    const shows = [arm, trace, unit, wrench, quantity.value];
    if (shows.some((one, i) => one !== shown[i])) lay(state);
    shown = shows;
    for (const { line, value, at: text } of cursors) {
      attribute(line, "x1", String(at * WIDTH));
      attribute(line, "x2", String(at * WIDTH));
      write(value, text(at));
    }
  }
  return { root, choice: h("label.right", {}, "Plots ", quantity), update };
}

// What a plot is of: the symbol, how a value is written, the limits, and the least range shown.
/** @param {import("../../../judge/geometry/arm.js").Row} joint */
const ofTorque = ({ kind, effort }) => ({
  letter: "τ",
  text: (v) => `${fixed(v, 2)} ${kind === "revolute" ? "N m" : "N"}`,
  limits: [-(effort ?? Infinity), effort ?? Infinity],
  least: 0.5,
});
const ofJoint = (joint, unit) => ({
  letter: "q",
  text: (v) => jointText(joint, v, unit),
  limits: [joint.lower ?? -Infinity, joint.upper ?? Infinity],
  least: isAngle(joint) ? 0.1 : 0.02,
});

function plot(row, values, { letter, text, limits, least }) {
  const [lower, upper] = limits;
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const half = Math.max((high - low) / 2, least) * 1.15;
  const y = (v) => HEIGHT * (0.5 - (v - (low + high) / 2) / (2 * half));
  const last = values.length - 1;
  const points = values.map((v, k) => `${((k * WIDTH) / last).toFixed(1)},${y(v).toFixed(1)}`);
  const line = svg("line", { y1: 0, y2: HEIGHT, x1: 0, x2: 0, class: "cursor" });
  const bands = [
    ...(upper < Infinity ? [beyond(-1, y(upper))] : []),
    ...(lower > -Infinity ? [beyond(y(lower), HEIGHT)] : []),
  ];
  const box = {
    viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
    preserveAspectRatio: "none",
    "aria-hidden": "true",
  };
  const picture = svg("svg", box, ...bands, svg("polyline", { points: points.join(" ") }), line);
  const value = h("span.now");
  const name = h("b", {}, indexed(letter, row + 1));
  const span = h("span.span", {}, `${text(low)} … ${text(high)}`);
  const past = values.some((v) => v < lower - 1e-9 || v > upper + 1e-9);
  const caption = h("figcaption", {}, name, value, span);
  return {
    cursor: { line, value, at: (share) => text(values[Math.round(share * last)]) },
    figure: h(past ? "figure.past" : "figure", {}, caption, picture),
  };
}

// A band beyond a limit.
function beyond(from, to) {
  const y = Math.max(0, from);
  const height = Math.max(0, Math.min(HEIGHT, to) - y);
  return svg("rect", { x: 0, width: WIDTH, y, height, class: "beyond" });
}
