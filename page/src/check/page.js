// The judge in the page: the question, the typed answer, its reading and the verdict. Nothing
// leaves the reader's machine.

import { WRONG } from "../../../judge/digits.js";
import { h, setText } from "../dom.js";
import {
  EMPTY,
  findQuestionFault,
  judgeQuestion,
  makeStartingQuestion,
  parseQuestionLink,
} from "./question.js";
import { addFileInput } from "./files.js";
import {
  adaptForm,
  buildForm,
  listNumberNames,
  makeOffer,
  showTableReading,
  showWrenchHint,
} from "./form.js";
import { addReportButton } from "./hand_in.js";
import { makeMarkedText } from "./marked_text.js";
import { AnswerMemory, clearAnswers } from "./memory.js";
import { showOwnJoints } from "./own_joints.js";
import { showPath } from "./path_picture.js";
import { showReading, showVerdict } from "./shown.js";
import { readStillForm, restoreFocus } from "./still_form.js";
import { addToolButtons } from "./tools.js";

/** @typedef {import("./question.js").Question} Question */
/** @typedef {import("./question.js").Outcome} Outcome */
/** @typedef {import("./question.js").ListedArm} ListedArm */
/**
 * The arms, examples and fixed fields of a form.
 * @typedef {object} PageData
 * @property {ListedArm[]} arms
 * @property {Question[]} examples
 * @property {Partial<Question>} [given] fields that a chapter fixes
 * @property {string} scope name of the form in the browser's storage
 */
/** @typedef {InputEvent & { target: import("./still_form.js").Control }} FieldEvent */

const MAX_SHOWN_LENGTH = 50_000; // characters; a longer answer is not shown in its field
const READ_DELAY = 120; // ms after the last key before the answer is read
const SPEAK_DELAY = 350; // ms after the last key before the verdict is announced
const PRIVACY_NOTE =
  "Nothing that you type leaves this machine: a script in this page judges, without a network " +
  "too, and your browser keeps your last answers until you clear them. " +
  "It names the mistake and does not print the solution.";
const CLEARED_NOTE = "Cleared: this browser keeps none of your answers.";
// Events by which the reader turns to the form.
const TURNING_EVENTS = ["pointerover", "touchstart", "focusin", "input"];
const DEFAULT_FIELDS = ["ask", "arm", "unit"]; // the defaults of the other fields depend on these

/**
 * Mount the form into a stub. A chapter's `given` fields are not asked, and its form is smaller.
 * @param {HTMLElement} stub
 * @param {string} book address of the book
 * @param {string} id
 */
export function mount(stub, book, id) {
  const { arms, examples = [], given } = JSON.parse(stub.querySelector("script").textContent);
  const form = buildForm(id, arms, given);
  const check = new AnswerCheck(form, { arms, examples, given, scope: nameScope(given, id) });
  const handleInput = (/** @type {FieldEvent} */ event) => check.handleInput(event);
  form.form.addEventListener("input", handleInput);
  form.form.addEventListener("submit", (event) => event.preventDefault());
  addToolButtons(check, book);
  addFileInput(check, stub);
  addReportButton(check);
  const { focus, patch } = readStillForm(stub, Object.keys(form.fields));
  const isLinked = !given && readLinks(check, stub);
  const isAnswered = isLinked || (!("answer" in patch) && check.restoreLastAnswer());
  const isUntouched = !isAnswered && !Object.keys(patch).length;
  if (!isUntouched || !keepStillVerdict(check, stub)) replaceStillForm(check, stub, patch);
  restoreFocus(form.fields, focus);
}

// Show the form with its verdict, and what the reader entered in the still form.
function replaceStillForm(check, stub, patch) {
  const { beside, below } = groupParts(check);
  stub.replaceChildren(h("div.desk", {}, check.form.form, ...beside), ...below);
  if (DEFAULT_FIELDS.some((key) => key in patch)) check.changeQuestion(patch);
  check.updateQuestion(patch);
}

// Return the parts that stand beside the form, and those below both.
function groupParts({ parts, markedText }) {
  const { verdict, joints, report, path, reading, tools, notice, privacy } = parts;
  const outcome = h("div.outcome", {}, verdict, joints, report, path, reading);
  return { beside: [outcome, markedText.root], below: [tools, notice, privacy] };
}

// Keep the verdict on the example, which the build has written, until the reader turns to the form:
// judging it anew is the longest task of the page. Returns false if the stub has no built form.
function keepStillVerdict(check, stub) {
  const desk = stub.querySelector(".desk");
  if (!desk) return false;
  desk.querySelector("form").replaceWith(check.form.form);
  stub.querySelector(":scope > .unscripted")?.remove();
  check.fillFields();
  const waiting = new AbortController();
  const options = { signal: waiting.signal, capture: true };
  for (const type of TURNING_EVENTS)
    stub.addEventListener(type, () => check.judgeAndShow(), options);
  check.onVerdict(() => {
    if (!waiting.signal.aborted) replaceStillParts(check, stub, desk);
    waiting.abort();
  });
  return true;
}

