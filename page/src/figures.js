// What comes in further scripts, loaded when the first of it is asked for: small figures that stand
// beside a sentence, views of the instrument, by name, and the reader of pasted tables.

import { loaded } from "./scripts.js";

/**
 * @typedef {(host: HTMLElement, spec: any) => () => void} MakeFigure builds into the host, returns
 *   what takes it away
 */

/** @type {Record<string, MakeFigure>} */
const FIGURES = {};
const VIEWS = {};
const MORE = "explorer-more.js";
/** @type {typeof import("./paste.js").readTable | null} */
let reader = null;

/** @param {string} name @param {MakeFigure} make */
export function registerFigure(name, make) {
  FIGURES[name] = make;
}

/** @param {string} name @param {{ build: Function }} view */
export function registerView(name, view) {
  VIEWS[name] = view;
}

/** A view of the second script, when that has come. */
export async function lateView(name) {
  if (!Object.hasOwn(VIEWS, name)) await loaded(MORE);
  return VIEWS[name];
}

export const registerReader = (read) => void (reader = read);

/** The reader of pasted tables, when its script has come. */
export async function lateReader() {
  if (!reader) await loaded("explorer-table.js");
  return reader;
}

// Bring a figure to life, at once or when its script has come; returns what takes it away.
export function mountFigure(host, spec) {
  let gone = false;
  let dispose = () => {};
  const make = () => {
    if (!gone && Object.hasOwn(FIGURES, spec.figure)) dispose = FIGURES[spec.figure](host, spec);
  };
  if (Object.hasOwn(FIGURES, spec.figure)) make();
  else loaded(MORE).then(make, () => {});
  return () => {
    gone = true;
    dispose();
  };
}
