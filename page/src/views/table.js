// The Denavit-Hartenberg table, to be typed in. A bad entry is said in words, and the last good arm
// stays.

import { MAX_ROWS } from "../../../judge/geometry/arm.js";
import { copied, h, indexed, scrolled, select, write } from "../dom.js";
import { entered, textField } from "../entry.js";
import { readTable } from "../paste.js";
import { entryText, replaced, tableText } from "../text.js";
import { tableVerdict } from "../verdicts.js";

export const title = "DH table";

const COLUMNS = [
  ["a", "a", false],
  ["alpha", "α", true],
  ["d", "d", false],
  ["theta", "θ", true],
];
const KINDS = { revolute: "turns", prismatic: "slides", fixed: "fixed" };
const MOVING = { revolute: "theta", prismatic: "d" };
const NEW_ROW = { kind: "revolute", a: 0.2, alpha: 0, d: 0, theta: 0 };

export function build(store, { say }) {
  const error = h("p.error");
  const verdict = h("p.verdict");
  const change = (rows, rowBefore, gesture = null) =>
    store.dispatch({ type: "edit", rows, rowBefore, gesture });
  const complain = (words) => {
    error.textContent = words ? `${words} The last good arm stays.` : "";
    if (words) say(() => error.textContent);
  };
  const grid = makeGrid(store, { change, complain, say });
  const button = (text, onclick) => h("button", { onclick }, text);
  const add = button("Add a row", () => change([...store.state.arm.rows, NEW_ROW]));
  const back = button("Back to the first table", () => change(store.state.base.rows));
  const row = h("div.row", {}, add, back, makeCopy(store, say));
  const root = h("div.dh", {}, grid.root, error, row, verdict);
  const update = (state, derived) => {
    grid.update(state);
    add.disabled = state.arm.rows.length >= MAX_ROWS;
    write(verdict, tableVerdict(state, derived));
  };
  return { root, update, summary: () => error.textContent || verdict.textContent };
}

// The table for a spreadsheet, for MATLAB, and for every reader of tables here.
function makeCopy(store, say) {
  const words = "Copy the table";
  const button = h("button.right", { onclick: copy }, words);
  async function copy() {
    const text = tableText(store.state.arm);
    const done = await copied(text);
    if (!done) download(text, "table.tsv");
    button.textContent = done ? "Copied" : "Saved";
    say(() => `The table is ${done ? "copied" : "saved"}.`, true);
    setTimeout(() => (button.textContent = words), 1600);
  }
  return button;
}

// The table itself: a line of fields for each row, which are not laid anew while one is typed in.
function makeGrid(store, { change, complain, say }) {
  const units = h("tr");
  const body = h("tbody", { onpaste: (event) => pasted(event, store, { change, complain, say }) });
  const name = { "aria-label": "Denavit-Hartenberg table, standard convention" };
  const table = h("table.entries", name, h("thead", {}, units), body);
  let shown = /** @type {any} */ ({});

  function typed(i, [key, letter, angle], input, whole) {
    const { unit, arm } = store.state;
    const { value, words } = entered(input, angle ? "angle" : "length", { unit, whole });
    complain(words && `Row ${i + 1}, ${letter} ${words}.`);
    if (value === undefined) return;
    change(replaced(arm.rows, i, { ...arm.rows[i], [key]: value }), undefined, `cell ${i} ${key}`);
    if (whole) input.value = entryText(value, angle, unit);
  }

  function update({ arm, unit }) {
    const root = /** @type {ShadowRoot} */ (body.getRootNode());
    const typing = body.contains(root.activeElement) && root.activeElement.matches("input");
    const reshaped = shown.rows?.length !== arm.rows.length || shown.unit !== unit;
    if (!reshaped && (shown.rows === arm.rows || typing)) return;
    units.replaceChildren(...headsOf(unit));
    body.replaceChildren(...arm.rows.map((_, i) => tableLine(i, arm, unit, { change, typed })));
    shown = { rows: arm.rows, unit };
  }
  return { root: scrolled("Denavit-Hartenberg table", table), update };
}

// A whole table from a spreadsheet, a matrix or a page, wherever in the table it is pasted.
function pasted(event, store, { change, complain, say }) {
  const { currentTarget: body, target } = event;
  const text = event.clipboardData?.getData("text/plain") ?? "";
  const table = readTable(text, store.state.unit);
  if (!table) return;
  event.preventDefault();
  complain("error" in table ? `What was pasted is not read: ${table.error}` : "");
  if ("error" in table) return;
  change(table.rows);
  body.querySelector(`[data-cell="${target.dataset.cell}"]`)?.focus({ preventScroll: true });
  if (table.said.length) say(() => `Taken as ${table.said.join("; ")}`, true);
}

const headsOf = (unit) => [
  ...["row", "joint"].map((text) => h("th", { scope: "col" }, text)),
  ...COLUMNS.map(([, letter, turn]) => {
    const small = h("small", {}, turn ? ` (${unit === "deg" ? "°" : "rad"})` : " (m)");
    return h("th", { scope: "col" }, h("i", {}, letter), small);
  }),
  h("th", {}, h("span.hidden", {}, "remove")),
];

function tableLine(i, arm, unit, { change, typed }) {
  const row = arm.rows[i];
  const chosen = (name) => change(replaced(arm.rows, i, newKind(row, name)));
  const kind = select(`Row ${i + 1}, kind of joint`, KINDS, chosen);
  kind.value = row.kind;
  const others = () => arm.rows.filter((_, k) => k !== i);
  const remove = h(
    "button.remove",
    {
      "aria-label": `Remove row ${i + 1}`,
      title: `Remove row ${i + 1}`,
      disabled: arm.rows.length === 1,
      onclick: () => change(others(), (k) => (k < i ? k : k + 1)),
    },
    "×",
  );
  return h(
    "tr",
    {},
    h("th", { scope: "row" }, String(i + 1)),
    h("td", {}, kind),
    COLUMNS.map((column) => entryCell(i, column, row, { unit, typed })),
    h("td", {}, remove),
  );
}

function entryCell(i, column, row, { unit, typed }) {
  const [key, letter, angle] = column;
  const input = textField(`Row ${i + 1}, ${letter}`, (...now) => typed(i, column, ...now), {
    value: entryText(row[key], angle, unit),
    "data-cell": `${i + 1}-${key}`,
  });
  if (key !== MOVING[row.kind]) return h("td", {}, input);
  return h("td.moves", {}, input, h("span", {}, "+ ", indexed("q", i + 1)));
}

const newKind = (row, kind) => ({
  ...row,
  kind,
  lower: null,
  upper: null,
  speed: null,
  effort: null,
});

function download(text, name) {
  const address = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
  h("a", { href: address, download: name }).click();
  URL.revokeObjectURL(address);
}
