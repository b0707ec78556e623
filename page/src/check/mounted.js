// The judges of the page, for the script of extras (scripts/page.js).

/** @type {import("./page.js").Judge[]} */
export const judges = [];
