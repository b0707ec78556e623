// Refuses an answer that its own text contradicts, for example by "[0.5, 1] = [28.6°, 60°]", or by
// rows that are called y before x.

import { number } from "./formula.js";
import { agree } from "./repetitions.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

/** @typedef {import("./block.js").Block} Block */

// The text between two lists: brackets, a unit and "=".
const EQUALS = new RegExp(
  String.raw`^[\s\])}]*(?:\\?(?:text|mathrm)?\{?(?:rad(?:ians?)?|deg(?:rees?)?|°)\}?)?` +
    String.raw`[\s,]*[=≈][\s[({]*(?:np\.array\()?[\s[({]*$`,
);

/**
 * Raise an error if "=" joins a row of the answer to a different row. A row in radians and a row in
 * degrees may be equal.
 * @param {string} text @param {Block} block
 */
export function refuseUnequalLists(text, { sources, lines }) {
  const rowsOfBlock = new Set(sources);
  for (const row of lines.all) {
    if (rowsOfBlock.has(row) || row.cells.length < 2) continue;
    const source = sources.find(
      (joined) => areJoined(text, joined, row) || areJoined(text, row, joined),
    );
    if (!source || areEqual(source, row)) continue;
    const ends = [...source.cells, ...row.cells].flatMap(({ from, to }) => [from, to]);
    const quoted = quoteText(text.slice(Math.min(...ends), Math.max(...ends)));
    throw new ArmError(formatMessage("two units", { text: quoted }));
  }
}

const areJoined = (text, first, second) =>
  first.cells.length === second.cells.length &&
  EQUALS.test(text.slice(first.cells.at(-1).to, second.cells[0].from));

const areEqual = ({ cells }, { cells: others }) =>
  cells.every((cell, k) => {
    const [one, other] = [cell, others[k]].map(({ text }) => text.replace(/ deg$/, ""));
    const [x, y] = [number(one), number(other)];
    const decimals = Math.min(...[one, other].map((text) => text.split(".")[1]?.length ?? 0));
    const areClose = Math.abs(x - y) <= 1.01 * 10 ** -decimals;
    return areClose || agree(String(x), other) || agree(String(y), one);
  });

// The axis at the end of a label, such as y of "vy", "w_y", "ry:" and "theta_y".
const AXIS = /(?:^|[\s_{(vwrωd]|rot|ang|lin|theta|omega)([xyz])[\s})\].:=|,]*$/i;

/**
 * Raise an error if the labels of all rows end with an axis, and the order is not x, y, z.
 * @param {Block} block in the order in which it is judged @param {string} what the answer
 */
export function refuseContraryRows({ labels }, what) {
  const texts = labels.map((words) => words.at(-1)?.text ?? "");
  const axes = texts.map((text) => AXIS.exec(text)?.[1].toLowerCase());
  if (axes.length < 2 || axes.includes(undefined)) return;
  if (axes.every((axis, k) => k % 3 === 0 || axis > axes[k - 1])) return;
  throw new ArmError(formatMessage("contrary rows", { what, names: texts.join(", ") }));
}
