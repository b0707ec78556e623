// The Denavit-Hartenberg table to type in. A bad entry is explained, and the last valid arm stays.

import { MAX_ROWS, NO_LIMITS } from "../../../judge/geometry/arm.js";
import { jointColumn } from "../../../judge/geometry/rows.js";
import { haveSameKinds } from "../blend.js";
import {
  copyToClipboard,
  h,
  makeIndexedSymbol,
  makeRangeInput,
  makeScrollRegion,
  makeSelect,
  setText,
  updateAttribute,
} from "../dom.js";
import { readField, makeTextField } from "../entry.js";
import { makePoseRows, readPose } from "../mounting.js";
import { readPastedTable } from "../paste.js";
import { formatEntry, replaceAt, formatTable } from "../text.js";
import { describeTable } from "../statements.js";

export const title = "DH table";

const COLUMNS = [
  ["a", "a", false],
  ["alpha", "α", true],
  ["d", "d", false],
  ["theta", "θ", true],
];
const KINDS = { revolute: "turns", prismatic: "slides", fixed: "fixed" };
const NEW_ROW = { kind: "revolute", a: 0.2, alpha: 0, d: 0, theta: 0 };

export function build(store, { announce, fit }) {
  const error = h("p.error");
  const verdict = h("p.verdict");
  const reading = makeReadingNote();
  const change = (rows, rowBefore, gesture = null) =>
    store.dispatch({ type: "editTable", rows, rowBefore, gesture });
  const complain = (message) => {
    error.textContent = message ? `${message} The last good arm stays.` : "";
    if (message) announce(() => error.textContent);
  };
  const replace = ({ rows, reading: text }) => {
    store.dispatch({ type: "replaceTable", rows });
    reading.show(`Read with ${text}.`, store.state.arm);
    fit();
  };
  const grid = makeGrid(store, { change, replace, complain });
  const button = (text, onclick) => h("button", { onclick }, text);
  const add = button("Add a row", () => change([...store.state.arm.rows, NEW_ROW]));
  const back = button("Back to the first table", () => change(store.state.base.rows));
  const row = h("div.row", {}, add, back, makeCopyButton(store, announce));
  const blend = makeBlendSlider(store);
  const mounts = makeMountFields(store, { change, complain, fit, reading });
  const root = h("div.dh", {}, grid.root, error, reading.root, row, mounts, verdict, blend.root);
  const update = (state, derived) => {
    grid.update(state);
    reading.update(state);
    blend.update(state);
    add.disabled = state.arm.rows.length >= MAX_ROWS;
    setText(verdict, describeTable(state, derived));
  };
  const summary = () =>
    error.textContent || [reading.root.textContent, verdict.textContent].filter(Boolean).join(" ");
  return { root, update, summary };
}

// Make the fields for a base and a tool; each becomes fixed rows of the table.
function makeMountFields(store, { change, complain, fit, reading }) {
  const mount = (label, input, place) => {
    const result = readPose(input.value, store.state.unit);
    complain("error" in result ? `${label}: this ${result.error}.` : "");
    if ("error" in result) return;
    place(makePoseRows(result.pose));
    if (result.note) reading.show(`${label}: this pose ${result.note}.`, store.state.arm);
    fit();
  };
  const putBefore = (rows) =>
    change([...rows, ...store.state.arm.rows], (row) => row - rows.length);
  const putBehind = (rows) => change([...store.state.arm.rows, ...rows]);
  const lines = [
    makeMountField("Base", "Base: its pose in the world", putBefore, mount),
    makeMountField("Tool", "Tool: its pose in the last frame", putBehind, mount),
  ];
  return h("details.mounts", {}, h("summary", {}, "Base and tool"), ...lines);
}

function makeMountField(label, description, place, mount) {
  const input = h("input", {
    type: "text",
    spellcheck: "false",
    autocomplete: "off",
    "aria-label": description,
    placeholder: "x, y, z, roll, pitch, yaw, or a 4 x 4 matrix",
    onkeydown: (event) => event.key === "Enter" && mount(label, input, place),
  });
  const button = h("button", { onclick: () => mount(label, input, place) }, "Add as rows");
  return h("div.row", {}, h("span", {}, description), input, button);
}

