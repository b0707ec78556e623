// Is my table wrong, or only different?

import { angleBetween, combinations, compared, placesBase, side } from "../geometry/axes.js";
import { DEG } from "../geometry/angles.js";
import { RIGHT, ROUNDED, units, WRONG } from "../digits.js";
import { equations, jointMap } from "../geometry/joint_map.js";
import { cause, nameOf, several } from "../causes/ranking.js";
import { lower, say, size } from "../sentences.js";
import { ENTRIES, inMillimetres, meant, read } from "../reading/table.js";
import * as usual from "../causes/table.js";

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
const ANGLE = 1e-4; // rad: angles are often written with four decimals
const LENGTH = 1e-6; // m
const LOW = 1e-2; // m: a base no higher tells no unit
const SHORT = 1e3 / Math.sqrt(10); // mm for each m: less is nearer to the arm's size in centimetres
const COARSEST = 1e-3; // m: lengths typed to the millimetre are still lengths
const WHOLES = /^(?:[-+−()$\s0-9]|(?<=[0-9])\.(?![0-9]))*$/; // and their sums
const DECIMAL = /\d*\.\d+(?:[eE][+-]?\d+)?/g;

/** @typedef {import("../geometry/axes.js").Numbers} Numbers */
/** @typedef {import("../geometry/axes.js").Compared} Compared */
/** @typedef {import("../geometry/axes.js").Difference} Difference */
/** @typedef {import("../causes/ranking.js").Cause} Cause */
/** @typedef {import("../report.js").Finding} Finding */
/** @typedef {import("../report.js").Report} Report */

/**
 * How the table is to be read; what is empty or not said is guessed.
 * @typedef {object} Options
 * @property {string} [columns] their order, as "theta d a alpha"
 * @property {string} [lengths] "m", "cm" or "mm"
 * @property {string} [angles] "rad" or "deg"
 * @property {string} [convention] "standard" or "craig"
 * @property {number} [tolerance] the largest deviation of a length (m)
 * @property {[string, number][]} [values] of symbols that the arm does not have
 */

/**
 * A student's table in numbers, in SI units where they were said, with the units of the last
 * places. In the modified convention a and alpha stand one row further down than in `rows`; `added`
 * is 1 where a fixed row before the typed ones holds the first of them.
 * @typedef {object} Table
 * @property {string} name
 * @property {Numbers[]} rows
 * @property {Record<string, string>[]} texts
 * @property {number} lengthUnit
 * @property {number} angleUnit
 * @property {number} lengthScale
 * @property {number} angleScale
 * @property {string[]} said
 * @property {boolean} modified
 * @property {number} added
 * @property {boolean} exchanged whether the heads of alpha and theta are
 */

/**
 * Whether a typed table describes the reference, and if not, where they differ and why.
 * @param {any} mine text, or an arm that Python holds
 * @param {any} reference
 * @param {Options} options
 * @returns {Report}
 */
export function compareTables(mine, reference, options = {}) {
  const kinds = reference.rows.map(({ kind }) => kind);
  const known = new Map([...(reference.values ?? []), ...(options.values ?? [])]);
  const isText = typeof mine === "string";
  const typed = isText
    ? read(mine, options, [...known]).flatMap((one) => sizes(one, reference.rows))
    : [];
  const tables = isText ? typed.map((one) => tableOf(one, meant(one, kinds))) : [ofArm(mine)];
  const readings = tables.map((table) => judgedTable(table, reference, options.tolerance ?? null));
  const whole = (report, k) => {
    if (!isText)
      return { ...report, table: { rows: tables[k].rows, cells: [], trees: [], wrong: [] } };
    const cells = shown(typed[k], tables[k], report.findings);
    return { ...report, table: { rows: tables[k].rows, ...cells } };
  };
  for (const [k, { good }] of readings.entries()) {
    const report = good();
    if (report) return whole(report, k);
  }
  const first = readings[0].bad();
  if (first.causes.length || !typed[1]?.otherSize) return whole(first, 0);
  const other = readings[1].bad();
  return other.causes.length ? whole(other, 1) : whole(first, 0);
}

// The sizes that large lengths may have where nobody said it: millimetres, or centimetres, first
// that which is nearer to the reference's.
function sizes(typed, wanted) {
  if (!inMillimetres(typed)) return [typed];
  const both = [
    typed,
    { ...typed, lengths: "cm", said: [...typed.said, say("taken: centimetres")] },
  ];
  const total = usual.totalLength(typed.rows.map(({ numbers }) => numbers));
  if (total < SHORT * usual.totalLength(wanted)) both.reverse();
  return both.map((one, n) => ({ ...one, otherSize: n > 0 }));
}

