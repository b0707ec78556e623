// Builds the small figures of the chapters. Each has one control and one message.

import { h, makeIndexedSymbol, setText } from "../dom.js";
import { runJob, makeLatestJob } from "../jobs.js";
import {
  movingRows,
  linkFrames,
  minus,
  norm,
  plus,
  scaled,
} from "../../../judge/geometry/kinematics.js";
import { removeAndDispose } from "../renderer.js";
import { getBranchColour } from "../look.js";
import { Arrow, makeTube } from "../shapes.js";
import { formatFixed } from "../text.js";
import { joinList } from "../../../judge/sentences.js";
import { describeRank, describeBranches, listJointsWhere } from "../statements.js";
import { makeHeatTable } from "../views/jacobian.js";
import { makeMatrix } from "../views/pose.js";
import { setBar } from "../views/torque.js";
import { buildEllipsesFigure } from "./ellipses.js";
import { formatWholeDegrees, makeLever, makeLive } from "./live.js";
import { buildSwingFigure } from "./swing.js";

const MATRIX_NOTE =
  "only the entries with its angle move; the last column goes round on a circle of radius a.";
const formatPoint = (p) => p.map((v) => formatFixed(1000 * v, 0)).join(", ");

// Build an arm to drag, by any link or by the tip.
function buildHandFigure(host, spec) {
  const message = (state, { frames }) => {
    const tip = `The tip is at (${formatPoint(frames.at(-1).o)}) mm.`;
    return `${spec.words ?? "Drag a link, or the tip."} ${tip}`;
  };
  return makeLive(host, spec, { state: { frames: spec.frames ?? "ends" }, message }).dispose;
}

// Build the four motions of a table's row, which carry the frame before it to its own frame.
function buildRowFigure(host, spec) {
  const number = spec.row ?? 1;
  let share = 4;
  const live = makeLive(host, spec, {
    isGrabbable: false,
    firstFrame: number - 1,
    state: { frames: "all" },
    message: ({ arm }) => describeMotions(arm.rows[0], share),
  });
  const given = live.store.state.arm.rows[number - 1];
  const put = (v) => {
    share = v;
    const rows = [makePartialRow(given, v, spec)];
    live.store.dispatch({
      type: "selectArm",
      arm: { name: `Row ${number}`, home: [], rows },
      q: [],
    });
  };
  const text = (v) => `${formatFixed(v, 1)} of 4`;
  const lever = makeLever("motions", [0, 4], 4, { put, text, signal: live.signal });
  live.card.querySelector(".side").prepend(lever.root);
  lever.move(4);
  live.picture?.fitView();
  return live.dispose;
}

function describeMotions({ theta, d, a, alpha }, share) {
  const slid = [d, a].map((v) => `${formatFixed(1000 * v, 0)} mm`);
  const motions = [
    `turn by θ about z (${formatWholeDegrees(theta)})`,
    `slide by d along z (${slid[0]})`,
    `slide by a along x (${slid[1]})`,
    `turn by α about x (${formatWholeDegrees(alpha)})`,
  ].slice(0, Math.ceil(share));
  return motions.length ? `${motions.join(", then ")}.` : "The frame before the row.";
}

// Return a row of which only the first `count` of the four motions are made.
function makePartialRow(row, count, { angle = 0.7 }) {
  const part = (i) => Math.min(1, Math.max(0, count - i));
  const theta = row.theta + (row.kind === "revolute" ? angle : 0);
  const d = row.d + (row.kind === "prismatic" ? 0.3 : 0);
  const turns = { theta: part(0) * theta, alpha: part(3) * row.alpha };
  return { kind: "fixed", ...turns, d: part(1) * d, a: part(2) * row.a };
}

// The matrix A_i while its joint turns.
function buildMatrixFigure(host, spec) {
  const number = spec.row ?? 1;
  const shown = makeMatrix("A", `A ${number}`);
  const live = makeLive(
    host,
    { ...spec, joints: [number] },
    {
      state: { frames: "all" },
      side: [h("div.scroll", {}, shown.root)],
      message: () => `Turn joint ${number}: ${MATRIX_NOTE}`,
    },
  );
  live.follow(({ arm, q }) => {
    const angle = q[movingRows(arm).indexOf(number - 1)];
    shown.update(number, linkFrames({ rows: [arm.rows[number - 1]] }, [angle])[1]);
  });
  return live.dispose;
}

