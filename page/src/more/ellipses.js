// The idea of the inverse kinematics by structure: two ellipses, one of joint 1 and one of joint 3,
// and their crossings. A lever turns the twist between axes 2 and 3 to 0, which flattens one.

import { h, makeIndexedSymbol, svg } from "../dom.js";
import { getBranchColour } from "../look.js";
import { findCrossings, sampleEllipses } from "./ellipse_curves.js";
import { replaceAt } from "../text.js";
import { formatWholeDegrees, makeLever, makeLive } from "./live.js";

const [WIDTH, HEIGHT, MARGIN] = [300, 220, 22];

// Return a function from chart units to pixels in which all points are in view.
function fitPixels(points) {
  const spans = [0, 1].map((i) => {
    const values = points.map((p) => p[i]);
    const low = Math.min(...values);
    return [low, Math.max(1e-9, Math.max(...values) - low)];
  });
  const share = (p, i) => (p[i] - spans[i][0]) / spans[i][1];
  return (p) => [
    MARGIN + (WIDTH - 2 * MARGIN) * share(p, 0),
    HEIGHT - MARGIN - (HEIGHT - 2 * MARGIN) * share(p, 1),
  ];
}

function drawLine(points, toPixel, colour) {
  const corners = points.map((p) => toPixel(p).map((v) => v.toFixed(1)));
  const look = { fill: "none", stroke: colour, "stroke-width": 2.5 };
  return svg("polyline", { points: corners.join(" "), ...look });
}

function drawLabel(text, attributes) {
  return svg("text", { "font-size": 11, fill: "currentColor", ...attributes }, text);
}

// Make the chart of both ellipses and their crossings.
function makeChart() {
  const description = "Two ellipses: height along axis 2, squared distance from a point of it";
  const viewBox = `0 0 ${WIDTH} ${HEIGHT}`;
  const root = svg("svg", { viewBox, role: "img", "aria-label": description });
  const middle = HEIGHT / 2 + 70;
  const labels = [
    drawLabel("height along axis 2", { x: WIDTH / 2 - 55, y: HEIGHT - 4 }),
    drawLabel("distance² from a point of it", {
      ...{ x: 12, y: middle, transform: `rotate(-90 12 ${middle})` },
    }),
  ];
  function update(ellipses, crossings) {
    const toPixel = fitPixels(ellipses.flat());
    const dots = crossings.map((p) => {
      const [cx, cy] = toPixel(p);
      return svg("circle", { cx, cy, r: 4.5, fill: "currentColor" });
    });
    const lines = ellipses.map((points, k) => drawLine(points, toPixel, getBranchColour(k)));
    root.replaceChildren(...lines, ...dots, ...labels);
  }
  return { root, update };
}

function describeCrossings(arm, count) {
  const flat = Math.abs(Math.sin(arm.rows[1].alpha)) < 1e-9;
  const solutions = `${count} ${count === 1 ? "solution" : "solutions"} for this position`;
  if (!flat) return `The ellipses of joints 1 and 3 cross ${count} times: ${solutions}.`;
  return (
    "Axes 2 and 3 are parallel: the ellipse of joint 3 is a segment, gone through twice. " +
    `Each crossing counts twice, elbow up and elbow down: ${solutions}.`
  );
}

/** Build the figure; returns a function that removes it. */
export function buildEllipsesFigure(host, spec) {
  const chart = makeChart();
  const legend = h("p.words", {}, "Blue: joint 1, undone. Orange: joint 3. Drag the tip.");
  const findCrossingsOf = (arm, frames) => {
    const ellipses = sampleEllipses(arm, frames.at(-1).o);
    return { ellipses, crossings: findCrossings(ellipses[0], ellipses[1]) };
  };
  const message = ({ arm }, { frames }) =>
    describeCrossings(arm, findCrossingsOf(arm, frames).crossings.length);
  const live = makeLive(host, spec, { side: [chart.root, legend], message });
  const { rows } = live.store.state.arm;
  const put = (alpha) => {
    const arm = { ...spec.arm, rows: replaceAt(rows, 1, { ...rows[1], alpha }) };
    live.store.dispatch({ type: "selectArm", arm, q: live.store.state.q });
  };
  const start = rows[1].alpha;
  const options = { put, text: formatWholeDegrees, signal: live.signal };
  const lever = makeLever(makeIndexedSymbol("α", 2), [0, start || 1], start, options);
  live.card.querySelector(".side").prepend(lever.root);
  live.follow(({ arm }, { frames }) => {
    const { ellipses, crossings } = findCrossingsOf(arm, frames);
    chart.update(ellipses, crossings);
  });
  return live.dispose;
}
