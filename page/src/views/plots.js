// Draws a small plot for each joint along a path, with a cursor at the arm's position and a tint
// beyond the limits.

import { updateAttribute, h, makeIndexedSymbol, makeSelect, svg, setText } from "../dom.js";
import { computeTorquesAlong } from "../homework_run.js";
import { movingRows } from "../../../judge/geometry/kinematics.js";
import { formatFixed, formatShort, isAngle, formatJointValue } from "../text.js";

const [WIDTH, HEIGHT] = [220, 54];
const QUANTITIES = { joint: "joint values", torque: "static torques" };

/**
 * Make the plots of the state's trace and the list of quantities to plot.
 * @param {import("../state.js").Store} store
 * @param {() => string[]} getTicks returns the numbers below the start, middle and end of a plot
 */
export function makePlots(store, getTicks) {
  const quantity = makeSelect("What the plots show", QUANTITIES, () => update(store.state));
  const root = h("div.plots");
  let [cursors, shown] = [[], []];

  function rebuild({ arm, trace, unit, wrench }) {
    const torques = quantity.value === "torque";
    const rows = trace && (torques ? computeTorquesAlong(arm, trace, wrench) : trace);
    const plotOf = (row, i) =>
      makePlot(
        row,
        rows.map((place) => place[i]),
        torques ? describeTorquePlot(arm.rows[row]) : describeJointPlot(arm.rows[row], unit),
      );
    const plots = rows ? movingRows(arm).map(plotOf) : [];
    cursors = plots.map(({ cursor }) => cursor);
    for (const { figure } of plots) figure.append(makeTicks(getTicks()));
    root.replaceChildren(...plots.map(({ figure }) => figure));
  }

  function update(state) {
    const { arm, trace, unit, wrench, progress } = state;
    const shows = [arm, trace, unit, wrench, quantity.value];
    if (shows.some((value, i) => value !== shown[i])) rebuild(state);
    shown = shows;
    for (const { line, value, textAt } of cursors) {
      updateAttribute(line, "x1", String(progress * WIDTH));
      updateAttribute(line, "x2", String(progress * WIDTH));
      setText(value, textAt(progress));
    }
  }
  return { root, choice: h("label.right", {}, "Plots ", quantity), update };
}

// Return the symbol of a plot, the format of its values, the limits, and the smallest range shown.
/** @param {import("../../../judge/geometry/arm.js").Row} joint */
const describeTorquePlot = ({ kind, effort }) => ({
  letter: "τ",
  text: (v) => `${formatFixed(v, 2)} ${kind === "revolute" ? "N m" : "N"}`,
  limits: [-(effort ?? Infinity), effort ?? Infinity],
  least: 0.5,
});
const describeJointPlot = (joint, unit) => ({
  letter: "q",
  text: (v) => formatJointValue(joint, v, unit),
  limits: [joint.lower ?? -Infinity, joint.upper ?? Infinity],
  least: isAngle(joint) ? 0.1 : 0.02,
});

function makePlot(row, values, { letter, text, limits, least }) {
  const [lower, upper] = limits;
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const half = Math.max((high - low) / 2, least) * 1.15;
  const y = (v) => HEIGHT * (0.5 - (v - (low + high) / 2) / (2 * half));
  const last = values.length - 1;
  const points = values.map((v, k) => `${((k * WIDTH) / last).toFixed(1)},${y(v).toFixed(1)}`);
  const line = svg("line", { y1: 0, y2: HEIGHT, x1: 0, x2: 0, class: "cursor" });
  const bands = [
    ...(upper < Infinity ? [makeLimitBand(-1, y(upper))] : []),
    ...(lower > -Infinity ? [makeLimitBand(y(lower), HEIGHT)] : []),
  ];
  const box = {
    viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
    preserveAspectRatio: "none",
    "aria-hidden": "true",
  };
  const picture = svg("svg", box, ...bands, svg("polyline", { points: points.join(" ") }), line);
  const value = h("span.now");
  const name = h("b", {}, makeIndexedSymbol(letter, row + 1));
  const span = h("span.span", {}, `${text(low)} … ${text(high)}`);
  const past = values.some((v) => v < lower - 1e-9 || v > upper + 1e-9);
  const caption = h("figcaption", {}, name, value, span);
  return {
    cursor: { line, value, textAt: (share) => text(values[Math.round(share * last)]) },
    figure: h(past ? "figure.past" : "figure", {}, caption, picture),
  };
}

// Make the axis below a plot.
const makeTicks = (texts) =>
  h(
    "div.ticks",
    { "aria-hidden": "true" },
    texts.map((text) => h("span", {}, text)),
  );

/** Return the ticks of a time axis of so many seconds. */
export function formatTimeTicks(seconds) {
  const time = (t) => formatShort(t, t < 1 ? 2 : 1);
  return ["0", `t = ${time(seconds / 2)} s`, `${time(seconds)} s`];
}

/** The ticks of a path that has no times. */
export const PATH_TICKS = ["0 %", "50 % of the path", "100 %"];

// Make a band beyond a limit.
function makeLimitBand(from, to) {
  const y = Math.max(0, from);
  const height = Math.max(0, Math.min(HEIGHT, to) - y);
  return svg("rect", { x: 0, width: WIDTH, y, height, class: "beyond" });
}
