// The Denavit-Hartenberg table, to be typed in. A bad entry is said in words, and the last good arm
// stays.

import { KINDS as JOINTS, MOST_ROWS } from "../../../judge/geometry/arm.js";
import { attribute, h, write } from "../dom.js";
import { readEntry, unfinished } from "../../../judge/reading/entry.js";
import { FORMATS, exported } from "../exports.js";
import { lateReader } from "../figures.js";
import { entryText } from "../text.js";
import { tableVerdict } from "../verdicts.js";

export const title = "DH table";

const COLUMNS = [
  ["a", "a", false],
  ["alpha", "α", true],
  ["d", "d", false],
  ["theta", "θ", true],
];
const SAID = { revolute: "turns", prismatic: "slides", fixed: "fixed" };
const KINDS = JOINTS.map((kind) => [kind, SAID[kind]]);
const SEVERAL = /[\n\t;&|]|\]\s*,|,\s*\[/; // a table has them, an entry has none
const NEW_ROW = { kind: "revolute", a: 0.2, alpha: 0, d: 0, theta: 0 };

export function build(store, { say }) {
  const units = h("tr");
  const body = h("tbody", { onpaste: pasted });
  const error = h("p.error");
  const verdict = h("p.verdict");
  const add = h(
    "button",
    { type: "button", onclick: () => change([...store.state.arm.rows, NEW_ROW]) },
    "Add a row",
  );
  const first = () => change(store.state.base.rows);
  const back = h("button", { type: "button", onclick: first }, "Back to the first table");
  const formats = Object.entries(FORMATS).map(([name, { label }]) =>
    h("option", { value: name }, label),
  );
  const format = h("select", { "aria-label": "Format to copy" }, formats);
  const copy = h("button", { type: "button", onclick: copied }, "Copy as");
  const table = h(
    "table.entries",
    { "aria-label": "Denavit-Hartenberg table, standard convention" },
    h("thead", {}, units),
    body,
  );
  const root = h(
    "div.dh",
    {},
    h(
      "div.scroll",
      { tabindex: 0, role: "region", "aria-label": "Denavit-Hartenberg table" },
      table,
    ),
    error,
    h("div.row", {}, add, back, h("span.right.pair", {}, copy, format)),
    verdict,
  );
  let shown = {};

  const change = (rows, rowBefore, gesture = null) =>
    store.dispatch({ type: "edit", rows, rowBefore, gesture });
  const complain = (words) => {
    error.textContent = words ? `${words} The last good arm stays.` : "";
    if (words) say(() => error.textContent);
  };

  function typed(i, [key, letter, angle], input, last) {
    const { value, error: fault } = readEntry(
      input.value,
      angle ? "angle" : "length",
      store.state.unit,
    );
    const wrong = fault && (last || !unfinished(input.value));
    attribute(input, "aria-invalid", String(Boolean(wrong)));
    complain(wrong ? `Row ${i + 1}, ${letter} ${fault}.` : "");
    if (fault) return;
    const rows = store.state.arm.rows.map((row, k) => (k === i ? { ...row, [key]: value } : row));
    change(rows, undefined, `cell ${i} ${key}`);
  }

  // A whole table from a spreadsheet, a matrix or a page, wherever in the table it is pasted.
  async function pasted(event) {
    const text = event.clipboardData?.getData("text/plain") ?? "";
    if (!SEVERAL.test(text.trim())) return;
    event.preventDefault();
    const readTable = await lateReader();
    const table = readTable(text, store.state.unit) ?? { error: "it is a single entry." };
    complain("error" in table ? `What was pasted is not read: ${table.error}` : "");
    if ("error" in table) return;
    change(table.rows);
    if (table.said.length) say(() => `Taken as ${table.said.join("; ")}`, true);
  }

  async function copied() {
    const text = exported(format.value, store.state);
    const done = await navigator.clipboard?.writeText(text).then(
      () => true,
      () => false,
    );
    if (!done) download(text, FORMATS[format.value].file);
    copy.textContent = done ? "Copied" : "Saved";
    say(() => `${copy.textContent} as ${FORMATS[format.value].label}`, true);
    setTimeout(() => (copy.textContent = "Copy as"), 1600);
  }

  function lay({ arm, unit }) {
    const angle = unit === "deg" ? "°" : "rad";
    units.replaceChildren(
      ...["row", "joint"].map((t) => h("th", { scope: "col" }, t)),
      ...COLUMNS.map(([, letter, turn]) =>
        h(
          "th",
          { scope: "col" },
          h("i", {}, letter),
          h("small", {}, turn ? ` (${angle})` : " (m)"),
        ),
      ),
      h("th", {}, h("span.hidden", {}, "remove")),
    );
    body.replaceChildren(...arm.rows.map((row, i) => line(row, i, arm, unit)));
    shown = { rows: arm.rows, unit };
  }

  function line(row, i, arm, unit) {
    const kind = h(
      "select",
      {
        "aria-label": `Row ${i + 1}, kind of joint`,
        onchange: (e) => change(arm.rows.map((r, k) => (k === i ? newKind(r, e.target.value) : r))),
      },
      KINDS.map(([value, text]) => h("option", { value, selected: row.kind === value }, text)),
    );
    const entry = (column) => {
      const [key, letter, angle] = column;
      const moves =
        (row.kind === "revolute" && key === "theta") || (row.kind === "prismatic" && key === "d");
      const input = h("input", {
        type: "text",
        spellcheck: "false",
        autocomplete: "off",
        value: entryText(row[key], angle, unit),
        "aria-label": `Row ${i + 1}, ${letter}`,
        "data-cell": `${i + 1}-${key}`,
        oninput: (e) => typed(i, column, e.target, false),
        onchange: (e) => typed(i, column, e.target, true),
      });
      return h(
        moves ? "td.moves" : "td",
        {},
        input,
        moves ? h("span", {}, "+ ", h("i", {}, "q"), h("sub", {}, String(i + 1))) : [],
      );
    };
    const remove = h(
      "button.remove",
      {
        type: "button",
        "aria-label": `Remove row ${i + 1}`,
        title: `Remove row ${i + 1}`,
        disabled: arm.rows.length === 1,
        onclick: () =>
          change(
            arm.rows.filter((_, k) => k !== i),
            (k) => (k < i ? k : k + 1),
          ),
      },
      "×",
    );
    return h(
      "tr",
      {},
      h("th", { scope: "row" }, String(i + 1)),
      h("td", {}, kind),
      COLUMNS.map(entry),
      h("td", {}, remove),
    );
  }

  function update(state, derived) {
    const typing =
      body.contains(root.getRootNode().activeElement) &&
      root.getRootNode().activeElement.matches("input");
    const reshaped = shown.rows?.length !== state.arm.rows.length || shown.unit !== state.unit;
    if (reshaped || (shown.rows !== state.arm.rows && !typing)) lay(state);
    add.disabled = state.arm.rows.length >= MOST_ROWS;
    write(verdict, tableVerdict(state, derived));
  }
  return { root, update, summary: () => error.textContent || verdict.textContent };
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
