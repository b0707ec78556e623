// What comes in further scripts, loaded when the first of it is asked for: small figures that stand
// beside a sentence, views of the instrument, and the reader of pasted tables, by name.

import { loaded } from "./scripts.js";

const MORE = "explorer-more.js";
/** @type {Record<string, any>} */
const known = {};

/** @param {Record<string, any>} things by their names */
export const register = (things) => void Object.assign(known, things);

/** What is called so, when its script has come. */
export async function late(name, script = MORE) {
  if (!Object.hasOwn(known, name)) await loaded(script);
  return known[name];
}

/**
 * Bring a figure to life, at once or when its script has come: `make(host, spec)` builds into the
 * host and returns what takes it away; so does this.
 */
export function mountFigure(host, spec) {
  let gone = false;
  let dispose = () => {};
  late(spec.figure).then(
    (make) => {
      if (!gone && make) dispose = make(host, spec);
    },
    () => {},
  );
  return () => {
    gone = true;
    dispose();
  };
}
