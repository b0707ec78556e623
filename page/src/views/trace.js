// A path played back: where the tip goes, and what each joint does meanwhile.

import { h, select, write } from "../dom.js";
import { readEntry } from "../../../judge/reading/entry.js";
import { marked, refill, textField } from "../entry.js";
import { latest } from "../jobs.js";
import { short } from "../text.js";
import { joinList, capitalize } from "../../../judge/sentences.js";
import { makePlots } from "./plots.js";
import { makeTransport } from "./transport.js";
import { pastLimits } from "../verdicts.js";

export const title = "Circle trace";

const MOST_RADIUS = 5; // m

export function build(store, { say, signal }) {
  const verdict = h("p.verdict");
  const asked = makeAsked(store, say);
  const plots = makePlots(store);
  const drawing = makeDrawing(store, asked, () => say(() => verdict.textContent, true));
  const transport = makeTransport(store, { signal, begin: drawing.draw });
  const row = h("div.row", {}, asked.labels, drawing.root, plots.choice);
  const root = h("div.trace", {}, transport.root, row, asked.error, verdict, plots.root);

  function update(state) {
    write(verdict, verdictText(state));
    plots.update(state);
    asked.update(state.circle);
    transport.update(state);
  }
  return { root, update, summary: () => verdict.textContent };
}

// A circle from where the tip is; `then` once it is drawn.
function makeDrawing(store, asked, tell) {
  const root = h("button", { onclick: () => draw() }, "Draw a circle from here");
  const ask = latest("circle");
  function draw(then = () => {}) {
    if (!asked.sized()) return;
    const { arm, q, circle } = store.state;
    ask({ arm, q, circle }, ({ path, wanted }) => {
      store.dispatch({ type: "traced", arm, circle, path, wanted });
      tell();
      then();
    });
  }
  return { root, draw };
}

// The circle that is asked for: its plane and its radius.
function makeAsked(store, say) {
  const error = h("p.error");
  const planes = { x: "x = const", y: "y = const", z: "z = const" };
  const chosen = (normal) => store.dispatch({ type: "circle", normal });
  const plane = select("Plane of the circle", planes, chosen);
  const typed = (_, whole) => sized(whole);
  const radius = textField("Radius of the circle, m", typed, { class: "small" });

  // Whether the radius that is typed is one; it goes into the state as soon as it is.
  function sized(whole = true) {
    const { value, error: fault } = readEntry(radius.value, "length");
    const good = value > 0 && value <= MOST_RADIUS;
    const none = `“${radius.value}” is no length above 0 and up to ${MOST_RADIUS} m`;
    const words = marked(radius, good ? "" : (fault ?? none), whole);
    write(error, words && `The radius ${words}.`);
    if (words) say(() => error.textContent);
    if (good && value !== store.state.circle.radius)
      store.dispatch({ type: "circle", radius: value });
    return good;
  }

  function update(circle) {
    plane.value = circle.normal;
    if (!error.textContent) refill(radius, short(circle.radius, 4));
  }
  const labels = [h("label", {}, "Plane ", plane), h("label", {}, "Radius ", radius, " m")];
  return { labels, error, sized, update };
}

const UNDRAWN =
  "Play draws a circle of this radius from where the tip is now; the tool keeps its orientation.";

function verdictText({ arm, trace, wanted }) {
  if (!trace) return UNDRAWN;
  if (wanted && trace.length < wanted.length) {
    const share = Math.floor((100 * (trace.length - 1)) / (wanted.length - 1));
    return `The whole circle is not within reach: the arm stops after ${share} % of it.`;
  }
  const past = pastLimits(arm, trace);
  if (!past.length) return "All joints stay within their limits.";
  const whose = past.length > 1 ? "their limits" : "its limit";
  const words = `${joinList(past)} would have to pass ${whose} (tinted).`;
  return capitalize(words);
}
