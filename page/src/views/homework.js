// The homework's circle played, and its mistakes: any number of runs at once on the wall, each with
// its own method.

import css from "./homework.css";
import { h, select, write } from "../dom.js";
import { ask, latest } from "../jobs.js";
import { linkFrames } from "../../../judge/geometry/kinematics.js";
import { isPanda, torquesAlong } from "../runs.js";
import { branchColour } from "../look.js";
import { makeFields } from "./homework_fields.js";
import { makeCurve, makeWall } from "./homework_pictures.js";
import { millimetres, named, said, startingRun } from "./homework_words.js";
import { makePlots, PLOTTED } from "./plots.js";
import { makeTransport } from "./transport.js";

const MODELS = { "": "none", wrench: "wrong sign of F", centres: "centres of mass not converted" };
const MOST_RUNS = 8;

export const build = (store, tools) => new Homework(store, tools);

/** The view: which run is chosen, where all begin, and what came of them. */
class Homework {
  /** @param {import("../state.js").Store} store */
  constructor(store, { say, signal }) {
    this.store = store;
    this.say = say;
    this.signal = signal;
    this.chosen = 0;
    this.start = store.state.q; // where the runs begin
    this.results = new Map(); // by arm, start and run
    this.shown = /** @type {any} */ ({});
    this.list = h("div.runs", { role: "radiogroup", "aria-label": "Runs" });
    this.verdict = h("p.verdict");
    this.wall = makeWall(() => this.drawWall());
    this.curve = makeCurve((radius) => this.edit({ radius }));
    this.plots = makePlots();
    this.transport = makeTransport(store, { signal, begin: () => this.show() });
    this.quantity = select("What the plots show", PLOTTED, () => this.lay());
    this.model = select("Mistake in the torques", MODELS, () => this.lay());
    this.fields = makeFields((patch) => this.edit(patch));
    this.askWinding = latest("winding");
    this.root = this.laidOut();
  }

  laidOut() {
    const button = (text, onclick) => h("button", { type: "button", onclick }, text);
    this.add = button("Add a run", () => this.addRun());
    this.remove = button("Remove it", () => this.removeRun());
    const here = button("Start where the arm stands", () => this.startHere());
    const plots = h("label", {}, "Plots ", this.quantity);
    const model = h("label", {}, "Mistake in the torques ", this.model);
    return h(
      "div.homework",
      {},
      h("style", {}, css),
      h("div.row", {}, this.list, this.add, this.remove, here),
      this.fields.root,
      this.verdict,
      this.transport.root,
      h("div.walls", {}, this.wall.root, this.curve.root),
      h("div.row", {}, plots, model),
      this.plots.root,
    );
  }

  put(runs) {
    this.store.dispatch({ type: "show", runs });
  }

  edit(patch) {
    const { runs } = this.store.state;
    this.put(runs.map((run, i) => (i === this.chosen ? { ...run, ...patch } : run)));
  }

  addRun() {
    const { runs } = this.store.state;
    const last = runs.at(-1);
    this.chosen = runs.length;
    this.put([...runs, { ...last, method: last.method === "euler" ? "rk4" : "euler" }]);
  }

  removeRun() {
    const runs = this.store.state.runs.filter((_, i) => i !== this.chosen);
    this.chosen = Math.max(0, this.chosen - 1);
    this.put(runs);
  }

  startHere() {
    this.start = this.store.state.q;
    this.results.clear();
    this.compute();
  }

  key(...of) {
    return JSON.stringify([this.store.state.arm.rows, this.start, ...of]);
  }

  resultOf(run) {
    return this.results.get(this.key(run));
  }

  // Ask for the runs that are not known yet; each shows as it comes.
  async compute() {
    const { store, results, start } = this;
    const { arm, runs } = store.state;
    for (const run of runs.filter((one) => !results.has(this.key(one)))) {
      const id = this.key(run);
      results.set(id, null);
      results.set(id, await ask("run", { arm, q: start, run }));
      if (this.signal.aborted || store.state.arm !== arm) return;
      if (runs === store.state.runs) this.show();
    }
    this.show();
    this.wind(runs[this.chosen]);
  }

