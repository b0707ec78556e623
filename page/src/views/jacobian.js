// The Jacobian as a table of tinted numbers, with its rank, lost directions and manipulability.

import { updateAttribute, h, makeIndexedSymbol, makeScrollRegion, setText } from "../dom.js";
import { movingRows } from "../../../judge/geometry/kinematics.js";
import { formatFixed, formatScientific, formatSparse } from "../text.js";
import { isPlanar, movableRows, taskRows } from "../../../judge/geometry/task_rows.js";
import { compareColumn, describeComparedColumn, isOff } from "../compared_column.js";
import { getFullRank, describeRank } from "../statements.js";

export const title = "Jacobian";

/** @type {[string, string][]} */
const ROW_SYMBOLS = [..."vω"].flatMap((letter) => [..."xyz"].map((axis) => [letter, axis]));

const NOTE =
  "The ellipsoid at the tip holds every velocity that joint rates of unit length give it; " +
  "where it is flat, the tip cannot go.";

export function build(_store, { point }) {
  const heat = makeHeatTable(point);
  const verdict = h("p.verdict");
  const facts = h("dl.facts");
  const note = h("p.words", {}, NOTE);
  const comparison = h("p.verdict", { hidden: true });
  const root = h("div.jacobian", {}, heat.root, h("div", {}, comparison, verdict, facts, note));

  function update(state, derived) {
    heat.update(state, derived.columns);
    setText(comparison, describeComparedColumn(compareColumn(state, derived.columns)));
    comparison.hidden = !comparison.textContent;
    const { singular, text } = describeRank(derived);
    updateAttribute(verdict, "class", singular ? "verdict warning" : "verdict");
    setText(verdict, text);
    facts.replaceChildren(...makeFacts(derived));
  }
  const summary = (_, derived) =>
    [comparison.textContent, describeRank(derived).text].filter(Boolean).join(" ");
  return { root, update, summary };
}

// Make the matrix; each number is tinted by its share of the largest of its kind. `point(row)` is
// called when the reader points at a column.
export function makeHeatTable(point) {
  const head = h("tr");
  const body = h("tbody");
  const name = { "aria-label": "Jacobian of the tip: one column for each joint" };
  const table = h("table.heat", name, h("thead", {}, head), body);
  let [buttons, cells, rows, shown] = [[], [], [], null];

  function rebuild(arm) {
    shown = arm;
    const moving = movingRows(arm);
    buttons = moving.map((row) =>
      h("button", makePointHandlers(row, point), makeIndexedSymbol("q", row + 1)),
    );
    const heads = buttons.map((button) => h("th", { scope: "col" }, button));
    head.replaceChildren(h("th", {}, h("span.hidden", {}, "row")), ...heads);
    rows = isPlanar(arm) ? movableRows(arm) : ROW_SYMBOLS.map((_, i) => i);
    cells = rows.map(() => moving.map((row) => h("td", makePointHandlers(row, point))));
    body.replaceChildren(...cells.map((row, k) => makeMatrixRow(row, rows[k], rows.length)));
  }

  function update({ arm, highlightedRow, answer = null }, columns) {
    if (shown !== arm) rebuild(arm);
    const on = movingRows(arm).indexOf(highlightedRow);
    buttons.forEach((button, k) => updateAttribute(button, "aria-pressed", String(k === on)));
    const largest = [0, 3].map((from) =>
      Math.max(1e-9, ...columns.flatMap((c) => c.slice(from, from + 3).map(Math.abs))),
    );
    const isCompared = answer?.length === 6 * columns.length;
    cells.forEach((row, i) =>
      row.forEach((cell, j) => {
        tintCell(cell, columns[j][rows[i]], largest[rows[i] < 3 ? 0 : 1]);
        if (isCompared) showTyped(cell, answer[rows[i] * columns.length + j], columns[j][rows[i]]);
      }),
    );
  }
  return { root: makeScrollRegion("Jacobian", table), update };
}

// Make the line of row i of the Jacobian; the turn of a planar arm is φ.
function makeMatrixRow(cells, i, count) {
  const isPlanarTurn = count < 6 && i >= 3;
  const symbol = isPlanarTurn ? h("i", {}, "φ") : makeIndexedSymbol(...ROW_SYMBOLS[i]);
  const isFirstTurn = i === 3 || isPlanarTurn;
  return h(isFirstTurn ? "tr.second" : "tr", {}, h("th", { scope: "row" }, symbol), cells);
}

function tintCell(cell, value, largest) {
  const share = Math.abs(value) / largest;
  setText(cell, formatSparse(value, 3));
  updateAttribute(cell, "class", share < 5e-4 ? "nought" : value > 0 ? "plus" : "minus");
  cell.style.setProperty("--share", share.toFixed(2));
}

// Show the typed number below the right one, if they differ.
function showTyped(cell, typed, value) {
  if (isOff(typed, value))
    cell.append(h("span.typed", {}, h("span.hidden", {}, "typed: "), formatSparse(typed, 3)));
}

function makePointHandlers(row, point) {
  const [on, off] = [() => point(row), () => point(null)];
  return { onpointerenter: on, onpointerleave: off, onfocus: on, onblur: off, onclick: on };
}

function makeFacts(derived) {
  const { arm, determinant, manipulability, singularValues, linearAxes } = derived;
  const small = (v) => {
    if (Math.abs(v) < 5e-7) return "0";
    return Math.abs(v) < 1e-3 ? formatScientific(v, 2) : formatFixed(v, 5);
  };
  const fact = (name, value) => [h("dt", {}, name), h("dd", {}, value)];
  const isPosition = taskRows(arm).every((i) => i < 3);
  const name = ["det ", h("i", {}, "J"), ...(isPosition ? [h("sub", {}, "v")] : [])];
  const square = determinant === null ? [] : fact(name, small(determinant));
  const least = getFullRank(arm)
    ? fact("smallest σ", small(singularValues[getFullRank(arm) - 1]))
    : [];
  return [
    ...square,
    ...fact("manipulability", small(manipulability)),
    ...least,
    ...fact("half axes", linearAxes.values.map((v) => formatFixed(v, 2)).join(", ")),
  ];
}
