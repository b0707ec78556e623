// Is a Jacobian wrong, and how?

import { answering, reportOf } from "../report.js";
import { setting, singles } from "../causes/jacobian.js";
import { allColumns, causesOf, CLOSE, HALVES, ROWS } from "../causes/jacobian_search.js";
import { complete, explain, nameOf, perhaps, several } from "../causes/ranking.js";
import {
  beyond,
  decimalsOf,
  graded,
  HAND,
  lastDigit,
  margins,
  RIGHT,
  ROUNDED,
  slopOf,
  SLOPPY,
  SO_FAR,
  TELLING,
  WRONG,
} from "../digits.js";
import * as chains from "../geometry/chains.js";
import { norm } from "../geometry/kinematics.js";
import { minusEach } from "../geometry/linear.js";
import { rowsOfColumns } from "../reading/matrix_columns.js";
import { lookup, numbered, numbers, pose, turning } from "../reading/numbers.js";
import { ArmError, counted, listed, lower, say } from "../sentences.js";

/**
 * The report on a Jacobian, a text or nested numbers, of an arm's tip at q.
 * @returns {import("../report.js").Report}
 */
export const compareJacobian = answering(jacobianCompared, /^j/i);

function jacobianCompared(mine, arm, q, options = {}) {
  const { angularFirst = false, frame = 0, angles = "rad" } = options;
  const at = pose(q, arm, angles);
  const dof = at.values.length;
  const { known, said } = lookup(arm, at.values, options.values ?? []);
  const typed = matrix(mine, `${arm.name}: your Jacobian`, known, dof, options);
  const asked = { arm, at, frame, tolerance: options.tolerance ?? null, briefly: options.briefly };
  const [rows, width] = typed.shape;
  if (width !== dof || ![3, 6].includes(rows)) return { ...misshapen(typed, asked, said), typed };
  if (!typed.values.some(Boolean))
    return { ...empty(arm, said), typed, wrong: typed.values.map(() => true) };
  return angularFirst && rows === 6
    ? judgedAngularFirst(typed, asked, said)
    : whole(judged(typed, asked, said), typed);
}

// `report` with what was typed; null where it was asked for briefly, and there is no single cause.
const whole = (report, typed) => report && { ...report, typed };

// What was typed as a matrix; all of its entries in one row or column are taken row by row. A
// formula needs no q; `computed` are the values of a function, which count as one.
function matrix(mine, what, known, dof, { generic = false, computed = false }) {
  const read = numbers(rowsOfColumns(mine), what, known);
  if (generic && !read.symbolic && !computed) throw new ArmError(say("J needs q"));
  const { values } = read;
  const one = read.shape.length === 3 ? read.shape.indexOf(1) : -1;
  const shape = one < 0 ? read.shape : read.shape.filter((_, i) => i !== one);
  const typed = { ...read, shape, symbolic: read.symbolic || computed };
  if (shape.length !== 2) throw new ArmError(say("no matrix", { what, given: counted(shape) }));
  const flat = values.length === 6 * dof && values.length === Math.max(...shape);
  return flat ? { ...typed, shape: [6, dof] } : typed;
}

function judgedAngularFirst(typed, asked, said) {
  const half = typed.values.length / 2;
  const exchanged = (list) => [...list.slice(half), ...list.slice(0, half)];
  const linearFirst = { ...typed, values: exchanged(typed.values), units: exchanged(typed.units) };
  const report = judged(linearFirst, asked, [...said, say("taken: angular first")]);
  return whole(report && { ...report, wrong: report.wrong && exchanged(report.wrong) }, typed);
}

const reported = (...told) => reportOf("Jacobian", ...told);

// The shape

function misshapen(typed, { arm, at, frame }, taken) {
  const { shape } = typed;
  const joint = leftOut(typed, setting(arm, at.values, frame));
  const key = joint ? "J.column missing" : shapeCause(shape, arm);
  const said = say(key, { shape: shape.join("x"), dof: numbered(arm).length, joint });
  const words = `${said.replace(/\.+$/, "")}.`;
  const expected = [6, numbered(arm).length];
  const findings = [{ what: "shape", where: "", mine: shape, expected, words }];
  const headline = say("J wrong", { arm: arm.name, cause: lower(words) });
  return reported(arm, WRONG, headline, {
    findings,
    causes: [joint ? `${key}:${joint}` : key],
    taken,
  });
}

