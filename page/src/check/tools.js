// Buttons of a question: a link to it, an example, its configuration in the explorer.

import { copyToClipboard, h } from "../dom.js";
import { makeConfigurationLink } from "./explorer_link.js";
import { EMPTY, formatQuestionLink } from "./question.js";

/**
 * Add the buttons below a form.
 * @param {import("./page.js").AnswerCheck} check
 */
export function addToolButtons(check) {
  const { parts, given, book } = check;
  const fullForm = new URL("check_your_homework.html", book).href;
  const more = h("a", { href: fullForm }, "More room, and all options");
  const explorer = h("a", { href: "" }, "See this configuration in the explorer");
  const button = (text, onclick) => h("button", { onclick }, text);
  const link = button("Copy link", () => copyLink(check, fullForm));
  const listExamples = () => check.examples.filter((example) => example.ask === check.question.ask);
  const example = button("Show an example", () => {
    const choices = listExamples();
    const sameArm = choices.find((candidate) => candidate.arm === check.question.arm);
    check.startQuestion({ ...EMPTY, ...(sameArm ?? choices[0]) });
  });
  // For an exercise's own arm these would show the table, which is the solution.
  if (!given?.table) parts.tools.append(example, link, given ? more : explorer);
  check.form.boxes.answer.querySelector(".over").append(button("Clear", () => check.clearAnswer()));

  check.onVerdict((question, outcome) => {
    more.href = fullForm + formatQuestionLink(question);
    example.hidden = !listExamples().length;
    const fragment = makeConfigurationLink(question, outcome, check.arms);
    explorer.hidden = !fragment;
    explorer.href = new URL(`explorer.html${fragment}`, book).href;
  });
}

async function copyLink(check, fullForm) {
  const { question, given } = check;
  const fragment = formatQuestionLink(question);
  if (!given) history.replaceState(null, "", fragment);
  const isCopied = await copyToClipboard(given ? fullForm + fragment : location.href);
  const fallback = given ? NO_CLIPBOARD : "The link is in the address bar.";
  check.notify(isCopied ? "The link is copied." : fallback);
}

const NO_CLIPBOARD = "The clipboard is closed to this page.";
