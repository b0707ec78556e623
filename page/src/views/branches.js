// Inverse kinematics: every solution branch of a pose, as a list and as ghosts.

import { updateAttribute, h, makeIndexedSymbol, setText } from "../dom.js";
import { hasLimits, isOutsideLimits } from "../../../judge/geometry/arm.js";
import { makeLatestJob } from "../jobs.js";
import { movingRows } from "../../../judge/geometry/kinematics.js";
import { isAtBranch } from "../motion.js";
import { getBranchColour } from "../look.js";
import { measureTipOffset } from "../state.js";
import { formatFixed, formatJointValue } from "../text.js";
import { describeTarget, describeBranches } from "../statements.js";

export const title = "IK branches";

const describeSearch = ({ arm }) => `Find the solutions for this ${describeTarget(arm)}`;

export function build(store, { goTo, announce }) {
  const message = h("p.verdict");
  const list = h("ol.solutions");
  const find = h("button.main", { onclick: search });
  const root = h("div.branches", {}, h("div.row", {}, find), message, list);
  const ask = makeLatestJob("branches");
  let rendered;

  function search() {
    const { arm, q } = store.state;
    find.textContent = "Looking …";
    ask({ arm, q }, (branches) => {
      find.textContent = describeSearch(store.state);
      store.dispatch({ type: "setBranches", arm, branches });
      announce(() => message.textContent, true);
    });
  }

  function update(state, derived) {
    const { branches, unit, arm } = state;
    if (rendered?.branches !== branches || rendered.unit !== unit || rendered.arm !== arm) {
      const light = (highlightedBranch) => store.dispatch({ type: "setFields", highlightedBranch });
      const buttons = (branches?.list ?? []).map((branch, i) =>
        makeBranchButton(branch, i, state, { goTo, light }),
      );
      if (rendered?.arm !== arm) find.textContent = describeSearch(state);
      list.replaceChildren(...buttons.map((button) => h("li", {}, button)));
      rendered = { branches, unit, arm, buttons };
    }
    const left = measureTipOffset(state, derived);
    root.classList.toggle("left", Boolean(left));
    setText(message, describeView(state, left));
    rendered.buttons.forEach((button, i) => {
      const isHere = isAtBranch(arm, branches.list[i].q, state.q);
      updateAttribute(button, "aria-current", String(isHere));
    });
  }
  return { root, update, summary: () => message.textContent };
}

function makeBranchButton({ q, label }, i, { arm, unit }, { goTo, light }) {
  const moving = movingRows(arm);
  const past = moving.flatMap((row, k) => (isOutsideLimits(arm.rows[row], q[k]) ? [row + 1] : []));
  const within = hasLimits(arm) ? "within limits" : "";
  const values = moving.map((row, k) =>
    h(
      "span",
      {},
      makeIndexedSymbol("q", row + 1),
      ` ${formatJointValue(arm.rows[row], q[k], unit)}`,
    ),
  );
  const [on, off] = [() => light(i), () => light(null)];
  const lights = { onpointerenter: on, onpointerleave: off, onfocus: on, onblur: off };
  return h(
    "button",
    { onclick: () => goTo(q), ...lights },
    h("span.swatch", { style: `background:${getBranchColour(i)}`, "aria-hidden": "true" }),
    h("span.name", {}, label ? formatBranchLabel(label) : `solution ${i + 1}`),
    h("span.values", {}, values),
    past.length
      ? h("span.note.past", {}, `past the limit of joint ${past.join(", ")}`)
      : h("span.note", {}, within),
  );
}

// Format a branch's label from Python: q_5 with an index, elbow - with a true minus.
const formatBranchLabel = (label) =>
  label
    .split(/\b([a-z]_\d+)\b/)
    .map((part, i) =>
      i % 2 ? h("span", {}, makeIndexedSymbol(...part.split("_"))) : part.replace(/-$/, "−"),
    );

function describeView({ branches, arm }, left) {
  const where = describeTarget(arm);
  if (!branches) {
    const shown = "is shown in a colour of its own; choose one to go there.";
    return `Each solution that takes the tip to this ${where} ${shown}`;
  }
  const choose =
    branches.list.length > 1 ? " Choose one, here or in the picture, to go there." : "";
  if (!left) return describeBranches(arm, branches) + choose;
  const gone =
    left.distance > 5e-4
      ? `${formatFixed(1000 * left.distance, 0)} mm from there`
      : "turned away from it";
  const back = `Choose one to go back, or find the solutions for this ${where}.`;
  const there = `These solutions are for the ${where} at which the tip was before`;
  return `${there}; it is now ${gone}. ${back}`;
}
