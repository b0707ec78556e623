// The judge in the page: the question, the typed answer, its reading and the verdict. Nothing
// leaves the reader's machine.

import { h, setText } from "../dom.js";
import {
  canBeAsked,
  EMPTY,
  findQuestionFault,
  judgeQuestion,
  makeStartingQuestion,
} from "./question.js";
import {
  adaptForm,
  listNumberNames,
  makeOffer,
  nameQuestion,
  showTableReading,
  showWrenchHint,
} from "./form.js";
import { makeMarkedText } from "./marked_text.js";
import { makeMistakeLink } from "./explorer_link.js";
import { AnswerMemory, clearAnswers } from "./memory.js";
import { showOwnJoints } from "./own_joints.js";
import { showPath } from "./path_picture.js";
import { makeReadingView, showShortVerdict, showVerdict } from "./shown.js";

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
 * @property {string} book address of the book
 */
/** @typedef {HTMLInputElement | HTMLTextAreaElement | HTMLSelectElement} Control */
/** @typedef {InputEvent & { target: Control }} FieldEvent */

const MAX_SHOWN_LENGTH = 50_000; // characters; a longer answer is not shown in its field
const READ_DELAY = 120; // ms after the last key before the answer is read
const SPEAK_DELAY = 350; // ms after the last key before the verdict is announced
const PRIVACY_NOTE =
  "Nothing that you type leaves this machine: a script in this page judges, without a network " +
  "too, and your browser keeps your last answers until you clear them. " +
  "It names the mistake and does not print the solution. ";
const SHOW_NOTE = " in the explorer, beside what is right.";
const FORGET_QUESTION = "Forget all answers that you typed anywhere in this book?";
const FORGOTTEN_NOTE = "Forgotten: this browser keeps none of your answers.";
const DEFAULT_FIELDS = ["ask", "arm", "unit"]; // the defaults of the other fields depend on these

