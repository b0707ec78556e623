// The Denavit-Hartenberg table to type in. A bad entry is explained, and the last valid arm stays.

import { MAX_ROWS } from "../../../judge/geometry/arm.js";
import {
  copyToClipboard,
  h,
  makeIndexedSymbol,
  makeScrollRegion,
  makeSelect,
  setText,
} from "../dom.js";
import { readField, makeTextField } from "../entry.js";
import { readPastedTable } from "../paste.js";
import { formatEntry, replaceAt, formatTable } from "../text.js";
import { describeTable } from "../verdicts.js";

export const title = "DH table";

const COLUMNS = [
  ["a", "a", false],
  ["alpha", "α", true],
  ["d", "d", false],
  ["theta", "θ", true],
];
const KINDS = { revolute: "turns", prismatic: "slides", fixed: "fixed" };
const VARIABLE_COLUMN = { revolute: "theta", prismatic: "d" };
const NEW_ROW = { kind: "revolute", a: 0.2, alpha: 0, d: 0, theta: 0 };

export function build(store, { announce }) {
  const error = h("p.error");
  const verdict = h("p.verdict");
  const change = (rows, rowBefore, gesture = null) =>
    store.dispatch({ type: "editTable", rows, rowBefore, gesture });
  const complain = (message) => {
    error.textContent = message ? `${message} The last good arm stays.` : "";
    if (message) announce(() => error.textContent);
  };
  const grid = makeGrid(store, { change, complain, announce });
  const button = (text, onclick) => h("button", { onclick }, text);
  const add = button("Add a row", () => change([...store.state.arm.rows, NEW_ROW]));
  const back = button("Back to the first table", () => change(store.state.base.rows));
  const row = h("div.row", {}, add, back, makeCopyButton(store, announce));
  const root = h("div.dh", {}, grid.root, error, row, verdict);
  const update = (state, derived) => {
    grid.update(state);
    add.disabled = state.arm.rows.length >= MAX_ROWS;
    setText(verdict, describeTable(state, derived));
  };
  return { root, update, summary: () => error.textContent || verdict.textContent };
}

// Make the button that copies the table for spreadsheets, MATLAB and this book's table readers.
function makeCopyButton(store, announce) {
  const message = "Copy the table";
  const button = h("button.right", { onclick: copy }, message);
  async function copy() {
    const text = formatTable(store.state.arm);
    const done = await copyToClipboard(text);
    if (!done) download(text, "table.tsv");
    button.textContent = done ? "Copied" : "Saved";
    announce(() => `The table is ${done ? "copied" : "saved"}.`, true);
    setTimeout(() => (button.textContent = message), 1600);
  }
  return button;
}

// Make the table of text fields. Rows are not rebuilt while the reader types in one.
function makeGrid(store, { change, complain, announce }) {
  const units = h("tr");
  const body = h("tbody", {
    onpaste: (event) => handlePaste(event, store, { change, complain, announce }),
  });
  const name = { "aria-label": "Denavit-Hartenberg table, standard convention" };
  const table = h("table.entries", name, h("thead", {}, units), body);
  let rendered = /** @type {any} */ ({});

  function typed(i, [key, letter, angle], input, whole) {
    const { unit, arm } = store.state;
    const { value, message } = readField(input, angle ? "angle" : "length", { unit, whole });
    complain(message && `Row ${i + 1}, ${letter} ${message}.`);
    if (value === undefined) return;
    change(replaceAt(arm.rows, i, { ...arm.rows[i], [key]: value }), undefined, `cell ${i} ${key}`);
    if (whole) input.value = formatEntry(value, angle, unit);
  }

  function update({ arm, unit }) {
    const root = /** @type {ShadowRoot} */ (body.getRootNode());
    const typing = body.contains(root.activeElement) && root.activeElement.matches("input");
    const reshaped = rendered.rows?.length !== arm.rows.length || rendered.unit !== unit;
    if (!reshaped && (rendered.rows === arm.rows || typing)) return;
    units.replaceChildren(...makeColumnHeaders(unit));
    body.replaceChildren(...arm.rows.map((_, i) => makeTableRow(i, arm, unit, { change, typed })));
    rendered = { rows: arm.rows, unit };
  }
  return { root: makeScrollRegion("Denavit-Hartenberg table", table), update };
}

// Replace the table by one pasted into any of its fields.
function handlePaste(event, store, { change, complain, announce }) {
  const { currentTarget: body, target } = event;
  const text = event.clipboardData?.getData("text/plain") ?? "";
  const table = readPastedTable(text, store.state.unit);
  if (!table) return;
  event.preventDefault();
  complain("error" in table ? `What was pasted is not read: ${table.error}` : "");
  if ("error" in table) return;
  change(table.rows);
  body.querySelector(`[data-cell="${target.dataset.cell}"]`)?.focus({ preventScroll: true });
  if (table.said.length) announce(() => `Taken as ${table.said.join("; ")}`, true);
}

const makeColumnHeaders = (unit) => [
  ...["row", "joint"].map((text) => h("th", { scope: "col" }, text)),
  ...COLUMNS.map(([, letter, turn]) => {
    const small = h("small", {}, turn ? ` (${unit === "deg" ? "°" : "rad"})` : " (m)");
    return h("th", { scope: "col" }, h("i", {}, letter), small);
  }),
  h("th", {}, h("span.hidden", {}, "remove")),
];

function makeTableRow(i, arm, unit, { change, typed }) {
  const row = arm.rows[i];
  const chosen = (name) => change(replaceAt(arm.rows, i, setJointKind(row, name)));
  const kind = makeSelect(`Row ${i + 1}, kind of joint`, KINDS, chosen);
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
    COLUMNS.map((column) => makeEntryCell(i, column, row, { unit, typed })),
    h("td", {}, remove),
  );
}

function makeEntryCell(i, column, row, { unit, typed }) {
  const [key, letter, angle] = column;
  const input = makeTextField(`Row ${i + 1}, ${letter}`, (...now) => typed(i, column, ...now), {
    value: formatEntry(row[key], angle, unit),
    "data-cell": `${i + 1}-${key}`,
  });
  if (key !== VARIABLE_COLUMN[row.kind]) return h("td", {}, input);
  return h("td.moves", {}, input, h("span", {}, "+ ", makeIndexedSymbol("q", i + 1)));
}

const setJointKind = (row, kind) => ({
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
