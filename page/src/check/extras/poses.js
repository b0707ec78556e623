// What a pose cannot show is said by the checker; here is the way to a pose that shows more.

import { h } from "../../dom.js";
import { range } from "../../../../judge/geometry/arm.js";
import { jacobianColumns, joints, linkFrames } from "../../../../judge/geometry/kinematics.js";
import { singular } from "../../../../judge/geometry/linear.js";
import { judge as judged } from "../question.js";

const TRIED = 12; // poses
const WIDEST = 2.4; // rad or m, of a joint
const SMALLEST = 0.06; // no pose is offered nearer to a singular one than this singular value
const GOLDEN = (Math.sqrt(5) - 1) / 2; // its multiples, modulo 1, spread evenly

// Joint values to two decimals, well inside their ranges; another pose for each number.
function spreadPose(arm, number) {
  const moving = joints(arm);
  return moving.map((row, k) => {
    const [low, high] = range(arm.rows[row]).map((x) => Math.max(-WIDEST, Math.min(WIDEST, x)));
    const part = ((number * moving.length + k + 1) * GOLDEN) % 1;
    return Number((low + (high - low) * (0.1 + 0.8 * part)).toFixed(2));
  });
}

// The least that the joints can do in any direction that they are for: six rows, or the place
// alone.
function smallest(arm, q) {
  const columns = jacobianColumns(arm, linkFrames(arm, q));
  const rows = columns.length >= 6 ? 6 : 3;
  return singular(columns, rows).values[rows - 1];
}

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
 * A pose at which fewest of the usual mistakes are hidden, of some that are tried.
 * @param {import("../question.js").Question} question
 * @returns {{ q: number[], hidden: number }}
 */
export function tellingPose(question, arms, arm) {
  const poses = Array.from({ length: 3 * TRIED }, (_, i) => spreadPose(arm, i));
  let best = null;
  for (const q of poses.filter((one) => smallest(arm, one) > SMALLEST).slice(0, TRIED)) {
    const hidden = hiddenAt(question, arms, arm, q);
    if (!best || hidden < best.hidden) best = { q, hidden };
    if (!hidden) break;
  }
  return best ?? { q: poses[0], hidden: hiddenAt(question, arms, arm, poses[0]) };
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
