// What explains a wrong Jacobian: the whole, then both halves apart, then each column.

import { bands } from "../digits.js";
import * as chains from "../geometry/chains.js";
import { numbered } from "../reading/numbers.js";
import { listed, lower, say } from "../sentences.js";
import { pairs } from "./jacobian.js";
import { better, both, cause, complete, explain, explainAll, nameOf, wordsOf } from "./ranking.js";

// what columns may be off by, however few their digits, to be known as some joints'
export const CLOSE = 0.05;

export const ROWS = ["vx", "vy", "vz", "wx", "wy", "wz"];

export const HALVES = ["linear", "angular"];

// What explains the whole, then both halves apart, then each column.
/**
 * `M` was typed for `right`, which is the `part` of the Jacobian from row `from` on.
 * @param {{ M: number[], right: number[], known: any, part: Function, where: any, from: number }}
 *   mistaken
 */
export function causesOf(mistaken, m) {
  const { M, right, known, part, where } = mistaken;
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
    let found = explain(M, right, band, { causes: known.causes, made });
    if (!complete(found)) {
      const [two, turned] = others.map((other) => other()[k]);
      found = better([found, two, complete(turned) ? turned : null]);
    }
    if (found) return [found.causes, oddColumns(found, where)];
    const halves = M.length === known.right.length ? byHalves(M, right, band, known) : [];
    if (halves.length) return [halves, []];
  }
  const band = M.some((x, i) => Math.abs(x - right[i]) > m.band[i]) ? m.band : m.allowed;
  return [[], columnFindings(mistaken, band)];
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
    const found = explain(mine, wanted, width, {
      causes: known.causes,
      made: known.made.map(rows),
    });
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

function columnFindings({ M, right, known, part, where, from }, band) {
  const { dof } = where.here;
  const column = (J, k) => J.filter((_, i) => i % dof === k);
  const others = allColumns(where).map(([joint, all]) => [
    joint,
    all.slice(from, from + M.length / dof),
  ]);
  return numbered(where.arm).flatMap((joint, k) => {
    const [mine, wanted, width] = [M, right, band].map((J) => column(J, k));
    if (mine.every((x, i) => Math.abs(x - wanted[i]) <= width[i])) return [];
    const same = (other) => mine.every((x, i) => Math.abs(x - other[i]) <= width[i]);
    const [what, said] =
      ofColumn(joint, mine, wanted, same) ??
      ofOtherJoint(
        others.find(([one, own]) => one !== joint && same(own)),
        where.arm,
      ) ??
      ofCause(known, (J) => same(column(part(J), k))) ??
      ofEntries(mine, wanted, width, from);
    const words = say("J column", { column: k + 1, joint, words: said });
    return [{ what, where: `column ${k + 1}`, words }];
  });
}

// What a wrong column is: itself turned over, another joint's, made by a known cause, or wrong in
// some entries.
function ofColumn(joint, mine, wanted, same) {
  if (same(wanted.map((x) => -x))) return [`J.column sign:${joint}`, say("J sign of column")];
  if (mine.length === 6 && same([...wanted.slice(3), ...wanted.slice(0, 3)])) {
    return ["J.column halves", say("J.column halves")];
  }
  return null;
}

function ofOtherJoint(other, arm) {
  if (!other) return null;
  const key = numbered(arm).includes(other[0]) ? "J.column of" : "J.column of locked";
  return [key, say(key, { joint: other[0] })];
}

function ofCause({ causes, made }, same) {
  const one = causes.find(({ keys: [key] }, i) => key.startsWith("J.") && same(made[i]));
  return one ? [nameOf(one), lower(wordsOf(one))] : null;
}

function ofEntries(mine, wanted, width, from) {
  const off = mine.flatMap((x, i) => (Math.abs(x - wanted[i]) > width[i] ? [i] : []));
  const turned = off.every((i) => Math.abs(mine[i] + wanted[i]) <= width[i]);
  const names = off.map((i) => ROWS[from + i]);
  return ["column", say(turned ? "J.entry signs" : "J.entries", { rows: listed(names) })];
}

// Each joint's column in the declared frame, then those that locked joints would have.
export function allColumns({ arm, here, T, seen }) {
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