const empty = (arm, taken) =>
  reported(arm, WRONG, say("J wrong", { arm: arm.name, cause: say("J zero") }), { taken });

// The only joint without which the columns are right; 0 where there is none.
function leftOut({ values, units, shape: [rows, width] }, where) {
  const { dof } = where.here;
  if (rows !== 6 || width !== dof - 1) return 0;
  const right = allColumns(where).slice(0, dof);
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
function judged(typed, { arm, at, frame, tolerance, briefly = false }, said) {
  const where = setting(arm, at.values, frame);
  const known = singles(where);
  const half = typed.shape[0] === 3 ? rowsMeant(typed.values, known.right) : null;
  const taken = half === null ? said : [...said, say("taken: half", { half: HALVES[half] })];
  const part = (J) =>
    half === null ? J : J.slice((half * J.length) / 2, ((half + 1) * J.length) / 2);
  const right = part(known.right);
  const left = slop(arm, at, frame);
  const m = margins(typed.units, part(scales(known.right)), left && part(left), tolerance);
  const grade = graded(typed.values, right, m, known.made.map(part));
  if (grade !== WRONG) {
    const how = lastDigit(typed.values, right, typed.units);
    const notes = typed.symbolic ? [] : hidden(known);
    return good(grade, typed, arm, half, { taken, notes, how });
  }
  if (briefly) {
    const made = known.made.map(part);
    const one = explain(typed.values, right, m.band, { causes: known.causes, made });
    return complete(one) ? bad(one.causes, [], arm, taken) : null;
  }
  const mistaken = { M: typed.values, right, known, part, where, from: half ? 3 : 0 };
  const [found, symptoms] = causesOf(mistaken, m);
  return { ...bad(found, symptoms, arm, taken), wrong: beyond(typed.values, right, m) };
}

// How large each entry may be taken to be: as large as its half's largest.
function scales(right) {
  const middle = right.length / 2;
  const sizes = [right.slice(0, middle), right.slice(middle)].map((J) =>
    Math.max(1e-3, largest(J)),
  );
  return right.map((_, i) => sizes[i < middle ? 0 : 1]);
}

const largest = (list) => list.reduce((top, x) => Math.max(top, Math.abs(x)), 0);

// Which half three rows are: the one they are nearer to.
function rowsMeant(M, right) {
  const off = [0, 1].map((half) => norm(M.map((x, i) => x - right[half * M.length + i])));
  return off[1] < off[0] ? 1 : 0;
}

// What the unwritten digits of q may change in each entry.
const slop = (arm, { units, values }, frame) =>
  slopOf(units, values, (q) => {
    const c = chains.chain(arm, q);
    const T = chains.framesOf(c);
    const J = chains.columns(c, T);
    return frame ? chains.seenIn(J, T[frame]) : J;
  });

// A word on the mistakes that this pose does not show.
function hidden({ right, causes, made }) {
  const effect = made.map((J) => largest(minusEach(J, right)));
  const method = causes.map(
    ({ keys: [key] }) => key.startsWith("J.") && key !== "J.columns exchanged",
  );
  const blind = method.filter((is, k) => is && effect[k] < TELLING).length;
  return blind ? [say("J hidden", { count: blind, all: method.filter(Boolean).length })] : [];
}

// `half` is which half three rows are, null where all six are there.
function good(grade, typed, arm, half, { how, ...said }) {
  const whole = half === null;
  const digits = decimalsOf(typed.units);
  const keys = {
    [RIGHT]: whole ? "J right" : "J half right",
    [SO_FAR]: "J so far",
    [ROUNDED]: "J rounded",
  };
  const where = typed.symbolic ? "" : say("at this pose");
  const precision = digits === null || digits > 6 ? "" : say("to decimals", { digits });
  const [own, other] = half ? ["angular", "linear"] : HALVES;
  const headline = say(keys[grade], {
    arm: arm.name,
    where,
    precision,
    digits: digits ?? 0,
    how,
    half: own,
    other,
  });
  const missing = {
    what: "missing",
    where: `${other} rows`,
    words: say("J half missing", { other }),
  };
  const findings = whole ? [] : [missing];
  return reported(arm, whole || grade !== RIGHT ? grade : SO_FAR, headline, { findings, ...said });
}

function bad(found, symptoms, arm, taken) {
  if (found.length) {
    const words = perhaps(several(found), symptoms);
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