// The table as it was read, a row of cells for each that was typed, and which of them are wrong.
function shown(typed, { lengthScale, angleScale }, findings) {
  const wheres = findings.map(({ where }) => where);
  const trees = typed.rows.map((row) => ENTRIES.map((column) => row.trees?.[column]));
  const cells = typed.rows.map(({ kind, numbers, radians, backwards }, k) =>
    ENTRIES.map((column) => {
      const scale = DEG * (radians.has(column) ? 1 : angleScale);
      const text = angular(column)
        ? `${size(numbers[column] * scale, 6)}°`
        : size(numbers[column] * lengthScale, 6);
      if (column !== variableOf(kind)) return text;
      const variable = `${backwards ? "-" : ""}q_${k + 1}`;
      return numbers[column]
        ? `${variable} ${text.replace(/^-?/, (sign) => (sign ? "- " : "+ "))}`
        : variable;
    }),
  );
  const wrong = cells.map((_, k) =>
    ENTRIES.map((column) => wheres.includes(`row ${k + 1}, ${column}`)),
  );
  return { cells, trees, wrong };
}

// The entry that a joint changes.
const variableOf = (kind) => ({ revolute: "theta", prismatic: "d" })[kind];

// What was typed

/** @returns {Table} */
function tableOf(typed, found) {
  const texts = typed.rows.map((row) => row.texts);
  const modified = typed.convention === "craig";
  const { a, alpha } = typed.rows[0].numbers;
  return {
    name: say("your table"),
    rows: found.rows,
    texts,
    lengthUnit: wholeUnit(typed, found.length) || unitOf(texts, ["a", "d"]) * found.length,
    angleUnit: unitOf(texts, ["alpha", "theta"]) * found.angle,
    lengthScale: found.length,
    angleScale: found.angle,
    said: found.said,
    modified,
    exchanged: Boolean(typed.exchanged),
    added: Number(modified && Boolean(a || alpha)),
  };
}

/**
 * An arm that Python holds, as a table in m and rad.
 * @param {{ name: string, rows: Numbers[], texts: Record<string, string>[] }} arm
 * @returns {Table}
 */
const ofArm = ({ name, rows, texts }) => ({
  name,
  rows,
  texts,
  lengthUnit: unitOf(texts, ["a", "d"]),
  angleUnit: unitOf(texts, ["alpha", "theta"]),
  lengthScale: 1,
  angleScale: 1,
  said: [],
  modified: false,
  exchanged: false,
  added: 0,
});

// The unit of the last place of the decimals in some columns; 0 where there are none.
function unitOf(texts, columns) {
  const found = texts.flatMap((row) =>
    columns.flatMap((column) => row[column].match(DECIMAL) ?? []),
  );
  return Math.max(0, ...units(found));
}

// The unit of lengths that are all whole numbers of a small size; 0 for others. Whole numbers among
// formulas are exact.
function wholeUnit(typed, scale) {
  const lengths = typed.rows.flatMap(({ kind, texts }) =>
    kind === "prismatic" ? [texts.a] : [texts.a, texts.d],
  );
  return scale <= COARSEST && lengths.every((text) => WHOLES.test(text)) ? scale : 0;
}

// The typed row, from 1, that holds an entry of a row of the table.
const rowOf = ({ added, modified }, row, column) =>
  row - added + Number(modified && (column === "a" || column === "alpha"));

// What was typed as an entry of a row; undefined where no row holds it.
const textOf = (table, row, column) => table.texts[rowOf(table, row, column) - 1]?.[column];

const squared = (rows) =>
  rows.map((row) => ({ ...row, alpha: square(row.alpha), theta: square(row.theta) }));

// An angle near a multiple of a right angle is taken as that.
function square(angle, unit = 0) {
  const right = (Math.round(angle / (Math.PI / 2)) * Math.PI) / 2;
  return Math.abs(angle - right) < Math.max(ANGLE, 0.51 * unit) ? right : angle;
}

// The rows with angles that were cut to two decimals or more taken as the right angles that they
// are near: 1.57 is meant as pi/2.
const meantRows = (table) =>
  table.rows.map((row, k) => {
    const [alpha, theta] = ["alpha", "theta"].map((c) => square(row[c], ownUnit(table, k + 1, c)));
    return { ...row, alpha, theta };
  });

