// The judge in the page: the question, what is typed, how it is read, and the verdict in words. Nothing leaves it.

import { joints } from "../kinematics.js";
import { h, write } from "../dom.js";
import { asPython, ASKED, EMPTY, fromFragment, judge, OWN, toFragment, UNITS } from "./ask.js";
import { turning } from "./door.js";
import { linesOf, MARKS } from "./ranking.js";
import { ready } from "./registry.js";
import { ArmError } from "./say.js";

const PAUSE = 350; // ms without a key before the verdict is spoken
const ROWS = {
  v: ["vx", "vy", "vz", "ωx", "ωy", "ωz"],
  omega: ["ωx", "ωy", "ωz", "vx", "vy", "vz"],
};
const HINTS = {
  jacobian:
    "Numbers or formulas in q_1, c_1, s_23, …: NumPy, MATLAB, LaTeX, Markdown, CSV or spreadsheet cells.",
  torques:
    "One torque for each joint in N m (N where it slides), from NumPy, MATLAB, LaTeX, CSV or a spreadsheet.",
};
let count = 0; // of judges on the page, for ids

/**
 * Bring a stub to life: `arms` is a list of arms with a key, a title and the call in Python.
 * @param {HTMLElement} stub
 */
export function mount(stub) {
  const { arms, examples } = JSON.parse(stub.querySelector("script").textContent);
  const made = build(`judge-${++count}`, arms);
  const { fields, parts } = made;
  let question = { ...EMPTY, ...examples[0] };
  let timer = 0;

  const show = () => {
    for (const [key, field] of Object.entries(fields))
      if (field.value !== question[key]) field.value = question[key];
    adapt(made, question, arms);
  };
  const answer = () => tell(made, question, judged());
  const judged = () => {
    const verdict = judge(question, arms);
    if (verdict.waiting) ready(question.ask).then(answer, ({ message }) => say(message));
    return verdict;
  };
  const changed = ({ target, inputType }) => {
    const key = Object.keys(fields).find((one) => fields[one] === target);
    question = { ...question, [key]: target.value };
    if (key === "arm") question.frame = "0";
    if (key === "arm" || key === "ask") question.q = examples.find(matches(question))?.q ?? question.q;
    show();
    const verdict = judged();
    const speak = () => tell(made, question, verdict);
    clearTimeout(timer);
    if (inputType === "insertFromPaste" || inputType === "insertFromDrop") return speak();
    preview(made, question, verdict);
    timer = setTimeout(speak, PAUSE);
    return undefined;
  };
  made.form.addEventListener("input", changed);
  made.form.addEventListener("submit", (event) => event.preventDefault());

  const say = (words) => write(parts.said, words);
  parts.link.addEventListener("click", async () => {
    history.replaceState(null, "", toFragment(question));
    say((await copied(location.href)) ? "The link is copied." : "The link stands in the address bar.");
  });
  parts.python.addEventListener("click", async () => {
    try {
      const text = asPython(question, arms);
      if (await copied(text)) return say("The call is copied.");
      parts.call.textContent = text;
      parts.call.parentElement.hidden = false;
      return say("The clipboard is closed to this page; the call stands below.");
    } catch (error) {
      if (error instanceof ArmError) return say(error.message);
      throw error;
    }
  });
  parts.example.addEventListener("click", () => {
    question = {
      ...EMPTY,
      ...(examples.find(matches(question)) ?? examples.find(({ ask }) => ask === question.ask)),
    };
    show();
    answer();
  });

  const read = () => {
    const { question: asked, words } = fromFragment(location.hash, arms.map(({ key }) => key)); // prettier-ignore
    if (asked) question = asked;
    if (asked || words) stub.scrollIntoView({ block: "start" });
    say(words);
    show();
    answer();
  };
  addEventListener("hashchange", read);
  stub.replaceChildren(...made.root);
  read();
}

const matches = (question) => (one) => one.arm === question.arm && one.ask === question.ask;

async function copied(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}

const option = ([value, words]) => h("option", { value }, words);

function field(id, label, control, ...more) {
  const name = typeof label === "string" ? h("label", { for: id }, label) : label;
  control.id = id;
  return h("div.field", {}, name, control, ...more);
}

