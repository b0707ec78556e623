// The frames trainer: bare axes, and frames that the reader places by clicking or by keys; the four
// numbers appear as they follow, and a choice that breaks the convention is named.

import { h, indexed, write } from "../dom.js";
import { joints } from "../../../judge/geometry/kinematics.js";
import { sameArm } from "../same_arm.js";
import { branchColour } from "../scene.js";
import { freed } from "../renderer.js";
import { along, ArmShape, Arrow, ball, paint, rod, Triads } from "../shapes.js";
import { entryText, fixed } from "../text.js";
import { plus, scaled } from "../../../judge/geometry/kinematics.js";
import { armOf, makeLive } from "./live.js";
import { bareArm, choices, directions, frameOf, randomArm, tableOf, violation } from "./placing.js";

const NEAR = 22; // px
const OWN = "An arm of its own";
const FREE = "A table of this arm; the book chose other directions or zeros, which are free.";
const ASKED = {
  z: (i) => `Frame ${i}: which way shall z point along its axis?`,
  o: (i) => `Frame ${i}: where on that axis is its origin?`,
  x: (i) => `Frame ${i}: and which way does x point?`,
};

export function trainer(host, spec) {
  const names = ["UR10e (homework)", "Panda (homework)", "Stanford arm", "Elbow arm", OWN];
  const select = h(
    "select",
    { "aria-label": "Arm to place frames on", onchange: (e) => begin(e.target.value) },
    names.map((name) => h("option", { value: name, selected: name === spec.arm }, name)),
  );
  const question = h("p.words", { "aria-live": "polite" });
  const options = h("div.row", { role: "group", "aria-label": "Choices" });
  const back = h("button", { type: "button", onclick: () => undo() }, "Back");
  const fault = h("p.why", { hidden: true, "aria-live": "polite" });
  const body = h("tbody");
  const heads = ["i", "a (m)", "α (°)", "d (m)", "θ (°)"].map((text) =>
    h("th", { scope: "col" }, text),
  );
  const table = h(
    "table",
    { "aria-label": "The table so far" },
    h("thead", {}, h("tr", {}, heads)),
    body,
  );
  const side = [
    h("div.row", {}, select, back),
    question,
    options,
    fault,
    h("div.scroll", {}, table),
  ];
  let arm, bare, placed, now;
  const live = makeLive(
    host,
    { arm: spec.arm ?? names[3] },
    { hold: false, side, words: () => "" },
  );
  const { store, picture } = live;

  function begin(name) {
    arm = name === OWN ? randomArm() : armOf(name);
    bare = bareArm(arm);
    placed = [bare.base];
    now = {};
    store.dispatch({ type: "select", arm, q: bare.q });
    const ends = bare.axes.flatMap(({ z, o }) =>
      [-1, 1].map((way) => plus(o, scaled(way * 1.3 * reach(), z))),
    );
    picture?.figure.fit([...ends, bare.end.o, plus(bare.end.o, [0, 0, reach()]), [0, 0, 0]]);
    show();
  }

  const step = () => (!now.z ? "z" : !now.o ? "o" : "x");
  const done = () => placed.length > bare.axes.length;

  // What can be chosen in this step: { value, at, label }.
  function offered() {
    if (done()) return [];
    const before = placed.at(-1);
    const { zs, points, axis } = choices(bare, placed);
    if (step() === "z")
      return zs.map((z) => ({ value: z, at: plus(axis.o, scaled(reach(), z)), label: said(z) }));
    if (step() === "o") return points.map((o, k) => ({ value: o, at: o, label: "ABCD"[k] }));
    return directions(before, now.z, now.o).map((x) => ({
      value: x,
      at: plus(now.o, scaled(reach(), x)),
      label: said(x),
    }));
  }

  const reach = () => 0.16 * (picture?.size ?? 1);

  function choose({ value }) {
    now = { ...now, [step()]: value };
    fault.hidden = true;
    if (now.x) {
      const frame = frameOf(now.z, now.x, now.o);
      const wrong = violation(placed.at(-1), frame, placed.length);
      if (wrong) {
        const { z, o } = now;
        now = /does not meet/.test(wrong) ? { z } : { z, o };
        write(
          fault,
          wrong.replaceAll(/_(\d+)/g, (_, digits) =>
            [...digits].map((d) => "₀₁₂₃₄₅₆₇₈₉"[d]).join(""),
          ),
        );
        fault.hidden = false;
      } else {
        placed = [...placed, frame];
        now = {};
      }
    }
    show();
  }

  function undo() {
    if (now.o) now = { z: now.z };
    else if (now.z) now = {};
    else if (placed.length > 1) placed = placed.slice(0, -1);
    fault.hidden = true;
    show();
  }

  function show() {
    const found = offered();
    const buttons = found.map((one) =>
      h("button", { type: "button", onclick: () => choose(one) }, one.label),
    );
    options.replaceChildren(...buttons);
    write(question, done() ? verdict() : ASKED[step()](placed.length));
    back.disabled = placed.length === 1 && !now.z;
    const rows = tableOf(arm, bare, placed);
    body.replaceChildren(
      ...rows.map((row, k) => {
        const moving = row.kind === "revolute" ? "theta" : "d";
        const cell = (key, text) =>
          h("td", {}, text, ...(key === moving ? [" + ", ...indexed("q", k + 1)] : []));
        const angle = (v) => entryText(v, true, "deg");
        const lengths = (key) => cell(key, entryText(row[key], false, "deg"));
        const angles = (key) => cell(key, angle(row[key]));
        const four = [lengths("a"), angles("alpha"), lengths("d"), angles("theta")];
        return h("tr", {}, h("th", { scope: "row" }, String(k + 1)), four);
      }),
    );
    live.refresh();
  }

  // The table is judged by what no choice of frames can change.
  function verdict() {
    const free = { lower: null, upper: null, speed: null, effort: null };
    const rows = tableOf(arm, bare, placed).map((row) => ({ ...free, ...row }));
    const same = sameArm({ name: "yours", home: [], rows }, arm);
    if (!same)
      return "The table is valid row by row, and yet not this arm: go back and look at the last frame.";
    const book = joints(arm).every((index, k) => {
      const theirs = arm.rows[index];
      return ["a", "alpha", "d", "theta"].every(
        (key) => Math.abs(rows[k][key] - theirs[key]) < 1e-6,
      );
    });
    return book ? "A table of this arm, and the book’s own." : FREE;
  }

  let things = [];
  live.follow(() => draw());
  function draw() {
    if (!picture?.world || !bare) return;
    picture.triads.visible = false;
    picture.labels.set([]);
    things.forEach(freed);
    const { size } = picture;
    const ink = paint(branchColour(7));
    picture.body.visible = false; // thin links, so that what is chosen can be seen
    const thin = new ArmShape(arm, { link: ink, joint: ink, ghost: true, girth: 0.2 });
    thin.pose(bare.frames);
    const lines = bare.axes.map(({ z, o }) => {
      const line = rod(ink);
      along(line, plus(o, scaled(-0.2 * size, z)), plus(o, scaled(0.2 * size, z)), 0.002 * size);
      return line;
    });
    const frames = new Triads(picture.dark, placed.length);
    frames.pose(placed, 0.1 * size);
    const spots = offered().map(({ at, value }) => {
      const colour = paint(branchColour(1));
      const from = step() === "o" ? null : step() === "z" ? choices(bare, placed).axis.o : now.o;
      if (!from) {
        const spot = ball(colour);
        spot.position.fromArray(at);
        spot.scale.setScalar(0.014 * size);
        return spot;
      }
      const arrow = new Arrow(colour);
      arrow.point(from, scaled(reach(), value), 0.005 * size);
      return arrow;
    });
    things = [thin, ...lines, frames, ...spots];
    things.forEach((thing) => picture.world.add(thing));
    picture.labels.set(
      offered().map(({ at, label }) => ({ tip: at, letter: label, index: "", tone: "y" })),
    );
  }

  picture?.figure.listen(picture.figure.canvas, "click", (event) => {
    const [x, y] = picture.figure.place(event);
    const gaps = offered().map((one) => {
      const [px, py] = picture.figure.pixel(one.at);
      return { one, gap: Math.hypot(px - x, py - y) };
    });
    const best = gaps.sort((p, q) => p.gap - q.gap)[0];
    if (best && best.gap < NEAR) choose(best.one);
  });
  begin(spec.arm ?? names[3]);
  return live.dispose;
}

// A direction in words: along a base axis where it is one, else by its numbers.
function said(v) {
  const k = v.findIndex((share) => Math.abs(Math.abs(share) - 1) < 1e-6);
  if (k < 0) return `(${v.map((share) => fixed(share, 2)).join(", ")})`;
  if (k === 2) return v[2] > 0 ? "up" : "down";
  return `${v[k] > 0 ? "+" : "−"}${"xy"[k]}`;
}
