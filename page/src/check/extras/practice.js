// Practice: questions of the series by number, judged by the form below them. How many were solved
// in a row is kept in this browser only where the reader asks for it.

import { h, write } from "../../dom.js";
import { joints, linkFrames } from "../../../../judge/geometry/kinematics.js";
import { ASKED, EMPTY, LONGEST_ANSWER, toFragment } from "../question.js";
import { typeset } from "../shown.js";
import { angle, LAST, questionOf, TOPICS } from "./series.js";

const KEPT = "practice-streak";
const LINK = /^#practice=([a-z]+):(\d{1,6})(?:&answer=([^&]*))?$/;

/**
 * What a link asks: the topic, the number and an answer; null where it is no practice link.
 * @param {string} hash
 */
export function fromLink(hash) {
  const match = LINK.exec(hash);
  if (!match || !TOPICS.includes(match[1]) || hash.length > LONGEST_ANSWER) return null;
  const answer = new URLSearchParams(`answer=${match[3] ?? ""}`).get("answer");
  return { topic: match[1], number: Number(match[2]), answer };
}

/** @param {import("../page.js").Judge} judge */
export function addPractice(judge) {
  const { boxes, stub, arms } = judge;
  const topic = h(
    "select",
    {},
    TOPICS.map((key) => h("option", { value: key }, ASKED[key].title)),
  );
  const number = h("input", { type: "number", min: "1", max: String(LAST), value: "1" });
  const keep = h("input", { type: "checkbox" });
  const problem = h("div.problem", { tabindex: "-1" });
  const streak = h("p.about", { role: "status" });
  const named = (words, control) => h("label.field", {}, words, control);
  const button = (words, onclick) => h("button", { type: "button", onclick }, words);
  const place = h(
    "details.practice",
    {},
    h("summary", {}, "Practice without end"),
    h("p.about", {}, ABOUT),
    h(
      "div.choice",
      {},
      named("Topic", topic),
      named("Number", number),
      button("Ask me", () => ask(topic.value, Number(number.value))),
      button("Next question", () => ask(topic.value, Number(number.value) + 1)),
    ),
    problem,
    streak,
    h("label.keep", {}, keep, " Keep how many I solved in a row in this browser"),
  );
  let posed = null;
  let solved = false;
  let row = kept();
  keep.checked = row > 0;

  const count = () => {
    write(streak, row ? `Solved in a row: ${row}.` : "");
    keepStreak(keep.checked ? row : 0);
  };
  function ask(key, n, answer = "") {
    if (posed && !solved) row = 0;
    const which = Math.max(1, Math.min(LAST, Math.floor(n) || 1));
    posed = { key, n: which, ...questionOf(key, which, arms) };
    solved = false;
    [topic.value, number.value] = [key, String(which)];
    place.open = true;
    problem.replaceChildren(...wordsOf(posed));
    count();
    judge.put({ ...EMPTY, ...posed.asked, answer });
    problem.focus();
  }
  const changed = (question) =>
    Object.entries(posed.asked).some(([key, value]) => question[key] !== value);
  judge.follow((question, { report }) => {
    if (posed && changed(question)) {
      posed = null;
      problem.replaceChildren(h("p", {}, "The fields below ask something else now."));
    }
    for (const key of ["ask", "arm", "table"]) boxes[key].classList.toggle("given", Boolean(posed));
    if (!posed || solved || report?.grade !== "right") return;
    solved = true;
    row++;
    count();
  });
  keep.addEventListener("change", count);
  judge.links.fragment = () => {
    const question = judge.question();
    const work = question.answer ? `&answer=${encodeURIComponent(question.answer)}` : "";
    return posed ? `#practice=${posed.key}:${posed.n}${work}` : toFragment(question);
  };
  judge.links.open = () => posed?.key !== "table"; // its table would be the solution
  const byLink = () => {
    const asked = fromLink(location.hash);
    if (!asked) return;
    ask(asked.topic, asked.number, asked.answer);
    stub.scrollIntoView({ block: "start" });
  };
  stub.prepend(place);
  count();
  addEventListener("hashchange", byLink);
  byLink();
}

const ABOUT =
  "Every number is another question, the same for everybody. Solve one in the form below; the next one waits. " +
  "A course draws its own from a secret; none of them is here.";

function kept() {
  try {
    return Math.max(0, Number(localStorage.getItem(KEPT)) || 0);
  } catch {
    return 0; // no storage in this browser
  }
}

