// Places the names of axes over a picture, away from the links and from each other.

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
// Offsets of a label from the end of its axis in px, nearest first.
const OFFSETS = [
  [0, 0],
  ...[15, 22, 30].flatMap((distance) => DIRECTIONS.map(([x, y]) => [distance * x, distance * y])),
];

/**
 * Find a spot for a label near the end of its axis. A spot beside the links is preferred.
 * @param {number[]} end pixel of the end of the axis
 * @param {number} width of the label in pixels
 * @param {{ spot: number[], width: number }[]} labels that have their spots
 * @param {{ from: number[], to: number[] }[]} links their ends in pixels
 * @param {number} radius of a link, in pixels
 * @returns {number[] | null} null if every spot overlaps a label
 */
export function findLabelSpot([x, y], width, labels, links, radius) {
  const isOffLabels = ([u, v]) =>
    labels.every(
      ({ spot, width: placedWidth }) =>
        Math.abs(spot[0] - u) > (width + placedWidth) / 2 || Math.abs(spot[1] - v) > LABEL_SIZE[1],
    );
  const isOffLinks = (spot) =>
    links.every(({ from, to }) => measureGap(spot, from, to) > radius + LABEL_RADIUS);
  const spots = OFFSETS.map(([dx, dy]) => [x + dx, y + dy]).filter(isOffLabels);
  return spots.find(isOffLinks) ?? spots[0] ?? null;
}

export class AxisLabels {
  constructor(host) {
    this.host = host;
    this.labels = [];
  }

  /**
   * Set the labels to draw.
   * @param {{ end: number[], letter: string, index?: string, length?: string }[]} labels most
   *   important first; `end` is the end of the axis, `length` its length if that is told
   */
  setLabels(labels) {
    this.labels = labels;
    while (this.host.children.length < labels.length)
      this.host.append(h("span", {}, h("i"), h("sub"), h("span")));
    labels.forEach(({ letter, index = "", length = "" }, i) => {
      const span = this.host.children[i];
      updateAttribute(span, "class", `axis-${letter}`);
      setText(span.children[0], letter);
      setText(span.children[1], index);
      setText(span.children[2], length && `: ${length}`);
    });
  }

  /**
   * Place the labels, and hide those without room.
   * @param {(point: number[]) => number[]} toPixel
   * @param {{ width: number, height: number }} size of the picture
   * @param {{ from: number[], to: number[] }[]} links their ends in pixels
   * @param {number} radius of a link, in pixels
   */
  placeLabels(toPixel, { width, height }, links, radius) {
    const placed = [];
    const transforms = this.labels.map(({ end, index = "", length = "" }) => {
      const [x, y] = toPixel(end);
      const isInside = x > -20 && y > -20 && x < width + 20 && y < height + 20;
      const labelWidth = LABEL_SIZE[0] + 4 * Math.max(0, index.length - 1) + 8 * length.length;
      const spot = isInside && findLabelSpot([x, y], labelWidth, placed, links, radius);
      if (!spot) return null;
      placed.push({ spot, width: labelWidth });
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
