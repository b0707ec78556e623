// The judge in the page: the question, what is typed, how it is read, and the verdict in words.
// Nothing leaves it.

import { h, write } from "../dom.js";
import { EMPTY, fromFragment, judge, startOf } from "./question.js";
import { addFiles } from "./files.js";
import { adapt, buildForm, offerOf } from "./form.js";
import { addReport } from "./hand_in.js";
import { showRead, tell } from "./shown.js";
import { addTools } from "./tools.js";

const MOST_SHOWN = 50_000; // characters of an answer, such as a file's, that stand in its field
const SOON = 120; // ms without a key before the answer is read
const PAUSE = 350; // and before the verdict is spoken
const PRIVATE =
  "Nothing that you type leaves this page: a script in it judges, without a network too. " +
  "It names the mistake and does not print the solution.";
const TURNS = ["ask", "arm", "unit"]; // on which what the page fills in depends

/**
 * Bring a stub to life. What is `given` in a chapter is not asked again, and the judge is smaller.
 * @param {HTMLElement} stub
 * @param {string} book its address
 * @param {string} id
 */
export function mount(stub, book, id) {
  const { arms, examples = [], given } = JSON.parse(stub.querySelector("script").textContent);
  const made = buildForm(id, arms, given);
  const parts = buildParts();
  const one = new Asked(made, parts, { arms, examples, given });
  made.form.addEventListener("input", (event) => one.typed(/** @type {any} */ (event)));
  made.form.addEventListener("submit", (event) => event.preventDefault());
  addTools(one, book);
  addFiles(one, stub);
  addReport(one);
  const { held, patch } = before(stub, Object.keys(made.fields));
  const { verdict, report, taken, ...below } = parts;
  const desk = h("div.desk", {}, made.form, h("div.told", {}, verdict, report, taken));
  stub.replaceChildren(desk, ...Object.values(below));
  if (!given) readLinks(one, stub);
  if (TURNS.some((key) => key in patch)) one.turnTo(patch);
  one.put(patch);
  made.fields[held]?.focus();
}

// What was chosen and typed in the still form before the script had come, and which of its fields
// was held.
function before(stub, keys) {
  const fields = keys.map((key) => [key, stub.querySelector(`[id$="-${key}"]`)]);
  const usual = (one) =>
    one.defaultValue ?? (one.querySelector("[selected]") ?? one.options[0])?.value;
  const changed = fields.filter(([, one]) => one && one.value !== (usual(one) ?? ""));
  return {
    held: fields.find(([, one]) => one && one === document.activeElement)?.[0],
    patch: Object.fromEntries(changed.map(([key, one]) => [key, one.value])),
  };
}

// A link brings its question, now and whenever the address changes.
function readLinks(one, stub) {
  const read = () => {
    const keys = one.arms.map(({ key }) => key);
    const { question, words } = fromFragment(location.hash, keys);
    if (question || words) stub.scrollIntoView({ block: "start" });
    one.say(words);
    if (!question) return;
    one.start = EMPTY; // of which nothing stands in the fields
    one.put(question);
  };
  addEventListener("hashchange", read);
  read();
}

/** What is asked and answered in one form, and the verdict on it. */
export class Asked {
  constructor(made, parts, { arms, examples, given }) {
    this.made = made;
    this.parts = parts;
    this.arms = arms;
    this.examples = examples;
    this.given = given;
    // What the page itself put into the fields.
    /** @type {import("./question.js").Question} */
    this.start = { ...EMPTY, arm: arms[0]?.key, ...(given ?? examples[0]) };
    this.question = this.start;
    /** @type {any} what judge() says */
    this.verdict = {};
    this.followers = [];
    this.timer = /** @type {any} */ (0);
    made.fields.answer.addEventListener("focus", () => this.hold());
    globalThis.visualViewport?.addEventListener("resize", () => this.hold());
  }

  // An example is typed over; the field stands high enough for the verdict above a phone's keys.
  hold() {
    const { answer } = this.made.fields;
    if (document.activeElement !== answer) return;
    if (this.isExample()) answer.select();
    if (matchMedia("(pointer: coarse)").matches)
      this.made.boxes.answer.scrollIntoView({ block: "start" });
  }

  isExample() {
    return Boolean(this.start.answer) && this.question.answer === this.start.answer;
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
    this.verdict = judge(this.question, this.arms);
    const { report } = this.verdict;
    const wrong = report?.grade === "wrong" && !this.isExample();
    this.made.fields.answer.setAttribute("aria-invalid", String(wrong));
    for (const act of this.followers) act(this.question, this.verdict);
  }

  speak() {
    const advice = this.verdict.advice ?? [];
    const offers = advice.map((one) => offerOf(one, this.question, this.arms));
    const fixed = (key) => this.made.boxes[key].classList.contains("given");
    const buttons = offers
      .filter((offer) => offer && !fixed(offer.key))
      .map((offer) => h("button", { onclick: () => this.take(offer) }, offer.words));
    tell(this.parts.verdict, this.verdict, { example: this.isExample(), buttons });
  }

  // Set what the judge advises; a symbol's number is still to be typed.
  take({ key, value }) {
    if (TURNS.includes(key)) this.turnTo({ [key]: value });
    else this.put({ [key]: value });
    if (key !== "values") return;
    this.made.folded.open = true;
    this.made.fields.values.focus();
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

  begin(question) {
    this.start = question;
    this.put(question);
  }

  typed({ target, inputType }) {
    const { fields } = this.made;
    const key = Object.keys(fields).find((one) => fields[one] === target);
    if (!key) return;
    if (TURNS.includes(key)) return this.turnTo({ [key]: target.value });
    this.question = { ...this.question, [key]: target.value };
    this.show();
    clearTimeout(this.timer);
    if (inputType === "insertFromPaste" || inputType === "insertFromDrop") this.atOnce();
    else this.timer = setTimeout(() => this.soon(), SOON);
  }

  // Another question, arm or unit: what the page had put into a field it puts anew, what was typed
  // stays.
  turnTo(patch) {
    const { ask, arm, unit } = { ...this.question, ...patch };
    const typed = Object.entries(this.question).filter(([key, text]) => text !== this.start[key]);
    const own = Object.fromEntries(typed);
    this.start = { ...startOf({ ask, arm, unit }, this), ...this.given, arm };
    this.put({ ...this.start, ...own, ask, arm, unit, frame: "0" });
  }

  atOnce() {
    this.read();
    this.speak();
    this.timer = setTimeout(() => this.set()); // a long answer takes as long as its verdict
  }

  soon() {
    this.read();
    this.set();
    this.timer = setTimeout(() => this.speak(), PAUSE - SOON);
  }

  // Hear of each verdict.
  /** @param {(question: import("./question.js").Question, verdict: any) => void} act */
  follow(act) {
    this.followers.push(act);
  }
}

const buildParts = () => ({
  verdict: h("div.verdict", { role: "status", "aria-live": "polite", "aria-atomic": "true" }),
  report: h("div.report", { hidden: true }),
  taken: h("div.scroll.taken", {
    role: "region",
    tabindex: "0",
    "aria-label": "How your answer is read",
  }),
  tools: h("div.tools"),
  said: h("p.about", { role: "status" }),
  private: h("p.about", {}, PRIVATE),
});