// Build the Jacobian's columns. Each is the tip's velocity when one joint moves alone.
function buildColumnsFigure(host, spec) {
  let chosen = movingRows(spec.arm)[(spec.column ?? 1) - 1]; // its row
  const heat = makeHeatTable((row) => row !== null && choose(row));
  const live = makeLive(host, spec, {
    side: [heat.root],
    message: ({ arm }) => {
      const moves = arm.rows[chosen].kind === "revolute" ? "turns about its axis" : "slides";
      const when = `when joint ${chosen + 1} ${moves} alone`;
      const column = movingRows(arm).indexOf(chosen) + 1;
      return `Column ${column}: the tip moves along the arrow ${when}.`;
    },
  });
  const { store, picture } = live;
  const choose = (row) => {
    chosen = row;
    store.dispatch({ type: "setFields", highlightedRow: row });
    live.refresh();
  };
  const arrow = picture && new Arrow(picture.forceArrow.shaft.material);
  live.follow(({ arm }, derived) => {
    heat.update({ arm, highlightedRow: chosen }, derived.columns);
    if (!arrow || !picture.world) return;
    if (arrow.parent !== picture.world) picture.world.add(arrow);
    const column = derived.columns[movingRows(arm).indexOf(chosen)];
    const velocity = scaled(0.3, column.slice(0, 3));
    arrow.placeAlong(derived.frames.at(-1).o, velocity, 0.008 * picture.size);
  });
  choose(chosen);
  return live.dispose;
}

// The velocity ellipsoid of the tip as the arm moves.
function buildEllipsoidFigure(host, spec) {
  const message = (state, derived) => {
    const axes = derived.linearAxes.values.map((v) => formatFixed(v, 2)).join(", ");
    return `Half axes ${axes}. ${describeRank(derived).text}`;
  };
  return makeLive(host, spec, { state: { view: "jacobian" }, message }).dispose;
}

// The torques that hold the arm, as bars.
function buildLoadsFigure(host, spec) {
  const bars = h("div.bars");
  const live = makeLive(host, spec, {
    state: { view: spec.push ? "torque" : "pose", wrench: spec.wrench ?? [0, 0, 0, 0, 0, 0] },
    side: [bars],
    message: ({ arm }, { torques }) => {
      const sizes = torques.map(Math.abs);
      const worst = sizes.indexOf(Math.max(...sizes));
      const value = `${formatFixed(torques[worst], 1)}\u00a0N\u00a0m`;
      const most = `joint ${movingRows(arm)[worst] + 1}: ${value}`;
      return `${spec.words ?? "Move the arm."} The most is asked of ${most}.`;
    },
  });
  const lines = movingRows(live.store.state.arm).map(makeTorqueBar);
  bars.replaceChildren(...lines.map((one) => one.root));
  live.follow(({ arm }, { torques }) => {
    const most = Math.max(...movingRows(arm).map((index) => arm.rows[index].effort ?? 50));
    lines.forEach((line, i) => line.show(torques[i], most));
  });
  return live.dispose;
}

function makeTorqueBar(index) {
  const [fill, value] = [h("span.fill"), h("span")];
  const name = h("span", {}, makeIndexedSymbol("τ", index + 1));
  const show = (torque, most) => {
    setBar(fill, torque / most);
    setText(value, `${formatFixed(torque, 1)} N m`);
  };
  return { root: h("div.bar", {}, name, h("span.track", {}, fill), value), show };
}

// The circle on the wall at several radii: below a certain radius the joints swing, above it they
// wind.
function buildWindingFigure(host, spec) {
  let [result, at, radius] = [null, 0, 0.1];
  const live = makeLive(host, spec, {
    isGrabbable: false,
    state: { view: "trace", highlightedRow: spec.lit ? spec.lit - 1 : null },
    message: ({ arm }) => (result ? describeWinding(arm, result, radius) : "Computing …"),
  });
  const { store } = live;
  const start = store.state.q;
  const show = () => {
    const { path } = result;
    const k = Math.round(at * (path.length - 1));
    store.dispatch({ type: "replaceState", trace: path, q: path[k] });
  };
  const asked = makeLatestJob("run");
  const run = () =>
    asked(
      { arm: store.state.arm, q: start, run: { method: "exact", steps: 180, radius } },
      (newResult) => {
        if (live.signal.aborted) return;
        result = newResult;
        show();
        live.refresh();
      },
    );
  const lever = (name, range, value, put, text) =>
    makeLever(name, range, value, { put, text, signal: live.signal }).root;
  const goTo = (v) => ((at = v), result && show());
  const place = lever("round", [0, 1], 0, goTo, (v) => `${formatFixed(100 * v, 0)} %`);
  const resize = (v) => ((radius = v), run());
  const size = lever("radius", [0.01, 0.1], radius, resize, (v) => `${formatFixed(100 * v, 1)} cm`);
  live.card.querySelector(".side").prepend(...(spec.fixed ? [place] : [size, place]));
  run();
  return live.dispose;
}

