// Small figures that stand beside a sentence, by name.

/**
 * @typedef {(host: HTMLElement, spec: any) => () => void} MakeFigure builds into the host, returns what takes it away
 */

/** @type {Record<string, MakeFigure>} */
export const FIGURES = {};

/** @param {string} name @param {MakeFigure} make */
export function registerFigure(name, make) {
  FIGURES[name] = make;
}
