// What a reader may set where a cause says that the question was another, rather than the answer
// wrong: a field of the question and its value. A page makes a button of it, Python an argument.

/**
 * `field` is an option of the judge's: angles, angularFirst, convention, frame, lengths; or
 * "locked", the number of a joint to be locked, "arm", the name of another arm, "values", a symbol
 * that needs a number, or "ownJoints", the arm in the joints of a right table.
 * @typedef {{ field: string, value: any }} Advice
 */

/** @type {Record<string, (place: string, options: any) => Advice>} */
const BY_CAUSE = {
  "J.halves": (_, { angularFirst }) => ({ field: "angularFirst", value: !angularFirst }),
  "J.frame": (place) => ({ field: "frame", value: Number(place) }),
  "J.degrees": () => ({ field: "angles", value: "deg" }),
  "tau.degrees": () => ({ field: "angles", value: "deg" }),
  "ik.degrees": () => ({ field: "angles", value: "deg" }),
  "trace.degrees": () => ({ field: "angles", value: "deg" }),
  "table.craig": () => ({ field: "convention", value: "craig" }),
};

// What the causes of a report advise, each of two mistakes for itself: nothing where it is set
// already.
/** @returns {Advice[]} */
export function adviseOnCauses(causes, options) {
  const names = new Set(causes.flatMap((name) => name.split(" + ")));
  const found = [...names].map((name) => {
    const [key, place] = name.split(":");
    return BY_CAUSE[key]?.(place, options);
  });
  return found.filter((one) => one && options[one.field] !== one.value);
}
