// The homework's circle played, and its mistakes: any number of runs at once on the wall, each with
// its own method.

import css from "./homework.css";
import { outside } from "../../../judge/geometry/arm.js";
import { attribute, h, svg, write } from "../dom.js";
import { ask, latest } from "../jobs.js";
import { joints, linkFrames, minus } from "../../../judge/geometry/kinematics.js";
import { BOUNDS, HOMEWORK, isPanda, onCircle, radiiTo, torquesAlong } from "../runs.js";
import { branchColour } from "../scene.js";
import { fixed, listed } from "../text.js";
import { makePlots } from "./plots.js";
import { makeTransport } from "./transport.js";

const NAMES = {
  euler: "Euler",
  rk4: "Runge-Kutta 4",
  exact: "exact inverse kinematics",
  inverse: "J⁻¹",
  pseudo: "pseudo-inverse",
  damped: "damped",
};
const SLIPS = {
  "": "none",
  angular: "z_i in the angular rows",
  z_i: "z_i and o_i throughout",
  o_i: "o_i instead of o_i−1",
  sign: "rates with the wrong sign",
  next: "velocity of the next step",
};
const MODELS = { "": "none", wrench: "wrong sign of F", centres: "centres of mass not converted" };
const WIDE = 260; // of the wall's picture
const CURVE = [260, 120]; // of the curves over the radius
const MOST_RUNS = 8;
const OVER_RADIUS =
  "Over the circle’s radius: whole turns of a joint (bars; red where no run gets round), " +
  "and the smallest σ (line). Click to choose one.";

