// A slider on a rail that a thumb can swipe past: on a touch screen only a sideways motion moves
// it, from where it stands; a mouse takes it as it is used to. The input keeps the keys and the
// speech.

import { h } from "./dom.js";

const SIDEWAYS = 6; // px before a touch counts as meant

let drags = 0;

/**
 * @param {HTMLInputElement} input a range
 * @param {(value: number, gesture: string) => void} put hears of each value, and of which motion it
 *   is one
 * @param {AbortSignal} signal
 * @param {HTMLElement[]} below
 */
export function makeRail(input, put, signal, ...below) {
  const rail = h("div.rail", {}, input, ...below);
  const on = (target, type, act) => target.addEventListener(type, act, { signal });
  on(input, "input", () => put(Number(input.value), `keys ${input.ariaLabel}`));
  let drag = null;
  const span = () => Number(input.max) - Number(input.min);
  const length = () => Math.max(1, rail.clientWidth - 16);
  const to = (value) =>
    put(Math.min(Number(input.max), Math.max(Number(input.min), value)), `drag ${drags}`);
  const begin = (event) => {
    drags += 1;
    Object.assign(drag, { on: true, x: event.clientX });
    rail.setPointerCapture(event.pointerId);
  };
  on(rail, "pointerdown", (event) => {
    if (event.button || drag) return;
    drag = { id: event.pointerId, x: event.clientX, from: Number(input.value), on: false };
    input.focus({ preventScroll: true });
    if (event.pointerType !== "mouse") return;
    event.preventDefault();
    begin(event);
    const share = (event.clientX - rail.getBoundingClientRect().left - 8) / length();
    const thumb = (drag.from - Number(input.min)) / span();
    if (Math.abs(share - thumb) * length() < 11) return; // the thumb itself was taken
    drag.from = Number(input.min) + share * span();
    to(drag.from);
  });
  on(rail, "pointermove", (event) => {
    if (event.pointerId !== drag?.id) return;
    if (!drag.on && Math.abs(event.clientX - drag.x) < SIDEWAYS) return;
    if (!drag.on) begin(event);
    to(drag.from + (span() * (event.clientX - drag.x)) / length());
  });
  on(rail, "pointerup", () => (drag = null));
  on(rail, "pointercancel", () => {
    if (drag?.on) to(drag.from); // the page took the touch
    drag = null;
  });
  return rail;
}
