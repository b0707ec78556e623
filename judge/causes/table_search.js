// Why a table is another arm: every reading with up to two causes undone, and what each leaves.

import { DEG } from "../geometry/angles.js";
import { angleBetween, compared, side } from "../geometry/axes.js";
import { combinations } from "../geometry/walk.js";
import { ANGLE, angular, squared, variableOf } from "../geometry/rows.js";
import { ENTRIES } from "../reading/table_rows.js";
import { say, size } from "../sentences.js";
import { rounded } from "../topics/table_words.js";
import { cause } from "./ranking.js";
import * as usual from "./table.js";

/** @typedef {import("../geometry/axes.js").Numbers} Numbers */
/** @typedef {import("./ranking.js").Cause} Cause */

/**
 * One reading of what was meant: its causes, the rows, the arm they are held against, and how many
 * entries differ.
 * @typedef {{ cause: Cause | null, rows: Numbers[], reference: Numbers[], entries: number }} Try
 */

const compare = ({ rows, reference }, length) =>
  compared(side(rows), side(reference), length, ANGLE);

const CHEAP = [
  "table.millimetres",
  "table.centimetres",
  "table.mixed units",
  "table.degrees",
  "table.twists in degrees",
];

const ONE_ENTRY = ["table.pen", "table.length"]; // a wrong entry whose reason is known

const ENTRY = 0.7; // what a wrong entry costs, where a cause costs 1

const BY_AXES = 0.5; // what it costs besides that entries still differ though the axes agree

// The causes after any one of which nothing is left: of the entries, or else of the axes, where
// that costs less than to mend a few entries one by one.
/** @returns {Cause[]} */
export function explaining(all, rows, wanted, length) {
  const equal = all.filter((t) => t.cause && !t.entries);
  const fewest = Math.min(...equal.map((t) => edits(t.cause)));
  if (equal.length) return equal.flatMap((t) => (edits(t.cause) === fewest ? [t.cause] : []));
  const most = fewEntries(all, wanted.length, length)?.cost ?? Infinity;
  const whole =
    agreeing(all, length, most) ?? (1 + BY_AXES < most ? oneSign(rows, wanted, length) : null);
  return whole?.cause ? [whole.cause] : [];
}

// What is told where no cause explains all: one besides which entries are wrong, or differences of
// the axes are left, whichever is less.
export function remaining(all, count, length, found) {
  const local = fewEntries(all, count, length);
  if (local && local.cost <= byAxes(found, local.best.cause)) {
    const entries = local.needed.map(([k, column]) => [local.best, k, column]);
    return { why: local.best.cause, entries, left: [] };
  }
  const { first, left } = fewest(all, length, found);
  return { why: first, entries: null, left };
}

// The reading that needs least besides a few entries: its cost, and the entries.
function fewEntries(all, rows, length) {
  const most = Math.max(3, Math.floor(rows / 2) + 1);
  const close = all.filter((t) => t.entries > 0 && t.entries <= most);
  if (!close.length) return null;
  const best = cheapest(close, (t) => cost(t.cause) + ENTRY * t.entries);
  const needed = neededOf(best, length);
  const count = needed.reduce((sum, [k, column]) => sum + mistakes(best, k, column, length), 0);
  return { cost: cost(best.cause) + ENTRY * count, best, needed };
}

// How many mistakes a wrong entry is: two where neither number nor sign is right.
function mistakes(t, k, column, length) {
  const why = kindOfError(column, k, t.rows[k][column], t.reference[k][column], length);
  return why.keys[0] === "table.number and sign" ? 2 : 1;
}

// What the differences of the axes cost, by which a table in frames of its own is judged. No bound
// where joints do not correspond, or against entries alone where a twist differs: axes that are
// parallel, and should not be, hide lengths.
function byAxes({ differences, signs }, why) {
  const hidden = !why && differences.some((d) => d.entry === "alpha");
  return hidden || !signs.length ? Infinity : ENTRY * differences.length;
}

const cheapest = (list, price) =>
  list.reduce((best, one) => (best === null || price(one) < price(best) ? one : best), null);

// What a reading costs; units go wrong so often that they are cheap.
const cost = (why) => (why?.keys ?? []).reduce((sum, key) => sum + costOf(key), 0);

const costOf = (key) => (CHEAP.includes(key) ? 0.5 : ONE_ENTRY.includes(key) ? 0.6 : 1);

// What it costs besides that entries still differ: nothing where the cause is one entry.
const apart = ({ keys }) => (keys.length === 1 && ONE_ENTRY.includes(keys[0]) ? 0 : BY_AXES);

const edits = (why) => why?.keys.length ?? 0;

