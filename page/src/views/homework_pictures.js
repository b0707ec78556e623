// The wall with the homework's runs.

import { linkFrames, minus } from "../../../judge/geometry/kinematics.js";
import { h, makeRangeInput, svg, setText } from "../dom.js";
import { getCirclePoint } from "../motion.js";
import { getBranchColour } from "../look.js";
import { formatFixed, formatShort } from "../text.js";

const WALL_SIZE = 260; // width and height of the picture
const CIRCLE_SHARES = Array.from({ length: 73 }, (_, k) => k / 72);

/**
 * Make the wall.
 * @param {() => void} changed called when the reader changes the magnification of errors
 */
export function makeWall(changed) {
  let magnify = 30;
  const words = { role: "img", "aria-label": "The wall with the runs on it" };
  const wall = svg("svg", { viewBox: `0 0 ${WALL_SIZE} ${WALL_SIZE}`, ...words });
  const zoom = makeRangeInput("Magnify the errors", [0, 3], {
    value: Math.log10(magnify),
    oninput: (e) => ((magnify = 10 ** Number(e.target.value)), changed()),
  });
  const zoomed = h("output");
  const caption = h("figcaption", {}, h("label", {}, "Errors magnified ", zoom, zoomed));

  // Draw runs that begin at `start`; a run without a result has null.
  function draw(arm, start, runs) {
    setText(zoomed, `× ${formatFixed(magnify, magnify < 10 ? 1 : 0)}`);
    const top = linkFrames(arm, start).at(-1).o;
    const largestRadius = Math.max(...runs.map(({ run }) => run.radius));
    const scale = WALL_SIZE / (2.6 * largestRadius);
    const lines = runs.map((one, i) => drawRun(one, i, { arm, top, scale, magnify }));
    wall.replaceChildren(...lines.flat(), ...drawAxes(runs[0].run, scale));
  }
  return { root: h("figure.wall", {}, wall, caption), draw };
}

// Draw the base axes in the wall: from the circle's centre, and as long as its radius.
function drawAxes({ normal, radius }, scale) {
  const length = scale * radius;
  const [x, y] = [WALL_SIZE / 2, 0.13 * WALL_SIZE + length];
  const sense = normal === "x" ? 1 : -1; // y points to the right, x to the left
  const across = normal === "x" ? "y" : "x";
  return [
    svg("polyline", {
      points: `${x + sense * length},${y} ${x},${y} ${x},${y - length}`,
      class: "axes",
    }),
    svg(
      "text",
      { x: x + sense * 0.5 * length, y: y + 16, "text-anchor": "middle" },
      `${across}: ${formatShort(radius, 3)} m`,
    ),
    svg("text", { x: x + 6, y: y - 0.5 * length }, "z"),
  ];
}

// Draw a run as seen against the wall's normal axis: the wanted circle, and the run with its errors
// magnified.
function drawRun({ run, result }, i, { arm, top, scale, magnify }) {
  const flat = (o) => {
    const d = minus(o, top);
    const across = run.normal === "x" ? d[1] : -d[0];
    const [x, y] = [WALL_SIZE / 2 + scale * across, 0.13 * WALL_SIZE - scale * d[2]];
    return `${x.toFixed(1)},${y.toFixed(1)}`;
  };
  const wanted = CIRCLE_SHARES.map((share) => flat(getCirclePoint(top, run, share).o));
  const circle = svg("polyline", { points: wanted.join(" "), class: "asked" });
  if (!result) return [circle];
  const points = result.path.map((q, k) => {
    const should = getCirclePoint(top, run, result.at[k]).o;
    const is = linkFrames(arm, q).at(-1).o;
    return flat(should.map((v, axis) => v + magnify * (is[axis] - v)));
  });
  return [circle, svg("polyline", { points: points.join(" "), stroke: getBranchColour(i) })];
}
