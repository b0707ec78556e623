// A copyable report of the question, the answer, its reading and the verdict. A student may send it
// to whoever keeps the book; the page sends nothing.

import { RIGHT } from "../../../judge/digits.js";
import { formatVerdict } from "../../../judge/verdict.js";
import { copyToClipboard, h, setText } from "../dom.js";

const COPIED_NOTE = "Copied, as it stands here.";
const NOT_COPIED_NOTE = "The clipboard is closed to this page: copy it from here.";
const SEND_NOTE = " If you think that this is mistaken, send it to whoever keeps this book.";

/**
 * Offer a report below every verdict on a typed answer that is not right.
 * @param {import("./page.js").AnswerCheck} judge
 */
export function addReportButton(judge) {
  const text = h("textarea", { rows: 8, readonly: true, "aria-label": "The report" });
  const said = h("p.about", { role: "status" });
  const onclick = async () => {
    judge.again(); // include what was typed a moment ago
    text.value = writeReport(judge);
    text.hidden = false;
    const done = await copyToClipboard(text.value);
    if (!done) text.select();
    setText(said, `${done ? COPIED_NOTE : NOT_COPIED_NOTE}${SEND_NOTE}`);
  };
  judge.parts.report.append(h("button", { onclick }, "Copy a report of this"), said, text);
  judge.follow(({ answer }, { report }) => {
    text.hidden = true;
    setText(said, "");
    const right = report && (report.mark ?? report.grade) === RIGHT;
    judge.parts.report.hidden = !answer.trim() || judge.isExample() || right;
  });
}

// Write the report: fields by their labels, the answer as typed, the cells as shown.
function writeReport({ made, parts, question, verdict, given }) {
  const { boxes, fields } = made;
  // an exercise's table is its solution
  const hidden = ["answer", ...(given?.table ? ["table"] : [])];
  const asked = Object.keys(boxes).filter(
    (key) => fields[key].value && !boxes[key].hidden && !hidden.includes(key),
  );
  const settings = asked.map((key) => {
    const value = fields[key].selectedOptions?.[0]?.textContent ?? fields[key].value;
    return `${boxes[key].querySelector("label").textContent}: ${value}`;
  });
  const rows = parts.taken.hidden ? [] : [...parts.taken.querySelectorAll("tr")];
  const read = rows.map(({ cells }) => [...cells].map((cell) => cell.textContent).join("\t"));
  const { report, error } = verdict;
  return [
    settings.join("\n"),
    `Typed:\n${question.answer}`,
    `Read:\n${read.join("\n") || "nothing"}`,
    `Said:\n${report ? formatVerdict(report) : error}`,
  ].join("\n\n");
}