// Make the slider that goes from the ghost's table to the typed one, if their joints are alike.
function makeBlendSlider(store) {
  const slider = makeRangeInput("From the ghost's table to this one", [0, 1], { oninput: blend });
  const root = h("label.blend", { hidden: true }, "the ghost", slider, "this table");

  function blend() {
    const rows = store.state.blended?.rows ?? store.state.arm.rows;
    store.dispatch({ type: "blendTables", rows, share: Number(slider.value), gesture: "blend" });
  }

  function update({ arm, reference, blended }) {
    root.hidden = (arm === reference && !blended) || !haveSameKinds(arm, reference);
    const share = blended?.share ?? 1;
    slider.value = String(share);
    updateAttribute(slider, "aria-valuetext", `${Math.round(100 * share)} % of the way`);
  }
  return { root, update };
}

// Make the line that says how a pasted table was read; it goes when another arm is shown.
function makeReadingNote() {
  const root = h("p.words", { hidden: true });
  let arm = null;
  return {
    root,
    show(text, readArm) {
      arm = readArm;
      setText(root, text);
      root.hidden = false;
    },
    update(state) {
      if (state.arm === arm) return;
      setText(root, "");
      root.hidden = true;
    },
  };
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

// Make the table of text fields. Rows are not rebuilt by what the reader types into one of them.
function makeGrid(store, { change, replace, complain }) {
  const units = h("tr");
  const body = h("tbody", {
    onpaste: (event) => handlePaste(event, store, { replace, complain }),
  });
  const name = { "aria-label": "Denavit-Hartenberg table, standard convention" };
  const table = h("table.entries", name, h("thead", {}, units), body);
  let rendered = /** @type {any} */ ({});
  let isTyping = false;

  function typed(i, [key, letter, angle], input, whole) {
    const { unit, arm } = store.state;
    const { value, message } = readField(input, angle ? "angle" : "length", { unit, whole });
    complain(message && `Row ${i + 1}, ${letter} ${message}.`);
    if (value === undefined) return;
    isTyping = true;
    change(replaceAt(arm.rows, i, { ...arm.rows[i], [key]: value }), undefined, `cell ${i} ${key}`);
    isTyping = false;
    if (whole) input.value = formatEntry(value, angle, unit);
  }

  function update({ arm, unit }) {
    const isShown = rendered.rows === arm.rows || isTyping;
    const before = rendered;
    rendered = { rows: arm.rows, unit };
    if (isShown && before.unit === unit) return;
    const focusedCell = findFocusedCell(body);
    units.replaceChildren(...makeColumnHeaders(unit));
    body.replaceChildren(...arm.rows.map((_, i) => makeTableRow(i, arm, unit, { change, typed })));
    body.querySelector(`[data-cell="${focusedCell}"]`)?.focus({ preventScroll: true });
  }
  return { root: makeScrollRegion("Denavit-Hartenberg table", table), update };
}

// Return the name of the cell that has the focus, or undefined.
function findFocusedCell(body) {
  const { activeElement } = /** @type {ShadowRoot} */ (body.getRootNode());
  const cell = /** @type {HTMLElement | null} */ (activeElement);
  return body.contains(cell) ? cell.dataset.cell : undefined;
}

// Replace the table by one pasted into any of its fields.
function handlePaste(event, store, { replace, complain }) {
  const text = event.clipboardData?.getData("text/plain") ?? "";
  const table = readPastedTable(text);
  if (!table) return;
  event.preventDefault();
  complain("error" in table ? `What was pasted is not read: ${table.error}` : "");
  if (!("error" in table)) replace(table);
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
  const chosen = (name) => change(replaceAt(arm.rows, i, { ...row, kind: name, ...NO_LIMITS }));
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
  if (key !== jointColumn(row.kind)) return h("td", {}, input);
  return h("td.moves", {}, input, h("span", {}, "+ ", makeIndexedSymbol("q", i + 1)));
}

function download(text, name) {
  const address = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
  h("a", { href: address, download: name }).click();
  URL.revokeObjectURL(address);
}
