// The kinds of small figures. Each has one lever and one message.

import { h, indexed, write } from "../dom.js";
import { ask, latest } from "../jobs.js";
import {
  movingRows,
  linkFrames,
  minus,
  norm,
  plus,
  scaled,
} from "../../../judge/geometry/kinematics.js";
import { freed } from "../renderer.js";
import { branchColour } from "../look.js";
import { Arrow, tube } from "../shapes.js";
import { fixed } from "../text.js";
import { joinList } from "../../../judge/sentences.js";
import { rankVerdict, waysVerdict } from "../verdicts.js";
import { makeHeat } from "../views/jacobian.js";
import { makeMatrix } from "../views/pose.js";
import { deg, makeLever, makeLive } from "./live.js";
import { swing } from "./swing.js";

const OF_A_ROW =
  "only the entries with its angle move; the last column goes round on a circle of radius a.";
const mm = (p) => p.map((v) => fixed(1000 * v, 0)).join(", ");

// The arm in the hand: any link, or the tip.
function hand(host, spec) {
  const words = (state, { frames }) =>
    `${spec.words ?? "Drag a link, or the tip."} The tip is at (${mm(frames.at(-1).o)}) mm.`;
  return makeLive(host, spec, { state: { frames: spec.frames ?? "ends" }, words }).dispose;
}

// One row of the table in its four motions: the frame before it goes over into its own.
function row(host, spec) {
  const number = spec.row ?? 1;
  let share = 4;
  const live = makeLive(host, spec, {
    hold: false,
    first: number - 1,
    state: { frames: "all" },
    words: ({ arm }) => motionsOf(arm.rows[0], share),
  });
  const given = live.store.state.arm.rows[number - 1];
  const put = (v) => {
    share = v;
    const rows = [partly(given, v, spec)];
    live.store.dispatch({ type: "select", arm: { name: `Row ${number}`, home: [], rows }, q: [] });
  };
  const text = (v) => `${fixed(v, 1)} of 4`;
  const lever = makeLever("motions", [0, 4], 4, { put, text, signal: live.signal });
  live.card.querySelector(".side").prepend(lever.root);
  lever.move(4);
  live.picture?.fit();
  return live.dispose;
}

function motionsOf({ theta, d, a, alpha }, share) {
  const slid = [d, a].map((v) => `${fixed(1000 * v, 0)} mm`);
  const motions = [
    `turn by θ about z (${deg(theta)})`,
    `slide by d along z (${slid[0]})`,
    `slide by a along x (${slid[1]})`,
    `turn by α about x (${deg(alpha)})`,
  ].slice(0, Math.ceil(share));
  return motions.length ? `${motions.join(", then ")}.` : "The frame before the row.";
}

// A row of which so many of the four motions are made.
function partly(row, count, { angle = 0.7 }) {
  const part = (i) => Math.min(1, Math.max(0, count - i));
  const theta = row.theta + (row.kind === "revolute" ? angle : 0);
  const d = row.d + (row.kind === "prismatic" ? 0.3 : 0);
  const turns = { theta: part(0) * theta, alpha: part(3) * row.alpha };
  return { kind: "fixed", ...turns, d: part(1) * d, a: part(2) * row.a };
}

// A_i in numbers, while its joint turns.
function matrix(host, spec) {
  const number = spec.row ?? 1;
  const shown = makeMatrix("A", `A ${number}`);
  const live = makeLive(
    host,
    { ...spec, joints: [number] },
    {
      state: { frames: "all" },
      side: [h("div.scroll", {}, shown.root)],
      words: () => `Turn joint ${number}: ${OF_A_ROW}`,
    },
  );
  live.follow(({ arm, q }) => {
    const angle = q[movingRows(arm).indexOf(number - 1)];
    shown.update(number, linkFrames({ rows: [arm.rows[number - 1]] }, [angle])[1]);
  });
  return live.dispose;
}

