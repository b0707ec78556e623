// An answer filled in cell by cell instead of pasted. What is filled in becomes the text of the
// answer, which the judge reads as it reads all others.

import { h, write } from "../../dom.js";
import { joints } from "../../../../judge/geometry/kinematics.js";
import { cells } from "../../../../judge/reading/grid.js";
import { ArmError } from "../../../../judge/sentences.js";
import { matrixOf, namesOf } from "../shown.js";

const [GRID, TEXT] = ["Fill in a grid", "Type or paste instead"];
const MOST = 12; // rows, of those that a reader adds
const STEPS = {
  ArrowUp: [-1, 0],
  ArrowDown: [1, 0],
  ArrowLeft: [0, -1],
  ArrowRight: [0, 1],
  Enter: [1, 0],
};
const SIZES = {
  jacobian: (dof) => [6, dof],
  torques: (dof) => [1, dof],
  pose: (dof) => [1, dof],
  branches: (dof, rows) => [rows || 4, dof],
  table: (dof, rows, arm) => [rows || arm.rows.length, 4],
};

/**
 * The rows and columns of an answer, or null where it is none to be filled in.
 * @param {import("../question.js").Question} question
 * @param {import("../../../../judge/geometry/arm.js").Arm} arm
 * @param {string[][]} texts that are there already
 * @returns {number[] | null}
 */
export function sizeOf(question, arm, texts = []) {
  const known = SIZES[question.ask];
  if (!arm || !known) return null;
  const [rows, width] = known(joints(arm).length, Math.min(MOST, texts.length), arm);
  return question.ask === "jacobian" && texts.length === 3 ? [3, width] : [rows, width];
}

// The cells of a text as typed; none where it cannot be read.
export function textsOf(text) {
  try {
    return text.trim() ? cells(text) : [];
  } catch (error) {
    if (error instanceof ArmError) return [];
    throw error;
  }
}

// The text of cells, or null while some are empty.
export function textOf(rows) {
  const whole = rows.every((row) => row.every((cell) => cell.trim()));
  return whole ? rows.map((row) => row.map((cell) => cell.trim()).join("\t")).join("\n") : null;
}

/**
 * Pasted cells put into others, from a place on; those of the size of the whole fill it from its
 * first one.
 * @param {string[][]} rows
 * @param {string[][]} pasted
 * @param {[number, number]} place
 */
export function filled(rows, pasted, [row, column]) {
  const whole =
    pasted.length === rows.length && pasted.every((line) => line.length === rows[0].length);
  const [top, left] = whole ? [0, 0] : [row, column];
  return rows.map((line, i) => line.map((cell, k) => pasted[i - top]?.[k - left] ?? cell));
}

/** @param {import("../page.js").Judge} judge */
export function addFilling(judge) {
  const { fields, boxes, say } = judge;
  const [label, control] = boxes.answer.children;
  const table = h("table.filling");
  const place = h(
    "div.scroll",
    { role: "group", "aria-label": "Your answer, cell by cell", hidden: true },
    table,
  );
  const button = h("button", { type: "button" }, GRID);
  const head = h("div.over", {}, button);
  label.before(head);
  head.prepend(label);
  control.after(place);
  let inputs = /** @type {HTMLInputElement[][]} */ ([]);
  let on = false;
  let shape = "";

  const rows = () => inputs.map((line) => line.map(({ value }) => value));
  const hand = () => {
    const text = textOf(rows());
    if (text === null) {
      const all = rows().flat();
      say(`${all.filter((cell) => cell.trim()).length} of ${all.length} cells are filled in.`);
    } else say("");
    if (fields.answer.value === (text ?? "")) return;
    fields.answer.value = text ?? "";
    fields.answer.dispatchEvent(new Event("input", { bubbles: true }));
  };
  const fill = (values) =>
    inputs.forEach((line, i) => line.forEach((one, k) => (one.value = values[i]?.[k] ?? "")));

  function build(question, arm, size) {
    const names = namesOf(question, arm, size);
    inputs = names.rows.map((row, i) =>
      names.columns.map((column, k) =>
        cellInput(
          `${row}, ${column}`,
          (event) => press(event, i, k),
          (event) => paste(event, i, k),
        ),
      ),
    );
    table.replaceChildren(
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          h("td"),
          names.columns.map((name) => h("th", { scope: "col" }, name)),
        ),
      ),
      h(
        "tbody",
        {},
        names.rows.map((name, i) =>
          h(
            "tr",
            {},
            h("th", { scope: "row" }, name),
            inputs[i].map((one) => h("td", {}, one)),
          ),
        ),
      ),
    );
  }
  function press(event, i, k) {
    const step = STEPS[event.key];
    if (!step || (step[1] && !atEdge(event.target, step[1]))) return;
    event.preventDefault();
    const next = inputs[i + step[0]]?.[k + step[1]];
    next?.focus();
    next?.select();
  }
  function paste(event, i, k) {
    const pasted = textsOf(event.clipboardData.getData("text"));
    if (pasted.length < 2 && (pasted[0]?.length ?? 0) < 2) return;
    event.preventDefault();
    fill(filled(rows(), pasted, [i, k]));
    hand();
  }
  table.addEventListener("input", (event) => (event.stopPropagation(), hand()));

  const show = (question, verdict) => {
    const texts = textsOf(question.answer);
    const size = sizeOf(question, verdict.arm, texts.length ? texts : rows());
    button.hidden = !size;
    const used = on && Boolean(size);
    place.hidden = !used;
    control.hidden = used;
    write(button, used ? TEXT : GRID);
    judge.stub.classList.toggle("in-grid", used);
    if (!used) return;
    const wanted = JSON.stringify([question.ask, question.first, verdict.arm.rows.length, size]);
    if (wanted !== shape) build(question, verdict.arm, size);
    if (wanted !== shape || (question.answer && textOf(rows()) !== question.answer)) fill(texts);
    shape = wanted;
    mark(inputs, matrixOf(question, verdict));
  };
  button.addEventListener("click", () => {
    on = !on;
    judge.put({});
    if (on) inputs[0]?.[0]?.focus();
  });
  judge.follow(show);
}

const cellInput = (name, onkeydown, onpaste) =>
  h("input", {
    "aria-label": name,
    size: "7",
    inputmode: "text",
    autocomplete: "off",
    spellcheck: "false",
    onkeydown,
    onpaste,
  });

// Whether the caret is where the arrow leads out of the cell.
const atEdge = ({ selectionStart, selectionEnd, value }, way) =>
  selectionStart === selectionEnd ? selectionStart === (way < 0 ? 0 : value.length) : true;

// Wrong cells after a verdict.
function mark(inputs, found) {
  const same = found && found.shape[0] === inputs.length && found.shape[1] === inputs[0]?.length;
  inputs.forEach((line, i) =>
    line.forEach((one, k) => {
      const off = Boolean(same && found.wrong[i * line.length + k]);
      one.classList.toggle("off", off);
      one.setAttribute("aria-invalid", String(off));
    }),
  );
}