/** The question, the typed answer and the verdict of one form. */
export class AnswerCheck {
  /**
   * @param {ReturnType<typeof import("./form.js").buildForm>} form
   * @param {PageData} page
   */
  constructor(form, { arms, examples, given, scope, book }) {
    this.form = form;
    this.book = book;
    this.parts = makeParts(() => this.forgetAnswers());
    form.boxes.answer.querySelector(".over").after(this.parts.short);
    form.boxes.answer.append(this.parts.action);
    this.reading = makeReadingView();
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

  listParts() {
    const { verdict, show, joints, report, path, tools, notice, privacy } = this.parts;
    const outcome = h("div.outcome", {}, verdict, show, joints, report, path, this.reading.root);
    return [outcome, this.markedText.root, tools, notice, privacy];
  }

  // Show the page's own question. Judging its example takes as long as starting the form, so the
  // browser draws the form first.
  showFirstQuestion() {
    this.fillFields();
    this.timer = setTimeout(() => this.judgeAndShow());
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

  // Offer an action below the answer, until the question changes.
  offerAction(message, text, act) {
    this.parts.action.replaceChildren(`${message} `, h("button", { onclick: act }, text));
  }

  // Write the question into the fields.
  fillFields() {
    const { question, form } = this;
    for (const [key, field] of Object.entries(form.fields)) {
      const text = question[key].length > MAX_SHOWN_LENGTH ? "" : question[key];
      if (field.value !== text) field.value = text;
    }
    adaptForm(form, question, this.arms);
    const arm = this.arms.find(({ key }) => key === question.arm);
    showWrenchHint(form.boxes.wrench, this.hasExampleWrench(), arm);
    this.fillGrids();
  }

  fillGrids() {
    for (const [key, grid] of Object.entries(this.form.grids))
      grid.update(listNumberNames(key, this.question, this.arms), this.question[key]);
  }

  judge() {
    clearTimeout(this.timer);
    this.outcome = judgeQuestion(this.question, this.arms, {
      isConfigurationFixed: Boolean(this.given?.q),
    });
    showTableReading(this.form, this.outcome);
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
    showShortVerdict(this.parts.short, this.outcome, this.isExample());
  }

  // Apply advice of the judge. After advice about the arm, the answer is kept. After advice about a
  // symbol, the reader still types its value.
  applyOffer({ key, value }) {
    const { answer, q } = this.question;
    if (DEFAULT_FIELDS.includes(key)) this.changeQuestion({ [key]: value });
    else this.updateQuestion({ [key]: value });
    if (key === "arm") this.updateQuestion({ answer, q });
    this.saveQuestion();
    if (key !== "values") return;
    this.form.folded.open = true;
    this.form.fields.values.focus();
  }

  showDetails() {
    const { joints } = this.parts;
    showOwnJoints(joints, this.question, this.outcome, (rows) => this.useJoints(rows));
    showPath(this.parts.path, this.question, this.outcome);
    this.showMistakeLink();
    this.reading.update(this.question, this.outcome);
    this.markedText.update(this.question, this.outcome, this.isExample());
  }

  // Link to the explorer, which shows the mistake beside the right arm.
  showMistakeLink() {
    const { show } = this.parts;
    const fragment = makeMistakeLink(this.question, this.outcome, this.arms);
    show.hidden = !fragment;
    show.querySelector("a").href = new URL(`explorer.html${fragment}`, this.book).href;
  }

  judgeAndShow() {
    this.judge();
    this.announceVerdict();
    this.showDetails();
  }

  updateQuestion(patch) {
    this.parts.action.replaceChildren();
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
    if (!this.isExample()) this.memory.save(this.question, this.#listTypedFields().length > 0);
  }

  // List the fields that the reader typed, with their texts.
  #listTypedFields() {
    return Object.entries(this.question).filter(([key, text]) => text !== this.start[key]);
  }

  // Start with a question that the page filled in.
  startQuestion(question) {
    this.start = question;
    this.updateQuestion(question);
  }

  // Restore the reader's last answer. Returns false if there is none.
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

  // Clear this answer, which a button brings back.
  clearAnswer() {
    const { answer } = this.question;
    dropLink();
    this.editQuestion({ answer: "" });
    if (answer) this.offerAction("Cleared.", "Undo", () => this.editQuestion({ answer }));
  }

  // Forget all answers of the book, here and in other tabs, if the reader confirms it.
  forgetAnswers() {
    if (!confirm(FORGET_QUESTION)) return;
    clearAnswers();
    dropLink();
    this.resetQuestion();
    this.notify(FORGOTTEN_NOTE);
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

  // Store what the reader types into a field, and judge it after a pause.
  typeInto(key, text) {
    this.parts.action.replaceChildren();
    this.question = { ...this.question, [key]: text };
    this.fillFields();
    this.saveQuestion();
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.judgeAfterTyping(), READ_DELAY);
  }

  // Change the question, arm or unit. The page's own defaults are replaced, and the reader's
  // settings stay. Each question about each arm has its own answer, and each arm its own joint
  // values.
  changeQuestion(patch) {
    const before = this.question;
    const { ask, unit, arm: chosen } = { ...before, ...patch };
    const arm = this.#chooseArm(ask, chosen);
    const isSameArm = arm === before.arm;
    const next = { ask, arm, unit, joints: isSameArm ? before.joints : "" };
    const typed = Object.fromEntries(this.#listTypedFields());
    if (isSameArm && ask === before.ask) return this.#startAnew(next, typed);
    const { answer, q, ...settings } = typed;
    if (!this.#restoreStored(next))
      this.#startAnew(next, isSameArm && q !== undefined ? { ...settings, q } : settings);
    if (!answer || (this.question.answer && !this.isExample())) return;
    const message = `Your answer to “${nameQuestion(before, this.arms)}” stays there.`;
    this.offerAction(message, "Use it here", () => this.editQuestion({ answer }));
  }

  #startAnew(next, typed) {
    this.start = { ...makeStartingQuestion(next, this), ...this.given, arm: next.arm };
    this.updateQuestion({ ...this.start, ...typed, ...next, frame: "0" });
  }

  // Restore a stored question, if its answer was typed in the same joint angles.
  #restoreStored({ ask, arm, joints }) {
    const stored = this.memory.load({ ask, arm });
    return Boolean(stored) && (stored.joints ?? "") === joints && this.#restoreQuestion(stored);
  }

  // Return the key of an arm that can be asked about: the chosen one, or the first of the list.
  #chooseArm(ask, key) {
    const isPossible = (listed) => canBeAsked(ask, listed);
    const chosen = this.arms.find((listed) => listed.key === key);
    if (!chosen || isPossible(chosen)) return key;
    return this.arms.find(isPossible)?.key ?? key;
  }

  // Use the joint angles of the reader's table from now on, or those of the arm's own table if
  // `joints` is empty. The page's own configuration is converted.
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

// Drop a question from the page's address, so that a reload does not bring it back.
function dropLink() {
  if (location.hash.startsWith("#ask="))
    history.replaceState(null, "", location.pathname + location.search);
}

const makeParts = (/** @type {() => void} */ onForget) => ({
  short: h("p.short", { "aria-hidden": "true" }),
  action: h("p.offer", { role: "status" }),
  verdict: h("div.verdict", { role: "status", "aria-live": "polite", "aria-atomic": "true" }),
  show: h("p.show", { hidden: true }, h("a.button", { href: "" }, "Show it"), SHOW_NOTE),
  joints: h("div", { hidden: true }),
  report: h("div.report", { hidden: true }),
  path: h("div", { hidden: true }),
  tools: h("div.tools"),
  notice: h("p.about", { role: "status" }),
  privacy: h(
    "p.about.privacy",
    {},
    PRIVACY_NOTE,
    h("button", { onclick: onForget }, "Forget everything"),
  ),
});
