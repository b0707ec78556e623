// The judge in the page: the question, what is typed, how it is read, and the verdict in words.
// Nothing leaves it.

import { h, write } from "../dom.js";
import { EMPTY, fromFragment, judge } from "./question.js";
import { adapt, buildForm } from "./form.js";
import { ready } from "./checkers.js";
import { showRead, tell } from "./shown.js";

const MOST_SHOWN = 50_000; // characters of an answer, such as a file's, that stand in its field
const SOON = 120; // ms without a key before the answer is read
const PAUSE = 350; // and before the verdict is spoken
const PRIVATE =
  "Nothing that you type leaves this page: a script in it judges, without a network too.";
const SILENT = "It names the mistake and does not print the solution.";
let count = 0; // of judges on the page, for ids

/**
 * A judge in the page, as its extras (page/) know it.
 * @typedef {object} Judge
 * @property {HTMLElement} stub
 * @property {any[]} arms those of its list: each has a key, a title and the call in Python
 * @property {any[]} examples
 * @property {any} given what a chapter asks, if it does
 * @property {Record<string, any>} fields
 * @property {Record<string, any>} boxes
 * @property {Record<string, any>} parts
 * @property {HTMLElement} form
 * @property {() => import("./question.js").Question} question
 * @property {() => any} verdict on it
 * @property {(patch: object) => void} put change the question, and judge it
 * @property {(act: (question: any, verdict: any) => void) => void} follow called with each verdict
 * @property {(words: string) => void} say
 */

/**
 * Bring a stub to life. What is `given` in a chapter is not asked again, and the judge is smaller.
 * @param {HTMLElement} stub
 * @returns {Judge}
 */
export function mount(stub) {
  const { arms, examples = [], given } = JSON.parse(stub.querySelector("script").textContent);
  const id = `judge-${++count}`;
  const made = buildForm(id, arms, given);
  const { form, fields } = made;
  const parts = buildParts(id, given);
  const followers = [];
  let question = { ...EMPTY, arm: arms[0]?.key, ...(given ?? examples[0]) };
  let verdict;
  let timer = 0;
  let stale = false; // whether something was typed since the verdict

  const shownAs = (key) => (question[key].length > MOST_SHOWN ? "" : question[key]);
  const show = () => {
    for (const [key, field] of Object.entries(fields))
      if (field.value !== shownAs(key)) field.value = shownAs(key);
    adapt(made, question, arms);
  };
  const say = (words) => write(parts.said, words);
  const speak = () => tell(parts.verdict, verdict);
  const set = () => showRead(parts.taken, question, verdict);
  const again = () => {
    read();
    speak();
    set();
  };
  const atOnce = () => {
    read();
    speak();
    timer = setTimeout(set); // long formulas take as long as their verdict
  };
  const soon = () => {
    read();
    set();
    timer = setTimeout(speak, PAUSE - SOON);
  };
  const read = () => {
    clearTimeout(timer);
    stale = false;
    verdict = judge(question, arms);
    if (verdict.waiting) ready(verdict.waiting).then(again, ({ message }) => say(message));
    fields.answer.setAttribute("aria-invalid", String(verdict.report?.grade === "wrong"));
    for (const act of followers) act(question, verdict);
  };
  const put = (patch) => {
    question = { ...question, ...patch };
    show();
    again();
  };
  form.addEventListener("input", ({ target, inputType }) => {
    const key = Object.keys(fields).find((one) => fields[one] === target);
    if (!key) return;
    question = { ...question, [key]: /** @type {any} */ (target).value };
    if (key === "arm") question.frame = "0";
    if (key === "arm" || key === "ask") question.q = exampleOf(question, examples)?.q ?? question.q;
    show();
    stale = true;
    clearTimeout(timer);
    if (inputType === "insertFromPaste" || inputType === "insertFromDrop") atOnce();
    else timer = setTimeout(soon, SOON);
  });
  form.addEventListener("submit", (event) => event.preventDefault());

  const byLink = () => {
    const { question: asked, words } = fromFragment(
      location.hash,
      arms.map(({ key }) => key),
    );
    if (asked || words) stub.scrollIntoView({ block: "start" });
    say(words);
    if (asked) put(asked);
  };
  stub.replaceChildren(form, ...Object.values(parts));
  put({});
  if (!given) {
    addEventListener("hashchange", byLink);
    byLink();
  }
  const follow = (act) => {
    followers.push(act);
    act(question, verdict);
  };
  const now = { question: () => question, verdict: () => (stale && again(), verdict) };
  return { stub, arms, examples, given, ...made, parts, ...now, put, follow, say };
}

function buildParts(id, given) {
  return {
    verdict: h("div.verdict", { role: "status", "aria-live": "polite", "aria-atomic": "true" }),
    taken: h("div.scroll.taken", {
      role: "region",
      tabindex: "0",
      "aria-label": "How your answer is read",
    }),
    tools: h("div.tools"),
    said: h("p.about", { role: "status" }),
    private: h("p.private", { id: `${id}-private` }, given ? PRIVATE : `${PRIVATE} ${SILENT}`),
  };
}

// The example of a question's kind and arm.
export const exampleOf = (question, examples) =>
  examples.find((one) => one.arm === question.arm && one.ask === question.ask);