// Replace all parts but the form, which may have the focus.
function replaceStillParts(check, stub, desk) {
  const { beside, below } = groupParts(check);
  for (const part of [...desk.children].slice(1)) part.remove();
  for (const part of [...stub.children]) if (part !== desk) part.remove();
  desk.append(...beside);
  stub.append(...below);
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

/** The question, the typed answer and the verdict of one form. */
export class AnswerCheck {
  /**
   * @param {ReturnType<typeof buildForm>} form
   * @param {PageData} page
   */
  constructor(form, { arms, examples, given, scope }) {
    this.form = form;
    this.parts = makeParts();
    this.arms = arms;
    this.examples = examples;
    this.given = given;
    this.memory = new AnswerMemory(scope);
    this.memory.onClear(() => this.resetQuestion());
    this.markedText = makeMarkedText((answer) => this.editQuestion({ answer }));
    /** @type {Question} what the page itself filled in */
    this.start = this.makeFirstQuestion();
    this.question = this.start;
    /** @type {Outcome} */
    this.outcome = {};
    this.listeners = [];
    /** @type {ReturnType<typeof setTimeout>} */
    this.timer = undefined;
    for (const [key, grid] of Object.entries(form.grids))
      grid.onChange = (text) => this.typeInto(key, text);
    form.fields.answer.addEventListener("focus", () => this.raiseAnswerField());
    globalThis.visualViewport?.addEventListener("resize", () => this.raiseAnswerField());
  }

  makeFirstQuestion() {
    return { ...EMPTY, arm: this.arms[0]?.key, ...(this.given ?? this.examples[0]) };
  }

  // Select an example, so that typing replaces it. On a phone, scroll the field up so that the
  // verdict stays above the keyboard.
  raiseAnswerField() {
    const { answer } = this.form.fields;
    if (document.activeElement !== answer) return;
    if (this.isExample()) answer.select();
    if (matchMedia("(pointer: coarse)").matches)
      this.form.boxes.answer.scrollIntoView({ block: "start" });
  }

  isExample() {
    return Boolean(this.start.answer) && this.question.answer === this.start.answer;
  }

  hasExampleWrench() {
    const { wrench, answer } = this.start;
    return Boolean(answer && wrench) && this.question.wrench === wrench;
  }

  notify(message) {
    setText(this.parts.notice, message);
  }

  // Write the question into the fields.
  fillFields() {
    const { question, form } = this;
    for (const [key, field] of Object.entries(form.fields)) {
      const text = question[key].length > MAX_SHOWN_LENGTH ? "" : question[key];
      if (field.value !== text) field.value = text;
    }
    adaptForm(form, question, this.arms);
    showWrenchHint(form.boxes.wrench, this.hasExampleWrench());
    this.fillGrids();
  }

  fillGrids() {
    for (const [key, grid] of Object.entries(this.form.grids))
      grid.update(listNumberNames(key, this.question, this.arms), this.question[key]);
  }

  judge() {
    clearTimeout(this.timer);
    this.outcome = judgeQuestion(this.question, this.arms);
    showTableReading(this.form.boxes.table, this.outcome.arm);
    const isWrong = this.outcome.verdict?.grade === "wrong" && !this.isExample();
    this.form.fields.answer.setAttribute("aria-invalid", String(isWrong));
    for (const listener of this.listeners) listener(this.question, this.outcome);
  }

  announceVerdict() {
    const advice = this.outcome.advice ?? [];
    const isFixed = (key) => this.form.boxes[key].classList.contains("fixed-field");
    const buttons = advice
      .map((item) => makeOffer(item, this.question, this.arms))
      .filter((offer) => offer && !isFixed(offer.key))
      .map((offer) => h("button", { onclick: () => this.applyOffer(offer) }, offer.text));
    showVerdict(this.parts.verdict, this.outcome, { example: this.isExample(), buttons });
  }

  // Apply an advice of the judge. After an advice about a symbol, the reader still types its value.
  applyOffer({ key, value }) {
    if (DEFAULT_FIELDS.includes(key)) this.changeQuestion({ [key]: value });
    else this.updateQuestion({ [key]: value });
    this.saveQuestion();
    if (key !== "values") return;
    this.form.folded.open = true;
    this.form.fields.values.focus();
  }

  showDetails() {
    const { joints } = this.parts;
    showOwnJoints(joints, this.question, this.outcome, (rows) => this.useJoints(rows));
    showPath(this.parts.path, this.question, this.outcome);
    showReading(this.parts.reading, this.question, this.outcome);
    this.markedText.update(this.question, this.outcome, this.isExample());
  }

  judgeAndShow() {
    this.judge();
    this.announceVerdict();
    this.showDetails();
  }

  updateQuestion(patch) {
    this.question = { ...this.question, ...patch };
    this.fillFields();
    this.judgeAndShow();
  }

  // Change fields for the reader, and keep the result.
  editQuestion(patch) {
    this.updateQuestion(patch);
    this.saveQuestion();
  }

  saveQuestion() {
    if (!this.isExample()) this.memory.save(this.question);
  }

  // Start with a question that the page filled in.
  startQuestion(question) {
    this.start = question;
    this.updateQuestion(question);
  }

  // Bring back the reader's last answer. Returns false if there is none.
  restoreLastAnswer() {
    return this.#restoreQuestion(this.memory.loadLast());
  }

  #restoreQuestion(kept) {
    const question = { ...EMPTY, ...kept, ...this.given };
    const keys = this.arms.map(({ key }) => key);
    if (!kept || findQuestionFault(question, keys)) return false;
    this.start = { ...makeStartingQuestion(question, this), ...this.given };
    this.updateQuestion(question);
    return true;
  }

  // Forget all answers of the book, here and in other tabs.
  forgetAnswers() {
    clearAnswers();
    if (location.hash.startsWith("#ask="))
      history.replaceState(null, "", location.pathname + location.search);
    this.resetQuestion();
    this.notify(CLEARED_NOTE);
  }

  resetQuestion() {
    this.startQuestion(this.makeFirstQuestion());
  }

  /** @param {FieldEvent} event */
  handleInput({ target, inputType }) {
    const { fields } = this.form;
    const key = Object.keys(fields).find((name) => fields[name] === target);
    if (!key) return;
    if (DEFAULT_FIELDS.includes(key)) return this.changeQuestion({ [key]: target.value });
    this.typeInto(key, target.value);
    if (inputType === "insertFromPaste" || inputType === "insertFromDrop") this.judgeAtOnce();
  }

  // Take over what the reader types into a field, and judge it after a pause.
  typeInto(key, text) {
    this.question = { ...this.question, [key]: text };
    this.fillFields();
    this.saveQuestion();
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.judgeAfterTyping(), READ_DELAY);
  }

  // Change the question, arm or unit. The page's own defaults are replaced, and the reader's
  // entries stay. A different question brings back its stored answer if that was typed in the same
  // joint angles. The joint angles of a table belong to one arm.
  changeQuestion(patch) {
    const { ask, arm, unit } = { ...this.question, ...patch };
    const joints = arm === this.question.arm ? this.question.joints : "";
    const kept = ask === this.question.ask ? null : this.memory.load({ ask, arm });
    if (kept && (kept.joints ?? "") === joints && this.#restoreQuestion(kept)) return;
    const typed = Object.entries(this.question).filter(([key, text]) => text !== this.start[key]);
    const entries = Object.fromEntries(typed);
    // A right answer stays with its question. Any other answer was perhaps pasted below the wrong
    // question, so it is kept.
    if (ask !== this.question.ask && this.hasRightAnswer()) delete entries.answer;
    this.start = { ...makeStartingQuestion({ ask, arm, unit, joints }, this), ...this.given, arm };
    this.updateQuestion({ ...this.start, ...entries, ask, arm, unit, joints, frame: "0" });
  }

  hasRightAnswer() {
    const { verdict } = this.outcome;
    return Boolean(verdict) && verdict.grade !== WRONG;
  }

  // Ask in the joint angles of the reader's table from now on; "" for the arm's own. A
  // configuration that the page filled in is written in the new angles.
  useJoints(joints) {
    const { ask, arm, unit, q } = this.question;
    const isHome = q === this.start.q;
    const { q: home } = makeStartingQuestion({ ask, arm, unit, joints }, this);
    this.start = { ...this.start, joints, ...(isHome ? { q: home } : {}) };
    this.editQuestion({ joints, ...(isHome ? { q: home } : {}) });
  }

  judgeAtOnce() {
    this.judge();
    this.announceVerdict();
    this.timer = setTimeout(() => this.showDetails()); // takes as long as judging a long answer
  }

  judgeAfterTyping() {
    this.judge();
    this.showDetails();
    this.timer = setTimeout(() => this.announceVerdict(), SPEAK_DELAY - READ_DELAY);
  }

  /**
   * Call a function after each verdict.
   * @param {(question: Question, outcome: Outcome) => void} listener
   */
  onVerdict(listener) {
    this.listeners.push(listener);
  }
}

const makeParts = () => ({
  verdict: h("div.verdict", { role: "status", "aria-live": "polite", "aria-atomic": "true" }),
  joints: h("div", { hidden: true }),
  report: h("div.report", { hidden: true }),
  path: h("div", { hidden: true }),
  reading: h("div.scroll.taken", {
    role: "region",
    tabindex: "0",
    "aria-label": "How your answer is read",
  }),
  tools: h("div.tools"),
  notice: h("p.about", { role: "status" }),
  privacy: h("p.about", {}, PRIVACY_NOTE),
});
