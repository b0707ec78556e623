// The picture with what one can do to it, or a still picture that follows where the browser has no
// WebGL.

import { h, whereNew, write } from "../dom.js";
import { makeGrabbable, moveTipByKey } from "../grab.js";
import { asked, holdVerdict } from "../verdicts.js";
import { joints } from "../../../judge/geometry/kinematics.js";
import { rightNull } from "../../../judge/geometry/linear.js";
import { reach } from "../motion.js";
import { ArmPicture } from "../scene.js";

const HELP =
  "Picture of the arm. Arrow keys turn the view, plus and minus bring it nearer and farther, 0 fits it. " +
  "The button at the tip moves the tip; the sliders turn the joints.";
const VIEW_KEYS = {
  ArrowLeft: [-0.12, 0],
  ArrowRight: [0.12, 0],
  ArrowUp: [0, -0.1],
  ArrowDown: [0, 0.1],
  "+": [0, 0, 0.9],
  "=": [0, 0, 0.9],
  "-": [0, 0, 1.1],
};
const SWING = 0.06; // rad along the null space for one press

export function makeStage(store, { goTo, id, say }) {
  const labels = h("div.labels", { "aria-hidden": "true" });
  const grip = h("button.grip", {
    type: "button",
    "aria-label": "Tip",
    "aria-describedby": `${id}-grip`,
    onkeydown: tipKeys,
    title: "Drag the tip: the joints follow. Arrow keys move it too.",
  });
  const help = h(
    "span.hidden",
    { id: `${id}-grip` },
    "Arrow keys move the tip across the picture, Page keys to and fro.",
  );
  const why = h("p.why", { "aria-hidden": "true" });
  const lost = h(
    "p.lost",
    { hidden: true },
    "The browser took the picture’s graphics away; it comes back when it can.",
  );
  const hold = makeHoldBar(store);
  const root = h(
    "div.stage",
    {
      tabindex: 0,
      role: "application",
      "aria-label": HELP,
      onkeydown: viewKeys,
      ondblclick: () => picture?.fit(),
    },
    labels,
    grip,
    help,
    hold.root,
    why,
    lost,
  );
  let picture = null;
  try {
    picture = new ArmPicture(root, labels, {
      onLost: (is) => (lost.hidden = !is),
      onPlace: ([x, y]) => (grip.style.transform = `translate(${x}px, ${y}px)`),
    });
    picture.figure.foot = () => hold.root.offsetHeight + 40; // and the foot’s own disc and label
    makeGrabbable(picture, store, { grip, goTo });
  } catch {
    picture = null; // no WebGL here
    root.classList.add("flat");
    root.setAttribute("role", "group");
    root.setAttribute("aria-label", "Still picture of the arm, which follows the sliders");
    root.removeAttribute("tabindex");
    root.replaceChildren(
      h("slot"),
      h("p", {}, "This browser gives no WebGL, so the picture is a still one that follows."),
    );
  }

  function viewKeys(event) {
    if (event.target !== root) return;
    const [turn, tilt, nearer] = VIEW_KEYS[event.key] ?? [];
    if (event.key === "0") picture?.fit();
    else if (turn === undefined) return;
    else picture?.figure.orbit(turn, tilt, nearer);
    event.preventDefault();
  }

  function tipKeys(event) {
    if (picture && moveTipByKey(picture, store, event)) say(() => holdVerdict(store.state.hold));
  }

  return {
    root,
    draw(state, derived, theme) {
      picture?.draw(state, derived, theme);
    },
    update(state) {
      hold.update(state);
      grip.hidden =
        !picture ||
        !joints(state.arm).length ||
        (state.view === "torque" && !state.wrench.slice(0, 3).some(Boolean));
      const words = holdVerdict(state.hold);
      write(why, words);
      why.hidden = !words;
    },
    fit: () => picture?.fit(),
    scale: () => picture?.scale,
    dispose: () => picture?.dispose(),
  };
}

// Below the picture: whether a dragged tip keeps its direction, and whether the tip is pinned so
// that the elbow swings.
function makeHoldBar(store) {
  const keep = h(
    "button",
    {
      type: "button",
      title: "A dragged tip keeps the direction of the tool too",
      onclick: () => store.dispatch({ type: "show", keepTurn: !store.state.keepTurn }),
    },
    "Keep direction",
  );
  const pin = h(
    "button",
    {
      type: "button",
      title: "Hold the tip where it is, and drag the elbow through what is left",
      onclick: togglePin,
    },
    "Pin the tip",
  );
  const swing = [-1, 1].map((way) =>
    h(
      "button.swing",
      {
        type: "button",
        "aria-label": `Swing ${way < 0 ? "one" : "the other"} way`,
        onclick: () => swingBy(store, way),
      },
      way < 0 ? "↺" : "↻",
    ),
  );
  const root = h("div.hold", { role: "group", "aria-label": "The tip" }, keep, pin, swing);

  function togglePin() {
    const { state, derived } = store;
    const turns = joints(state.arm).length > 6 || (state.keepTurn && asked(state.arm) === 6);
    const pinned = state.hold?.pinned
      ? null
      : { pinned: derived.frames.at(-1), turns, free: freedom(store, turns) };
    store.dispatch({ type: "show", hold: pinned });
  }

  function update({ keepTurn, hold, arm }) {
    const pinned = Boolean(hold?.pinned);
    keep.setAttribute("aria-pressed", String(keepTurn));
    keep.hidden = asked(arm) < 6;
    pin.setAttribute("aria-pressed", String(pinned));
    pin.textContent = pinned ? pinWords(hold) : "Pin the tip";
    swing.forEach((button) => (button.hidden = !pinned || !hold.free));
  }
  const shows = ({ keepTurn, hold, arm }) => [keepTurn, arm, hold?.pinned, hold?.free, hold?.turns];
  return { root, update: whereNew(shows, update) };
}

const pinWords = ({ free, turns }) => {
  const what = turns ? "place and direction" : "place";
  return free ? `Tip pinned (${what}): drag the elbow` : `Tip pinned (${what}): nothing is free`;
};

const stillColumns = ({ derived }, turns) => derived.columns.map((c) => c.slice(0, turns ? 6 : 3));
const freedom = (store, turns) => rightNull(stillColumns(store, turns)).length;

// A step through the null space, as a drag of the elbow makes it.
function swingBy(store, way) {
  const { arm, q, hold } = store.state;
  if (!hold?.pinned) return;
  const [direction] = rightNull(stillColumns(store, hold.turns));
  if (!direction) return;
  const lead = direction.reduce(
    (best, v, k) => (Math.abs(v) > Math.abs(direction[best]) ? k : best),
    0,
  );
  const sign = way * Math.sign(direction[lead]);
  const moved = q.map((v, k) => v + sign * SWING * direction[k]);
  const there = hold.turns ? reach(arm, moved, hold.pinned).q : moved;
  store.dispatch({ type: "move", q: there, hold, gesture: "swing" });
}
