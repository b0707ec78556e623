// A slider on a rail that a thumb can swipe past: on a touch screen only a sideways motion moves
// it, from where it stands; a mouse takes it as it is used to. The input keeps the keys and the
// speech.

const SIDEWAYS = 6; // px before a touch counts as meant

/**
 * @param {HTMLElement} rail around the input
 * @param {HTMLInputElement} input a range
 * @param {{ start?: () => void, put: (value: number) => void, signal: AbortSignal }} tools
 */
export function relativeRail(rail, input, { start = () => {}, put, signal }) {
  let drag = null;
  const span = () => Number(input.max) - Number(input.min);
  const within = (value) => Math.min(Number(input.max), Math.max(Number(input.min), value));
  const length = () => Math.max(1, rail.clientWidth - 16);

  const begin = (event) => {
    start();
    Object.assign(drag, { on: true, x: event.clientX });
    rail.setPointerCapture(event.pointerId);
  };

  const on = (type, act) => rail.addEventListener(type, act, { signal });
  on("pointerdown", (event) => {
    if (event.button || drag) return;
    drag = { id: event.pointerId, x: event.clientX, from: Number(input.value), on: false };
    input.focus({ preventScroll: true });
    if (event.pointerType !== "mouse") return;
    event.preventDefault();
    begin(event);
    const share = (event.clientX - rail.getBoundingClientRect().left - 8) / length();
    const thumb = (drag.from - Number(input.min)) / span();
    if (Math.abs(share - thumb) * length() < 11) return; // the thumb itself was taken
    drag.from = within(Number(input.min) + share * span());
    put(drag.from);
  });
  on("pointermove", (event) => {
    if (event.pointerId !== drag?.id) return;
    if (!drag.on && Math.abs(event.clientX - drag.x) < SIDEWAYS) return;
    if (!drag.on) begin(event);
    put(within(drag.from + (span() * (event.clientX - drag.x)) / length()));
  });
  on("pointerup", () => (drag = null));
  on("pointercancel", () => {
    if (drag?.on) put(drag.from); // the page took the touch
    drag = null;
  });
}