  // The curves over the radius, for what they depend on in a run.
  wind(run) {
    if (!run) return;
    const { normal, locked } = run;
    const key = this.key(normal, locked);
    if (this.shown.winding === key) return;
    this.shown.winding = key;
    const asked = { arm: this.store.state.arm, q: this.start, run: { normal, locked } };
    this.askWinding(asked, (points) => {
      this.shown.points = points;
      this.drawCurve();
    });
  }

  // The chosen run becomes the trace that is played; the others are lines beside it.
  show() {
    const { store } = this;
    const { runs, arm, circle } = store.state;
    const known = runs.map((run) => this.resultOf(run));
    const way = ({ path }) => path.map((q) => linkFrames(arm, q).at(-1).o);
    const paths = known.flatMap((result, i) =>
      result ? [{ points: way(result), colour: branchColour(i) }] : [],
    );
    store.dispatch({ type: "show", paths });
    const path = known[this.chosen]?.path;
    if (path?.length < 2) store.dispatch({ type: "show", trace: null });
    else if (path && store.state.trace !== path)
      store.dispatch({ type: "traced", arm, circle, path, stray: 0, wanted: null });
    this.lay();
    this.say(() => this.verdict.textContent);
  }

  lay() {
    const { runs, arm } = this.store.state;
    const run = runs[this.chosen];
    this.list.replaceChildren(...runs.map((one, i) => this.line(one, i)));
    this.fields.update(run, arm);
    write(this.verdict, run ? said(run, this.resultOf(run), arm) : "");
    this.remove.disabled = runs.length < 2;
    this.add.disabled = runs.length >= MOST_RUNS;
    this.model.options[2].disabled = !isPanda(arm);
    this.plot();
    this.drawWall();
    this.drawCurve();
  }

  plot() {
    const { state } = this.store;
    const { arm, wrench, trace } = state;
    const torques = this.quantity.value === "torque";
    if (!trace) this.plots.clear();
    else if (torques)
      this.plots.lay(state, torquesAlong(arm, trace, wrench, this.model.value), true);
    else this.plots.lay(state, trace, false);
    this.plots.mark(state.at);
  }

  line(run, i) {
    const attributes = {
      type: "button",
      role: "radio",
      "aria-checked": String(i === this.chosen),
      onclick: () => ((this.chosen = i), this.compute()),
    };
    const colour = { style: `background:${branchColour(i)}`, "aria-hidden": "true" };
    const words = `${named(run)}: ${outcome(this.resultOf(run))}`;
    return h("button", attributes, h("span.swatch", colour), h("span", {}, words));
  }

  drawWall() {
    const { runs, arm } = this.store.state;
    const known = runs.map((run) => ({ run, result: this.resultOf(run) }));
    this.wall.draw(arm, this.start, known);
  }

  drawCurve() {
    this.curve.draw(this.shown.points, this.store.state.runs[this.chosen]?.radius ?? 0.1);
  }

  update(state) {
    if (this.shown.arm !== state.arm) {
      const first = !this.shown.arm;
      this.start = state.q;
      this.chosen = 0;
      this.results.clear();
      this.shown = { arm: state.arm };
      // which comes back here
      if (!state.runs.length || !first) return this.put([startingRun(state.arm)]);
    }
    const { runs, unit, wrench } = this.shown;
    Object.assign(this.shown, { runs: state.runs, unit: state.unit, wrench: state.wrench });
    if (runs !== state.runs) {
      this.chosen = Math.min(this.chosen, state.runs.length - 1);
      this.lay();
      this.compute();
    } else if (unit !== state.unit || wrench !== state.wrench) this.lay();
    this.plots.mark(state.at);
    return this.transport.update(state);
  }

  summary() {
    return this.verdict.textContent;
  }
}

// What came of a run, in a word or two.
function outcome(result) {
  if (!result) return "…";
  return result.failed === null ? millimetres(result.largest) : "no inverse";
}