// The Jacobian's columns: each is the tip's velocity when one joint turns alone.
function columns(host, spec) {
  let chosen = movingRows(spec.arm)[(spec.column ?? 1) - 1]; // its row
  const heat = makeHeat((row) => row !== null && choose(row));
  const live = makeLive(host, spec, {
    side: [heat.root],
    words: ({ arm }) => {
      const moves = arm.rows[chosen].kind === "revolute" ? "turns about its axis" : "slides";
      const when = `when joint ${chosen + 1} ${moves} alone`;
      const column = movingRows(arm).indexOf(chosen) + 1;
      return `Column ${column}: the tip moves along the arrow ${when}.`;
    },
  });
  const { store, picture } = live;
  const choose = (row) => {
    chosen = row;
    store.dispatch({ type: "show", lit: row });
    live.refresh();
  };
  const arrow = picture && new Arrow(picture.force.shaft.material);
  live.follow(({ arm }, derived) => {
    heat.update({ arm, lit: chosen }, derived.columns);
    if (!arrow || !picture.world) return;
    if (arrow.parent !== picture.world) picture.world.add(arrow);
    const column = derived.columns[movingRows(arm).indexOf(chosen)];
    const way = scaled(0.3, column.slice(0, 3));
    arrow.point(derived.frames.at(-1).o, way, 0.008 * picture.size);
  });
  choose(chosen);
  return live.dispose;
}

// How fast the tip can go which way, as the arm is moved.
function ellipsoid(host, spec) {
  const words = (state, derived) => {
    const axes = derived.linear.values.map((v) => fixed(v, 2)).join(", ");
    return `Half axes ${axes}. ${rankVerdict(derived).text}`;
  };
  return makeLive(host, spec, { state: { view: "jacobian" }, words }).dispose;
}

// Torques that hold the arm, as bars that follow.
function loads(host, spec) {
  const bars = h("div.bars");
  const live = makeLive(host, spec, {
    state: { view: spec.push ? "torque" : "pose", wrench: spec.wrench ?? [0, 0, 0, 0, 0, 0] },
    side: [bars],
    words: ({ arm }, { torque }) => {
      const sizes = torque.map(Math.abs);
      const worst = sizes.indexOf(Math.max(...sizes));
      const most = `joint ${movingRows(arm)[worst] + 1}: ${fixed(torque[worst], 1)}\u00a0N\u00a0m`;
      return `${spec.words ?? "Move the arm."} The most is asked of ${most}.`;
    },
  });
  const lines = movingRows(live.store.state.arm).map(torqueBar);
  bars.replaceChildren(...lines.map((one) => one.root));
  live.follow(({ arm }, { torque }) => {
    const most = Math.max(...movingRows(arm).map((index) => arm.rows[index].effort ?? 50));
    lines.forEach((line, i) => line.show(torque[i], most));
  });
  return live.dispose;
}

function torqueBar(index) {
  const [fill, value] = [h("span.fill"), h("span")];
  const name = h("span", {}, indexed("τ", index + 1));
  const show = (torque, most) => {
    const share = Math.max(-1, Math.min(1, torque / most));
    const [left, width] = [50 + 50 * Math.min(0, share), 50 * Math.abs(share)];
    Object.assign(fill.style, { left: `${left}%`, width: `${width}%` });
    write(value, `${fixed(torque, 1)} N m`);
  };
  return { root: h("div.bar", {}, name, h("span.track", {}, fill), value), show };
}

// The circle on the wall for a radius: below a certain one the joints swing, above they wind.
function winds(host, spec) {
  let [result, at, radius] = [null, 0, 0.1];
  const live = makeLive(host, spec, {
    hold: false,
    state: { view: "trace", lit: spec.lit ? spec.lit - 1 : null },
    words: ({ arm }) => (result ? windingOf(arm, result, radius) : "Computing …"),
  });
  const { store } = live;
  const start = store.state.q;
  const show = () => {
    const { path } = result;
    const k = Math.round(at * (path.length - 1));
    store.dispatch({ type: "set", trace: path, q: path[k] });
  };
  const asked = latest("run");
  const run = () =>
    asked(
      { arm: store.state.arm, q: start, run: { method: "exact", steps: 180, radius } },
      (found) => {
        if (live.signal.aborted) return;
        result = found;
        show();
        live.refresh();
      },
    );
  const lever = (name, range, value, put, text) =>
    makeLever(name, range, value, { put, text, signal: live.signal }).root;
  const goTo = (v) => ((at = v), result && show());
  const place = lever("round", [0, 1], 0, goTo, (v) => `${fixed(100 * v, 0)} %`);
  const resize = (v) => ((radius = v), run());
  const size = lever("radius", [0.01, 0.1], radius, resize, (v) => `${fixed(100 * v, 1)} cm`);
  live.card.querySelector(".side").prepend(...(spec.fixed ? [place] : [size, place]));
  run();
  return live.dispose;
}

