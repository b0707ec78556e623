// The homework's circle played, and its mistakes: any number of runs at once on the wall, each with
// its own method.

import { h, write } from "../dom.js";
import { ask } from "../jobs.js";
import { linkFrames } from "../../../judge/geometry/kinematics.js";
import { branchColour } from "../look.js";
import { makeFields } from "./homework_fields.js";
import { makeWall } from "./homework_pictures.js";
import { millimetres, named, said, startingRun } from "./homework_words.js";
import { makePlots } from "./plots.js";
import { makeTransport } from "./transport.js";

export const title = "Play the homework";

const OTHERS =
  "The homework’s circle is drawn by the Panda and the UR10e: choose one of them above.";

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
    this.plots = makePlots(store);
    this.transport = makeTransport(store, { signal, begin: () => this.show() });
    this.fields = makeFields((patch) => this.edit(patch));
    this.root = this.laidOut();
  }

  laidOut() {
    this.played = h(
      "div",
      {},
      this.list,
      h("div.row", {}, this.fields.mistake, this.plots.choice),
      this.transport.root,
      this.verdict,
      this.fields.root,
      this.wall.root,
      this.plots.root,
    );
    this.others = h("p.words", {}, OTHERS);
    return h("div.homework", {}, this.played, this.others);
  }

  put(runs) {
    this.store.dispatch({ type: "show", runs });
  }

  edit(patch) {
    const { runs } = this.store.state;
    this.put(runs.map((run, i) => (i === this.chosen ? { ...run, ...patch } : run)));
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
      store.dispatch({ type: "traced", arm, circle, path, wanted: null });
    this.lay();
    this.say(() => this.verdict.textContent);
  }

  lay() {
    const { runs, arm } = this.store.state;
    const run = runs[this.chosen];
    this.played.hidden = !run;
    this.others.hidden = Boolean(run);
    this.list.hidden = runs.length < 2;
    this.list.replaceChildren(...runs.map((one, i) => this.line(one, i)));
    this.fields.update(run);
    write(this.verdict, run ? said(this.resultOf(run), arm) : "");
    if (run) this.drawWall();
  }

  line(run, i) {
    const attributes = {
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

  update(state) {
    if (this.shown.arm !== state.arm) {
      const first = !this.shown.arm;
      this.start = state.q;
      this.chosen = 0;
      this.results.clear();
      this.shown = { arm: state.arm };
      // which comes back here
      if (!state.runs.length || !first)
        return this.put([startingRun(state.arm, state.base) ?? []].flat());
    }
    if (this.shown.runs !== state.runs) {
      this.shown.runs = state.runs;
      this.chosen = Math.max(0, Math.min(this.chosen, state.runs.length - 1));
      this.lay();
      this.compute();
    }
    this.plots.update(this.store.state);
    return this.transport.update(this.store.state);
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
