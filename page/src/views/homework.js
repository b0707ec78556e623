// The homework's circle played with its mistakes: any number of runs at once, each with its own
// method.

import { h, setText } from "../dom.js";
import { runJob } from "../jobs.js";
import { linkFrames } from "../../../judge/geometry/kinematics.js";
import { getBranchColour } from "../look.js";
import { makeFields } from "./homework_fields.js";
import { makeWall } from "./homework_pictures.js";
import {
  formatMillimetres,
  describeRun,
  describeResult,
  makeStartingRun,
} from "./homework_words.js";
import { makePlots } from "./plots.js";
import { makeTransport } from "./transport.js";

export const title = "Play the homework";

const OTHER_ARMS_NOTE =
  "The homework’s circle is drawn by the Panda and the UR10e: choose one of them above.";

export const build = (store, tools) => new HomeworkView(store, tools);

/** The view: the runs, which one is chosen, and their results. */
class HomeworkView {
  /** @param {import("../state.js").Store} store */
  constructor(store, { announce, signal }) {
    this.store = store;
    this.announce = announce;
    this.signal = signal;
    this.chosen = 0;
    this.start = store.state.q; // joint values at which the runs begin
    this.results = new Map(); // by arm, start and run
    this.shown = /** @type {any} */ ({});
    this.list = h("div.runs", { role: "radiogroup", "aria-label": "Runs" });
    this.verdict = h("p.verdict");
    this.wall = makeWall(() => this.drawWall());
    this.plots = makePlots(store);
    this.transport = makeTransport(store, { signal, makeTrace: () => this.show() });
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
    this.others = h("p.words", {}, OTHER_ARMS_NOTE);
    return h("div.homework", {}, this.played, this.others);
  }

  setRuns(runs) {
    this.store.dispatch({ type: "setFields", runs });
  }

  edit(patch) {
    const { runs } = this.store.state;
    this.setRuns(runs.map((run, i) => (i === this.chosen ? { ...run, ...patch } : run)));
  }

  key(...of) {
    return JSON.stringify([this.store.state.arm.rows, this.start, ...of]);
  }

  resultOf(run) {
    return this.results.get(this.key(run));
  }

  // Simulate the runs that have no result yet; each is shown when it is ready.
  async compute() {
    const { store, results, start } = this;
    const { arm, runs } = store.state;
    for (const run of runs.filter((candidate) => !results.has(this.key(candidate)))) {
      const id = this.key(run);
      results.set(id, null);
      results.set(id, await runJob("run", { arm, q: start, run }));
      if (this.signal.aborted || store.state.arm !== arm) return;
      if (runs === store.state.runs) this.show();
    }
    this.show();
  }

  // Make the chosen run the trace to play; the others are lines beside it.
  show() {
    const { store } = this;
    const { runs, arm, circle } = store.state;
    const known = runs.map((run) => this.resultOf(run));
    const getTipPath = ({ path }) => path.map((q) => linkFrames(arm, q).at(-1).o);
    const tipPaths = known.flatMap((result, i) =>
      result ? [{ points: getTipPath(result), colour: getBranchColour(i) }] : [],
    );
    store.dispatch({ type: "setFields", tipPaths });
    const path = known[this.chosen]?.path;
    if (path?.length < 2) store.dispatch({ type: "setFields", trace: null });
    else if (path && store.state.trace !== path)
      store.dispatch({ type: "setTrace", arm, circle, path, wantedPath: null });
    this.showRuns();
    this.announce(() => this.verdict.textContent);
  }

  showRuns() {
    const { runs, arm } = this.store.state;
    const run = runs[this.chosen];
    this.played.hidden = !run;
    this.others.hidden = Boolean(run);
    this.list.hidden = runs.length < 2;
    this.list.replaceChildren(...runs.map((run, i) => this.line(run, i)));
    this.fields.update(run);
    setText(this.verdict, run ? describeResult(this.resultOf(run), arm) : "");
    if (run) this.drawWall();
  }

  line(run, i) {
    const attributes = {
      role: "radio",
      "aria-checked": String(i === this.chosen),
      onclick: () => ((this.chosen = i), this.compute()),
    };
    const colour = { style: `background:${getBranchColour(i)}`, "aria-hidden": "true" };
    const message = `${describeRun(run)}: ${describeOutcome(this.resultOf(run))}`;
    return h("button", attributes, h("span.swatch", colour), h("span", {}, message));
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
      // the event calls update again
      if (!state.runs.length || !first)
        return this.setRuns([makeStartingRun(state.arm, state.base) ?? []].flat());
    }
    if (this.shown.runs !== state.runs) {
      this.shown.runs = state.runs;
      this.chosen = Math.max(0, Math.min(this.chosen, state.runs.length - 1));
      this.showRuns();
      this.compute();
    }
    this.plots.update(this.store.state);
    return this.transport.update(this.store.state);
  }

  summary() {
    return this.verdict.textContent;
  }
}

// Describe the result of a run in a word or two.
function describeOutcome(result) {
  if (!result) return "…";
  return result.failedStep === null ? formatMillimetres(result.largestError) : "no inverse";
}
