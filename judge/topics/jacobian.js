// Is a Jacobian wrong, and how?

import { norm } from "../geometry/kinematics.js";
import * as chains from "../geometry/chains.js";
import {
  bands,
  beyond,
  decimalsOf,
  graded,
  HAND,
  margins,
  RIGHT,
  ROUNDED,
  SLOPPY,
  SO_FAR,
  TELLING,
  WRONG,
} from "../digits.js";
import { lookup, numbered, numbers, pose, turning } from "../reading/numbers.js";
import { pairs, setting, singles } from "../causes/jacobian.js";
import {
  better,
  both,
  cause,
  complete,
  explain,
  explainAll,
  nameOf,
  several,
  wordsOf,
} from "../causes/ranking.js";
import { ArmError, listed, lower, say, tuple } from "../sentences.js";

// what columns may be off by, however few their digits, to be known as some joints'
const CLOSE = 0.05;
const ROWS = ["vx", "vy", "vz", "wx", "wy", "wz"];
const HALVES = ["linear", "angular"];

/**
 * The report on a Jacobian, a text or nested numbers, of an arm's tip at q.
 * @returns {import("../report.js").Report}
 */
export function compareJacobian(mine, arm, q, options = {}) {
  const {
    angularFirst = false,
    frame = 0,
    angles = "rad",
    tolerance = null,
    values = [],
  } = options;
  const { generic = false, computed = false, briefly = false } = options;
  const at = pose(q, arm, angles);
  const dof = at.values.length;
  const what = `${arm.name}: your Jacobian`;
  const { known, said } = lookup(arm, at.values, values);
  let typed = numbers(mine, what, known);
  if (generic && !typed.symbolic && !computed) throw new ArmError(say("J needs q"));
  if (computed) typed = { ...typed, symbolic: true };
  const count = typed.values.length;
  const flat = typed.shape.indexOf(1);
  if (typed.shape.length === 3 && flat >= 0)
    typed = { ...typed, shape: typed.shape.filter((_, i) => i !== flat) };
  if (typed.shape.length === 2 && count === 6 * dof && count === Math.max(...typed.shape)) {
    typed = { ...typed, shape: [6, dof] };
  }
  if (typed.shape.length !== 2)
    throw new ArmError(say("no matrix", { what, shape: tuple(typed.shape) }));
  const [rows, width] = typed.shape;
  if (width !== dof || (rows !== 6 && rows !== 3)) {
    return { ...misshapen(typed, arm, at.values, frame, said), typed };
  }
  if (!typed.values.some(Boolean)) {
    return { ...empty(arm, said), typed, wrong: typed.values.map(() => true) };
  }
  if (!angularFirst || rows !== 6) {
    const report = judged(typed, arm, at, frame, tolerance, said, briefly);
    return report && { ...report, typed };
  }
  const exchanged = (list) => [...list.slice(3 * dof), ...list.slice(0, 3 * dof)];
  const linearFirst = { ...typed, values: exchanged(typed.values), units: exchanged(typed.units) };
  const taken = [...said, say("taken: angular first")];
  const report = judged(linearFirst, arm, at, frame, tolerance, taken, briefly);
  return report && { ...report, typed, wrong: report.wrong && exchanged(report.wrong) };
}

/** @returns {import("../report.js").Report} */
const reported = (arm, grade, headline, rest = {}) => ({
  topic: "Jacobian",
  arm: arm.name,
  grade,
  headline,
  findings: [],
  causes: [],
  taken: [],
  notes: [],
  ...rest,
});

// The shape

function misshapen(typed, arm, q, frame, taken) {
  const { shape } = typed;
  const joint = leftOut(typed, arm, q, frame);
  const key = joint ? "J.column missing" : shapeCause(shape, arm);
  const said = say(key, { shape: shape.join("x"), dof: numbered(arm).length, joint });
  const words = `${said.replace(/\.+$/, "")}.`;
  const findings = [
    { what: "shape", where: "", mine: shape, expected: [6, numbered(arm).length], words },
  ];
  const headline = say("J wrong", { arm: arm.name, cause: lower(words) });
  return reported(arm, WRONG, headline, {
    findings,
    causes: [joint ? `${key}:${joint}` : key],
    taken,
  });
}

