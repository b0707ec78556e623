// Scripts that come when they are asked for, from beside the one that asks.

const here =
  typeof document === "undefined" ? null : /** @type {any} */ (document.currentScript)?.src;
/** @type {Map<string, Promise<void>>} */
const coming = new Map();

// When a script has run; it is loaded once, and once more where that failed.
export function loaded(name) {
  if (!coming.has(name)) coming.set(name, load(name));
  return coming.get(name);
}

/** @returns {Promise<void>} */
const load = (name) =>
  new Promise((done, failed) => {
    const onerror = () => {
      coming.delete(name);
      failed(new Error(`The script ${name} could not be loaded.`));
    };
    const script = document.createElement("script");
    const src = new URL(name, here).href;
    document.head.append(Object.assign(script, { src, onload: () => done(), onerror }));
  });