// The unit of the last decimal in one angle, where it has two or more.
function ownUnit(table, row, column) {
  const last = (textOf(table, row, column) ?? "").match(DECIMAL)?.at(-1) ?? "";
  const places = last.slice(last.indexOf(".") + 1).length;
  return places >= 2 ? table.angleScale * 10 ** -places : 0;
}

// The verdict

/**
 * One reading of what was meant: its causes, the rows, the arm they are held against, and how many
 * entries differ.
 * @typedef {{ cause: Cause | null, rows: Numbers[], reference: Numbers[], entries: number }} Try
 */

const compare = ({ rows, reference }, length) =>
  compared(side(rows), side(reference), length, ANGLE);

/**
 * One reading of a table beside the reference: the report on the same arm, null where it is
 * another, and that on another.
 * @param {Table} table
 * @returns {{ good: () => Report | null, bad: () => Report }}
 */
function judgedTable(table, reference, tolerance) {
  const wanted = squared(reference.rows);
  const rows = meantRows(table);
  const [mine, ref] = [side(rows), side(wanted)];
  const exact = tolerance === null ? LENGTH : Math.max(tolerance, 1e-12);
  const [length, angle] = [table.lengthUnit, table.angleUnit].map((unit) =>
    tolerance === null && unit <= COARSEST ? 0.51 * unit : 0,
  );
  const found = compared(mine, ref, exact);
  const agrees = (grade, by) =>
    table.exchanged
      ? bad(table, reference, [cause("table.alpha and theta")])
      : same(grade, table, reference, mine, ref, by);
  const good = () => {
    if (!found.differences.length) return agrees(RIGHT, found);
    if (tolerance !== null) return null;
    // a turned axis meets the next one elsewhere
    const wide = Math.max(exact, 2 * length, 2.5 * angle * reach(rows));
    const near = compared(mine, ref, wide, Math.max(ANGLE, 4 * angle));
    return near.differences.length ? null : agrees(ROUNDED, near);
  };
  return { good, bad: () => different(table, reference, rows, wanted, Math.max(exact, length)) };
}

const reach = (rows) => Math.max(...rows.flatMap(({ a, d }) => [Math.abs(a), Math.abs(d)]));

/** @returns {Report} */
function same(grade, table, reference, mine, ref, found) {
  const last = table.lengthUnit || table.angleUnit * reach(mine.rows);
  const loose = grade === RIGHT ? LENGTH : 10 * last;
  const mapped = jointMap(mine, ref, found, loose);
  const key = grade === RIGHT ? "table same" : "table rounded";
  return {
    topic: "table",
    arm: reference.name,
    grade,
    headline: say(key, { mine: table.name, reference: reference.name }),
    findings: [],
    causes: [],
    taken: table.said,
    ...(mapped ? { map: { ...mapped, rows: mine.rows } } : {}),
    figures: { "upside down": found.upsideDown },
    notes: [
      ...zeros(table, mapped, mine, ref),
      ...base(table, mine, found, mapped),
      ...twoUnits(table, mine, found),
      ...tool(found),
      ...written(table),
    ],
  };
}

function zeros(table, mapped, mine, ref) {
  if (!mapped) return [say("map unknown")];
  const own = mine.joints.map((i) => rowOf(table, i, "d"));
  const told = equations(mapped, own, ref);
  return told.length ? [say("map", { equations: told.join("; ") })] : [];
}

// A word on where the base's frame stands on axis 1, and on z_0 where axis 1 leans from it.
function base(table, mine, found, mapped = null) {
  if (found.upsideDown) return [say("base upside down")];
  const [along, lean] = [found.baseHigher, mine.foot[1]];
  const rest = mapped ? mapped.base.o[2] - along * Math.cos(lean) : 0;
  const row = rowOf(table, mine.joints[mine.gaps.find(placesBase)?.bunch.at(-1) ?? 0], "d");
  const stands = (key, higher) => {
    if (Math.abs(higher) <= LENGTH) return [];
    const way = higher > 0 ? say("higher") : say("lower");
    return [say(key, { height: size(rounded(1000 * Math.abs(higher), 6), 4), way, row })];
  };
  if (lean <= ANGLE) return stands("base", along + rest);
  return [...stands("base", along), ...stands("base on z_0", rest)];
}

