// The Denavit-Hartenberg table, to be typed in. A bad entry is said in words, and the last good arm stays.

import { h } from "../dom.js";
import { linkFrames, minus, norm, dot } from "../kinematics.js";
import { carriedOver } from "../state.js";
import { entryText, fixed, readEntry } from "../text.js";

export const title = "DH table";

const COLUMNS = [["a", "a", false], ["alpha", "α", true], ["d", "d", false], ["theta", "θ", true]];
const KINDS = [["revolute", "turns"], ["prismatic", "slides"], ["fixed", "fixed"]];

export function build(store) {
  const units = h("tr");
  const body = h("tbody");
  const error = h("p.error", { role: "alert" });
  const verdict = h("p.verdict", { role: "status" });
  const root = h("div.dh", {},
    h("div.scroll", { tabindex: 0, role: "region", "aria-label": "Denavit-Hartenberg table" }, h("table.entries", { "aria-label": "Denavit-Hartenberg table, standard convention" }, h("thead", {}, units), body)),
    error,
    h("div.row", {},
      h("button", { type: "button", onclick: () => change([...store.state.arm.rows, { kind: "revolute", a: 0.2, alpha: 0, d: 0, theta: 0 }]) }, "Add a row"),
      h("button", { type: "button", onclick: () => change(store.state.reference.rows, store.state.reference.name) }, "Back to the first table")),
    verdict);
  let shown = {};

  function change(rows, name, rowBefore = (row) => row) {
    const { arm, q } = store.state;
    const same = rows === store.state.reference.rows;
    const next = same ? store.state.reference : { ...arm, name: name ?? arm.name, rows };
    store.set({ arm: next, q: carriedOver(arm, q, next, rowBefore), trace: null, ways: null });
  }

  function typed(i, [key, letter, angle], input) {
    const { value, error: wrong } = readEntry(input.value, angle, store.state.unit);
    input.setAttribute("aria-invalid", String(Boolean(wrong)));
    error.textContent = wrong ? `Row ${i + 1}, ${letter} ${wrong}. The last good arm stays.` : "";
    if (!wrong) change(store.state.arm.rows.map((row, k) => (k === i ? { ...row, [key]: value } : row)));
  }

  function lay({ arm, unit }) {
    const angle = unit === "deg" ? "°" : "rad";
    units.replaceChildren(...["row", "joint"].map((t) => h("th", { scope: "col" }, t)),
      ...COLUMNS.map(([, letter, turn]) => h("th", { scope: "col" }, h("i", {}, letter), h("small", {}, turn ? ` (${angle})` : " (m)"))), h("th", {}, h("span.hidden", {}, "remove")));
    body.replaceChildren(...arm.rows.map((row, i) => line(row, i, arm, unit)));
    shown = { rows: arm.rows, unit };
  }

  function line(row, i, arm, unit) {
    const kind = h("select", { "aria-label": `Row ${i + 1}, kind of joint`, onchange: (e) => change(arm.rows.map((r, k) => (k === i ? newKind(r, e.target.value) : r))) },
      KINDS.map(([value, text]) => h("option", { value, selected: row.kind === value }, text)));
    const entry = (column) => {
      const [key, letter, angle] = column;
      const moves = (row.kind === "revolute" && key === "theta") || (row.kind === "prismatic" && key === "d");
      const input = h("input", { type: "text", spellcheck: "false", value: entryText(row[key], angle, unit), "aria-label": `Row ${i + 1}, ${letter}`, "data-cell": `${i + 1}-${key}`, oninput: (e) => typed(i, column, e.target) });
      return h(moves ? "td.moves" : "td", {}, input, moves ? h("span", {}, "+ ", h("i", {}, "q"), h("sub", {}, String(i + 1))) : []);
    };
    const remove = h("button.remove", { type: "button", "aria-label": `Remove row ${i + 1}`, title: `Remove row ${i + 1}`, disabled: arm.rows.length === 1,
      onclick: () => change(arm.rows.filter((_, k) => k !== i), undefined, (k) => (k < i ? k : k + 1)) }, "×");
    return h("tr", {}, h("th", { scope: "row" }, String(i + 1)), h("td", {}, kind), COLUMNS.map(entry), h("td", {}, remove));
  }

  function update(state, { frames }) {
    const typing = body.contains(root.getRootNode().activeElement) && root.getRootNode().activeElement.matches("input");
    const reshaped = shown.rows?.length !== state.arm.rows.length || shown.unit !== state.unit;
    if (reshaped || (shown.rows !== state.arm.rows && !typing)) lay(state);
    verdict.textContent = comparison(state, frames);
  }
  return { root, update };
}

const newKind = (row, kind) => ({ ...row, kind, lower: null, upper: null, speed: null, effort: null });

function comparison({ arm, reference, q }, frames) {
  if (arm === reference) return "Type into any entry: 0.333, −90°, pi/2. The arm follows, and the table’s first arm stays behind as a ghost.";
  if (reference.rows.filter((row) => row.kind !== "fixed").length !== q.length) return "Your arm has another number of joints than the first table.";
  const [mine, first] = [frames.at(-1), linkFrames(reference, q).at(-1)];
  const turn = Math.acos(Math.max(-1, Math.min(1, (dot(mine.x, first.x) + dot(mine.y, first.y) + dot(mine.z, first.z) - 1) / 2)));
  return `Your tip is ${fixed(1000 * norm(minus(mine.o, first.o)), 1)} mm and ${fixed((turn * 180) / Math.PI, 1)}° away from the ghost’s, ${reference.name}.`;
}
