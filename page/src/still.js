// Draws an arm as still lines in the page's text colour. The drawing is shown until the script has
// loaded, if the browser has no WebGL, and on paper.

import { estimateReach } from "../../judge/geometry/arm.js";
import { dot, linkFrames, plus, scaled } from "../../judge/geometry/kinematics.js";
import { svg } from "./dom.js";
import { fitPoints } from "./fit.js";
import { AXIS_COLOURS } from "./look.js";
import { getBarrelSegments, getLinkSegments } from "./picking.js";

const [WIDTH, HEIGHT] = [480, 320];
const FILLED_SHARE = 0.81; // share of the picture, as in the live one
// Axes of the live picture's initial camera.
const RIGHT = [0.6816, 0.7317, 0];
const UP = [-0.2514, 0.2342, 0.9391];

/**
 * Make the still picture.
 * @param {import("./state.js").State} state
 * @param {{ frames: any[] }} derived
 * @param {string} description description for screen readers
 */
export function makeStillPicture({ arm, trace, frames: which }, { frames }, description) {
  const size = estimateReach(arm);
  const drawn = frames.filter((_, i) => which === "all" || i === 0 || i === frames.length - 1);
  const axes = drawn.flatMap((frame) =>
    Object.entries(AXIS_COLOURS.light).map(([axis, colour]) => {
      const tip = plus(frame.o, scaled(0.1 * size, frame[axis]));
      return { points: [frame.o, tip], width: 2.5, colour };
    }),
  );
  const links = getLinkSegments(arm, frames).map(({ from, to }) => [from, to]);
  const barrels = getBarrelSegments(arm, frames, size).map(({ from, to }) => [from, to]);
  const path = trace?.map((q) => linkFrames(arm, q).at(-1).o) ?? [];
  const project = (p) => [dot(RIGHT, p), dot(UP, p)];
  const seen = [...links.flat(), ...axes.flatMap(({ points }) => points), ...path].map(project);
  const fit = fitPoints(seen, [WIDTH, HEIGHT], FILLED_SHARE);
  const place = (p) => fit(project(p));
  const lines = (list, width, colour = "currentColor", ends = "round") =>
    list.map((points) => makePolyline(points.map(place), { width, colour, ends }));
  const group = (opacity, parts) => svg("g", { opacity }, ...parts);
  return svg(
    "svg",
    {
      viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
      width: WIDTH,
      class: "still",
      role: "img",
      "aria-label": description,
    },
    group(0.35, lines(links, 10)),
    group(0.75, lines(barrels, 12, "currentColor", "butt")),
    ...lines(path.length ? [path] : [], 2.5, AXIS_COLOURS.light.x),
    ...axes.flatMap(({ points, width, colour }) => lines([points], width, colour)),
  );
}

function makePolyline(points, { width, colour, ends }) {
  const places = points.map((p) => p.map((v) => v.toFixed(1)).join(",")).join(" ");
  const how = {
    fill: "none",
    stroke: colour,
    "stroke-width": width,
    "stroke-linecap": ends,
    "stroke-linejoin": "round",
  };
  return svg("polyline", { points: places, ...how });
}