// A word on the row up to joint 1 whose d puts the base where the reference's is once it is read in
// metres among smaller units, or in millimetres among metres.
function twoUnits(table, mine, { baseHigher }) {
  const factor = table.lengthScale < 1 ? 1 / table.lengthScale : 1e-3;
  return table.rows.slice(0, mine.joints[0]).flatMap(({ d }, k) => {
    const off = Math.abs(Math.abs(d * (factor - 1)) - Math.abs(baseHigher));
    const others = usual.totalLength(table.rows) > Math.abs(d);
    const near = Math.abs(d * factor) >= LOW && off < 0.51 * COARSEST;
    return others && near ? [say("base unit", { row: rowOf(table, k + 1, "d") })] : [];
  });
}

function tool({ tilts }) {
  const [mine, reference] = tilts.map((tilt) => size(rounded(tilt * DEG, 4), 4));
  return angleBetween(...tilts) > ANGLE ? [say("tool", { mine, reference })] : [];
}

const NAMES = { "-2": "-pi", "-1": "-pi/2", 0: "0", 1: "pi/2", 2: "pi" };

// A word on each angle that was taken as a multiple of a right angle though it is not quite one.
const written = (table) =>
  table.rows.flatMap((row, k) =>
    ["alpha", "theta"].flatMap((column) => {
      const right = square(row[column], ownUnit(table, k + 1, column));
      if (Math.abs(row[column] - right) <= 1e-9) return [];
      const turns = Math.round(right / (Math.PI / 2));
      const wanted = NAMES[turns] ?? `${turns} pi/2`;
      const fields = {
        column,
        row: rowOf(table, k + 1, column),
        typed: typedAs(table, k + 1, column),
        wanted,
      };
      return [say("write right angle", fields)];
    }),
  );

const typedAs = (table, row, column) =>
  textOf(table, row, column) ?? size(table.rows[row - 1][column], 6);

// What differs, and why

