// Names of axes over a picture, moved off the links and off each other.

import { updateAttribute, h, setText } from "./dom.js";
import { measureGap } from "./picking.js";

const LABEL_SIZE = [22, 15]; // px, width and height of a label
const LABEL_RADIUS = 9; // px; about half of a label, so that it clears a link
const DIRECTIONS = [
  [0, -1],
  [0, 1],
  [1, 0],
  [-1, 0],
  [0.8, -0.8],
  [-0.8, 0.8],
  [0.8, 0.8],
  [-0.8, -0.8],
];
// Offsets of a label from the end of its axis, in px, nearest first.
const OFFSETS = [
  [0, 0],
  ...[15, 22, 30].flatMap((far) => DIRECTIONS.map(([x, y]) => [far * x, far * y])),
];

/**
 * Find a spot for a label near the end of its axis: off the links if there is one, at least off the
 * labels that stand already; null if there is none.
 * @param {number[]} end pixel of the end of the axis
 * @param {number} width of the label in pixels
 * @param {{ spot: number[], width: number }[]} labels those that stand already
 * @param {{ from: number[], to: number[] }[]} links their ends in pixels
 * @param {number} thickness half of a link's, in pixels
 */
export function findLabelSpot([x, y], width, labels, links, thickness) {
  const isOffLabels = ([u, v]) =>
    labels.every(
      ({ spot, width: other }) =>
        Math.abs(spot[0] - u) > (width + other) / 2 || Math.abs(spot[1] - v) > LABEL_SIZE[1],
    );
  const isOffLinks = (spot) =>
    links.every(({ from, to }) => measureGap(spot, from, to) > thickness + LABEL_RADIUS);
  const spots = OFFSETS.map(([dx, dy]) => [x + dx, y + dy]).filter(isOffLabels);
  return spots.find(isOffLinks) ?? spots[0] ?? null;
}

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

  /**
   * Place the labels. One without room beside the others is hidden.
   * @param {(point: number[]) => number[]} pixel
   * @param {{ width: number, height: number }} size of the picture
   * @param {{ from: number[], to: number[] }[]} links their ends in pixels
   * @param {number} thickness half of a link's, in pixels
   */
  place(pixel, { width, height }, links, thickness) {
    const placed = [];
    const transforms = this.tags.map(({ tip, index }) => {
      const [x, y] = pixel(tip);
      const isInside = x > -20 && y > -20 && x < width + 20 && y < height + 20;
      const room = LABEL_SIZE[0] + 4 * Math.max(0, index.length - 1);
      const spot = isInside && findLabelSpot([x, y], room, placed, links, thickness);
      if (!spot) return null;
      placed.push({ spot, width: room });
      const [left, top] = spot.map((v) => v.toFixed(1));
      return `translate(${left}px, ${top}px) translate(-50%, -50%)`;
    });
    [...this.host.children].forEach((span, i) => {
      span.hidden = !transforms[i];
      if (transforms[i]) span.style.transform = transforms[i];
    });
  }

  dispose() {
    this.host.replaceChildren();
  }
}
