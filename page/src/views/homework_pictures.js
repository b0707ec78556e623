// The pictures beside the homework's runs: the wall with the runs on it, and curves over the
// circle's radius.

import { linkFrames, minus } from "../../../judge/geometry/kinematics.js";
import { attribute, h, svg, write } from "../dom.js";
import { onCircle, radiiTo } from "../runs.js";
import { branchColour } from "../look.js";
import { fixed } from "../text.js";
import { curveWords } from "./homework_words.js";

const WIDE = 260; // of the wall's picture
const [LONG, HIGH] = [260, 120]; // of the curves over the radius
const [LEAST, MOST] = [0.01, 0.1]; // m, the radii
const AROUND = radiiTo(1, 73).map((_, k) => k / 72); // shares of the way round
const OVER_RADIUS =
  "Over the circle’s radius: whole turns of a joint (bars; red where no run gets round), " +
  "and the smallest σ (line). Click to choose one.";

/** @param {() => void} changed called when the reader magnifies the errors */
export function makeWall(changed) {
  let magnify = 30;
  const words = { role: "img", "aria-label": "The wall with the runs on it" };
  const wall = svg("svg", { viewBox: `0 0 ${WIDE} ${WIDE}`, ...words });
  const zoom = h("input", {
    type: "range",
    min: 0,
    max: 3,
    step: "any",
    value: Math.log10(magnify),
    "aria-label": "Magnify the errors",
    oninput: (e) => ((magnify = 10 ** Number(e.target.value)), changed()),
  });
  const zoomed = h("output");
  const caption = h("figcaption", {}, h("label", {}, "Errors magnified ", zoom, zoomed));

  // `runs` with their results, null for one that has not come, of an arm from its start.
  function draw(arm, start, runs) {
    write(zoomed, `× ${fixed(magnify, magnify < 10 ? 1 : 0)}`);
    const top = linkFrames(arm, start).at(-1).o;
    const largest = Math.max(...runs.map(({ run }) => run.radius), LEAST);
    const scale = WIDE / (2.6 * largest);
    const lines = runs.map((one, i) => onWall(one, i, { arm, top, scale, magnify }));
    wall.replaceChildren(...lines.flat());
  }
  return { root: h("figure", {}, wall, caption), draw };
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

/** @param {(radius: number) => void} choose */
export function makeCurve(choose) {
  const curve = svg("svg", { viewBox: `0 0 ${LONG} ${HIGH}`, role: "img" });
  curve.addEventListener("click", (event) => {
    const box = curve.getBoundingClientRect();
    const share = Math.min(1, Math.max(0, (event.clientX - box.left) / box.width));
    choose(Number((LEAST + (MOST - LEAST) * share).toFixed(3)));
  });
  const x = (radius) => (LONG * (radius - LEAST)) / (MOST - LEAST);

  // The smallest singular value and the turns for each radius, and where the chosen run is.
  function draw(points, radius) {
    if (!points?.length) return curve.replaceChildren();
    const most = Math.max(...points.map(({ least }) => least), 1e-6);
    const y = (least) => HIGH - 8 - ((HIGH - 16) * least) / most;
    const line = points.map((one) => `${x(one.radius).toFixed(1)},${y(one.least).toFixed(1)}`);
    const now = { x1: x(radius), x2: x(radius), y1: 0, y2: HIGH, class: "cursor" };
    curve.replaceChildren(
      ...points.map((one) => bar(x(one.radius), one)),
      svg("polyline", { points: line.join(" "), class: "least" }),
      svg("line", now),
    );
    return attribute(curve, "aria-label", curveWords(points));
  }
  return { root: h("figure", {}, curve, h("figcaption", {}, OVER_RADIUS)), draw };
}

function bar(x, { turns, reached }) {
  const tall = Math.min(3, Math.abs(turns)) * 18;
  const place = { x: x - 3, y: HIGH - 4 - tall, width: 6, height: tall + 4 };
  return svg("rect", { ...place, class: reached ? "turns" : "broken" });
}