function empty(arm, taken) {
  const words = say("J.empty");
  const headline = say("J wrong", { arm: arm.name, cause: lower(words) });
  return reported(arm, WRONG, headline, {
    findings: [{ what: "cause", where: "", words }],
    causes: ["J.empty"],
    taken,
  });
}

// The only joint without which the columns are right; 0 where there is none.
function leftOut({ values, units, shape: [rows, width] }, arm, q, frame) {
  const dof = numbered(arm).length;
  if (rows !== 6 || width !== dof - 1) return 0;
  const right = allColumns(setting(arm, q, frame)).slice(0, dof);
  const fits = (k) => {
    const others = right.filter((_, i) => i !== k);
    return values.every((x, n) => {
      const wanted = others[n % width][1][Math.floor(n / width)];
      return Math.abs(x - wanted) <= Math.min(Math.max(HAND * units[n], SLOPPY), CLOSE);
    });
  };
  const found = right.filter((_, k) => fits(k));
  return found.length === 1 ? found[0][0] : 0;
}

function shapeCause([rows, width], arm) {
  const [dof, all] = [numbered(arm).length, arm.rows.length];
  if (rows === dof && width === 6) return "J.transposed";
  if (all > dof && width === all && rows === 5) return "J.row for column";
  if (all > dof && width === all && rows === 6) return "J.locked column kept";
  return "J.shape";
}

// The verdict

/** @returns {import("../report.js").Report} */
function judged(typed, arm, at, frame, tolerance, taken, briefly) {
  const q = at.values;
  const dof = q.length;
  const where = setting(arm, q, frame);
  const known = singles(where);
  const size = (half) => largest(known.right.slice(3 * half * dof, 3 * (half + 1) * dof));
  const sizes = [0, 1].map((half) => Math.max(1e-3, size(half)));
  let [from, to] = [0, 6];
  if (typed.shape[0] === 3) {
    from = rowsMeant(typed.values, known.right);
    to = from + 3;
    taken = [...taken, say("taken: half", { half: HALVES[from / 3] })];
  }
  const part = (J) => (to - from === 6 ? J : J.slice(from * dof, to * dof));
  const [right, made] = [part(known.right), known.made.map(part)];
  const scale = part(known.right.map((_, i) => sizes[i < 3 * dof ? 0 : 1]));
  const left = slop(arm, at, frame);
  const m = margins(typed.units, scale, left && part(left), tolerance);
  const grade = graded(typed.values, right, m, made);
  if (grade !== WRONG) {
    return good(grade, typed, arm, to - from, from, taken, typed.symbolic ? [] : hidden(known));
  }
  if (briefly) {
    const one = explain(typed.values, right, m.band, known.causes, made);
    return complete(one) ? bad(one.causes, [], arm, taken) : null;
  }
  const [found, symptoms] = causesOf(typed.values, right, m, known, part, where, from);
  return { ...bad(found, symptoms, arm, taken), wrong: beyond(typed.values, right, m) };
}

const largest = (list) => list.reduce((top, x) => Math.max(top, Math.abs(x)), 0);

// Which half three rows are: the one they are nearer to.
function rowsMeant(M, right) {
  const off = [0, 1].map((half) => norm(M.map((x, i) => x - right[half * M.length + i])));
  return off[1] < off[0] ? 3 : 0;
}

// What the unwritten digits of q may change in each entry: those of q with three decimals or more.
function slop(arm, at, frame) {
  const steps = at.units.map((u) => (u > 0 && u < 2e-3 ? u : 0));
  if (!steps.some(Boolean)) return null;
  const dof = steps.length;
  const jacobian = (q) => {
    const c = chains.chain(arm, q);
    return chains.columns(c, chains.framesOf(c));
  };
  const step = 1e-6;
  const here = jacobian(at.values);
  const total = here.map(() => 0);
  steps.forEach((u, k) => {
    const there = jacobian(at.values.map((x, i) => (i === k ? x + step : x)));
    let rates = there.map((x, i) => Math.abs(x - here[i]) / step);
    if (frame)
      rates = rates.map((_, i) =>
        Math.max(...[0, 1, 2, 3, 4, 5].map((r) => rates[r * dof + (i % dof)])),
      );
    rates.forEach((rate, i) => (total[i] += u * rate));
  });
  return total.map((x) => 0.51 * x);
}

