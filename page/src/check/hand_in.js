// A copyable report of the question, the answer, its reading and the verdict. A student may send it
// to whoever keeps the book; the page sends nothing.

import { RIGHT, RIGHT_BY_MAP } from "../../../judge/digits.js";
import { formatVerdict } from "../../../judge/verdict.js";
import { copyToClipboard, h, setText } from "../dom.js";
import { getFieldText } from "./form.js";

const COPIED_NOTE = "Copied: the text below.";
const NOT_COPIED_NOTE = "The clipboard is closed to this page: copy it from here.";
const SEND_NOTE = " If you think that this is mistaken, send it to whoever keeps this book.";

/**
 * Offer a report below every verdict on a typed answer that is not right.
 * @param {import("./page.js").AnswerCheck} check
 */
export function addReportButton(check) {
  const text = h("textarea", { rows: 8, readonly: true, "aria-label": "The report" });
  const note = h("p.about", { role: "status" });
  const onclick = async () => {
    check.judgeAndShow(); // include what was typed a moment ago
    text.value = writeReport(check);
    text.hidden = false;
    const isCopied = await copyToClipboard(text.value);
    if (!isCopied) text.select();
    setText(note, `${isCopied ? COPIED_NOTE : NOT_COPIED_NOTE}${SEND_NOTE}`);
  };
  check.parts.report.append(h("button", { onclick }, "Copy a report of this"), note, text);
  check.onVerdict(({ answer }, { verdict }) => {
    text.hidden = true;
    setText(note, "");
    const isRight = [RIGHT, RIGHT_BY_MAP].includes(verdict?.mark ?? verdict?.grade);
    check.parts.report.hidden = !answer.trim() || check.isExample() || isRight;
  });
}

// Write the report: fields by their labels, the answer as typed, the cells as shown.
function writeReport({ form, reading, question, outcome, given }) {
  const { boxes, fields } = form;
  // an exercise's table is its solution
  const hidden = ["answer", ...(given?.table ? ["table"] : [])];
  const asked = Object.keys(boxes).filter(
    (key) => fields[key].value && !boxes[key].hidden && !hidden.includes(key),
  );
  const settings = asked.map((key) => {
    return `${boxes[key].querySelector("label").textContent}: ${getFieldText(fields[key])}`;
  });
  const lines = [...reading.root.querySelectorAll(".by-column caption, tr")];
  const getText = (cell) => (cell.querySelector(".value") ?? cell).textContent; // of a formula
  const read = reading.root.hidden
    ? []
    : lines.map((line) => (line.cells ? [...line.cells] : [line]).map(getText).join("\t"));
  const { verdict, error } = outcome;
  return [
    settings.join("\n"),
    `Typed:\n${question.answer}`,
    `Read:\n${read.join("\n") || "nothing"}`,
    `Said:\n${verdict ? formatVerdict(verdict) : error}`,
  ].join("\n\n");
}
