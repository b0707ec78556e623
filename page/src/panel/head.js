// The line above the picture: which arm, units, and what may be done with the whole instrument.

import { homeOf } from "../../../judge/geometry/arm.js";
import { h, svg, whereNew } from "../dom.js";
import { randomPose } from "../motion.js";

export function makeHead(store, { arms, link, goTo, stage, card, say }) {
  const several = arms.length > 1;
  const choice = h("select.name", {
    "aria-label": "Arm",
    onchange: (e) => choose(e.target.selectedIndex),
  });
  const name = several ? choice : h("span.name");
  let listed = null;
  const button = (text, title, onclick) => h("button", { type: "button", title, onclick }, text);
  const units = [
    ["deg", "degrees"],
    ["rad", "radians"],
  ].map(([unit, title]) => {
    const show = () => store.dispatch({ type: "show", unit });
    return h("button", { type: "button", title, "data-unit": unit, onclick: show }, unit);
  });
  const frames = button(
    "Frames",
    "Draw the frame of every link, or the first and the last only",
    () => {
      store.dispatch({ type: "show", frames: store.state.frames === "all" ? "ends" : "all" });
    },
  );
  const undo = button("↶", "Undo (Ctrl+Z)", () => store.dispatch({ type: "undo" }));
  const redo = button("↷", "Redo (Ctrl+Shift+Z)", () => store.dispatch({ type: "redo" }));
  undo.setAttribute("aria-label", "Undo");
  redo.setAttribute("aria-label", "Redo");
  const full = button("", "Full screen", () => toggleFull(card));
  full.setAttribute("aria-label", "Full screen");
  const corners = "M1 5V1h4M9 1h4v4M13 9v4H9M5 13H1V9";
  const ink = { d: corners, fill: "none", stroke: "currentColor", "stroke-width": 1.6 };
  full.append(
    svg(
      "svg",
      { viewBox: "0 0 14 14", width: 14, height: 14, "aria-hidden": "true" },
      svg("path", ink),
    ),
  );
  const buttons = [
    h("span.pair", { role: "group", "aria-label": "Unit of angles" }, units),
    frames,
    button("Home", "Where this arm stands first", () => goTo(homeOf(store.state.arm))),
    button("Random", "Somewhere within its limits", () => goTo(randomPose(store.state.arm))),
    button("Fit", "The whole arm into the picture", () => stage.fit()),
    h("span.pair", { role: "group", "aria-label": "Undo and redo" }, undo, redo),
  ];
  if (document.fullscreenEnabled) buttons.push(full);
  if (link) {
    buttons.push(
      button("Copy link", "An address that opens this arm in this place", async (event) => {
        const copied = await link.copy();
        event.target.textContent = copied ? "Copied" : "In the address bar";
        say(() => event.target.textContent);
        setTimeout(() => (event.target.textContent = "Copy link"), 1600);
      }),
    );
  }

  card.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z") return;
    if (event.target.matches("input[type=text], textarea") && !event.target.dataset.cell) return;
    event.preventDefault();
    store.dispatch({ type: event.shiftKey ? "redo" : "undo" });
  });

  function choose(index) {
    if (!arms[index]) return;
    store.dispatch({ type: "select", arm: arms[index] });
    stage.fit();
  }

  // An arm that was typed stands in the list by its own name.
  function list({ arm, base }) {
    const own = arm === base ? null : arm.name;
    if (listed === own && choice.options.length) return;
    listed = own;
    const options = arms.map((one) => h("option", {}, one.name));
    choice.replaceChildren(...options, ...(own ? [h("option", {}, own)] : []));
  }

  function update(state) {
    units.forEach((unit) =>
      unit.setAttribute("aria-pressed", String(unit.dataset.unit === state.unit)),
    );
    frames.setAttribute("aria-pressed", String(state.frames === "all"));
    undo.disabled = !state.past.length;
    redo.disabled = !state.future.length;
    if (!several) return void (name.textContent = state.arm.name);
    list(state);
    const index =
      state.arm === state.base ? arms.findIndex((arm) => arm.name === state.arm.name) : arms.length;
    choice.selectedIndex = Math.max(0, index);
    return undefined;
  }
  return {
    root: h(
      "header",
      {},
      name,
      h("div.buttons", { role: "group", "aria-label": "Settings" }, buttons),
    ),
    update: whereNew(
      ({ unit, frames, past, future, arm, base }) => [
        unit,
        frames,
        !past.length,
        !future.length,
        arm,
        base,
      ],
      update,
    ),
  };
}

function toggleFull(card) {
  const { host } = card.getRootNode();
  if (document.fullscreenElement === host) document.exitFullscreen();
  else host.requestFullscreen().catch(() => {});
}
