// Draws the path of a checked trajectory over the wanted path, seen at right angles to its wall.

import { h, svg } from "../dom.js";
import { fitPoints } from "../fit.js";
import { linkFrames, minus, norm, plus, scaled } from "../../../judge/geometry/kinematics.js";

const SIZE = 260; // width and height of the picture
const FILLED_SHARE = 0.76; // of the picture
const ARROW = 16; // length of an arrowhead
const SHOWN_ERROR = 0.25; // the largest error as a share of the path's width, once magnified
const AXES = ["x", "y", "z"];

/**
 * Show both paths, or hide the picture if there is none.
 * @param {HTMLElement} place
 * @param {import("./question.js").Question} question
 * @param {import("./question.js").Outcome} outcome
 */
export function showPath(place, { ask, plane }, { verdict, arm }) {
  const { q, wanted } = verdict?.figures ?? {};
  const isShown = ask === "trace" && Boolean(q && wanted);
  place.hidden = !isShown;
  if (!isShown) return place.replaceChildren();
  const actual = q.map((row) => linkFrames(arm, row).at(-1).o);
  return place.replaceChildren(drawPaths(actual, wanted, plane));
}

/**
 * Draw the actual path over the wanted path.
 * @param {number[][]} actual points in m
 * @param {number[][]} wanted
 * @param {string} plane the circle's base axes, as "zy"
 */
function drawPaths(actual, wanted, plane) {
  const across = AXES.indexOf(plane.replace("z", ""));
  const { factor, path } = magnifyErrors(actual, wanted);
  const [actualPixels, wantedPixels] = projectPaths([path, wanted], across);
  const [x, y] = actualPixels[0].map(formatPixel);
  const label = `The tip's path beside the wanted circle, by ${AXES[across]} and z`;
  const picture = svg(
    "svg",
    { viewBox: `0 0 ${SIZE} ${SIZE}`, role: "img", "aria-label": label },
    makeLine(wantedPixels, "wanted"),
    makeLine(actualPixels, "actual"),
    makeArrowhead(wantedPixels, "wanted"),
    makeArrowhead(actualPixels, "actual"),
    svg("circle", { cx: x, cy: y, r: 4.5, class: "actual" }),
  );
  const depth = Math.max(...actual.map((p) => Math.abs(p[1 - across] - wanted[0][1 - across])));
  const depthNote = depth > 1e-3 ? `; it leaves the wall by ${(1000 * depth).toFixed(0)} mm` : "";
  const names = [h("span.wanted", {}, "wanted"), " ", h("span.actual", {}, "yours")];
  const factorNote = factor > 1 ? `, its errors ${factor} times as large` : "";
  return h("figure.path", {}, picture, h("figcaption", {}, ...names, factorNote, depthNote));
}

// Magnify the errors of a path by the power of ten that makes them plain to see.
function magnifyErrors(actual, wanted) {
  if (actual.length !== wanted.length) return { factor: 1, path: actual };
  const errors = actual.map((p, i) => minus(p, wanted[i]));
  const largest = Math.max(...errors.map(norm));
  const width = Math.max(...wanted.map((p) => norm(minus(p, wanted[0]))));
  const power = Math.floor(Math.log10((SHOWN_ERROR * width) / Math.max(largest, 1e-9)));
  const factor = 10 ** Math.max(0, power);
  return { factor, path: wanted.map((p, i) => plus(p, scaled(factor, errors[i]))) };
}

const formatPixel = (v) => v.toFixed(1);
const formatPoints = (pixels) => pixels.map((p) => p.map(formatPixel).join(",")).join(" ");
const makeLine = (pixels, name) => svg("polyline", { class: name, points: formatPoints(pixels) });

// Make an arrowhead a tenth of the way along a path, for its direction.
function makeArrowhead(pixels, name) {
  const i = Math.max(1, Math.round(0.1 * (pixels.length - 1)));
  const [[x0, y0], [x, y]] = [pixels[i - 1], pixels[i]];
  const length = Math.hypot(x - x0, y - y0) || 1;
  const [u, v] = [(ARROW * (x - x0)) / length, (ARROW * (y - y0)) / length];
  const back = [x - u, y - v];
  const corners = [
    [x, y],
    [back[0] - v / 2, back[1] + u / 2],
    [back[0] + v / 2, back[1] - u / 2],
  ];
  return svg("polygon", { class: name, points: formatPoints(corners) });
}

// Project paths to one picture, seen at right angles to the wall.
function projectPaths(paths, across) {
  const flat = paths.map((path) => path.map((p) => [p[across], p[2]]));
  const project = fitPoints(flat.flat(), [SIZE, SIZE], FILLED_SHARE);
  return flat.map((path) => path.map(project));
}
