// What a pose cannot show is said by the checker; here is the way to a pose that shows more.

import { h } from "../../dom.js";
import { jacobianColumns, linkFrames } from "../../../../judge/geometry/kinematics.js";
import { judge as judged } from "../question.js";
import { drawPose, rolls } from "./series.js";

const TRIED = 12; // poses

/**
 * How many of the usual mistakes a pose hides, as the checker says of the right matrix there.
 * @param {import("../question.js").Question} question
 */
function hiddenAt(question, arms, arm, q) {
  const columns = jacobianColumns(arm, linkFrames(arm, q));
  const answer = [0, 1, 2, 3, 4, 5]
    .map((i) => columns.map((column) => column[i]).join(", "))
    .join("\n");
  const asked = { ...question, q: q.join(", "), unit: "rad", frame: "0", first: "v", answer };
  return Number(/^\d+/.exec(judged(asked, arms).report?.notes[0] ?? "0")?.[0] ?? 0);
}

/**
 * A pose at which fewest of the usual mistakes are hidden, of some that are drawn.
 * @param {import("../question.js").Question} question
 * @returns {{ q: number[], hidden: number }}
 */
export function tellingPose(question, arms, arm) {
  const roll = rolls(arm.name);
  let best = null;
  for (let i = 0; i < TRIED && best?.hidden !== 0; i++) {
    const q = drawPose(arm, roll);
    const hidden = hiddenAt(question, arms, arm, q);
    if (!best || hidden < best.hidden) best = { q, hidden };
  }
  return best;
}

/** @param {import("../page.js").Judge} judge */
export function addPoses(judge) {
  const { parts, arms, given, say } = judge;
  if (given?.q) return;
  const go = () => {
    const { arm, report } = judge.verdict();
    const { q, hidden } = tellingPose(judge.question(), arms, arm);
    const text = q.join(", ");
    // A formula is judged there at once, numbers belong to the pose that they were computed at.
    judge.put(
      report.typed?.symbolic ? { q: text, unit: "rad" } : { q: text, unit: "rad", answer: "" },
    );
    const left = hidden
      ? `${hidden} usual mistakes stay hidden at this pose`
      : "No usual mistake is hidden at this pose";
    say(report.typed?.symbolic ? `${left}.` : `${left}; compute your matrix there.`);
  };
  const button = h("button", { type: "button", onclick: go }, "Go to a pose that shows them");
  parts.verdict.after(button);
  judge.follow(({ ask }, { report }) => {
    button.hidden = ask !== "jacobian" || !report?.notes.length || report.grade === "wrong";
  });
}
