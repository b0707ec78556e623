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
  describeCircleArms,
  describeRun,
  describeResult,
  makeStartingRun,
} from "./homework_words.js";
import { formatTimeTicks, makePlots } from "./plots.js";
import { makeTransport } from "./transport.js";

export const title = "Play the homework";

export const build = (store, tools) => new HomeworkView(store, tools);

/** The runs of the homework, their results, and the chosen run. */
class HomeworkView {
  /** @param {import("../state.js").Store} store */
  constructor(store, { announce, arms, signal }) {
    this.store = store;
    this.arms = arms;
    this.announce = announce;
    this.signal = signal;
    this.results = new Map(); // by arm, start and run
    this.listedFields = []; // the state fields that the list of runs was made from
    this.list = h("div.runs", { role: "radiogroup", "aria-label": "Runs" });
    this.verdict = h("p.verdict");
    this.wall = makeWall(() => this.drawWall());
    this.plots = makePlots(store, () => this.getTicks());
    this.transport = makeTransport(store, { signal, makeTrace: () => this.showResults() });
    this.fields = makeFields((patch) => this.editChosenRun(patch));
    this.root = this.makeLayout();
  }

  makeLayout() {
    this.player = h(
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
    this.circleArms = h("p.words", {}, describeCircleArms(this.arms));
    return h("div.homework", {}, this.player, this.circleArms);
  }

  // Return the runs of the state, or the run that the homework asks of its arm.
  get runs() {
    const { runs, arm, base } = this.store.state;
    return runs.length ? runs : [makeStartingRun(arm, base) ?? []].flat();
  }

  // Change the chosen run. Consecutive changes of the same field share an undo step.
  editChosenRun(patch) {
    const { chosenRun } = this.store.state;
    const runs = this.runs.map((run, i) => (i === chosenRun ? { ...run, ...patch } : run));
    const gesture = `run ${chosenRun} ${Object.keys(patch)}`;
    this.store.dispatch({ type: "setFields", runs, gesture });
  }

  getResultKey(run) {
    const { arm, runStart } = this.store.state;
    return JSON.stringify([arm.rows, runStart, run]);
  }

  getResult(run) {
    return this.results.get(this.getResultKey(run));
  }

  // Simulate the runs without a result, and show each result when it is ready.
  async computeResults() {
    const { store, results, runs } = this;
    const { state } = store;
    const { arm, runStart } = state;
    const isCurrent = () =>
      ["arm", "runStart", "runs"].every((key) => store.state[key] === state[key]);
    for (const run of runs) {
      const key = this.getResultKey(run);
      if (results.has(key)) continue;
      results.set(key, null);
      results.set(key, await runJob("run", { arm, q: runStart, run }));
      if (this.signal.aborted) return;
      this.showResults();
      if (!isCurrent()) return;
    }
    this.showResults();
  }

  // Play the chosen run, and draw the paths of all runs.
  showResults() {
    const { store, runs } = this;
    const { arm, circle, chosenRun } = store.state;
    const results = runs.map((run) => this.getResult(run));
    const getTipPath = ({ path }) => path.map((q) => linkFrames(arm, q).at(-1).o);
    const tipPaths = results.flatMap((result, i) =>
      result ? [{ points: getTipPath(result), colour: getBranchColour(i) }] : [],
    );
    store.dispatch({ type: "setFields", tipPaths });
    const path = results[chosenRun]?.path;
    if (path?.length < 2) store.dispatch({ type: "setFields", trace: null });
    else if (path && store.state.trace !== path)
      store.dispatch({ type: "setTrace", arm, circle, path, wantedPath: null });
    this.showRuns();
    this.announce(() => this.verdict.textContent);
  }

  showRuns() {
    const { runs } = this;
    const { arm, chosenRun } = this.store.state;
    const run = runs[chosenRun];
    this.player.hidden = !run;
    this.circleArms.hidden = Boolean(run);
    this.list.hidden = runs.length < 2;
    this.listRuns(runs, chosenRun);
    this.fields.update(run);
    setText(this.verdict, run ? describeResult(this.getResult(run), arm) : "");
    if (run) this.drawWall();
  }

  // Return the ticks of the time axis, which ends with the chosen run.
  getTicks() {
    const run = this.runs[this.store.state.chosenRun];
    const result = run && this.getResult(run);
    return formatTimeTicks(result ? result.at.at(-1) * run.seconds : 0);
  }

  // Rebuild the list of runs. If it had the focus, the chosen run gets it.
  listRuns(runs, chosenRun) {
    const { activeElement } = /** @type {ShadowRoot} */ (this.list.getRootNode());
    const hadFocus = Boolean(activeElement) && this.list.contains(activeElement);
    this.list.replaceChildren(...runs.map((run, i) => this.makeRunButton(run, i)));
    if (hadFocus) /** @type {HTMLElement} */ (this.list.children[chosenRun]).focus();
  }

  makeRunButton(run, i) {
    const attributes = {
      role: "radio",
      "aria-checked": String(i === this.store.state.chosenRun),
      onclick: () => this.store.dispatch({ type: "setFields", chosenRun: i }),
    };
    const colour = { style: `background:${getBranchColour(i)}`, "aria-hidden": "true" };
    const message = `${describeRun(run)}: ${describeOutcome(this.getResult(run))}`;
    return h("button", attributes, h("span.swatch", colour), h("span", {}, message));
  }

  drawWall() {
    const { arm, runStart } = this.store.state;
    const runs = this.runs.map((run) => ({ run, result: this.getResult(run) }));
    this.wall.draw(arm, runStart, runs);
  }

  update(state) {
    const fields = ["arm", "runs", "runStart", "chosenRun"].map((key) => state[key]);
    if (fields.some((value, i) => value !== this.listedFields[i])) {
      this.listedFields = fields;
      this.showRuns();
      this.computeResults();
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
