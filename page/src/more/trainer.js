// The frames trainer: bare axes, and frames that the reader places by clicking or by keys; the four
// numbers appear as they follow, and a choice that breaks the convention is named.

import { h, indexed, write } from "../dom.js";
import { joints } from "../../../judge/geometry/kinematics.js";
import { sameArm } from "../same_arm.js";
import { branchColour } from "../look.js";
import { freed } from "../renderer.js";
import { along, ArmShape, Arrow, ball, paint, rod, Triads } from "../shapes.js";
import { entryText, fixed } from "../text.js";
import { plus, scaled } from "../../../judge/geometry/kinematics.js";
import { armOf, makeLive } from "./live.js";
import { bareArm, choices, directions, frameOf, randomArm, tableOf, violation } from "./placing.js";

const NEAR = 22; // px
const OWN = "An arm of its own";
const FREE = "A table of this arm; the book chose other directions or zeros, which are free.";
const NOT_THIS =
  "The table is valid row by row, and yet not this arm: go back and look at the last frame.";
const NAMES = ["UR10e (homework)", "Panda (homework)", "Stanford arm", "Elbow arm", OWN];
const HEADS = ["i", "a (m)", "α (°)", "d (m)", "θ (°)"];
const ASKED = {
  z: (i) => `Frame ${i}: which way shall z point along its axis?`,
  o: (i) => `Frame ${i}: where on that axis is its origin?`,
  x: (i) => `Frame ${i}: and which way does x point?`,
};

export function trainer(host, spec) {
  const made = new Trainer(host, spec);
  return made.live.dispose;
}

/** The frames placed so far, what of the next one is chosen, and how both are shown. */
class Trainer {
  constructor(host, spec) {
    this.select = this.makeSelect(spec.arm);
    this.question = h("p.words", { "aria-live": "polite" });
    this.options = h("div.row", { role: "group", "aria-label": "Choices" });
    this.back = h("button", { type: "button", onclick: () => this.undo() }, "Back");
    this.fault = h("p.why", { hidden: true, "aria-live": "polite" });
    this.body = h("tbody");
    const heads = HEADS.map((text) => h("th", { scope: "col" }, text));
    const head = h("thead", {}, h("tr", {}, heads));
    const table = h("table", { "aria-label": "The table so far" }, head, this.body);
    const row = h("div.row", {}, this.select, this.back);
    const side = [row, this.question, this.options, this.fault, h("div.scroll", {}, table)];
    /** @type {any[]} */
    this.things = []; // that are drawn
    const arm = spec.arm ?? NAMES[3];
    this.live = makeLive(host, { arm }, { hold: false, side, words: () => "" });
    this.picture = this.live.picture;
    this.live.follow(() => this.draw());
    const { figure } = this.picture ?? {};
    figure?.listen(figure.canvas, "click", (event) => this.click(figure.place(event)));
    this.begin(arm);
  }

  makeSelect(chosen) {
    return h(
      "select",
      { "aria-label": "Arm to place frames on", onchange: (e) => this.begin(e.target.value) },
      NAMES.map((name) => h("option", { value: name, selected: name === chosen }, name)),
    );
  }

  begin(name) {
    this.arm = /** @type {any} */ (name === OWN ? randomArm() : armOf(name));
    this.bare = bareArm(this.arm);
    this.placed = [this.bare.base];
    this.now = /** @type {any} */ ({});
    const { axes, end, q } = this.bare;
    this.live.store.dispatch({ type: "select", arm: this.arm, q });
    const ends = axes.flatMap(({ z, o }) =>
      [-1, 1].map((way) => plus(o, scaled(way * 1.3 * this.reach, z))),
    );
    const above = plus(end.o, [0, 0, this.reach]);
    this.picture?.figure.fit([...ends, end.o, above, [0, 0, 0]]);
    this.show();
  }

  get step() {
    return !this.now.z ? "z" : !this.now.o ? "o" : "x";
  }

  get done() {
    return this.placed.length > this.bare.axes.length;
  }

  get reach() {
    return 0.16 * (this.picture?.size ?? 1);
  }

  // What can be chosen in this step: { value, at, label }.
  offered() {
    if (this.done) return [];
    const { now, reach } = this;
    const { zs, points, axis } = choices(this.bare, this.placed);
    if (this.step === "o") return points.map((o, k) => ({ value: o, at: o, label: "ABCD"[k] }));
    const [from, ways] =
      this.step === "z" ? [axis.o, zs] : [now.o, directions(this.placed.at(-1), now.z, now.o)];
    return ways.map((v) => ({ value: v, at: plus(from, scaled(reach, v)), label: said(v) }));
  }

  choose({ value }) {
    this.now = { ...this.now, [this.step]: value };
    this.fault.hidden = true;
    if (this.now.x) this.place();
    this.show();
  }

