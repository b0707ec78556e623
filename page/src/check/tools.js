// What can be done with a question: a link to it, an example, the pose in the explorer.

import { copied, h } from "../dom.js";
import { EMPTY, OWN, toFragment } from "./question.js";

/**
 * @param {import("./page.js").Asked} judge
 * @param {string} book its address
 */
export function addTools(judge, book) {
  const { parts, given } = judge;
  const whole = new URL("check_your_homework.html", book).href;
  const more = h("a", { href: whole }, "More room, and all options");
  const explorer = h("a", { href: "" }, "See this pose in the explorer");
  const button = (words, onclick) => h("button", { onclick }, words);
  const link = button("Copy link", () => copyLink(judge, whole));
  const examples = () => judge.examples.filter((one) => one.ask === judge.question.ask);
  const example = button("Show an example", () => {
    const same = examples();
    const ours = same.find((one) => one.arm === judge.question.arm);
    judge.begin({ ...EMPTY, ...(ours ?? same[0]) });
  });
  // Of an exercise's own arm all of them would show the table, which is the solution.
  if (!given?.table) parts.tools.append(example, link, given ? more : explorer);

  judge.follow((question, { arm, q }) => {
    more.href = whole + toFragment(question);
    example.hidden = !examples().length;
    explorer.hidden = !arm || !q || question.arm === OWN || !arm.explorer;
    if (!explorer.hidden)
      explorer.href = new URL(`explorer.html#${poseOf(question, arm, q)}`, book).href;
  });
}

async function copyLink(judge, whole) {
  const { question, given } = judge;
  const fragment = toFragment(question);
  if (!given) history.replaceState(null, "", fragment);
  const copying = await copied(given ? whole + fragment : location.href);
  const there = given ? CLOSED : "The link stands in the address bar.";
  judge.say(copying ? "The link is copied." : there);
}

const CLOSED = "The clipboard is closed to this page.";

const poseOf = ({ ask }, arm, q) =>
  new URLSearchParams({
    arm: arm.explorer,
    q: q.map((x) => Number(x.toFixed(6))).join(","),
    view: ask === "torques" ? "torque" : "jacobian",
  });
