// The kinds of small figures. Each has one lever and one message.

import { h, indexed, write } from "../dom.js";
import { ask } from "../jobs.js";
import {
  joints,
  linkFrames,
  matrix as matrixOf,
  minus,
  norm,
  plus,
  scaled,
} from "../../../judge/geometry/kinematics.js";
import { rightNull } from "../../../judge/geometry/linear.js";
import { reach } from "../motion.js";
import { branchColour } from "../scene.js";
import { Arrow, tube } from "../shapes.js";
import { fixed, jointText, listed, sparse } from "../text.js";
import { rankVerdict, waysVerdict } from "../verdicts.js";
import { makeLever, makeLive } from "./live.js";

const OF_A_ROW =
  "only the entries with its angle move; the last column goes round on a circle of radius a.";
const mm = (p) => p.map((v) => fixed(1000 * v, 0)).join(", ");
const deg = (v) => `${fixed((v * 180) / Math.PI, 0)}°`;

// The arm in the hand: any link, or the tip.
export function hand(host, spec) {
  const words = (state, { frames }) =>
    `${spec.words ?? "Drag a link, or the tip."} The tip is at (${mm(frames.at(-1).o)}) mm.`;
  return makeLive(host, spec, { state: { frames: spec.frames ?? "ends" }, words }).dispose;
}

// One row of the table in its four motions: the frame before it goes over into its own.
export function row(host, spec) {
  const NAMES = [
    "turn by θ about z",
    "slide by d along z",
    "slide by a along x",
    "turn by α about x",
  ];
  const abort = new AbortController();
  let share = 4;
  const live = makeLive(host, spec, {
    hold: false,
    first: (spec.row ?? 1) - 1,
    state: { frames: "all" },
    words: ({ arm }) => {
      const { theta, d, a, alpha } = arm.rows[0];
      const values = [
        deg(theta),
        `${fixed(1000 * d, 0)} mm`,
        `${fixed(1000 * a, 0)} mm`,
        deg(alpha),
      ];
      const done = NAMES.slice(0, Math.ceil(share)).map((name, i) => `${name} (${values[i]})`);
      return done.length ? `${done.join(", then ")}.` : "The frame before the row.";
    },
  });
  const full = live.store.state.arm;
  const given = full.rows[(spec.row ?? 1) - 1];
  const put = (v) => {
    share = v;
    const part = (i) => Math.min(1, Math.max(0, v - i));
    const theta = given.theta + (given.kind === "revolute" ? (spec.angle ?? 0.7) : 0);
    const d = given.d + (given.kind === "prismatic" ? (spec.slide ?? 0.3) : 0);
    const one = {
      kind: "fixed",
      theta: part(0) * theta,
      d: part(1) * d,
      a: part(2) * given.a,
      alpha: part(3) * given.alpha,
    };
    const arm = { name: `Row ${spec.row ?? 1}`, home: [], rows: [one] };
    live.store.dispatch({ type: "select", arm, q: [] });
  };
  const lever = makeLever("motions", [0, 4], 4, {
    put,
    text: (v) => `${fixed(v, 1)} of 4`,
    signal: abort.signal,
  });
  live.card.querySelector(".side").prepend(lever.root);
  lever.move(4);
  live.picture?.fit();
  return () => (abort.abort(), live.dispose());
}

// A_i in numbers, while its joint turns.
export function matrix(host, spec) {
  const number = spec.row ?? 1;
  const cells = Array.from({ length: 4 }, () => Array.from({ length: 4 }, () => h("td")));
  const table = h(
    "table",
    { "aria-label": `A ${number}` },
    cells.map((line) => h("tr", {}, line)),
  );
  const name = h("span", {}, indexed("A", number), " =");
  const live = makeLive(
    host,
    { ...spec, joints: [number] },
    {
      state: { frames: "all" },
      side: [h("div.row", {}, name, h("div.scroll", {}, table))],
      words: () => spec.words ?? `Turn joint ${number}: ${OF_A_ROW}`,
    },
  );
  live.follow((state) => {
    const frames = linkFrames({ rows: [state.arm.rows[number - 1]] }, [
      state.q[joints(state.arm).indexOf(number - 1)],
    ]);
    matrixOf(frames[1]).forEach((line, i) =>
      line.forEach((v, j) => write(cells[i][j], i === 3 ? String(v) : sparse(v, 3))),
    );
  });
  return live.dispose;
}