export function build(store, { say, signal }) {
  let [chosen, magnify, model] = [0, 30, ""];
  let shown = {};
  const results = new Map(); // by arm, start and run
  let start = store.state.q; // where the runs begin
  const list = h("div.runs", { role: "radiogroup", "aria-label": "Runs" });
  const verdict = h("p.verdict");
  const wall = svg("svg", {
    viewBox: `0 0 ${WIDE} ${WIDE}`,
    role: "img",
    "aria-label": "The wall with the runs on it",
  });
  const curve = svg("svg", { viewBox: `0 0 ${CURVE[0]} ${CURVE[1]}`, role: "img" });
  const plots = makePlots();
  const transport = makeTransport(store, { signal, begin: () => show() });
  const quantity = select(
    "What the plots show",
    { joint: "joint values", torque: "static torques" },
    () => lay(),
  );
  const slipOfModel = select("Mistake in the torques", MODELS, (value) => ((model = value), lay()));
  const fields = makeFields((patch) => edit(patch));
  const button = (text, onclick) => h("button", { type: "button", onclick }, text);
  const zoom = h("input", {
    type: "range",
    min: 0,
    max: 3,
    step: "any",
    value: Math.log10(magnify),
    "aria-label": "Magnify the errors",
    oninput: (e) => ((magnify = 10 ** Number(e.target.value)), drawWall()),
  });
  const zoomed = h("output");
  const add = button("Add a run", () => {
    const { runs } = store.state;
    chosen = runs.length;
    put([...runs, { ...runs.at(-1), method: runs.at(-1).method === "euler" ? "rk4" : "euler" }]);
  });
  const remove = button("Remove it", () => {
    const runs = store.state.runs.filter((_, i) => i !== chosen);
    chosen = Math.max(0, chosen - 1);
    put(runs);
  });
  const here = button(
    "Start where the arm stands",
    () => ((start = store.state.q), results.clear(), compute()),
  );
  const root = h(
    "div.homework",
    {},
    h("style", {}, css),
    h("div.row", {}, list, add, remove, here),
    fields.root,
    verdict,
    transport.root,
    h(
      "div.walls",
      {},
      h("figure", {}, wall, h("figcaption", {}, h("label", {}, "Errors magnified ", zoom, zoomed))),
      h("figure", {}, curve, h("figcaption", {}, OVER_RADIUS)),
    ),
    h(
      "div.row",
      {},
      h("label", {}, "Plots ", quantity),
      h("label", {}, "Mistake in the torques ", slipOfModel),
    ),
    plots.root,
  );
  const askWinding = latest("winding");
  curve.addEventListener("click", (event) => {
    const box = curve.getBoundingClientRect();
    const share = Math.min(1, Math.max(0, (event.clientX - box.left) / box.width));
    edit({ radius: Number((0.01 + 0.09 * share).toFixed(3)) });
  });

  const put = (runs) => store.dispatch({ type: "show", runs });
  const edit = (patch) =>
    put(store.state.runs.map((run, i) => (i === chosen ? { ...run, ...patch } : run)));
  const key = (run) => JSON.stringify([store.state.arm.rows, start, run]);
  const resultOf = (run) => results.get(key(run));

  // Ask for the runs that are not known yet; each shows as it comes.
  async function compute() {
    const { arm, runs } = store.state;
    const wanted = runs.filter((run) => !results.has(key(run)));
    for (const run of wanted) {
      const id = key(run);
      results.set(id, null);
      const answer = await ask("run", { arm, q: start, run });
      results.set(id, answer);
      if (signal.aborted || store.state.arm !== arm) return;
      if (runs === store.state.runs) show();
    }
    show();
    const run = runs[chosen];
    if (!run || shown.winding === windingKey(run)) return;
    shown.winding = windingKey(run);
    const asked = { arm, q: start, run: { normal: run.normal, locked: run.locked } };
    askWinding(asked, (curveOf) => ((shown.curve = curveOf), drawCurve()));
  }
  const windingKey = (run) => JSON.stringify([store.state.arm.rows, start, run.normal, run.locked]);

  // The chosen run becomes the trace that is played; the others are lines beside it.
  function show() {
    const { runs, arm, circle } = store.state;
    const known = runs.map(resultOf);
    const paths = known.flatMap((result, i) =>
      result
        ? [{ points: result.path.map((q) => linkFrames(arm, q).at(-1).o), colour: branchColour(i) }]
        : [],
    );
    store.dispatch({ type: "show", paths });
    const mine = known[chosen];
    if (mine && mine.path.length > 1 && store.state.trace !== mine.path) {
      store.dispatch({ type: "traced", arm, circle, path: mine.path, stray: 0, wanted: null });
    } else if (mine && mine.path.length < 2) store.dispatch({ type: "show", trace: null });
    lay();
    say(() => verdict.textContent);
  }

  function lay() {
    const { runs, arm, wrench, trace } = store.state;
    list.replaceChildren(...runs.map((run, i) => line(run, i)));
    fields.update(runs[chosen], arm);
    write(verdict, runs[chosen] ? said(runs[chosen], resultOf(runs[chosen]), arm) : "");
    remove.disabled = runs.length < 2;
    add.disabled = runs.length >= MOST_RUNS;
    const torques = quantity.value === "torque";
    slipOfModel.options[2].disabled = !isPanda(arm);
    if (trace)
      plots.lay(store.state, torques ? torquesAlong(arm, trace, wrench, model) : trace, torques);
    else plots.clear();
    plots.mark(store.state.at);
    drawWall();
    drawCurve();
  }

  function line(run, i) {
    const result = resultOf(run);
    const error = result
      ? result.failed === null
        ? ` ${millimetres(result.largest)}`
        : " no inverse"
      : " …";
    const attributes = {
      type: "button",
      role: "radio",
      "aria-checked": String(i === chosen),
      onclick: () => ((chosen = i), compute()),
    };
    const swatch = h("span.swatch", {
      style: `background:${branchColour(i)}`,
      "aria-hidden": "true",
    });
    return h("button", attributes, swatch, h("span", {}, `${named(run)}:${error}`));
  }

  // The wall seen from the arm: the circle that was asked for, and each run with its error made
  // larger.
  function drawWall() {
    const { runs, arm } = store.state;
    write(zoomed, `× ${fixed(magnify, magnify < 10 ? 1 : 0)}`);
    const top = linkFrames(arm, start).at(-1).o;
    const largest = Math.max(...runs.map((run) => run.radius), 0.01);
    const scale = WIDE / (2.6 * largest);
    const flat = (run, o) => {
      const d = minus(o, top);
      return [WIDE / 2 + scale * (run.normal === "x" ? d[1] : -d[0]), 0.13 * WIDE - scale * d[2]];
    };
    const shapes = runs.flatMap((run, i) => {
      const result = resultOf(run);
      const share = (k) => onCircle(top, run, k).o;
      const asked = radiiTo(1, 73).map((_, k) => flat(run, share(k / 72)));
      const circle = svg("polyline", { points: asked.join(" "), class: "asked" });
      if (!result) return [circle];
      const points = result.path.map((q, k) => {
        const [is, should] = [linkFrames(arm, q).at(-1).o, share(result.at[k])];
        return flat(
          run,
          should.map((v, a) => v + magnify * (is[a] - v)),
        );
      });
      return [
        circle,
        svg("polyline", {
          points: points.map((p) => p.map((v) => v.toFixed(1))).join(" "),
          stroke: branchColour(i),
        }),
      ];
    });
    wall.replaceChildren(...shapes);
  }

  function drawCurve() {
    const points = shown.curve;
    if (!points?.length) return curve.replaceChildren();
    const [w, high] = CURVE;
    const x = (radius) => (w * (radius - 0.01)) / 0.09;
    const most = Math.max(...points.map(({ least }) => least), 1e-6);
    const least = points.map(
      ({ radius, least: v }) =>
        `${x(radius).toFixed(1)},${(high - 8 - ((high - 16) * v) / most).toFixed(1)}`,
    );
    const bars = points.map(({ radius, turns, reached }) => {
      const tall = Math.min(3, Math.abs(turns)) * 18;
      return svg("rect", {
        x: x(radius) - 3,
        y: high - 4 - tall,
        width: 6,
        height: tall + 4,
        class: reached ? "turns" : "broken",
      });
    });
    const now = store.state.runs[chosen]?.radius ?? 0.1;
    const mark = svg("line", { x1: x(now), x2: x(now), y1: 0, y2: high, class: "cursor" });
    curve.replaceChildren(
      ...bars,
      svg("polyline", { points: least.join(" "), class: "least" }),
      mark,
    );
    attribute(curve, "aria-label", curveWords(points));
    return undefined;
  }

  function update(state) {
    if (shown.arm !== state.arm) {
      const first = !shown.arm;
      start = state.q;
      chosen = 0;
      results.clear();
      shown = { arm: state.arm };
      // which comes back here
      if (!state.runs.length || !first) return put([startingRun(state.arm)]);
    }
    if (shown.runs !== state.runs) {
      shown.runs = state.runs;
      chosen = Math.min(chosen, state.runs.length - 1);
      lay();
      compute();
    } else if (shown.unit !== state.unit || shown.wrench !== state.wrench) lay();
    Object.assign(shown, { unit: state.unit, wrench: state.wrench });
    plots.mark(state.at);
    transport.update(state);
    return undefined;
  }
  return { root, update, summary: () => verdict.textContent };
}

