// Small figures that stand beside a sentence, by name. They are in a script of their own, loaded when the first of them
// is near.

/**
 * @typedef {(host: HTMLElement, spec: any) => () => void} MakeFigure builds into the host, returns what takes it away
 */

/** @type {Record<string, MakeFigure>} */
const FIGURES = {};
const here = typeof document === "undefined" ? null : /** @type {any} */ (document.currentScript)?.src;
let loading = null;

/** @param {string} name @param {MakeFigure} make */
export function registerFigure(name, make) {
  FIGURES[name] = make;
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
