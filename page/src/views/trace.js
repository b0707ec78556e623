// A path played back: the tip's path and the joint values along it.

import { h, makeSelect, setText } from "../dom.js";
import { readEntry } from "../../../judge/reading/entry.js";
import { markInvalid, refillField, makeTextField } from "../entry.js";
import { makeLatestJob } from "../jobs.js";
import { formatShort } from "../text.js";
import { joinList, capitalize } from "../../../judge/sentences.js";
import { makePlots, PATH_TICKS } from "./plots.js";
import { makeTransport } from "./transport.js";
import { listJointsPastLimits } from "../statements.js";

export const title = "Circle trace";

const MAX_RADIUS = 5; // m

export function build(store, { announce, signal }) {
  const verdict = h("p.verdict");
  const asked = makeCircleFields(store, announce);
  const plots = makePlots(store, () => PATH_TICKS);
  const drawing = makeDrawButton(store, asked, () => announce(() => verdict.textContent, true));
  const transport = makeTransport(store, { signal, makeTrace: drawing.draw });
  const row = h("div.row", {}, asked.labels, drawing.root, plots.choice);
  const root = h("div.trace", {}, transport.root, row, asked.error, verdict, plots.root);

  function update(state) {
    setText(verdict, describeTrace(state));
    plots.update(state);
    asked.update(state.circle);
    transport.update(state);
  }
  return { root, update, summary: () => verdict.textContent };
}

// Make the button that draws a circle from the current tip; `onReady` is called once it is drawn.
function makeDrawButton(store, asked, onDrawn) {
  const root = h("button", { onclick: () => draw() }, "Draw a circle from here");
  const ask = makeLatestJob("circle");
  function draw(onReady = () => {}) {
    if (!asked.sized()) return;
    const { arm, q, circle } = store.state;
    ask({ arm, q, circle }, ({ path, wantedPath }) => {
      store.dispatch({ type: "setTrace", arm, circle, path, wantedPath });
      onDrawn();
      onReady();
    });
  }
  return { root, draw };
}

// Make the fields for the circle's plane and radius.
function makeCircleFields(store, announce) {
  const error = h("p.error");
  const planes = { x: "x = const", y: "y = const", z: "z = const" };
  const chosen = (normal) => store.dispatch({ type: "setCircle", normal });
  const plane = makeSelect("Plane of the circle", planes, chosen);
  const typed = (_, whole) => sized(whole);
  const radius = makeTextField("Radius of the circle, m", typed, { class: "small" });

  // Return whether the typed radius is valid; a valid one goes into the state at once.
  function sized(whole = true) {
    const { value, error: fault } = readEntry(radius.value, "length");
    const good = value > 0 && value <= MAX_RADIUS;
    const none = `“${radius.value}” is no length above 0 and up to ${MAX_RADIUS} m`;
    const message = markInvalid(radius, good ? "" : (fault ?? none), whole);
    setText(error, message && `The radius ${message}.`);
    if (message) announce(() => error.textContent);
    if (good && value !== store.state.circle.radius)
      store.dispatch({ type: "setCircle", radius: value });
    return good;
  }

  function update(circle) {
    plane.value = circle.normal;
    if (!error.textContent) refillField(radius, formatShort(circle.radius, 4));
  }
  const labels = [h("label", {}, "Plane ", plane), h("label", {}, "Radius ", radius, " m")];
  return { labels, error, sized, update };
}

const DRAW_HELP =
  "Play draws a circle of this radius from where the tip is now; the tool keeps its orientation.";

function describeTrace({ arm, trace, wantedPath }) {
  if (!trace) return DRAW_HELP;
  if (wantedPath && trace.length < wantedPath.length) {
    const share = Math.floor((100 * (trace.length - 1)) / (wantedPath.length - 1));
    return `The whole circle is not within reach: the arm stops after ${share} % of it.`;
  }
  const past = listJointsPastLimits(arm, trace);
  if (!past.length) return "All joints stay within their limits.";
  const whose = past.length > 1 ? "their limits" : "its limit";
  const message = `${joinList(past)} would have to pass ${whose} (tinted).`;
  return capitalize(message);
}