// The Jacobian's columns: each is the tip's velocity when one joint turns alone.
export function columns(host, spec) {
  let chosen = 0;
  const heads = h("tr");
  const body = h("tbody");
  const table = h("table", { "aria-label": "Jacobian of the tip" }, h("thead", {}, heads), body);
  const live = makeLive(host, spec, {
    side: [h("div.scroll", {}, table)],
    words: ({ arm }) => {
      const index = joints(arm)[chosen];
      const moves = arm.rows[index].kind === "revolute" ? "turns about its axis" : "slides";
      return `Column ${chosen + 1}: the tip moves along the arrow when joint ${index + 1} ${moves} alone.`;
    },
  });
  const { store, picture } = live;
  const arrow = picture && new Arrow(picture.force.shaft.material);
  const choose = (k) => () => {
    chosen = k;
    store.dispatch({ type: "show", lit: joints(store.state.arm)[k] });
    live.refresh();
  };
  const buttons = joints(store.state.arm).map((index, k) =>
    h(
      "button",
      {
        type: "button",
        "aria-pressed": "false",
        onpointerenter: choose(k),
        onfocus: choose(k),
        onclick: choose(k),
      },
      indexed("J", index + 1),
    ),
  );
  heads.replaceChildren(h("th"), ...buttons.map((button) => h("th", {}, button)));
  const cells = ["vx", "vy", "vz", "ωx", "ωy", "ωz"].map((name) => [
    name,
    buttons.map(() => h("td")),
  ]);
  body.replaceChildren(
    ...cells.map(([name, line]) => h("tr", {}, h("th", {}, indexed(name[0], name[1])), line)),
  );
  live.follow((state, derived) => {
    cells.forEach(([, line], i) =>
      line.forEach((cell, k) => {
        write(cell, sparse(derived.columns[k][i], 2));
        cell.classList.toggle("on", k === chosen);
      }),
    );
    buttons.forEach((button, k) => button.setAttribute("aria-pressed", String(k === chosen)));
    if (!arrow || !picture.world) return;
    if (arrow.parent !== picture.world) picture.world.add(arrow);
    const way = scaled(0.3, derived.columns[chosen].slice(0, 3));
    arrow.point(derived.frames.at(-1).o, way, 0.008 * picture.size);
  });
  choose(spec.column ? spec.column - 1 : 0)();
  return live.dispose;
}

// How fast the tip can go which way, as the arm is moved.
export function ellipsoid(host, spec) {
  const words = (state, derived) => {
    const axes = derived.linear.values.map((v) => fixed(v, 2)).join(", ");
    return `Half axes ${axes}. ${rankVerdict(derived).text}`;
  };
  return makeLive(host, spec, { state: { view: "jacobian" }, words }).dispose;
}