// Why a table is another arm, the simplest first: causes after which every entry agrees, one or two
// wrong entries, causes and single signs after which the axes agree, more wrong entries, or what is
// left of the axes.
/** @param {Table} table @returns {Report} */
function different(table, reference, rows, wanted, length) {
  const found = compared(side(rows), side(wanted), length);
  const all = tries(rows, reference, wanted, table.modified, length);
  const equal = all.filter((t) => t.cause && !t.entries);
  if (equal.length) {
    const fewest = Math.min(...equal.map((t) => edits(t.cause)));
    const alike = equal.filter((t) => edits(t.cause) === fewest);
    return bad(
      table,
      reference,
      alike.map((t) => t.cause),
    );
  }
  const notes = found.signs.length ? base(table, side(rows), found) : [];
  const local = fewEntries(all, wanted.length, length);
  const most = local?.cost ?? Infinity;
  let whole = agreeing(all, length, most);
  if (!whole && 1 + BY_AXES < most) whole = oneSign(rows, wanted, length);
  if (whole?.cause) return bad(table, reference, [whole.cause]);
  if (local && most <= byAxes(found, local.best.cause)) {
    const entries = local.needed.map(([k, column]) => entry(table, local.best, k, column, length));
    const why = local.best.cause;
    return bad(table, reference, why ? [why] : [], entries, why ? [] : notes);
  }
  const { first, left } = fewest(all, length, found);
  return bad(
    table,
    reference,
    first ? [first] : [],
    left.map((d) => geometry(table, d)),
    first ? [] : notes,
  );
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
function tries(rows, reference, wanted, modified, length) {
  const others = [
    [null, wanted],
    ...usual.references(reference).map(([why, arm]) => [why, squared(arm)]),
  ];
  const mends = usual.structures(rows.length, modified);
  const whole = mends.filter(([why]) => why.keys[0] !== usual.EXCHANGED);
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
  return found.map(([why, read, arm]) => ({
    cause: why,
    rows: read,
    reference: arm,
    entries: differing(read, arm, length),
  }));
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

const angular = (column) => column === "alpha" || column === "theta";

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

// One wrong entry in the student's numbers; its row is the student's, also where a and alpha were
// read one row on.
/** @param {Table} table @returns {Finding} */
function entry(table, t, k, column, length) {
  const [mine, wanted] = [t.rows[k][column], t.reference[k][column]];
  const craig = Boolean(t.cause?.keys.includes("table.craig"));
  const shift = Number(craig && Boolean(table.rows[0].a || table.rows[0].alpha));
  const lowered = Number(craig && (column === "a" || column === "alpha"));
  const row = rowOf(table, k + 1, column) - shift + lowered;
  const why = kindOfError(column, row, mine, wanted, length);
  const typed = t.cause ? size(mine, 6) : typedAs(table, k + 1, column);
  const words = say("table entry", { typed, words: say(why.keys[0], why.fields[0]) });
  return { what: nameOf(why), where: `row ${row}, ${column}`, words };
}

/** @returns {Cause} */
function kindOfError(column, row, mine, wanted, length) {
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

const WHAT = {
  "table distance": "table distance what",
  "table between": "table between what",
  "table held": "table held what",
  "table side": "table side what",
  "table lean": "table lean what",
  "table foot": "table foot what",
  "table along": "table along what",
  "table base": "table base what",
  "table kind": "table kind what",
};

// One difference, in the rows and axes of the table as typed.
/** @param {Table} table @param {Difference} d @returns {Finding} */
function geometry(table, d) {
  const toBase = d.key === "table lean" || d.key === "table foot";
  const row = toBase ? d.row : rowOf(table, d.row, d.entry);
  const where = `row ${row}, ${d.entry}`;
  if (d.key === "table count") {
    const { mine, reference } = d;
    return { what: "row", where, words: say("table count words", { mine, reference }) };
  }
  const [i, j] = d.ends.map((end) => end && rowOf(table, end, "d"));
  const toTip = (d.key === "table distance" || d.key === "table side") && !j;
  const end = toTip ? say("the tip") : say("axis", { i: j });
  const along = i === j ? say("axis", { i }) : say("parallel axes", { i, j });
  const what = say(WHAT[d.key], { start: i, end, along, j });
  const words = say("table at", { row, entry: d.entry, words: amount(d, what) });
  return { what: "row", where, words };
}

/** @param {Difference} d @param {string} what */
function amount({ key, mine, reference }, what) {
  if (key === "table kind") return say("table other", { what, mine, reference });
  if (key === "table side") return say("table side", { what });
  if (["table between", "table held", "table lean"].includes(key)) {
    const signed = key === "table held" || mine >= 0; // held as theta is, about the student's axis
    const [x, y] = signed ? [mine, reference] : [-mine, -reference];
    const spelt = [x, y, angleBetween(x, y)].map((angle) => size(rounded(angle * DEG, 4), 6));
    return say("table angle", { what, mine: spelt[0], reference: spelt[1], off: spelt[2] });
  }
  // To a micrometre: where axes are nearly parallel, rounding leaves no more of a distance. First
  // to a nanometre, so that half a micrometre is one for the checkers too.
  const [x, y] = [mine, reference].map((length) => rounded(rounded(length, 9), 6));
  if (x * y < 0) return say("table other way", { what, mine: size(x, 6), reference: size(y, 6) });
  const way = Math.abs(x) > Math.abs(y) ? say("long") : say("short");
  const off = size(rounded(1000 * Math.abs(mine - reference), 6), 4);
  const [ours, theirs] = [x, y].map((length) => size(Math.abs(length), 6));
  return say("table length", { what, mine: ours, reference: theirs, off, way });
}

const rounded = (x, decimals) => Number(x.toFixed(decimals));

// `causes` explain the same; of the findings those with a cause of their own add to it.
/** @param {Table} table @param {Cause[]} causes @param {Finding[]} findings @returns {Report} */
function bad(table, reference, causes, findings = [], notes = []) {
  const own = findings.map(({ what }) => what).filter((what) => what.includes("."));
  const added = own.length === findings.length ? own : [];
  const names = causes.length
    ? causes.map((why) => [nameOf(why), ...added].join(" + "))
    : added.length
      ? [added.join(" + ")]
      : [];
  const fields = { mine: table.name, reference: reference.name };
  const report = {
    topic: "table",
    arm: reference.name,
    grade: WRONG,
    headline: say("table other arm", fields),
    findings,
    causes: names,
    taken: table.said,
    notes,
  };
  if (causes.length) {
    const words = several(causes);
    const rest = findings.length ? say("and what remains") : "";
    const headline = say("table wrong", { cause: lower(words) + rest, ...fields });
    return {
      ...report,
      headline,
      findings: [{ what: "cause", where: "", words: `${words}.` }, ...findings],
    };
  }
  if (findings.length !== 1 || own.length !== 1) return report;
  const [only] = findings;
  const headline = say("table wrong", { cause: lower(only.words).replace(/\.+$/, ""), ...fields });
  return { ...report, headline, findings: [{ ...only, what: "cause" }] };
}
