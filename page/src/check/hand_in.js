// A report of what was asked, typed, read and said, to copy: a student may send it to whoever keeps
// the book, and nothing is sent from here.

import { RIGHT } from "../../../judge/digits.js";
import { formatVerdict } from "../../../judge/report.js";
import { copied, h, write } from "../dom.js";

const COPIED = "Copied, as it stands here.";
const CLOSED = "The clipboard is closed to this page: copy it from here.";
const WHY = " If you think that this is mistaken, send it to whoever keeps this book.";

/**
 * Offer a report below every verdict on what a reader typed, but on a right answer.
 * @param {import("./page.js").Asked} judge
 */
export function addReport(judge) {
  const text = h("textarea", { rows: 8, readonly: true, "aria-label": "The report" });
  const said = h("p.about", { role: "status" });
  const onclick = async () => {
    judge.again(); // what was typed a moment ago is in it too
    text.value = reportOf(judge);
    text.hidden = false;
    const done = await copied(text.value);
    if (!done) text.select();
    write(said, `${done ? COPIED : CLOSED}${WHY}`);
  };
  judge.parts.report.append(h("button", { onclick }, "Copy a report of this"), said, text);
  judge.follow(({ answer }, { report }) => {
    text.hidden = true;
    write(said, "");
    const right = report && (report.mark ?? report.grade) === RIGHT;
    judge.parts.report.hidden = !answer.trim() || judge.isExample() || right;
  });
}

// The fields as the form calls them, the answer as typed, the cells as the page shows them.
function reportOf({ made, parts, question, verdict, given }) {
  const { boxes, fields } = made;
  const hidden = ["answer", ...(given?.table ? ["table"] : [])]; // which is an exercise's solution
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