// Torques that hold the arm, as bars that follow.
export function loads(host, spec) {
  const bars = h("div.bars");
  const live = makeLive(host, spec, {
    state: { view: spec.push ? "torque" : "pose", wrench: spec.wrench ?? [0, 0, 0, 0, 0, 0] },
    side: [bars],
    words: (state, { torque }) => {
      const worst = torque.reduce(
        (best, v, i) => (Math.abs(v) > Math.abs(torque[best]) ? i : best),
        0,
      );
      const most = `joint ${joints(state.arm)[worst] + 1}: ${fixed(torque[worst], 1)} N m`;
      return `${spec.words ?? "Move the arm."} The most is asked of ${most}.`;
    },
  });
  const lines = joints(live.store.state.arm).map((index) => {
    const [fill, value] = [h("span.fill"), h("span")];
    return {
      fill,
      value,
      root: h(
        "div.bar",
        {},
        h("span", {}, indexed("τ", index + 1)),
        h("span.track", {}, fill),
        value,
      ),
    };
  });
  bars.replaceChildren(...lines.map((one) => one.root));
  live.follow((state, { torque }) => {
    const most = Math.max(...joints(state.arm).map((index) => state.arm.rows[index].effort ?? 50));
    lines.forEach(({ fill, value }, i) => {
      const share = Math.max(-1, Math.min(1, torque[i] / most));
      Object.assign(fill.style, {
        left: `${50 + 50 * Math.min(0, share)}%`,
        width: `${50 * Math.abs(share)}%`,
      });
      write(value, `${fixed(torque[i], 1)} N m`);
    });
  });
  return live.dispose;
}

// The elbow swings while the tip stays: the freedom that a seventh joint gives.
export function swing(host, spec) {
  const abort = new AbortController();
  const live = makeLive(host, spec, {
    words: (state) => {
      const values = joints(state.arm).map(
        (index, k) => `q${index + 1} ${jointText(state.arm.rows[index], state.q[k], "deg")}`,
      );
      return `The tip stays; ${values.join(", ")}.`;
    },
  });
  const { store } = live;
  const held = store.derived.frames.at(-1);
  store.dispatch({ type: "show", hold: { pinned: held, turns: true, free: 1 } });
  const path = swungBothWays(store.state.arm, store.state.q, held);
  const middle = path.findIndex((q) => q === store.state.q);
  const put = (v) => {
    const q = path[Math.max(0, Math.min(path.length - 1, Math.round(v)))];
    store.dispatch({ type: "move", q, hold: store.state.hold, gesture: "swing" });
  };
  const text = (v) => deg(path[Math.round(v)]?.[2] - path[middle][2]);
  const lever = makeLever("elbow", [0, path.length - 1], middle, {
    put,
    text,
    signal: abort.signal,
  });
  live.card.querySelector(".side").prepend(lever.root);
  return () => (abort.abort(), live.dispose());
}

// Joint vectors with the tip at rest, in small steps both ways, within limits.
function swungBothWays(arm, start, held) {
  const limits = joints(arm).map((index) => [
    arm.rows[index].lower ?? -Infinity,
    arm.rows[index].upper ?? Infinity,
  ]);
  const walk = (sign) => {
    const found = [];
    let [q, before] = [start, null];
    for (let step = 0; step < 80; step++) {
      const columnsOf = linkColumns(arm, q);
      const [direction] = rightNull(columnsOf);
      if (!direction) break;
      const along = before
        ? direction.reduce((s, v, k) => s + v * before[k], 0)
        : sign * direction[2];
      const way = direction.map((v) => (along < 0 ? -v : v));
      const next = reach(
        arm,
        q.map((v, k) => v + 0.03 * way[k]),
        held,
      ).q;
      if (next.some((v, k) => v < limits[k][0] || v > limits[k][1])) break;
      found.push(next);
      [q, before] = [next, way];
    }
    return found;
  };
  return [...walk(-1).reverse(), start, ...walk(1)];
}

function linkColumns(arm, q) {
  const frames = linkFrames(arm, q);
  const tip = frames.at(-1).o;
  return joints(arm).map((index) => {
    const { z, o } = frames[index];
    const r = minus(tip, o);
    const v = [z[1] * r[2] - z[2] * r[1], z[2] * r[0] - z[0] * r[2], z[0] * r[1] - z[1] * r[0]];
    return [...v, ...z];
  });
}