// A word on the mistakes that this pose does not show.
function hidden({ right, causes, made }) {
  const effect = made.map((J) => largest(J.map((x, i) => x - right[i])));
  const method = causes.map(
    ({ keys: [key] }) => key.startsWith("J.") && key !== "J.columns exchanged",
  );
  const blind = method.filter((is, k) => is && effect[k] < TELLING).length;
  return blind ? [say("J hidden", { count: blind, all: method.filter(Boolean).length })] : [];
}

function good(grade, typed, arm, count, from, taken, notes) {
  const whole = count === 6;
  const digits = decimalsOf(typed.units);
  const keys = {
    [RIGHT]: whole ? "J right" : "J half right",
    [SO_FAR]: "J so far",
    [ROUNDED]: "J rounded",
  };
  const where = typed.symbolic ? "" : say("at this pose");
  const precision = digits === null || digits > 6 ? "" : say("to decimals", { digits });
  const [half, other] = from ? ["angular", "linear"] : HALVES;
  const headline = say(keys[grade], {
    arm: arm.name,
    where,
    precision,
    digits: digits ?? 0,
    half,
    other,
  });
  const missing = {
    what: "missing",
    where: `${other} rows`,
    words: say("J half missing", { other }),
  };
  const findings = whole ? [] : [missing];
  return reported(arm, whole || grade !== RIGHT ? grade : SO_FAR, headline, {
    findings,
    taken,
    notes,
  });
}

function bad(found, symptoms, arm, taken) {
  if (found.length) {
    const words = several(found);
    const findings = [{ what: "cause", where: "", words: `${words}.` }, ...symptoms];
    const headline = say("J wrong", { arm: arm.name, cause: `${lower(words)}.` });
    return reported(arm, WRONG, headline, { findings, causes: found.map(nameOf), taken });
  }
  if (symptoms.every(everything) && symptoms.length === numbered(arm).length) {
    const key = turning(arm)[0] ? "J turns" : "J slides";
    const question = say(key, { joint: numbered(arm)[0] });
    return reported(arm, WRONG, say("J wrong everywhere", { arm: arm.name, question }), { taken });
  }
  const headline =
    symptoms.length === 1
      ? say("J wrong place", { arm: arm.name, words: lower(symptoms[0].words) })
      : say("J wrong places", {
          arm: arm.name,
          places: listed(symptoms.map(({ where }) => where)),
        });
  const causes = [
    ...new Set(symptoms.map(({ what }) => what).filter((what) => what.includes("."))),
  ];
  return reported(arm, WRONG, headline, { findings: symptoms, causes, taken });
}

// Whether a column is wrong in every row, for no reason that is known.
const everything = ({ what, words }) =>
  what === "column" && ROWS.every((name) => words.includes(name));

// The causes

// What explains the whole, then both halves apart, then each column.
function causesOf(M, right, m, known, part, where, from) {
  const made = known.made.map(part);
  const all = bands(m);
  const others = [pairs, otherWays].map((make) =>
    once(() => explainAll(M, right, all, parts(make(where)))),
  );
  /** @returns {Generator<[import("../causes/ranking.js").Cause[], number[]]>} */
  const parts = function* (candidates) {
    for (const [causes, J] of candidates) yield [causes, part(J)];
  };
  for (const [k, band] of all.entries()) {
    let found = explain(M, right, band, known.causes, made);
    if (!complete(found)) {
      const [two, turned] = others.map((other) => other()[k]);
      found = better([found, two, complete(turned) ? turned : null]);
    }
    if (found) return [found.causes, oddColumns(found, where)];
    const halves = M.length === known.right.length ? byHalves(M, right, band, known) : [];
    if (halves.length) return [halves, []];
  }
  const band = M.some((x, i) => Math.abs(x - right[i]) > m.band[i]) ? m.band : m.allowed;
  return [[], columnFindings(M, right, band, known, part, where, from)];
}

const once = (make) => {
  let made;
  return () => (made ??= make());
};

// One cause for each wrong half, as a pair, if each half has one.
function byHalves(M, right, band, known) {
  const said = [];
  for (const [i, half] of HALVES.entries()) {
    const rows = (J) => J.slice((i * J.length) / 2, ((i + 1) * J.length) / 2);
    const [mine, wanted, width] = [rows(M), rows(right), rows(band)];
    if (mine.every((x, k) => Math.abs(x - wanted[k]) <= width[k])) continue;
    const found = explain(mine, wanted, width, known.causes, known.made.map(rows));
    if (!complete(found)) return [];
    const first = found.causes.find(({ keys: [key] }) => key.includes(half)) ?? found.causes[0];
    const words = wordsOf(first);
    const inside = words.includes(`${half} rows`);
    said.push(inside ? first : cause("J in half", { half, words, _of: nameOf(first) }));
  }
  return said.length ? [said.reduce(both)] : [];
}