function select(label, options, onchoice) {
  const list = Object.entries(options).map(([value, text]) => h("option", { value }, text));
  return h("select", { "aria-label": label, onchange: (e) => onchoice(e.target.value) }, list);
}

// What the homework asks of this arm: the Panda with joint 3 locked, the UR10e in front of its
// wall.
const startingRun = (arm) =>
  joints(arm).length === 7
    ? { ...HOMEWORK }
    : {
        ...HOMEWORK,
        locked: -1,
        normal: /** @type {"x" | "y"} */ (/UR10e/.test(arm.name) ? "y" : "x"),
        seconds: /UR10e/.test(arm.name) ? 20 : 5,
        rates: /** @type {"pseudo"} */ ("pseudo"),
      };

function millimetres(v) {
  if (v < 1e-12) return "under 1e−9 mm";
  return `${v < 1e-5 ? (1000 * v).toExponential(1).replace("-", "−") : fixed(1000 * v, v < 1e-2 ? 3 : 1)} mm`;
}
const named = ({ method, rates, steps, gain, slip }) => {
  const how = method === "exact" ? NAMES.exact : `${NAMES[method]}, ${NAMES[rates]}, N = ${steps}`;
  return how + (gain ? `, gain ${fixed(gain, 1)}` : "") + (slip ? `, ${SLIPS[slip]}` : "");
};

function said(run, result, arm) {
  if (!result) return "Computing …";
  if (result.failed !== null) {
    return result.failed === 0
      ? "The Jacobian has no inverse where the run starts: the pose is singular. " +
          "Choose the pseudo-inverse or damped rates."
      : `The run breaks at step ${result.failed} of ${run.steps}: no inverse there.`;
  }
  const jointNames = (holds) =>
    joints(arm).flatMap((row, k) => (holds(row, k) ? [`joint ${row + 1}`] : []));
  const winding = jointNames((_, k) => Math.abs(result.wound[k]) > 0.9);
  const past = jointNames((row, k) => result.path.some((q) => outside(arm.rows[row], q[k])));
  const turns = winding.length ? ` Once round: ${listed(winding)}.` : "";
  const limits = past.length ? ` Past its limits: ${listed(past)}.` : "";
  const size =
    result.least < 1e-4 ? result.least.toExponential(1).replace("-", "−") : fixed(result.least, 4);
  const error = `Largest error ${millimetres(result.largest)}`;
  const speed =
    result.run.method === "exact" ? "" : `, fastest joint ${fixed(result.fastest, 2)} rad/s`;
  const tilt =
    result.tilt > 1e-3 ? `, the tool tilts by ${fixed((result.tilt * 180) / Math.PI, 1)}°` : "";
  return `${error}${tilt}${speed}. Smallest σ on the way: ${size}.${turns}${limits}`;
}