function windingOf(arm, { failed, wound }, radius) {
  const size = `Radius ${fixed(100 * radius, 1)} cm`;
  if (failed !== null)
    return `${size}: no run gets round; the arm would have to pass a singular pose.`;
  const round = movingRows(arm).flatMap((index, k) =>
    Math.abs(wound[k]) > 0.9 ? [`joint ${index + 1}`] : [],
  );
  const swing = "the joints swing and come back";
  return `${size}: ${round.length ? `${joinList(round)} wind once round` : swing}.`;
}

// Every way to the pose, to be clicked through.
function ways(host, spec) {
  const list = h("div.row", { role: "radiogroup", "aria-label": "Ways" });
  const live = makeLive(host, spec, {
    state: { view: "branches" },
    side: [list],
    words: ({ arm, ways: found }) => (found ? waysVerdict(arm, found) : "Computing …"),
  });
  const { store } = live;
  let gone = false;
  ask("ways", { arm: store.state.arm, q: store.state.q }).then((found) => {
    if (gone) return;
    store.dispatch({ type: "ways", arm: store.state.arm, ways: found });
    const button = ({ q }, i) => {
      const style = `border-left: 6px solid ${branchColour(i)}`;
      const onclick = () => store.dispatch({ type: "glide", q });
      return h(
        "button",
        { role: "radio", "aria-label": `Way ${i + 1}`, style, onclick },
        `${i + 1}`,
      );
    };
    list.replaceChildren(...found.list.map(button));
    live.refresh();
  });
  live.follow(({ q, ways: found }) => {
    [...list.children].forEach((button, i) => {
      const here = found?.list[i]?.q.every((v, k) => Math.abs(v - q[k]) < 1e-3);
      button.setAttribute("aria-checked", String(Boolean(here)));
    });
  });
  return () => ((gone = true), live.dispose());
}

// The elbow's two triangles: shoulder, elbow and tip; and the tip's place over the shoulder.
function triangles(host, spec) {
  const words = ({ arm, q }, { frames }) => {
    const far = norm(minus(frames.at(-1).o, frames[1].o));
    const [a2, a3] = [arm.rows[1].a, arm.rows[2].a];
    const D = (far * far - a2 * a2 - a3 * a3) / (2 * a2 * a3);
    const reached = `Shoulder to tip ${fixed(1000 * far, 0)} mm`;
    return `${reached}, so D = ${fixed(D, 3)} and θ₃ = ${deg(q[2])}; its cosine is D.`;
  };
  const live = makeLive(host, spec, { words });
  const { picture } = live;
  let drawn = [];
  live.follow((state, { frames }) => {
    if (!picture?.world) return;
    drawn.forEach(freed);
    drawn = sidesOf(frames.slice(1).map((frame) => frame.o))
      .filter(([p, q]) => norm(minus(p, q)) > 1e-3)
      .map(([p, q, colour]) => {
        const middle = plus(scaled(0.5, p), scaled(0.5, q));
        return tube([p, middle, q], 0.003 * picture.size, branchColour(colour));
      });
    drawn.forEach((piece) => picture.world.add(piece));
  });
  return live.dispose;
}

// The triangles' sides, each with the number of its colour.
function sidesOf([shoulder, elbow, tip]) {
  const below = [tip[0], tip[1], shoulder[2]];
  return [
    [shoulder, tip, 0],
    [shoulder, below, 2],
    [below, tip, 2],
    [shoulder, elbow, 1],
    [elbow, tip, 1],
  ];
}

/**
 * Each kind by its name: `kind(host, spec)` builds into the host and gives what takes it away.
 * @type {Record<string, (host: HTMLElement, spec: any) => () => void>}
 */
export const FIGURES = {
  columns,
  ellipsoid,
  hand,
  loads,
  matrix,
  row,
  swing,
  triangles,
  ways,
  winds,
};
