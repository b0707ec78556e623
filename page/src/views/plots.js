// One small plot for each joint along a path, with a cursor where the arm is and a tint beyond the
// joint's limits.

import { attribute, h, indexed, svg, write } from "../dom.js";
import { joints } from "../../../judge/geometry/kinematics.js";
import { fixed, isAngle, jointText } from "../text.js";

const [WIDTH, HEIGHT] = [220, 54];

export function makePlots() {
  const root = h("div.plots");
  let cursors = [];

  /**
   * @param {{ arm: import("../../../judge/geometry/arm.js").Arm, unit: string }} state
   * @param {number[][]} rows values for each place along the path
   * @param {boolean} torques whether they are torques rather than joint values
   */
  function lay({ arm, unit }, rows, torques) {
    cursors = [];
    const column = (i) => rows.map((row) => row[i]);
    root.replaceChildren(
      ...joints(arm).map((row, i) => plot(arm.rows[row], row, column(i), torques, unit)),
    );
  }

  function plot(joint, row, values, torques, unit) {
    const text = (v) =>
      torques
        ? `${fixed(v, 2)} ${joint.kind === "revolute" ? "N m" : "N"}`
        : jointText(joint, v, unit);
    const effort = joint.effort ?? Infinity;
    const [lower, upper] = torques
      ? [-effort, effort]
      : [joint.lower ?? -Infinity, joint.upper ?? Infinity];
    const [low, high] = [Math.min(...values), Math.max(...values)];
    const least = torques ? 0.5 : isAngle(joint) ? 0.1 : 0.02;
    const middle = (low + high) / 2;
    const half = Math.max((high - low) / 2, least) * 1.15;
    const y = (v) => HEIGHT * (0.5 - (v - middle) / (2 * half));
    const points = values.map(
      (v, k) => `${((k * WIDTH) / (values.length - 1)).toFixed(1)},${y(v).toFixed(1)}`,
    );
    const beyond = (from, to) => {
      const top = Math.max(0, from);
      return svg("rect", {
        x: 0,
        width: WIDTH,
        y: top,
        height: Math.max(0, Math.min(HEIGHT, to) - top),
        class: "beyond",
      });
    };
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
    cursors.push({
      line,
      value,
      at: (share) => text(values[Math.round(share * (values.length - 1))]),
    });
    const past = values.some((v) => v < lower - 1e-9 || v > upper + 1e-9);
    const name = h("b", {}, indexed(torques ? "τ" : "q", row + 1));
    const caption = h(
      "figcaption",
      {},
      name,
      value,
      h("span.span", {}, `${text(low)} … ${text(high)}`),
    );
    return h(past ? "figure.past" : "figure", {}, caption, picture);
  }

  function mark(at) {
    for (const { line, value, at: text } of cursors) {
      attribute(line, "x1", String(at * WIDTH));
      attribute(line, "x2", String(at * WIDTH));
      write(value, text(at));
    }
  }
  return { root, lay, mark, clear: () => ((cursors = []), root.replaceChildren()) };
}