  // Place the frame that is chosen, or say what is wrong with it and keep what may be right.
  place() {
    const { z, x, o } = this.now;
    const frame = frameOf(z, x, o);
    const wrong = violation(this.placed.at(-1), frame, this.placed.length);
    if (!wrong) {
      this.placed = [...this.placed, frame];
      this.now = {};
      return;
    }
    this.now = /does not meet/.test(wrong) ? { z } : { z, o };
    const lowered = (_, digits) => [...digits].map((d) => "₀₁₂₃₄₅₆₇₈₉"[d]).join("");
    write(this.fault, wrong.replaceAll(/_(\d+)/g, lowered));
    this.fault.hidden = false;
  }

  undo() {
    if (this.now.o) this.now = { z: this.now.z };
    else if (this.now.z) this.now = {};
    else if (this.placed.length > 1) this.placed = this.placed.slice(0, -1);
    this.fault.hidden = true;
    this.show();
  }

  show() {
    const choose = (one) => () => this.choose(one);
    const buttons = this.offered().map((one) =>
      h("button", { type: "button", onclick: choose(one) }, one.label),
    );
    this.options.replaceChildren(...buttons);
    write(this.question, this.done ? this.verdict() : ASKED[this.step](this.placed.length));
    this.back.disabled = this.placed.length === 1 && !this.now.z;
    this.body.replaceChildren(...tableOf(this.arm, this.bare, this.placed).map(tableRow));
    this.live.refresh();
  }

  // The table is judged by what no choice of frames can change.
  verdict() {
    const { arm } = this;
    const free = { lower: null, upper: null, speed: null, effort: null };
    const rows = tableOf(arm, this.bare, this.placed).map((row) => ({ ...free, ...row }));
    if (!sameArm({ name: "yours", home: [], rows }, arm)) return NOT_THIS;
    const near = (row, theirs) =>
      ["a", "alpha", "d", "theta"].every((key) => Math.abs(row[key] - theirs[key]) < 1e-6);
    const book = joints(arm).every((index, k) => near(rows[k], arm.rows[index]));
    return book ? "A table of this arm, and the book’s own." : FREE;
  }

  draw() {
    const { picture, bare } = this;
    if (!picture?.world || !bare) return;
    picture.triads.visible = false;
    picture.body.visible = false; // thin links, so that what is chosen can be seen
    this.things.forEach(freed);
    const { size } = picture;
    const ink = paint(branchColour(7));
    const thin = new ArmShape(this.arm, { link: ink, joint: ink, ghost: true, girth: 0.2 });
    thin.pose(bare.frames);
    const lines = bare.axes.map(({ z, o }) => {
      const line = rod(ink);
      along(line, plus(o, scaled(-0.2 * size, z)), plus(o, scaled(0.2 * size, z)), 0.002 * size);
      return line;
    });
    const frames = new Triads(picture.dark, this.placed.length);
    frames.pose(this.placed, 0.1 * size);
    const offered = this.offered();
    this.things = [thin, ...lines, frames, ...offered.map((one) => this.spot(one))];
    this.things.forEach((thing) => picture.world.add(thing));
    picture.labels.set(
      offered.map(({ at, label }) => ({ tip: at, letter: label, index: "", tone: "y" })),
    );
  }

  // A place or a direction that can be chosen.
  spot({ at, value }) {
    const colour = paint(branchColour(1));
    const { size } = this.picture;
    if (this.step === "o") {
      const spot = ball(colour);
      spot.position.fromArray(at);
      spot.scale.setScalar(0.014 * size);
      return spot;
    }
    const arrow = new Arrow(colour);
    const from = this.step === "z" ? choices(this.bare, this.placed).axis.o : this.now.o;
    arrow.point(from, scaled(this.reach, value), 0.005 * size);
    return arrow;
  }

  click([x, y]) {
    const gaps = this.offered().map((one) => {
      const [px, py] = this.picture.figure.pixel(one.at);
      return { one, gap: Math.hypot(px - x, py - y) };
    });
    const best = gaps.sort((p, q) => p.gap - q.gap)[0];
    if (best && best.gap < NEAR) this.choose(best.one);
  }
}

function tableRow(row, k) {
  const moving = row.kind === "revolute" ? "theta" : "d";
  const cell = (key, angle) =>
    h(
      "td",
      {},
      entryText(row[key], angle, "deg"),
      ...(key === moving ? [" + ", ...indexed("q", k + 1)] : []),
    );
  const four = [cell("a", false), cell("alpha", true), cell("d", false), cell("theta", true)];
  return h("tr", {}, h("th", { scope: "row" }, String(k + 1)), four);
}

// A direction in words: along a base axis where it is one, else by its numbers.
function said(v) {
  const k = v.findIndex((share) => Math.abs(Math.abs(share) - 1) < 1e-6);
  if (k < 0) return `(${v.map((share) => fixed(share, 2)).join(", ")})`;
  if (k === 2) return v[2] > 0 ? "up" : "down";
  return `${v[k] > 0 ? "+" : "−"}${"xy"[k]}`;
}
