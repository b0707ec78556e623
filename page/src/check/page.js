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
  const spec = JSON.parse(stub.querySelector("script").textContent);
  const { arms, examples = [], given } = spec;
  const id = `judge-${++count}`;
  const made = buildForm(id, arms, given);
  const parts = buildParts(id, given);
  const one = new Question(made, parts, { arms, examples, given });
  made.form.addEventListener("input", (event) => one.typed(/** @type {any} */ (event)));
  made.form.addEventListener("submit", (event) => event.preventDefault());
  stub.replaceChildren(made.form, ...Object.values(parts));
  one.put({});
  const byLink = () => {
    const keys = arms.map(({ key }) => key);
    const { question, words } = fromFragment(location.hash, keys);
    if (question || words) stub.scrollIntoView({ block: "start" });
    one.say(words);
    if (question) one.put(question);
  };
  if (!given) {
    addEventListener("hashchange", byLink);
    byLink();
  }
  return {
    stub,
    arms,
    examples,
    given,
    ...made,
    parts,
    question: () => one.question,
    verdict: () => one.upToDate(),
    put: (patch) => one.put(patch),
    follow: (act) => one.follow(act),
    say: (words) => one.say(words),
  };
}

/** What is asked and answered in one form, and the verdict on it. */
class Question {
  constructor(made, parts, { arms, examples, given }) {
    this.made = made;
    this.parts = parts;
    this.arms = arms;
    this.examples = examples;
    /** @type {import("./question.js").Question} */
    this.question = { ...EMPTY, arm: arms[0]?.key, ...(given ?? examples[0]) };
    /** @type {any} what judge() says */
    this.verdict = {};
    this.followers = [];
    this.timer = /** @type {any} */ (0);
    this.stale = false; // whether something was typed since the verdict
  }

  say(words) {
    write(this.parts.said, words);
  }

  show() {
    const { question, made } = this;
    for (const [key, field] of Object.entries(made.fields)) {
      const text = question[key].length > MOST_SHOWN ? "" : question[key];
      if (field.value !== text) field.value = text;
    }
    adapt(made, question, this.arms);
  }

  read() {
    clearTimeout(this.timer);
    this.stale = false;
    this.verdict = judge(this.question, this.arms);
    const { waiting, report } = this.verdict;
    if (waiting)
      ready(waiting).then(
        () => this.again(),
        ({ message }) => this.say(message),
      );
    this.made.fields.answer.setAttribute("aria-invalid", String(report?.grade === "wrong"));
    for (const act of this.followers) act(this.question, this.verdict);
  }

  speak() {
    tell(this.parts.verdict, this.verdict);
  }

  set() {
    showRead(this.parts.taken, this.question, this.verdict);
  }

  again() {
    this.read();
    this.speak();
    this.set();
  }

  put(patch) {
    this.question = { ...this.question, ...patch };
    this.show();
    this.again();
  }

  typed({ target, inputType }) {
    const { fields } = this.made;
    const key = Object.keys(fields).find((one) => fields[one] === target);
    if (!key) return;
    const question = { ...this.question, [key]: target.value };
    if (key === "arm") question.frame = "0";
    if (key === "arm" || key === "ask")
      question.q = exampleOf(question, this.examples)?.q ?? question.q;
    this.question = question;
    this.show();
    this.stale = true;
    clearTimeout(this.timer);
    if (inputType === "insertFromPaste" || inputType === "insertFromDrop") this.atOnce();
    else this.timer = setTimeout(() => this.soon(), SOON);
  }

  atOnce() {
    this.read();
    this.speak();
    this.timer = setTimeout(() => this.set()); // long formulas take as long as their verdict
  }

  soon() {
    this.read();
    this.set();
    this.timer = setTimeout(() => this.speak(), PAUSE - SOON);
  }

  upToDate() {
    if (this.stale) this.again();
    return this.verdict;
  }

  follow(act) {
    this.followers.push(act);
    act(this.question, this.verdict);
  }
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
