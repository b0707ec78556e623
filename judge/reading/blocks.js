// Every rectangular block of entries in a text, with what stands beside it.

import { RAD } from "../geometry/angles.js";
import { hasDecimals, number } from "./formula.js";
import { labelIn } from "./labels.js";
import { runsOf, withHeads } from "./runs.js";
import { plainSigns } from "./signs.js";

/**
 * @typedef {{ rows: string[][], labels: string[][], heads: string[], name: string, from: number,
 *   to: number, runs: import("./runs.js").Run[], beside?: () => string[] }} Block
 *   entries as typed; the words before each row, and of the line above; what the block is
 *   assigned to; its lines, and numbers on them that are not its own
 */

// A decimal comma before one that parts; a line's end before what a printer broke; gaps last.
const WAYS = [false, true].flatMap((gaps) =>
  [true, false].flatMap((decimal) => [false, true].map((wrapped) => ({ gaps, decimal, wrapped }))),
);

/**
 * The blocks in each way that the text can be parted, each way when it is asked for, but for what
 * the question itself gave.
 * @param {string} typed
 * @param {{ isEntry: (cell: string) => boolean, names?: RegExp, given?: number[][] }} question
 * @returns {(() => Block[])[]}
 */
export function blocksIn(typed, { isEntry, names = /(?!)/, given = [] }) {
  const text = withHeads(plainSigns(typed));
  const known = new Map();
  const entry = (cell) => {
    if (!known.has(cell)) known.set(cell, isEntry(cell));
    return known.get(cell);
  };
  const ways = WAYS.filter(({ decimal }) => !decimal || /\d,\d/.test(text));
  return ways.map((way) => once(() => blocksOf(runsOf(text, entry, way), names, given)));
}

// What is made when it is first asked for.
function once(make) {
  let made = null;
  return () => (made ??= make());
}

function blocksOf(all, names, given) {
  const runs = all.filter(({ cells }) => !given.some((one) => isGiven(cells, one)));
  const blocks = [...stretches(runs, names), ...repeated(runs), ...byName(runs), ...byPlace(runs)];
  return blocks.map((block) => ({ ...block, beside: () => besides(block, runs) }));
}

// The numbers on a block's lines that are not its own, decimals in words too; nothing where there
// is one for each row, as a time is.
function besides({ from, to, runs: own }, runs) {
  const mine = new Set(own);
  const others = runs.filter((run) => run.line >= from && run.line <= to && !mine.has(run));
  const words = own.flatMap((run) => run.words.filter((word) => hasDecimals(word)));
  return [others.map(({ cells }) => cells), words.map((word) => [word])]
    .filter(({ length }) => own.length < 2 || length % own.length)
    .flat(2);
}

// Whether cells are what the question gave, to their digits, in radians or degrees.
const isGiven = (cells, given) =>
  cells.length === given.length &&
  given.length > 1 &&
  given.some(Boolean) &&
  cells.every((cell, k) => {
    const text = cell.replace(/ ?deg$/, "");
    const half = 0.51 * 10 ** -(text.split(".")[1]?.length ?? 0);
    const x = number(text);
    return [given[k], given[k] / RAD].some((y) => x !== null && Math.abs(x - y) <= half);
  });

