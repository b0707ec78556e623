// The freedom that a seventh joint gives, as a small figure.

import { isOutsideLimits } from "../../../judge/geometry/arm.js";
import { jacobianColumns, movingRows, linkFrames } from "../../../judge/geometry/kinematics.js";
import { nullSpace } from "../../../judge/geometry/linear.js";
import { reach } from "../motion.js";
import { jointText } from "../text.js";
import { deg, makeLever, makeLive } from "./live.js";

// The elbow swings while the tip stays.
export function swing(host, spec) {
  const live = makeLive(host, spec, {
    words: (state) => {
      const values = movingRows(state.arm).map(
        (index, k) => `q${index + 1} ${jointText(state.arm.rows[index], state.q[k], "deg")}`,
      );
      return `The tip stays; ${values.join(", ")}.`;
    },
  });
  const { store } = live;
  const held = store.derived.frames.at(-1);
  store.dispatch({ type: "show", hold: { pinned: held, turns: true, free: 1 } });
  const path = swungBothWays(store.state.arm, store.state.q, held);
  const middle = path.findIndex((q) => q === store.state.q);
  const put = (v) => {
    const q = path[Math.max(0, Math.min(path.length - 1, Math.round(v)))];
    store.dispatch({ type: "move", q, hold: store.state.hold, gesture: "swing" });
  };
  const text = (v) => deg(path[Math.round(v)]?.[2] - path[middle][2]);
  const { signal } = live;
  const lever = makeLever("elbow", [0, path.length - 1], middle, { put, text, signal });
  live.card.querySelector(".side").prepend(lever.root);
  return live.dispose;
}

// Joint vectors with the tip at rest, in small steps both ways, within limits.
function swungBothWays(arm, start, held) {
  const walk = (sign) => {
    const found = [];
    let [q, before] = [start, null];
    for (let step = 0; step < 80; step++) {
      const [direction] = nullSpace(jacobianColumns(arm, linkFrames(arm, q)));
      if (!direction) break;
      const along = before
        ? direction.reduce((s, v, k) => s + v * before[k], 0)
        : sign * direction[2];
      const way = direction.map((v) => (along < 0 ? -v : v));
      const moved = q.map((v, k) => v + 0.03 * way[k]);
      const next = reach(arm, moved, held).q;
      if (movingRows(arm).some((row, k) => isOutsideLimits(arm.rows[row], next[k]))) break;
      found.push(next);
      [q, before] = [next, way];
    }
    return found;
  };
  return [...walk(-1).reverse(), start, ...walk(1)];
}
