// Names of axes over a picture, moved apart where they would cover one another.

import { attribute, h, write } from "./dom.js";

const ROOM = [22, 15]; // px that a name takes
const STEPS = [
  [0, 0],
  [0, -14],
  [0, 14],
  [16, 0],
  [-16, 0],
  [14, -13],
  [-14, 13],
  [14, 13],
  [-14, -13],
  [0, -26],
  [0, 26],
];

export class Labels {
  #spans = [];
  #places = []; // where each stands, so that nothing is written twice

  constructor(host) {
    this.host = host;
    this.tags = [];
  }

  /**
   * @param {{ tip: number[], letter: string, index: string }[]} tags the most important
   *   first
   */
  set(tags) {
    this.tags = tags;
    while (this.#spans.length < tags.length) {
      const span = h("span", {}, h("i"), h("sub"));
      this.#spans.push(span);
      this.host.append(span);
    }
    this.#spans.forEach((span, i) => {
      const tag = tags[i];
      span.hidden = !tag;
      if (!tag) return;
      attribute(span, "class", `axis-${tag.letter}`);
      write(span.children[0], tag.letter);
      write(span.children[1], tag.index);
    });
  }

  // Put each at its place, or beside it where another stands already; one that finds no room stays
  // away.
  place(pixel, width, height) {
    const taken = [];
    this.tags.forEach(({ tip, index }, i) => {
      const [x, y] = pixel(tip);
      const room = [ROOM[0] + 4 * Math.max(0, index.length - 1), ROOM[1]];
      const free = ([dx, dy]) =>
        taken.every(
          ([p, q, r]) => Math.abs(p - x - dx) > (room[0] + r) / 2 || Math.abs(q - y - dy) > room[1],
        );
      const inside = x > -20 && y > -20 && x < width + 20 && y < height + 20;
      const step = inside ? STEPS.find(free) : null;
      const [left, top] = step ? [x + step[0], y + step[1]] : [];
      if (step) taken.push([left, top, room[0]]);
      this.#move(
        i,
        step ? `translate(${left.toFixed(1)}px, ${top.toFixed(1)}px) translate(-50%, -50%)` : null,
      );
    });
  }

  // Put a name somewhere, or away.
  #move(i, place) {
    const before = this.#places[i];
    if (before === place) return;
    this.#places[i] = place;
    const { style } = this.#spans[i];
    if (!before || !place) style.visibility = place ? "visible" : "hidden";
    if (place) style.transform = place;
  }

  dispose() {
    this.host.replaceChildren();
    [this.#spans, this.#places, this.tags] = [[], [], []];
  }
}