// Every reading with up to two causes, each with how many entries differ from the reference's.
/** @returns {Try[]} */
export function tries(rows, reference, wanted, modified, length) {
  const others = [
    [null, wanted],
    ...usual.references(reference).map(([why, arm]) => [why, squared(arm)]),
  ];
  const mends = usual.structures(rows.length, modified);
  const whole = mends.filter(([{ keys }]) => ![usual.EXCHANGED, usual.IN_ROW].includes(keys[0]));
  /** @type {[Cause | null, Numbers[], Numbers[]][]} */
  const found = [];
  for (const [first, read] of usual.units(rows, wanted)) {
    for (const [other, arm] of others) {
      const both = usual.joined(first, other);
      found.push([both, squared(read), arm]);
      for (const [second, mend] of edits(both) < 2 ? mends : [])
        found.push([usual.joined(both, second), squared(mend(read)), arm]);
    }
    for (const [[second, mend], [third, then]] of first ? [] : combinations(whole, 2))
      found.push([usual.joined(second, third), squared(then(mend(rows))), wanted]);
  }
  const all = found.map(([why, read, arm]) => ({
    cause: why,
    rows: read,
    reference: arm,
    entries: differing(read, arm, length),
  }));
  // a and d of one row: where the axes alone agree, another frame may have been meant
  return all.filter(({ cause, entries }) => !entries || !cause?.keys.includes(usual.IN_ROW));
}

// How many entries differ; all where the rows do not correspond.
function differing(rows, wanted, length) {
  const alike =
    rows.length === wanted.length && rows.every(({ kind }, k) => kind === wanted[k].kind);
  return alike ? unequal(rows, wanted, length).length : Infinity;
}

// The entries that differ, the zeros of joints not counted.
/** @returns {[number, string][]} */
function unequal(rows, wanted, length) {
  return rows.flatMap((row, k) =>
    ENTRIES.filter((column) => {
      const [x, y] = [row[column], wanted[k][column]];
      const free = column === variableOf(row.kind);
      return !free && (angular(column) ? angleBetween(x, y) > ANGLE : Math.abs(x - y) > length);
    }).map((column) => /** @type {[number, string]} */ ([k, column])),
  );
}

// The first reading after which the axes agree, though entries differ, below a cost; or null.
function agreeing(all, length, most) {
  for (const t of all) {
    if (!t.cause || cost(t.cause) + apart(t.cause) >= most) continue;
    // Two causes after which most entries differ, and exchanged rows, fit by chance only; Craig's
    // rows may have one more than the reference.
    const few = edits(t.cause) === 1 || t.entries <= 2 * t.reference.length;
    const last = t.cause.keys.at(-1);
    const likely = (few || last === "table.craig") && last !== usual.EXCHANGED;
    if (likely && !compare(t, length).differences.length) return t;
  }
  return null;
}

function oneSign(rows, wanted, length) {
  const all = usual.flips(rows).map(([why, mended]) => ({
    cause: why,
    rows: mended,
    reference: wanted,
    entries: differing(mended, wanted, length),
  }));
  return cheapest(
    all.filter((t) => !compare(t, length).differences.length),
    (t) => t.entries,
  );
}

// The fewest of the entries that differ after whose mending the axes agree.
function neededOf(t, length) {
  const wrong = unequal(t.rows, t.reference, length);
  for (let count = 1; count < wrong.length; count++) {
    for (const chosen of combinations(wrong, count)) {
      const rows = [...t.rows];
      for (const [k, column] of chosen) rows[k] = { ...rows[k], [column]: t.reference[k][column] };
      if (!compare({ rows, reference: t.reference }, length).differences.length) return chosen;
    }
  }
  return wrong;
}

// The single cause that leaves much less than none does, and what it leaves: differences of axes,
// for where joints do not correspond these are not seen.
function fewest(all, length, { differences }) {
  let best = {
    cost: 0.7 * differences.length,
    first: /** @type {Cause | null} */ (null),
    left: differences,
  };
  for (const t of all) {
    if (edits(t.cause) !== 1 || t.cause.keys[0] === usual.EXCHANGED) continue;
    const { signs, differences: left } = compare(t, length);
    const total = 1 + 0.7 * left.length;
    if (signs.length && left.length && total < best.cost)
      best = { cost: total, first: t.cause, left };
  }
  return best;
}

/** @returns {Cause} */
export function kindOfError(column, row, mine, wanted, length) {
  const negative = angular(column)
    ? angleBetween(mine, -wanted) < ANGLE
    : Math.abs(mine + wanted) <= length;
  const twist = column === "alpha";
  if (negative) return twist ? cause("table.twist", { row }) : cause("table.sign", { column, row });
  if (!mine)
    return twist ? cause("table.no twist", { row }) : cause("table.missing", { column, row });
  if (!wanted) return cause("table.too much", { column, row });
  if (angular(column))
    return cause("table.angle", {
      column,
      row,
      _off: size(rounded(angleBetween(mine, wanted) * DEG, 6), 4),
    });
  if (mine * wanted < 0) return cause("table.number and sign", { column, row });
  const _way = Math.abs(mine) > Math.abs(wanted) ? say("long") : say("short");
  return cause("table.number", {
    column,
    row,
    _off: size(rounded(1000 * Math.abs(mine - wanted), 6), 4),
    _way,
  });
}
