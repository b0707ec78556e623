// The freedom of a seventh joint, as a small figure.

import { isOutsideLimits } from "../../../judge/geometry/arm.js";
import { jacobianColumns, movingRows, linkFrames } from "../../../judge/geometry/kinematics.js";
import { nullSpace } from "../../../judge/geometry/linear.js";
import { solvePose } from "../motion.js";
import { formatJointValue } from "../text.js";
import { formatWholeDegrees, makeLever, makeLive } from "./live.js";

// The elbow swings while the tip stays at its pose.
export function buildSwingFigure(host, spec) {
  const live = makeLive(host, spec, {
    message: (state) => {
      const values = movingRows(state.arm).map(
        (index, k) => `q${index + 1} ${formatJointValue(state.arm.rows[index], state.q[k], "deg")}`,
      );
      return `The tip stays; ${values.join(", ")}.`;
    },
  });
  const { store } = live;
  const pinnedPose = store.derived.frames.at(-1);
  store.dispatch({ type: "setFields", tipHold: { pinned: pinnedPose, turns: true, free: 1 } });
  const path = swingBothWays(store.state.arm, store.state.q, pinnedPose);
  const middle = path.findIndex((q) => q === store.state.q);
  const put = (v) => {
    const q = path[Math.max(0, Math.min(path.length - 1, Math.round(v)))];
    store.dispatch({ type: "moveJoints", q, tipHold: store.state.tipHold, gesture: "swing" });
  };
  const text = (v) => formatWholeDegrees(path[Math.round(v)]?.[2] - path[middle][2]);
  const { signal } = live;
  const lever = makeLever("elbow", [0, path.length - 1], middle, { put, text, signal });
  live.card.querySelector(".side").prepend(lever.root);
  return live.dispose;
}

// Return joint values with the tip at rest, in small steps both ways, within limits.
function swingBothWays(arm, start, pinnedPose) {
  const walk = (sign) => {
    const configurations = [];
    let [q, before] = [start, null];
    for (let step = 0; step < 80; step++) {
      const [direction] = nullSpace(jacobianColumns(arm, linkFrames(arm, q)));
      if (!direction) break;
      const along = before
        ? direction.reduce((s, v, k) => s + v * before[k], 0)
        : sign * direction[2];
      const oriented = direction.map((v) => (along < 0 ? -v : v));
      const moved = q.map((v, k) => v + 0.03 * oriented[k]);
      const next = solvePose(arm, moved, pinnedPose).q;
      if (movingRows(arm).some((row, k) => isOutsideLimits(arm.rows[row], next[k]))) break;
      configurations.push(next);
      [q, before] = [next, oriented];
    }
    return configurations;
  };
  return [...walk(-1).reverse(), start, ...walk(1)];
}
