// Mounts forms into the page: loads links and wires the parts of a form.

import { addFileInput } from "./files.js";
import { buildForm } from "./form.js";
import { addReportButton } from "./hand_in.js";
import { AnswerCheck } from "./page.js";
import { EMPTY, parseQuestionLink } from "./question.js";
import { addToolButtons } from "./tools.js";

/** @typedef {InputEvent & { target: import("./page.js").Control }} FieldEvent */

/**
 * Mount the form into a stub. A chapter's `given` fields are not asked, and its form is smaller.
 * @param {HTMLElement} stub
 * @param {string} book address of the book
 * @param {string} id
 */
export function mount(stub, book, id) {
  const { arms, examples = [], given } = JSON.parse(stub.querySelector("script").textContent);
  const form = buildForm(id, arms, given);
  const check = new AnswerCheck(form, { arms, examples, given, scope: nameScope(given, id), book });
  const handleInput = (/** @type {FieldEvent} */ event) => check.handleInput(event);
  form.form.addEventListener("input", handleInput);
  form.form.addEventListener("submit", (event) => event.preventDefault());
  addToolButtons(check);
  addFileInput(check, stub);
  addReportButton(check);
  stub.replaceChildren(form.form, ...check.listParts());
  const isLinked = !given && readLinks(check, stub);
  if (!isLinked && !check.restoreLastAnswer()) check.showFirstQuestion();
}

// Name the form among all forms of the book, for the browser's storage.
function nameScope(given, id) {
  if (!given) return "check";
  const page = globalThis.location?.pathname?.split("/").at(-1) ?? "";
  return `${page.replace(".html", "")}-${id}`;
}

// Load the question from the link, now and whenever the address changes. Returns whether the
// address holds one now.
function readLinks(check, stub) {
  const read = () => {
    const keys = check.arms.map(({ key }) => key);
    const { question, message } = parseQuestionLink(location.hash, keys);
    if (question || message) stub.scrollIntoView({ block: "start" });
    check.notify(message);
    if (!question) return false;
    check.start = EMPTY; // the reader typed all fields of a link
    check.updateQuestion(question);
    return true;
  };
  addEventListener("hashchange", read);
  return read();
}