function curveWords(points) {
  const broken = points.filter(({ reached }) => !reached);
  const wound = points.filter(({ turns, reached }) => reached && turns);
  const cm = (one) => `${fixed(100 * one.radius, 1)} cm`;
  const parts = [];
  if (wound.length) parts.push(`a joint winds once round from ${cm(wound[0])} on`);
  if (broken.length) parts.push(`no run from ${cm(broken[0])} to ${cm(broken.at(-1))}`);
  return `Radius from 1 to 10 cm: ${parts.join("; ") || "the joints only swing"}.`;
}

// The levers of one run.
function makeFields(edit) {
  const choice = (label, keys) => [
    label,
    select(label, Object.fromEntries(keys.map((k) => [k, NAMES[k]])), (v) =>
      edit({ [label === "Method" ? "method" : "rates"]: v }),
    ),
  ];
  const [method, rates] = [
    choice("Method", ["euler", "rk4", "exact"]),
    choice("Rates", ["inverse", "pseudo", "damped"]),
  ];
  const slip = ["Mistake", select("Mistake", SLIPS, (v) => edit({ slip: v }))];
  const sliders = [
    slider("steps", "N", true, (v) => String(v), Math.round),
    slider("seconds", "T", false, (v) => `${fixed(v, 0)} s`, Math.round),
    slider(
      "radius",
      "Radius",
      false,
      (v) => `${fixed(100 * v, 1)} cm`,
      (v) => Number(v.toFixed(3)),
    ),
    slider(
      "gain",
      "Feedback",
      false,
      (v) => `${fixed(v, 1)} /s`,
      (v) => Number(v.toFixed(1)),
    ),
    slider(
      "cutoff",
      "Cut-off",
      true,
      (v) => v.toExponential(0).replace("-", "−"),
      (v) => Number(v.toPrecision(1)),
    ),
    slider(
      "damping",
      "Damping",
      true,
      (v) => fixed(v, 3),
      (v) => Number(v.toPrecision(2)),
    ),
  ];
  const lock = h("input", {
    type: "checkbox",
    onchange: (e) => edit({ locked: e.target.checked ? 2 : -1 }),
  });
  const locked = h("label.check", {}, lock, " joint 3 locked");
  const selects = [method, rates, slip].map(([label, element]) =>
    h("label", {}, `${label} `, element),
  );
  const root = h(
    "div.levers",
    {},
    selects,
    locked,
    sliders.map(({ root: part }) => part),
  );

  function slider(key, label, logarithmic, text, rounded) {
    const [low, high] = BOUNDS[key].map((v) => (logarithmic ? Math.log10(v) : v));
    const value = (input) => rounded(logarithmic ? 10 ** Number(input.value) : Number(input.value));
    const input = h("input", {
      type: "range",
      min: low,
      max: high,
      step: "any",
      "aria-label": label,
      oninput: (e) => write(output, text(value(e.target))),
      onchange: (e) => edit({ [key]: value(e.target) }),
    });
    const output = h("output");
    return {
      key,
      root: h("label.lever", {}, `${label} `, input, output),
      show: (v) => {
        input.value = String(logarithmic ? Math.log10(v) : v);
        input.setAttribute("aria-valuetext", text(v));
        write(output, text(v));
      },
    };
  }

  function update(run, arm) {
    if (!run) return;
    method[1].value = run.method;
    rates[1].value = run.rates;
    slip[1].value = run.slip;
    lock.checked = run.locked === 2;
    locked.hidden = joints(arm).length < 7;
    for (const { key, root: part, show } of sliders) {
      show(run[key]);
      const idle = run.method === "exact" && !["radius", "steps", "seconds"].includes(key);
      part.hidden =
        idle ||
        (key === "cutoff" && run.rates !== "pseudo") ||
        (key === "damping" && run.rates !== "damped");
    }
    selects[1].hidden = run.method === "exact";
    selects[2].hidden = run.method === "exact";
  }
  return { root, update };
}
