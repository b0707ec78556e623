// The parts of every small figure: a picture of an arm to drag, a message that follows it, and
// levers.

import css from "./figure.css";
import common from "../common.css";
import { homeConfiguration, jointRange } from "../../../judge/geometry/arm.js";
import { updateAttribute, h, makeIndexedSymbol, makeRangeInput, setText } from "../dom.js";
import { makeStage } from "../panel/stage.js";
import { movingRows } from "../../../judge/geometry/kinematics.js";
import { makeRail } from "../rail.js";
import { makeInitialState, Store } from "../state.js";
import { formatDegrees, formatJointValue, replaceAt, formatSpokenValue } from "../text.js";
import { watchTheme } from "../theme.js";

export const formatWholeDegrees = (v) => formatDegrees(v, 0);

let figureCount = 0;

/**
 * Make a small figure.
 * @param {HTMLElement} host
 * @param {any} spec options of the figure: arm, q, joints (the numbers of joints with a lever)
 * @param {{ state?: object, isGrabbable?: boolean, message: (state: any, derived: any) => string,
 *   side?: HTMLElement[], firstFrame?: number }} options the initial state, whether the arm can be
 *   grabbed, the message, elements beside the picture, and the number of the first frame
 */
export function makeLive(host, spec, options) {
  const { state = {}, isGrabbable = true, message, side = [], firstFrame = 0 } = options;
  const abort = new AbortController();
  const { signal } = abort;
  const { arm } = spec;
  const store = new Store(makeInitialState({ arm, q: spec.q ?? homeConfiguration(arm), ...state }));
  const root = host.shadowRoot ?? host.attachShadow({ mode: "open" });
  const stage = makeStage(store, {
    ...{ signal, firstFrame, isGrabbable, hasTipBar: false, id: `figure-${++figureCount}` },
    goTo: (q) => store.dispatch({ type: "glide", q }),
  });
  const caption = h("p.words");
  const levers = (spec.joints ?? []).map((number) => makeJointLever(store, number, signal));
  const beside = h("div.side", {}, ...side, ...levers.map((lever) => lever.root), caption);
  const card = h("figure.live", {}, stage.root, beside);
  root.replaceChildren(h("style", {}, common, css), card);

  let theme = "light";
  const listeners = [];
  function refresh() {
    const { state: now, derived } = store;
    for (const lever of levers) lever.show(now);
    setText(caption, message(now, derived));
    stage.draw(now, derived, theme);
    stage.update(now);
    for (const listener of listeners) listener(now, derived);
  }
  watchTheme((now) => {
    theme = now;
    card.dataset.theme = now;
    refresh();
  }, signal);
  store.listen(refresh, signal);
  const { picture } = stage;
  const follow = (listener) => (listeners.push(listener), refresh());
  const dispose = () => (abort.abort(), stage.dispose(), root.replaceChildren());
  return { store, picture, card, signal, refresh, follow, dispose };
}

// Make a lever for the joint of a row, counted from 1.
function makeJointLever(store, number, signal) {
  const { arm } = store.state;
  const k = movingRows(arm).indexOf(number - 1);
  const row = arm.rows[number - 1];
  const put = (value, gesture) =>
    store.dispatch({ type: "moveJoints", q: replaceAt(store.state.q, k, value), gesture });
  const input = makeRangeInput(`Joint ${number}`, jointRange(row));
  const { root, show } = makeLeverParts(makeIndexedSymbol("q", number), input, put, signal);
  return {
    root,
    show: ({ q, unit }) =>
      show(q[k], formatJointValue(row, q[k], unit), formatSpokenValue(row, q[k], unit)),
  };
}

// Make a lever for any number.
export function makeLever(label, bounds, value, { put, text, signal }) {
  const input = makeRangeInput(label, bounds);
  const { root, show } = makeLeverParts(label, input, (v) => move(v), signal);
  const move = (v) => (show(v, text(v)), put(v));
  show(value, text(value));
  return { root, move };
}

function makeLeverParts(name, input, put, signal) {
  const output = h("output");
  const show = (value, text, spoken = text) => {
    input.value = String(value);
    updateAttribute(input, "aria-valuetext", spoken);
    setText(output, text);
  };
  return {
    root: h("div.lever", {}, h("span", {}, name), makeRail(input, put, signal), output),
    show,
  };
}
