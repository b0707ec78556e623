// Buttons of a question: a link to it, an example, its pose in the explorer.

import { copyToClipboard, h } from "../dom.js";
import { EMPTY, OWN_ARM, formatQuestionLink } from "./question.js";

/**
 * Add the buttons.
 * @param {import("./page.js").AnswerCheck} check
 * @param {string} book address of the book
 */
export function addToolButtons(check, book) {
  const { parts, given } = check;
  const whole = new URL("check_your_homework.html", book).href;
  const more = h("a", { href: whole }, "More room, and all options");
  const explorer = h("a", { href: "" }, "See this pose in the explorer");
  const button = (text, onclick) => h("button", { onclick }, text);
  const link = button("Copy link", () => copyLink(check, whole));
  const examples = () => check.examples.filter((example) => example.ask === check.question.ask);
  const example = button("Show an example", () => {
    const same = examples();
    const ours = same.find((candidate) => candidate.arm === check.question.arm);
    check.begin({ ...EMPTY, ...(ours ?? same[0]) });
  });
  // For an exercise's own arm these would show the table, which is the solution.
  if (!given?.table) parts.tools.append(example, link, given ? more : explorer);
  const clear = button("Clear what I typed", () => check.clear());
  parts.tools.append(clear);

  check.onVerdict((question, { arm, q }) => {
    more.href = whole + formatQuestionLink(question);
    example.hidden = !examples().length;
    explorer.hidden = !arm || !q || question.arm === OWN_ARM || !arm.explorer;
    if (!explorer.hidden)
      explorer.href = new URL(`explorer.html#${getExplorerQuery(question, arm, q)}`, book).href;
  });
}

async function copyLink(check, whole) {
  const { question, given } = check;
  const fragment = formatQuestionLink(question);
  if (!given) history.replaceState(null, "", fragment);
  const isCopied = await copyToClipboard(given ? whole + fragment : location.href);
  const fallback = given ? NO_CLIPBOARD : "The link stands in the address bar.";
  check.notify(isCopied ? "The link is copied." : fallback);
}

const NO_CLIPBOARD = "The clipboard is closed to this page.";

const getExplorerQuery = ({ ask }, arm, q) =>
  new URLSearchParams({
    arm: arm.explorer,
    q: q.map((x) => Number(x.toFixed(6))).join(","),
    view: ask === "torques" ? "torque" : "jacobian",
  });
