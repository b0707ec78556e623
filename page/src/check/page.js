// The judge in the page: the question, the typed answer, its reading and the verdict. Nothing
// leaves the page.

import { h, setText } from "../dom.js";
import { EMPTY, parseQuestionLink, judgeQuestion, makeStartingQuestion } from "./question.js";
import { addFileInput } from "./files.js";
import { adaptForm, buildForm, makeOffer } from "./form.js";
import { addReportButton } from "./hand_in.js";
import { showReading, showVerdict } from "./shown.js";
import { addToolButtons } from "./tools.js";

const MAX_SHOWN_LENGTH = 50_000; // characters; a longer answer is not shown in its field
const READ_DELAY = 120; // ms after the last key before the answer is read
const SPEAK_DELAY = 350; // ms after the last key before the verdict is announced
const PRIVACY_NOTE =
  "Nothing that you type leaves this page: a script in it judges, without a network too. " +
  "It names the mistake and does not print the solution.";
const DEFAULT_FIELDS = ["ask", "arm", "unit"]; // the defaults of the other fields depend on these

/**
 * Mount the form into a stub. A chapter's `given` fields are not asked, and its form is smaller.
 * @param {HTMLElement} stub
 * @param {string} book address of the book
 * @param {string} id
 */
export function mount(stub, book, id) {
  const { arms, examples = [], given } = JSON.parse(stub.querySelector("script").textContent);
  const made = buildForm(id, arms, given);
  const parts = makeParts();
  const one = new AnswerCheck(made, parts, { arms, examples, given });
  made.form.addEventListener("input", (event) => one.typed(/** @type {any} */ (event)));
  made.form.addEventListener("submit", (event) => event.preventDefault());
  addToolButtons(one, book);
  addFileInput(one, stub);
  addReportButton(one);
  const { held, patch } = readStillForm(stub, Object.keys(made.fields));
  const { verdict, report, taken, ...below } = parts;
  const desk = h("div.desk", {}, made.form, h("div.told", {}, verdict, report, taken));
  stub.replaceChildren(desk, ...Object.values(below));
  if (!given) readLinks(one, stub);
  if (DEFAULT_FIELDS.some((key) => key in patch)) one.turnTo(patch);
  one.put(patch);
  made.fields[held]?.focus();
}

// Return what the reader entered in the still form before the script loaded, and which field has
// the focus.
function readStillForm(stub, keys) {
  const fields = keys.map((key) => [key, stub.querySelector(`[id$="-${key}"]`)]);
  const usual = (one) =>
    one.defaultValue ?? (one.querySelector("[selected]") ?? one.options[0])?.value;
  const changed = fields.filter(([, one]) => one && one.value !== (usual(one) ?? ""));
  return {
    held: fields.find(([, one]) => one && one === document.activeElement)?.[0],
    patch: Object.fromEntries(changed.map(([key, one]) => [key, one.value])),
  };
}

// Load the question from the link, now and whenever the address changes.
function readLinks(one, stub) {
  const read = () => {
    const keys = one.arms.map(({ key }) => key);
    const { question, words } = parseQuestionLink(location.hash, keys);
    if (question || words) stub.scrollIntoView({ block: "start" });
    one.say(words);
    if (!question) return;
    one.start = EMPTY; // a link's fields are all the reader's own
    one.put(question);
  };
  addEventListener("hashchange", read);
  read();
}

/** The question, the typed answer and the verdict of one form. */
export class AnswerCheck {
  constructor(made, parts, { arms, examples, given }) {
    this.made = made;
    this.parts = parts;
    this.arms = arms;
    this.examples = examples;
    this.given = given;
    // What the page itself filled in.
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

  // An example is selected, to be typed over. On a phone the field is scrolled up so that the
  // verdict stays above the keyboard.
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
    setText(this.parts.said, words);
  }

  show() {
    const { question, made } = this;
    for (const [key, field] of Object.entries(made.fields)) {
      const text = question[key].length > MAX_SHOWN_LENGTH ? "" : question[key];
      if (field.value !== text) field.value = text;
    }
    adaptForm(made, question, this.arms);
  }

  read() {
    clearTimeout(this.timer);
    this.verdict = judgeQuestion(this.question, this.arms);
    const { report } = this.verdict;
    const wrong = report?.grade === "wrong" && !this.isExample();
    this.made.fields.answer.setAttribute("aria-invalid", String(wrong));
    for (const act of this.followers) act(this.question, this.verdict);
  }

  speak() {
    const advice = this.verdict.advice ?? [];
    const offers = advice.map((one) => makeOffer(one, this.question, this.arms));
    const fixed = (key) => this.made.boxes[key].classList.contains("given");
    const buttons = offers
      .filter((offer) => offer && !fixed(offer.key))
      .map((offer) => h("button", { onclick: () => this.take(offer) }, offer.words));
    showVerdict(this.parts.verdict, this.verdict, { example: this.isExample(), buttons });
  }

  // Apply an advice of the judge. After an advice about a symbol, the reader still types its value.
  take({ key, value }) {
    if (DEFAULT_FIELDS.includes(key)) this.turnTo({ [key]: value });
    else this.put({ [key]: value });
    if (key !== "values") return;
    this.made.folded.open = true;
    this.made.fields.values.focus();
  }

  set() {
    showReading(this.parts.taken, this.question, this.verdict);
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
    if (DEFAULT_FIELDS.includes(key)) return this.turnTo({ [key]: target.value });
    this.question = { ...this.question, [key]: target.value };
    this.show();
    clearTimeout(this.timer);
    if (inputType === "insertFromPaste" || inputType === "insertFromDrop") this.atOnce();
    else this.timer = setTimeout(() => this.soon(), READ_DELAY);
  }

  // Change the question, arm or unit: the page's own defaults are replaced, and the reader's
  // entries stay.
  turnTo(patch) {
    const { ask, arm, unit } = { ...this.question, ...patch };
    const typed = Object.entries(this.question).filter(([key, text]) => text !== this.start[key]);
    const own = Object.fromEntries(typed);
    this.start = { ...makeStartingQuestion({ ask, arm, unit }, this), ...this.given, arm };
    this.put({ ...this.start, ...own, ask, arm, unit, frame: "0" });
  }

  atOnce() {
    this.read();
    this.speak();
    this.timer = setTimeout(() => this.set()); // showing a long answer takes as long as judging it
  }

  soon() {
    this.read();
    this.set();
    this.timer = setTimeout(() => this.speak(), SPEAK_DELAY - READ_DELAY);
  }

  // Call `act` after each verdict.
  /** @param {(question: import("./question.js").Question, verdict: any) => void} act */
  follow(act) {
    this.followers.push(act);
  }
}

const makeParts = () => ({
  verdict: h("div.verdict", { role: "status", "aria-live": "polite", "aria-atomic": "true" }),
  report: h("div.report", { hidden: true }),
  taken: h("div.scroll.taken", {
    role: "region",
    tabindex: "0",
    "aria-label": "How your answer is read",
  }),
  tools: h("div.tools"),
  said: h("p.about", { role: "status" }),
  private: h("p.about", {}, PRIVACY_NOTE),
});
