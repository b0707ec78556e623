// What comes in further scripts, loaded when the first of it is asked for: small figures that stand
// beside a sentence, views of the instrument, by name, and the reader of pasted tables.

/**
 * @typedef {(host: HTMLElement, spec: any) => () => void} MakeFigure builds into the host, returns
 *   what takes it away
 */

/** @type {Record<string, MakeFigure>} */
const FIGURES = {};
const VIEWS = {};
const here =
  typeof document === "undefined" ? null : /** @type {any} */ (document.currentScript)?.src;
const MORE = "explorer-more.js";
/** @type {Record<string, Promise<void>>} */
const loading = {};
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
  if (!Object.hasOwn(VIEWS, name)) await load(MORE);
  return VIEWS[name];
}

export const registerReader = (read) => void (reader = read);

/** The reader of pasted tables, when its script has come. */
export async function lateReader() {
  if (!reader) await load("explorer-table.js");
  return reader;
}

function load(script) {
  loading[script] ??= new Promise((done, failed) => {
    const src = new URL(script, here).href;
    const onload = () => done();
    document.head.append(
      Object.assign(document.createElement("script"), { src, onload, onerror: failed }),
    );
  });
  return loading[script];
}

// Bring a figure to life, at once or when its script has come; returns what takes it away.
export function mountFigure(host, spec) {
  let gone = false;
  let dispose = () => {};
  const make = () => {
    if (!gone && Object.hasOwn(FIGURES, spec.figure)) dispose = FIGURES[spec.figure](host, spec);
  };
  if (Object.hasOwn(FIGURES, spec.figure)) make();
  else if (here) load(MORE).then(make, () => {});
  return () => {
    gone = true;
    dispose();
  };
}
