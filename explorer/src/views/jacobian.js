// The Jacobian as a table of tinted numbers, and what it says: rank, lost directions, how well the tip can move.

import { h, indexed } from "../dom.js";
import { joints } from "../kinematics.js";
import { fixed, listed, motionText, sparse } from "../text.js";

export const title = "Jacobian";

const ROWS = [["v", "x"], ["v", "y"], ["v", "z"], ["ω", "x"], ["ω", "y"], ["ω", "z"]];

export function build(store, { point }) {
  const head = h("tr");
  const body = h("tbody");
  const table = h("table.heat", { "aria-label": "Jacobian of the tip: one column for each joint" }, h("thead", {}, head), body);
  const verdict = h("p.verdict", { role: "status" });
  const facts = h("dl.facts");
  const note = h("p.words");
  const root = h("div.jacobian", {}, h("div.scroll", { tabindex: 0, role: "region", "aria-label": "Jacobian" }, table), h("div", {}, verdict, facts, note));
  let [cells, arm] = [[], null];

  function lay() {
    arm = store.state.arm;
    const moving = joints(arm);
    head.replaceChildren(h("th", {}, h("span.hidden", {}, "row")), ...moving.map((row) => h("th", { scope: "col" }, indexed("q", row + 1))));
    cells = ROWS.map(() => moving.map((row) => h("td", { onpointerenter: () => point(row), onpointerleave: () => point(null) })));
    body.replaceChildren(...cells.map((row, i) => h(i === 3 ? "tr.second" : "tr", {}, h("th", { scope: "row" }, indexed(...ROWS[i])), row)));
  }

  function update(state, derived, stage) {
    if (arm !== state.arm) lay();
    const { columns, rank, lost, values, linear } = derived;
    const full = Math.min(6, columns.length);
    const largest = [0, 3].map((from) => Math.max(1e-9, ...columns.flatMap((c) => c.slice(from, from + 3).map(Math.abs))));
    cells.forEach((row, i) => row.forEach((cell, j) => {
      const value = columns[j][i];
      const share = Math.abs(value) / largest[i < 3 ? 0 : 1];
      cell.textContent = sparse(value, 3);
      cell.className = share < 5e-4 ? "nought" : value > 0 ? "plus" : "minus";
      cell.style.setProperty("--share", share.toFixed(3));
    }));
    verdict.className = rank < full ? "verdict warning" : "verdict";
    verdict.textContent = verdictText(rank, full, lost);
    facts.replaceChildren(...factList(derived, values, linear, full));
    const scale = stage ? (1 / stage).toFixed(1).replace(".0", "") : null;
    note.textContent = `The ellipsoid at the tip holds every velocity that joint rates of unit length give it${scale ? `, drawn at 1 : ${scale}` : ""}; where it is flat, the tip cannot go.`;
  }
  return { root, update };
}

function verdictText(rank, full, lost) {
  if (rank === full && full === 6) return `Rank ${rank}: the tip can move along and turn about every direction.`;
  if (rank === full) return `Rank ${rank}, the most that ${full} joints can have.`;
  if (!lost.length) return `Singular: rank ${rank} of ${full}.`;
  const single = lost.filter((d) => d.filter((v) => Math.abs(v) > 0.02).length === 1).map(motionText);
  const blends = lost.filter((d) => d.filter((v) => Math.abs(v) > 0.02).length > 1).map((d) => `make the motion ${motionText(d)}`);
  return `Singular: rank ${rank} of ${full}. Here the tip cannot ${listed([...single, ...blends], "nor")}.`;
}

function factList({ determinant, manipulability }, values, linear, full) {
  const small = (v) => (Math.abs(v) < 5e-7 ? "0" : Math.abs(v) < 1e-3 ? v.toExponential(2).replaceAll("-", "−") : fixed(v, 5));
  const fact = (name, value) => [h("dt", {}, name), h("dd", {}, value)];
  const square = determinant === null ? [] : fact([full === 3 ? "det " : "det ", h("i", {}, "J"), ...(full === 3 ? [h("sub", {}, "v")] : [])], small(determinant));
  return [
    ...square,
    ...fact("manipulability", small(manipulability)),
    ...fact("smallest σ", small(values[full - 1])),
    ...fact("half axes", linear.values.map((v) => fixed(v, 2)).join(", ")),
  ];
}
