// What every small figure is made of: a picture of an arm that can be held, words that follow, and
// a few levers.

import css from "./figure.css";
import common from "../common.css";
import { homePose, jointRange } from "../../../judge/geometry/arm.js";
import { attribute, h, indexed, slider, write } from "../dom.js";
import { makeStage } from "../panel/stage.js";
import { movingRows } from "../../../judge/geometry/kinematics.js";
import { makeRail } from "../rail.js";
import { startingState, Store } from "../state.js";
import { degrees, jointText, replaced, spokenJoint } from "../text.js";
import { watchTheme } from "../theme.js";

export const deg = (v) => degrees(v, 0);

let count = 0;

/**
 * @param {HTMLElement} host
 * @param {any} spec options of the figure: arm, q, joints (numbers of those that get a lever)
 * @param {{ state?: object, hold?: boolean, words: (state: any, derived: any) => string, side?:
 *   HTMLElement[],
 *   first?: number }} made
 */
export function makeLive(host, spec, { state = {}, hold = true, words, side = [], first = 0 }) {
  const abort = new AbortController();
  const { signal } = abort;
  const { arm } = spec;
  const store = new Store(startingState({ arm, q: spec.q ?? homePose(arm), ...state }));
  const root = host.shadowRoot ?? host.attachShadow({ mode: "open" });
  const stage = makeStage(store, {
    ...{ signal, first, held: hold, bar: false, id: `figure-${++count}` },
    goTo: (q) => store.dispatch({ type: "glide", q }),
  });
  const said = h("p.words");
  const levers = (spec.joints ?? []).map((number) => jointLever(store, number, signal));
  const beside = h("div.side", {}, ...side, ...levers.map((one) => one.root), said);
  const card = h("figure.live", {}, stage.root, beside);
  root.replaceChildren(h("style", {}, common, css), card);

  let theme = "light";
  const listeners = [];
  function refresh() {
    const { state: now, derived } = store;
    for (const one of levers) one.show(now);
    write(said, words(now, derived));
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

// A lever for the joint of a row, by its number from 1.
function jointLever(store, number, signal) {
  const { arm } = store.state;
  const k = movingRows(arm).indexOf(number - 1);
  const row = arm.rows[number - 1];
  const put = (value, gesture) =>
    store.dispatch({ type: "move", q: replaced(store.state.q, k, value), gesture });
  const input = slider(`Joint ${number}`, jointRange(row));
  const { root, show } = leverOf(indexed("q", number), input, put, signal);
  return {
    root,
    show: ({ q, unit }) => show(q[k], jointText(row, q[k], unit), spokenJoint(row, q[k], unit)),
  };
}

// A lever for any number.
export function makeLever(label, bounds, value, { put, text, signal }) {
  const input = slider(label, bounds);
  const { root, show } = leverOf(label, input, (v) => move(v), signal);
  const move = (v) => (show(v, text(v)), put(v));
  show(value, text(value));
  return { root, move };
}

function leverOf(name, input, put, signal) {
  const output = h("output");
  const show = (value, text, spoken = text) => {
    input.value = String(value);
    attribute(input, "aria-valuetext", spoken);
    write(output, text);
  };
  return {
    root: h("div.lever", {}, h("span", {}, name), makeRail(input, put, signal), output),
    show,
  };
}
