// Names of axes over a picture, moved apart where they would overlap.

import { updateAttribute, h, setText } from "./dom.js";

const LABEL_SIZE = [22, 15]; // px, width and height of a label
const OFFSETS = [
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

export class AxisLabels {
  constructor(host) {
    this.host = host;
    this.tags = [];
  }

  /**
   * Set the labels to draw.
   * @param {{ tip: number[], letter: string, index: string }[]} tags the most important first
   */
  set(tags) {
    this.tags = tags;
    while (this.host.children.length < tags.length)
      this.host.append(h("span", {}, h("i"), h("sub")));
    tags.forEach(({ letter, index }, i) => {
      const span = this.host.children[i];
      updateAttribute(span, "class", `axis-${letter}`);
      setText(span.children[0], letter);
      setText(span.children[1], index);
    });
  }

  // Place each label at its point, or next to it if another label is there. A label without room is
  // hidden.
  place(pixel, width, height) {
    const taken = [];
    const placed = this.tags.map(({ tip, index }) => {
      const [x, y] = pixel(tip);
      const room = [LABEL_SIZE[0] + 4 * Math.max(0, index.length - 1), LABEL_SIZE[1]];
      const free = ([dx, dy]) =>
        taken.every(
          ([p, q, r]) => Math.abs(p - x - dx) > (room[0] + r) / 2 || Math.abs(q - y - dy) > room[1],
        );
      const inside = x > -20 && y > -20 && x < width + 20 && y < height + 20;
      const step = inside && OFFSETS.find(free);
      if (!step) return null;
      const [left, top] = [x + step[0], y + step[1]];
      taken.push([left, top, room[0]]);
      return `translate(${left.toFixed(1)}px, ${top.toFixed(1)}px) translate(-50%, -50%)`;
    });
    [...this.host.children].forEach((span, i) => {
      span.hidden = !placed[i];
      if (placed[i]) span.style.transform = placed[i];
    });
  }

  dispose() {
    this.host.replaceChildren();
  }
}