function describeWinding(arm, { failedStep, windings }, radius) {
  const size = `Radius ${formatFixed(100 * radius, 1)} cm`;
  if (failedStep !== null)
    return `${size}: no run gets round; the arm would have to pass a singular configuration.`;
  const round = listJointsWhere(arm, (_, k) => Math.abs(windings[k]) > 0.9);
  const swing = "the joints swing and come back";
  return `${size}: ${round.length ? `${joinList(round)} wind once round` : swing}.`;
}

// Build a button for each solution branch of a pose.
function buildBranchesFigure(host, spec) {
  const list = h("div.row", { role: "radiogroup", "aria-label": "Solutions" });
  const live = makeLive(host, spec, {
    state: { view: "branches" },
    side: [list],
    message: ({ arm, branches: branchSet }) =>
      branchSet ? describeBranches(arm, branchSet) : "Computing …",
  });
  const { store } = live;
  let gone = false;
  runJob("branches", { arm: store.state.arm, q: store.state.q }).then((branchSet) => {
    if (gone) return;
    store.dispatch({ type: "setBranches", arm: store.state.arm, branches: branchSet });
    const button = ({ q }, i) => {
      const style = `border-left: 6px solid ${getBranchColour(i)}`;
      const onclick = () => store.dispatch({ type: "glide", q });
      return h(
        "button",
        { role: "radio", "aria-label": `Way ${i + 1}`, style, onclick },
        `${i + 1}`,
      );
    };
    list.replaceChildren(...branchSet.list.map(button));
    live.refresh();
  });
  live.follow(({ q, branches: branchSet }) => {
    [...list.children].forEach((button, i) => {
      const here = branchSet?.list[i]?.q.every((v, k) => Math.abs(v - q[k]) < 1e-3);
      button.setAttribute("aria-checked", String(Boolean(here)));
    });
  });
  return () => ((gone = true), live.dispose());
}

// The triangles of the elbow arm: shoulder, elbow and tip, and the tip's position above the
// shoulder.
function buildTrianglesFigure(host, spec) {
  const message = ({ arm, q }, { frames }) => {
    const far = norm(minus(frames.at(-1).o, frames[1].o));
    const [a2, a3] = [arm.rows[1].a, arm.rows[2].a];
    const D = (far * far - a2 * a2 - a3 * a3) / (2 * a2 * a3);
    const reached = `Shoulder to tip ${formatFixed(1000 * far, 0)} mm`;
    const angle = formatWholeDegrees(q[2]);
    return `${reached}, so D = ${formatFixed(D, 3)} and θ₃ = ${angle}; its cosine is D.`;
  };
  const live = makeLive(host, spec, { message });
  const { picture } = live;
  let drawn = [];
  live.follow((state, { frames }) => {
    if (!picture?.world) return;
    drawn.forEach(removeAndDispose);
    drawn = getTriangleSides(frames.slice(1).map((frame) => frame.o))
      .filter(([p, q]) => norm(minus(p, q)) > 1e-3)
      .map(([p, q, colour]) => {
        const middle = plus(scaled(0.5, p), scaled(0.5, q));
        return makeTube([p, middle, q], 0.003 * picture.size, getBranchColour(colour));
      });
    drawn.forEach((piece) => picture.world.add(piece));
  });
  return live.dispose;
}

// Return the sides of the triangles, each with the index of its colour.
function getTriangleSides([shoulder, elbow, tip]) {
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
 * The function that builds each figure. It returns a function that removes the figure.
 * @type {Record<string, (host: HTMLElement, spec: any) => () => void>}
 */
export const FIGURES = {
  columns: buildColumnsFigure,
  ellipses: buildEllipsesFigure,
  ellipsoid: buildEllipsoidFigure,
  hand: buildHandFigure,
  loads: buildLoadsFigure,
  matrix: buildMatrixFigure,
  row: buildRowFigure,
  swing: buildSwingFigure,
  triangles: buildTrianglesFigure,
  ways: buildBranchesFigure,
  winds: buildWindingFigure,
};
