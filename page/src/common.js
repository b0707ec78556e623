// The styles that the instrument and the small figures have in common.

import css from "./common.css";

/** @type {string} */
export const common = css;