function keepStreak(row) {
  try {
    if (row) localStorage.setItem(KEPT, String(row));
    else localStorage.removeItem(KEPT);
  } catch {
    // nothing is kept then
  }
}

// The question in words

const vector = (text) => `(${text.replaceAll("-", "−")})`;
const numbers = (values) => vector(values.map((v) => String(Number(v.toFixed(4)) + 0)).join(", "));

const SAID = {
  jacobian: ({ q }) =>
    `Write the Jacobian of the tip, rows (v, ω) in base axes, at q = ${vector(q)}.`,
  torques: ({ q, wrench }) =>
    `Which joint torques hold the arm at q = ${vector(q)} while the world acts on its tip with the wrench ` +
    `${vector(wrench)} (N and N m, base axes)? Take 9.81 m/s², down.`,
  branches: () => "Find all joint angles that bring the tip there, a row for each way:",
  pose: () => "Find joint angles that bring the tip there; one way is enough:",
  trace: ({ q, radius, plane }) =>
    `The tip starts at q = ${vector(q)} and draws a circle of radius ${radius} m that hangs below it, towards ` +
    `+${plane[1]} first, at even speed and with its orientation held. Hand in the joints, a row for each time: ` +
    "100 steps or more, and as many rows and one.",
};

function wordsOf({ key, n, asked, arm, along }) {
  const head = h("p.asked", {}, `${ASKED[key].title}, question ${n}`);
  if (key === "table") return [head, ...describedByAxes(arm, along)];
  const whose = h("p", {}, typeset(`${arm.title}. ${SAID[key](asked)}`));
  const target = asked.target ? [h("pre", {}, asked.target.replaceAll("-", "−"))] : [];
  const place = { role: "region", tabindex: "0", "aria-label": "The arm's table" };
  return [head, whose, ...target, h("div.scroll", place, tableOf(arm))];
}

const cells = (values) => values.map((value) => h("td", {}, value));
const grid = (caption, heads, rows) =>
  h(
    "table",
    {},
    h("caption", {}, caption),
    h(
      "thead",
      {},
      h(
        "tr",
        {},
        heads.map((name) => h("th", { scope: "col" }, name)),
      ),
    ),
    h(
      "tbody",
      {},
      rows.map((row) => h("tr", {}, cells(row))),
    ),
  );

const length = (value) => String(Number(value.toFixed(6)) + 0);
const set = (text) => text.replaceAll("+ -", "− ").replaceAll("-", "−").replaceAll("pi", "π");

// The arm's table and, where it has them, its masses.
function tableOf(arm) {
  const masses = arm.rows.every(({ body }) => body);
  const heads = ["i", "a (m)", "α", "d (m)", "θ"];
  if (masses) heads.push("mass (kg)", "centre (m)");
  const rows = arm.rows.map(({ kind, a, alpha, d, theta, body }, i) => {
    const shown = [length(a), angle(alpha), length(d), angle(theta)];
    const at = { revolute: 3, prismatic: 2 }[kind];
    if (at) shown[at] = Number(at === 3 ? theta : d) ? `q${i + 1} + ${shown[at]}` : `q${i + 1}`;
    const load = masses ? [String(body[0]), numbers(body.slice(1))] : [];
    return [String(i + 1), ...shown, ...load].map(set);
  });
  return grid("Its table", heads, rows);
}

// An arm by its axes at q = 0.
function describedByAxes(arm, along) {
  const frames = linkFrames(arm, arm.home);
  const rows = joints(arm).map((row, k) => {
    const { o, z } = frames[row];
    const point = o.map((v, i) => v + along[k] * z[i]);
    return [
      String(row + 1),
      arm.rows[row].kind === "prismatic" ? "slides" : "turns",
      numbers(point),
      numbers(z),
    ];
  });
  const { o, x, z } = frames.at(-1);
  const words =
    `The tip is at ${numbers(o)}; its frame has the axes x = ${numbers(x)} and z = ${numbers(z)}. Write a table of ` +
    "this arm in the standard convention, a row (a, α, d, θ) for each joint. Every choice of frames that the " +
    "convention allows is right.";
  const place = { role: "region", tabindex: "0", "aria-label": "The arm's axes" };
  return [
    h(
      "p",
      {},
      "An arm of four joints, at q = 0 and in base axes, whose z axis is the first joint axis:",
    ),
    h(
      "div.scroll",
      place,
      grid("Its axes", ["joint", "it", "a point on its axis (m)", "direction"], rows),
    ),
    h("p", {}, words),
  ];
}