// The circle on the wall for a radius: below a certain one the joints swing, above they wind.
export function winds(host, spec) {
  const abort = new AbortController();
  let [result, at, radius, wanted] = [null, 0, spec.radius ?? 0.1, 0];
  const live = makeLive(host, spec, {
    hold: false,
    state: { view: "trace", lit: spec.lit ? spec.lit - 1 : null },
    words: ({ arm }) => {
      if (!result) return "Computing …";
      const size = `Radius ${fixed(100 * radius, 1)} cm`;
      if (result.largest > 1e-4)
        return `${size}: no run gets round; the arm would have to pass a singular pose.`;
      const wound = joints(arm).flatMap((index, k) =>
        Math.abs(result.wound[k]) > 0.9 ? [`joint ${index + 1}`] : [],
      );
      return `${size}: ${wound.length ? `${listed(wound)} wind once round` : "the joints swing and come back"}.`;
    },
  });
  const { store } = live;
  const start = store.state.q;
  const show = () => {
    const { path } = result;
    const k = Math.round(at * (path.length - 1));
    store.dispatch({ type: "set", trace: path, q: path[k] });
  };
  const run = async () => {
    const mine = ++wanted;
    const { arm } = store.state;
    const found = await ask("run", { arm, q: start, run: { method: "exact", steps: 180, radius } });
    if (mine !== wanted || abort.signal.aborted) return;
    result = found;
    show();
    live.refresh();
  };
  const options = { signal: abort.signal };
  const place = makeLever("round", [0, 1], 0, {
    ...options,
    put: (v) => ((at = v), result && show()),
    text: (v) => `${fixed(100 * v, 0)} %`,
  });
  const size = makeLever("radius", [0.01, 0.1], radius, {
    ...options,
    put: (v) => ((radius = v), run()),
    text: (v) => `${fixed(100 * v, 1)} cm`,
  });
  live.card
    .querySelector(".side")
    .prepend(...(spec.fixed ? [place.root] : [size.root, place.root]));
  run();
  return () => (abort.abort(), live.dispose());
}

// Every way to the pose, to be clicked through.
export function ways(host, spec) {
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
    list.replaceChildren(
      ...found.list.map(({ q }, i) =>
        h(
          "button",
          {
            type: "button",
            role: "radio",
            "aria-label": `Way ${i + 1}`,
            style: `border-left: 6px solid ${branchColour(i)}`,
            onclick: () => store.dispatch({ type: "glide", q }),
          },
          String(i + 1),
        ),
      ),
    );
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
export function triangles(host, spec) {
  const live = makeLive(
    host,
    { arm: "Elbow arm", ...spec },
    {
      words: ({ arm, q }, { frames }) => {
        const [shoulder, tip] = [frames[1].o, frames.at(-1).o];
        const far = norm(minus(tip, shoulder));
        const [a2, a3] = [arm.rows[1].a, arm.rows[2].a];
        const D = (far * far - a2 * a2 - a3 * a3) / (2 * a2 * a3);
        const reached = `Shoulder to tip ${fixed(1000 * far, 0)} mm`;
        return `${reached}, so D = ${fixed(D, 3)} and θ₃ = ${deg(q[2])}; its cosine is D.`;
      },
    },
  );
  const { picture } = live;
  let drawn = [];
  live.follow((state, { frames }) => {
    if (!picture?.world) return;
    for (const piece of drawn) {
      piece.traverse((part) => {
        part.material?.dispose();
        part.geometry?.dispose();
      });
      piece.removeFromParent();
    }
    const [shoulder, elbow, tip] = frames.slice(1).map((frame) => frame.o);
    const below = [tip[0], tip[1], shoulder[2]];
    const line = (p, q) => [p, plus(scaled(0.5, p), scaled(0.5, q)), q];
    const thin = 0.003 * picture.size;
    const sides = [
      [shoulder, tip, 0],
      [shoulder, below, 2],
      [below, tip, 2],
      [shoulder, elbow, 1],
      [elbow, tip, 1],
    ];
    drawn = sides
      .filter(([p, q]) => norm(minus(p, q)) > 1e-3)
      .map(([p, q, colour]) => tube(line(p, q), thin, branchColour(colour)));
    drawn.forEach((piece) => picture.world.add(piece));
  });
  return live.dispose;
}
