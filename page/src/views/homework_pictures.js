// The wall with the homework's runs on it.

import { linkFrames, minus } from "../../../judge/geometry/kinematics.js";
import { h, slider, svg, write } from "../dom.js";
import { onCircle } from "../motion.js";
import { branchColour } from "../look.js";
import { fixed } from "../text.js";

const WIDE = 260; // of the wall's picture
const AROUND = Array.from({ length: 73 }, (_, k) => k / 72); // shares of the way round

/** @param {() => void} changed called when the reader magnifies the errors */
export function makeWall(changed) {
  let magnify = 30;
  const words = { role: "img", "aria-label": "The wall with the runs on it" };
  const wall = svg("svg", { viewBox: `0 0 ${WIDE} ${WIDE}`, ...words });
  const zoom = slider("Magnify the errors", [0, 3], {
    value: Math.log10(magnify),
    oninput: (e) => ((magnify = 10 ** Number(e.target.value)), changed()),
  });
  const zoomed = h("output");
  const caption = h("figcaption", {}, h("label", {}, "Errors magnified ", zoom, zoomed));

  // `runs` with their results, null for one that has not come, of an arm from its start.
  function draw(arm, start, runs) {
    write(zoomed, `× ${fixed(magnify, magnify < 10 ? 1 : 0)}`);
    const top = linkFrames(arm, start).at(-1).o;
    const largest = Math.max(...runs.map(({ run }) => run.radius));
    const scale = WIDE / (2.6 * largest);
    const lines = runs.map((one, i) => onWall(one, i, { arm, top, scale, magnify }));
    wall.replaceChildren(...lines.flat());
  }
  return { root: h("figure.wall", {}, wall, caption), draw };
}

// A run as it is seen from the arm: the circle that was asked for, and the run with its error made
// larger.
function onWall({ run, result }, i, { arm, top, scale, magnify }) {
  const flat = (o) => {
    const d = minus(o, top);
    const across = run.normal === "x" ? d[1] : -d[0];
    return `${(WIDE / 2 + scale * across).toFixed(1)},${(0.13 * WIDE - scale * d[2]).toFixed(1)}`;
  };
  const asked = AROUND.map((share) => flat(onCircle(top, run, share).o));
  const circle = svg("polyline", { points: asked.join(" "), class: "asked" });
  if (!result) return [circle];
  const points = result.path.map((q, k) => {
    const should = onCircle(top, run, result.at[k]).o;
    const is = linkFrames(arm, q).at(-1).o;
    return flat(should.map((v, axis) => v + magnify * (is[axis] - v)));
  });
  return [circle, svg("polyline", { points: points.join(" "), stroke: branchColour(i) })];
}