function build(id, arms) {
  const plain = { spellcheck: "false", autocomplete: "off", autocapitalize: "off" };
  const fields = {
    ask: h("select", {}, Object.entries(ASKED).map(([key, { title }]) => option([key, title]))),
    arm: h("select", {}, arms.map(({ key, title }) => option([key, title])), option([OWN, "My own table"])),
    table: h("textarea", { rows: "6", wrap: "off", ...plain, "aria-describedby": `${id}-table-hint` }),
    q: h("input", { ...plain, "aria-describedby": `${id}-q-hint` }),
    unit: h("select", { "aria-label": "Unit of the angles" }, UNITS.map((unit) => option([unit, unit]))),
    frame: h("select"),
    first: h("select", {}, [["v", "v, then ω"], ["omega", "ω, then v"]].map(option)),
    wrench: h("input", { ...plain, "aria-describedby": `${id}-wrench-hint` }),
    answer: h("textarea", { rows: "8", wrap: "off", ...plain, "aria-describedby": `${id}-answer-hint ${id}-private` }),
  }; // prettier-ignore
  const hint = (key, words) => h("p.about", { id: `${id}-${key}-hint` }, words);
  const parts = {
    table: field(
      `${id}-table`,
      "Table",
      fields.table,
      hint(
        "table",
        "A row for each joint: a, α, d, θ, with θ or d as “q1” or “θ1 + π/2”. In m; angles as chosen.",
      ),
    ),
    qHint: hint("q", ""),
    frame: field(`${id}-frame`, "Rows in the axes of", fields.frame),
    first: field(`${id}-first`, "Order of the rows", fields.first),
    wrench: field(
      `${id}-wrench`,
      "Wrench on the tool, by the world",
      fields.wrench,
      hint(
        "wrench",
        "Fx, Fy, Fz in N, Mx, My, Mz in N m, in base axes; empty for none. Gravity is 9.81 m/s² down.",
      ),
    ),
    hint: hint("answer", ""),
    verdict: h("div.verdict", { role: "status", "aria-live": "polite", "aria-atomic": "true" }),
    taken: h("div.scroll", { role: "region", tabindex: "0", "aria-label": "How your answer is read" }),
    said: h("p.about", { role: "status" }),
    link: h("button", { type: "button" }, "Copy link"),
    python: h("button", { type: "button" }, "Copy as Python"),
    example: h("button", { type: "button" }, "Show an example"),
    explorer: h("a", { href: "explorer.html" }, "See this pose in the explorer"),
    call: h("code"),
  };
  parts.table.classList.add("whole");
  parts.wrench.classList.add("whole");
  const pose = h(
    "div.field.whole", {},
    h("label", { for: `${id}-q` }, "Pose q"),
    h("div.pair", {}, Object.assign(fields.q, { id: `${id}-q` }), fields.unit), parts.qHint,
  ); // prettier-ignore
  const typed = field(`${id}-answer`, "Your answer", fields.answer, parts.hint);
  typed.classList.add("whole");
  const form = h(
    "form", { "aria-label": "Check an answer" },
    field(`${id}-ask`, "Question", fields.ask), field(`${id}-arm`, "Arm", fields.arm),
    parts.table, pose, parts.frame, parts.first, parts.wrench, typed,
  ); // prettier-ignore
  const words =
    "Nothing that you type leaves this page: a script in it judges, without a network too. " +
    "It names the mistake and does not print the solution.";
  const root = [
    form,
    parts.verdict,
    parts.taken,
    h("div.tools", {}, parts.example, parts.link, parts.python, parts.explorer),
    parts.said,
    h("pre", { hidden: true, tabindex: "0" }, parts.call),
    h("p.private", { id: `${id}-private` }, words),
  ];
  return { form, fields, parts, root };
}

// Show the fields that the question has, and what the arm says about them.
function adapt({ fields, parts }, question, arms) {
  const own = question.arm === OWN;
  parts.table.hidden = !own;
  for (const key of ["frame", "first", "wrench"])
    parts[key].hidden = !ASKED[question.ask].fields.includes(key);
  write(parts.hint, HINTS[question.ask]);
  const arm = arms.find(({ key }) => key === question.arm);
  const names = arm ? joints(arm).map((i) => `q_${i + 1}`) : null;
  const slides = arm && turning(arm).includes(false) ? "; m where a joint slides" : "";
  write(
    parts.qHint,
    names ? `${names.join(", ")}${slides}` : "One value for each joint, in the table's order.",
  );
  const frames = arm ? arm.rows.length : 16;
  if (fields.frame.options.length !== frames + 1) {
    const name = (k) => (k ? `frame ${k}` : "the base");
    fields.frame.replaceChildren(
      ...Array.from({ length: frames + 1 }, (_, k) => option([String(k), name(k)])),
    );
  }
  fields.frame.value = question.frame;
}