const own = (name, names) => (name ? names.test(name.replace(/^"|\W$/g, "")) : null);

/** Runs of one length that follow each other; a line of numbers of other lengths parts them. */
function stretches(runs, names) {
  const found = [];
  for (const width of new Set(runs.map(({ cells }) => cells.length))) {
    let held = [];
    let last = -1;
    runs.forEach((run, k) => {
      if (run.cells.length !== width) return;
      const before = runs[last];
      const between = runs.slice(last + 1, k);
      const follows =
        before &&
        before.part === run.part &&
        before.listed === run.listed &&
        between.every(({ line }) => line === before.line || line === run.line) &&
        (!run.name || !held[0].name || own(run.name, names) === own(held[0].name, names));
      if (follows) held.push(run);
      else found.push((held = [run]));
      last = k;
    });
  }
  return [...found.map(blockOf), ...sideBySide(found)];
}

/** @returns {Block} */
function blockOf(runs) {
  const scaled = ({ cells, scale }) => (scale ? cells.map((cell) => `${cell}${scale}`) : cells);
  return {
    rows: runs.map(scaled),
    labels: runs.map(({ words }) => words),
    heads: runs[0].above,
    name: runs[0].name || runs[0].words.at(-1) || "",
    from: runs[0].line,
    to: runs.at(-1).last,
    runs,
  };
}

// MATLAB's parts of a wide matrix, "Columns 1 through 4" and on.
function sideBySide(found) {
  const parts = found
    .filter(([run]) => run.part > 0)
    .sort(([one], [other]) => one.part - other.part)
    .map(blockOf);
  if (parts.length < 2 || parts.some(({ rows }) => rows.length !== parts[0].rows.length)) return [];
  const rows = parts[0].rows.map((_, i) => parts.flatMap((part) => part.rows[i]));
  const runs = parts.flatMap((part) => part.runs);
  return [{ ...parts[0], rows, heads: [], to: parts.at(-1).to, runs }];
}

// Rows with one name, "positions:", between which other numbers stand.
function repeated(runs) {
  const named = new Map();
  for (const run of runs) {
    const name = `${run.cells.length} ${run.words.join(" ")}`;
    if (!run.words.length || run.cells.length < 2) continue;
    if (!named.has(name)) named.set(name, []);
    named.get(name).push(run);
  }
  return [...named.values()].filter((own) => own.length > 2).map(blockOf);
}

// Single values with names of joints, q1 = 0.3: a row for each set of them.
function byName(runs) {
  const single = runs.flatMap((run) => {
    const label = run.cells.length === 1 ? labelIn(run.words) : null;
    return label && label.kind !== "count" ? [{ run, label }] : [];
  });
  const sets = [];
  for (const one of single) {
    const seen = sets.at(-1)?.some(({ label }) => label.at === one.label.at);
    if (!sets.length || seen) sets.push([]);
    sets.at(-1).push(one);
  }
  const count = sets[0]?.length;
  if (!count || count < 2 || sets.some((set) => set.length !== count)) return [];
  const rows = sets.map((set) => blockOf(set.map(({ run }) => run)).rows.flat());
  const heads = sets[0].map(({ run }) => run.words.join(" "));
  const [first, last] = [single[0].run, single.at(-1).run];
  const labels = rows.map(() => []);
  const own = single.map(({ run }) => run);
  return [{ rows, labels, heads, name: first.name, from: first.line, to: last.last, runs: own }];
}

const PLACE = /[[({](\d{1,2})\s*,\s*(\d{1,2})[\])}]$/;

// Single values with two indices, J[2,3] := 0.5.
function byPlace(runs) {
  const placed = runs.flatMap((run) => {
    const place = run.cells.length === 1 && PLACE.exec(run.words.at(-1) ?? "");
    return place ? [{ run, i: Number(place[1]), j: Number(place[2]) }] : [];
  });
  if (placed.length < 2) return [];
  const least = (key) => Math.min(...placed.map((one) => one[key]));
  const size = (key) => Math.max(...placed.map((one) => one[key])) - least(key) + 1;
  if (size("i") * size("j") !== placed.length) return [];
  const rows = Array.from({ length: size("i") }, () => Array(size("j")));
  for (const { run, i, j } of placed) rows[i - least("i")][j - least("j")] = run.cells[0];
  const [first, last] = [placed[0].run, placed.at(-1).run];
  const labels = rows.map(() => []);
  const own = placed.map(({ run }) => run);
  const { name, line: top } = first;
  return [{ rows, labels, heads: [], name, from: top, to: last.last, runs: own }];
}