// Joints counted the other way, in the matrix and in q; fewest first.
/** @returns {Generator<[import("../causes/ranking.js").Cause[], number[]]>} */
function* otherWays({ arm, frame, here }) {
  const names = (signs) => numbered(arm).flatMap((i, k) => (signs[k] < 0 ? [`q_${i}`] : []));
  for (const signs of chains.signSets(here.dof)) {
    const other = { ...here, q: here.q.map((x, k) => signs[k] * x) };
    const T = chains.framesOf(other);
    const J = chains.columns(other, T).map((x, i) => x * signs[i % here.dof]);
    yield [
      [cause("joints reversed", { joints: listed(names(signs)) })],
      frame ? chains.seenIn(J, T[frame]) : J,
    ];
  }
}

function oddColumns({ odd }, { arm, here: { dof } }) {
  return numbered(arm).flatMap((joint, k) => {
    const rows = ROWS.filter((_, i) => odd[i * dof + k]);
    if (!rows.length) return [];
    const words = say("J besides", { column: k + 1, joint, rows: rows.join(", ") });
    return [{ what: "column", where: `column ${k + 1}`, words }];
  });
}

function columnFindings(M, right, band, known, part, where, from) {
  const { dof } = where.here;
  const column = (J, k) => J.filter((_, i) => i % dof === k);
  const others = allColumns(where).map(([joint, all]) => [
    joint,
    all.slice(from, from + M.length / dof),
  ]);
  return numbered(where.arm).flatMap((joint, k) => {
    const [mine, wanted, width] = [M, right, band].map((J) => column(J, k));
    if (mine.every((x, i) => Math.abs(x - wanted[i]) <= width[i])) return [];
    const as = (J) => mine.every((x, i) => Math.abs(x - column(part(J), k)[i]) <= width[i]);
    const [what, said] = columnFinding(
      joint,
      mine,
      wanted,
      width,
      known,
      as,
      where.arm,
      others,
      from,
    );
    return [
      {
        what,
        where: `column ${k + 1}`,
        words: say("J column", { column: k + 1, joint, words: said }),
      },
    ];
  });
}

function columnFinding(joint, mine, wanted, width, known, as, arm, others, from) {
  const same = (other) => mine.every((x, i) => Math.abs(x - other[i]) <= width[i]);
  if (same(wanted.map((x) => -x))) return [`J.column sign:${joint}`, say("J sign of column")];
  if (mine.length === 6 && same([...wanted.slice(3), ...wanted.slice(0, 3)])) {
    return ["J.column halves", say("J.column halves")];
  }
  const other = others.find(([one, column]) => one !== joint && same(column));
  if (other) {
    const key = numbered(arm).includes(other[0]) ? "J.column of" : "J.column of locked";
    return [key, say(key, { joint: other[0] })];
  }
  const one = known.causes.find(({ keys: [key] }, i) => key.startsWith("J.") && as(known.made[i]));
  if (one) return [nameOf(one), lower(wordsOf(one))];
  const off = mine.flatMap((x, i) => (Math.abs(x - wanted[i]) > width[i] ? [i] : []));
  const turned = off.every((i) => Math.abs(mine[i] + wanted[i]) <= width[i]);
  const names = off.map((i) => ROWS[from + i]);
  return ["column", say(turned ? "J.entry signs" : "J.entries", { rows: listed(names) })];
}

// Each joint's column in the declared frame, then those that locked joints would have.
function allColumns({ arm, here, T, seen }) {
  const locked = arm.rows.flatMap((row, i) => (row.kind === "fixed" ? [i] : []));
  const loose = {
    ...here,
    q: locked.map(() => 0),
    at: locked,
    turns: locked.map(() => true),
    dof: locked.length,
  };
  return [here, loose].flatMap((c) => {
    const J = seen(chains.columns(c, T));
    return c.at.map((i, k) => [i + 1, J.filter((_, n) => n % c.dof === k)]);
  });
}