// What stands in the answer as it is understood, cell by cell; wrong ones are marked.
/**
 * @param {any} made
 * @param {ReturnType<typeof judge>} verdict
 */
function preview({ parts, fields }, question, verdict) {
  const { report, arm, q } = verdict;
  const typed = report?.typed;
  parts.explorer.hidden = !arm || !q || question.arm === OWN || !arm.explorer;
  if (!parts.explorer.hidden) {
    const view = question.ask === "torques" ? "torque" : "jacobian";
    const fragment = new URLSearchParams({
      arm: arm.explorer,
      q: q.map((x) => Number(x.toFixed(6))).join(","),
      view,
    });
    parts.explorer.href = `explorer.html#${fragment}`;
  }
  fields.answer.setAttribute("aria-invalid", String(report?.grade === "wrong"));
  parts.taken.hidden = !typed || typed.shape.length !== 2;
  if (parts.taken.hidden) return;
  const [rows, width] = question.ask === "torques" ? [1, typed.values.length] : typed.shape;
  const wrong = report.wrong?.length === typed.values.length ? report.wrong : [];
  const numbers = joints(arm).map((i) => i + 1);
  const above = (k) => (numbers.length === width ? `joint ${numbers[k]}` : String(k + 1));
  const left = question.ask === "torques" ? ["τ"] : rows === 6 ? ROWS[question.first] : [];
  const head = h(
    "tr",
    {},
    h("td"),
    Array.from({ length: width }, (_, k) => h("th", { scope: "col" }, above(k))),
  );
  const body = Array.from({ length: Math.min(rows, 40) }, (_, i) =>
    h(
      "tr", {}, h("th", { scope: "row" }, left[i] ?? `row ${i + 1}`),
      Array.from({ length: width }, (_, k) => cell(typed, i * width + k, wrong)),
    ),
  ); // prettier-ignore
  parts.taken.replaceChildren(
    h("table", {}, h("caption", {}, "How your answer is read"), h("thead", {}, head), h("tbody", {}, body)),
  );
}

function cell({ values, units }, i, wrong) {
  const decimals = units[i] ? Math.max(0, Math.round(-Math.log10(units[i]))) : 4;
  const text = (Number(values[i].toFixed(Math.min(decimals, 6))) + 0)
    .toFixed(Math.min(decimals, 6))
    .replace("-", "−");
  return wrong[i] ? h("td.off", {}, h("span.unseen", {}, "wrong: "), text) : h("td", {}, text);
}

function tell(made, question, verdict) {
  preview(made, question, verdict);
  const { report, error } = verdict;
  const { verdict: box } = made.parts;
  box.className = `verdict ${report?.grade ?? ""}`;
  if (!report) return box.replaceChildren(h("p", {}, typeset(error)));
  const lines = linesOf(report).filter((line) => !report.headline.endsWith(line.slice(1)));
  const list = lines.length ? [h("ul", {}, lines.map((line) => h("li", {}, typeset(line))))] : []; // prettier-ignore
  const mark = h("span", { "aria-hidden": "true" }, `${MARKS[report.grade]} `);
  return box.replaceChildren(h("p.headline", {}, mark, typeset(report.headline)), ...list);
}

const SYMBOL = /(?<!\w)([A-Za-z]|theta|alpha)_(?:\{([^}]+)\}|(\w+))(?![\w=])/g;
const LETTERS = { theta: "θ", alpha: "α" };

// A sentence with its symbols set: z_{i-1} as a letter and an index.
function typeset(words) {
  const parts = [];
  let at = 0;
  for (const match of words.matchAll(SYMBOL)) {
    const [whole, letter, braced, bare] = match;
    parts.push(words.slice(at, match.index), h("i", {}, LETTERS[letter] ?? letter));
    parts.push(h("sub", {}, (braced ?? bare).replace("-", "−")));
    at = match.index + whole.length;
  }
  return [...parts, words.slice(at)];
}
