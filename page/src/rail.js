// A slider that can be swiped past on a touch screen: only a sideways motion moves it, from its
// current value. With a mouse it works like any slider. The input element handles keys and screen
// readers.

import { h } from "./dom.js";

const SWIPE_THRESHOLD = 6; // px that a touch must move sideways before it moves the slider

let dragCount = 0;

/**
 * Make a slider with its rail.
 * @param {HTMLInputElement} input a range
 * @param {(value: number, gesture: string) => void} put called with each value and the name of the
 *   gesture
 * @param {AbortSignal} signal
 * @param {HTMLElement[]} below elements under the slider
 */
export function makeRail(input, put, signal, ...below) {
  const rail = h("div.rail", {}, input, ...below);
  const on = (target, type, act) => target.addEventListener(type, act, { signal });
  on(input, "input", () => put(Number(input.value), `keys ${input.ariaLabel}`));
  let drag = null;
  const span = () => Number(input.max) - Number(input.min);
  const length = () => Math.max(1, rail.clientWidth - 16);
  const to = (value) =>
    put(Math.min(Number(input.max), Math.max(Number(input.min), value)), `drag ${dragCount}`);
  const begin = (event) => {
    dragCount += 1;
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
    if (Math.abs(share - thumb) * length() < 11) return; // the pointer is on the thumb itself
    drag.from = Number(input.min) + share * span();
    to(drag.from);
  });
  on(rail, "pointermove", (event) => {
    if (event.pointerId !== drag?.id) return;
    if (!drag.on && Math.abs(event.clientX - drag.x) < SWIPE_THRESHOLD) return;
    if (!drag.on) begin(event);
    to(drag.from + (span() * (event.clientX - drag.x)) / length());
  });
  on(rail, "pointerup", () => (drag = null));
  on(rail, "pointercancel", () => {
    if (drag?.on) to(drag.from); // the browser took the touch for scrolling
    drag = null;
  });
  return rail;
}
