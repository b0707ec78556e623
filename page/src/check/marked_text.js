// The reader's own text, with each number marked by its use. A number can be
// corrected in place; each correction changes the text itself.

import { h, setText } from "../dom.js";
import { commentLines, putBehindHash, replaceSpan } from "./corrections.js";
import { getShownKind, listMarks, MARK_NAMES, splitAtMarks } from "../../../judge/marks.js";

/** @typedef {import("./question.js").Question} Question */
/** @typedef {import("./question.js").Outcome} Outcome */
/** @typedef {import("../../../judge/marks.js").Mark} Mark */

const HELP = "Choose a number to correct it; arrow keys move from number to number.";

/**
 * Make the region of the marked text.
 * @param {(text: string) => void} onCorrect called with the corrected text
 */
export function makeMarkedText(onCorrect) {
  const text = h("pre", { role: "group", "aria-label": "The text with its numbers marked" });
  const status = h("p.about");
  const legend = h("p.legend", { "aria-hidden": "true" });
  const editor = new NumberEditor(onCorrect);
  const choices = h("p.offer");
  const caption = h("p.caption", {}, "Your text, with what each number was taken for");
  const root = h(
    "div.marked",
    { hidden: true },
    caption,
    choices,
    text,
    editor.root,
    status,
    legend,
  );
  text.addEventListener("keydown", moveFocus);

  /** @param {Question} question @param {Outcome} outcome @param {boolean} isExample */
  function update(question, outcome, isExample) {
    const marks = listMarks(question, outcome);
    root.hidden = isExample || !(marks.length || outcome.answers?.length);
    editor.close();
    if (root.hidden) return;
    const buttons = marks.map((mark) => makeNumber(mark, question.answer, { status, editor }));
    const pieces = splitAtMarks(question.answer, marks);
    text.replaceChildren(...pieces.map((piece) => buttons[piece.index ?? -1] ?? piece.text));
    makeTabStop(buttons, marks);
    setText(status, describeHelp(marks, question.answer));
    legend.replaceChildren(...makeLegend(marks));
    choices.replaceChildren(...makeChoices(question.answer, outcome.answers ?? [], onCorrect));
  }
  return { root, update };
}

// Describe how a number is corrected, and quote the first unread number, which stops the verdict.
function describeHelp(marks, text) {
  const unread = marks.find(({ kind }) => kind === "unread");
  if (!unread) return marks.length ? HELP : "";
  const word = text.slice(unread.from, unread.to);
  return `Choose ${word} to write it as a plain number, or to say that it is no entry.`;
}

function makeNumber(mark, text, { status, editor }) {
  const word = text.slice(mark.from, mark.to);
  const describe = () => setText(status, `${word}: ${mark.description}`);
  return h(
    `button.number.${mark.kind}${mark.isWrong ? ".off" : ""}`,
    {
      title: mark.description,
      "aria-label": `${word}: ${mark.description}`,
      tabindex: -1,
      onpointerenter: describe,
      onfocus: describe,
      onclick: () => (setText(status, ""), editor.open(mark, text)),
    },
    word,
  );
}

// The first number that needs a look is the one that Tab reaches.
function makeTabStop(buttons, marks) {
  const first = marks.findIndex(({ kind, isWrong }) => isWrong || kind === "unread");
  const stop = buttons[Math.max(0, first)];
  if (stop) stop.tabIndex = 0;
}

function moveFocus(event) {
  const buttons = [...event.currentTarget.querySelectorAll("button")];
  const i = buttons.indexOf(event.target);
  const next = {
    ArrowRight: i + 1,
    ArrowDown: i + 1,
    ArrowLeft: i - 1,
    ArrowUp: i - 1,
    Home: 0,
    End: buttons.length - 1,
  }[event.key];
  if (next === undefined || !buttons[next]) return;
  event.preventDefault();
  buttons[i].tabIndex = -1;
  buttons[next].tabIndex = 0;
  buttons[next].focus();
}

function makeLegend(marks) {
  const kinds = new Set(marks.map(getShownKind));
  return Object.entries(MARK_NAMES)
    .filter(([kind]) => kinds.has(kind))
    .map(([kind, name]) =>
      h(
        "span",
        {},
        h(`span.number.${kind === "wrong" ? "entry.off" : kind}`, {}, "0.5"),
        ` ${name}`,
      ),
    );
}

/** A line below the text for the correction of a number. */
class NumberEditor {
  /** @param {(text: string) => void} onCorrect */
  constructor(onCorrect) {
    this.onCorrect = onCorrect;
    this.root = h("div.editor", { hidden: true });
    const label = "The number as it should be read";
    this.field = h("input", { "aria-label": label, autocomplete: "off", spellcheck: "false" });
  }

  close() {
    this.root.hidden = true;
  }

  /** @param {Mark} mark @param {string} text */
  open(mark, text) {
    const { field } = this;
    const word = text.slice(mark.from, mark.to);
    const isEntry = mark.kind === "entry" || mark.kind === "unread";
    const change = () => {
      if (field.value === word) return;
      this.correct(text, replaceSpan(text, mark, field.value), `${word} is changed.`);
    };
    const exclude = () =>
      this.correct(text, putBehindHash(text, mark), `${word} stands behind # now: it is no entry.`);
    field.value = word;
    field.onkeydown = (event) => {
      if (event.key === "Enter") change();
      if (event.key === "Escape") this.close();
    };
    this.root.replaceChildren(
      h("span", {}, h("code", {}, word), `: ${mark.description}`),
      field,
      h("button", { onclick: change }, "Change it"),
      ...(isEntry ? [h("button", { onclick: exclude }, "This is no entry")] : []),
      h("button", { onclick: () => this.close() }, "Close"),
    );
    this.root.hidden = false;
    field.focus();
  }

  // Hand over the corrected text, and offer to take the correction back.
  correct(before, after, message) {
    this.onCorrect(after);
    const undo = h("button", { onclick: () => this.onCorrect(before) }, "Undo");
    this.root.replaceChildren(h("span", { role: "status" }, message), undo);
    this.root.hidden = false;
  }
}

// Make a button for each of several answers that differ. It puts the other answers behind #.
function makeChoices(text, answers, onCorrect) {
  if (answers.length < 2) return [];
  const inside = ({ firstLine, lastLine }, line) => line >= firstLine && line <= lastLine;
  const choose = (answer) =>
    onCorrect(
      commentLines(
        text,
        (line) => !inside(answer, line) && answers.some((other) => inside(other, line)),
      ),
    );
  const buttons = answers.map((answer) => {
    const lines =
      answer.firstLine === answer.lastLine
        ? `line ${answer.firstLine + 1}`
        : `lines ${answer.firstLine + 1} to ${answer.lastLine + 1}`;
    return h("button", { onclick: () => choose(answer) }, `My answer is in ${lines}`);
  });
  return ["The others go behind #: ", ...buttons];
}
