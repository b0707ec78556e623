// What comes in a second script, loaded when the first of it is asked for: small figures that stand
// beside a sentence, and views of the instrument, by name.

/**
 * @typedef {(host: HTMLElement, spec: any) => () => void} MakeFigure builds into the host, returns
 *   what takes it away
 */

/** @type {Record<string, MakeFigure>} */
const FIGURES = {};
const VIEWS = {};
const here =
  typeof document === "undefined" ? null : /** @type {any} */ (document.currentScript)?.src;
let loading = null;

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
  if (!Object.hasOwn(VIEWS, name)) await load();
  return VIEWS[name];
}

function load() {
  loading ??= new Promise((done, failed) => {
    const src = new URL("explorer-more.js", here).href;
    document.head.append(
      Object.assign(document.createElement("script"), { src, onload: done, onerror: failed }),
    );
  });
  return loading;
}

// Bring a figure to life, at once or when its script has come; returns what takes it away.
export function mountFigure(host, spec) {
  let gone = false;
  let dispose = () => {};
  const make = () => {
    if (!gone && Object.hasOwn(FIGURES, spec.figure)) dispose = FIGURES[spec.figure](host, spec);
  };
  if (Object.hasOwn(FIGURES, spec.figure)) make();
  else if (here) load().then(make, () => {});
  return () => {
    gone = true;
    dispose();
  };
}
