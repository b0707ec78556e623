// The Jacobian as a table of tinted numbers, and what it says: rank, lost directions, how well the
// tip can move.

import { attribute, h, indexed, scrolled, write } from "../dom.js";
import { movingRows } from "../../../judge/geometry/kinematics.js";
import { fixed, powered, sparse } from "../text.js";
import { asked, fullRank, rankVerdict } from "../verdicts.js";

export const title = "Jacobian";

/** @type {[string, string][]} */
const ROWS = [..."vω"].flatMap((letter) => [..."xyz"].map((axis) => [letter, axis]));

const NOTE =
  "The ellipsoid at the tip holds every velocity that joint rates of unit length give it; " +
  "where it is flat, the tip cannot go.";

export function build(_store, { point }) {
  const heat = makeHeat(point);
  const verdict = h("p.verdict");
  const facts = h("dl.facts");
  const note = h("p.words", {}, NOTE);
  const root = h("div.jacobian", {}, heat.root, h("div", {}, verdict, facts, note));

  function update(state, derived) {
    heat.update(state, derived.columns);
    const { singular, text } = rankVerdict(derived);
    attribute(verdict, "class", singular ? "verdict warning" : "verdict");
    write(verdict, text);
    facts.replaceChildren(...factList(derived));
  }
  return { root, update, summary: (_, derived) => rankVerdict(derived).text };
}

// The matrix, each number tinted by its share of the largest of its kind; `point` hears of the row
// whose column is pointed at.
export function makeHeat(point) {
  const head = h("tr");
  const body = h("tbody");
  const name = { "aria-label": "Jacobian of the tip: one column for each joint" };
  const table = h("table.heat", name, h("thead", {}, head), body);
  let [buttons, cells, shown] = [[], [], null];

  function lay(arm) {
    shown = arm;
    const moving = movingRows(arm);
    buttons = moving.map((row) => h("button", pointed(row, point), indexed("q", row + 1)));
    const heads = buttons.map((button) => h("th", { scope: "col" }, button));
    head.replaceChildren(h("th", {}, h("span.hidden", {}, "row")), ...heads);
    cells = ROWS.map(() => moving.map((row) => h("td", pointed(row, point))));
    const line = (row, i) =>
      h(i === 3 ? "tr.second" : "tr", {}, h("th", { scope: "row" }, indexed(...ROWS[i])), row);
    body.replaceChildren(...cells.map(line));
  }

  function update({ arm, lit }, columns) {
    if (shown !== arm) lay(arm);
    const on = movingRows(arm).indexOf(lit);
    buttons.forEach((button, k) => attribute(button, "aria-pressed", String(k === on)));
    const largest = [0, 3].map((from) =>
      Math.max(1e-9, ...columns.flatMap((c) => c.slice(from, from + 3).map(Math.abs))),
    );
    const tint = (cell, value, most) => {
      const share = Math.abs(value) / most;
      write(cell, sparse(value, 3));
      attribute(cell, "class", share < 5e-4 ? "nought" : value > 0 ? "plus" : "minus");
      cell.style.setProperty("--share", share.toFixed(2));
    };
    cells.forEach((row, i) =>
      row.forEach((cell, j) => tint(cell, columns[j][i], largest[i < 3 ? 0 : 1])),
    );
  }
  return { root: scrolled("Jacobian", table), update };
}

function pointed(row, point) {
  const [on, off] = [() => point(row), () => point(null)];
  return { onpointerenter: on, onpointerleave: off, onfocus: on, onblur: off, onclick: on };
}

function factList(derived) {
  const { arm, determinant, manipulability, values, linear } = derived;
  const small = (v) => {
    if (Math.abs(v) < 5e-7) return "0";
    return Math.abs(v) < 1e-3 ? powered(v, 2) : fixed(v, 5);
  };
  const fact = (name, value) => [h("dt", {}, name), h("dd", {}, value)];
  const three = asked(arm) === 3;
  const name = ["det ", h("i", {}, "J"), ...(three ? [h("sub", {}, "v")] : [])];
  const square = determinant === null ? [] : fact(name, small(determinant));
  const least = fullRank(arm) ? fact("smallest σ", small(values[fullRank(arm) - 1])) : [];
  return [
    ...square,
    ...fact("manipulability", small(manipulability)),
    ...least,
    ...fact("half axes", linear.values.map((v) => fixed(v, 2)).join(", ")),
  ];
}
