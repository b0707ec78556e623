// Advises settings to change if the question, not the answer, may be wrong. The page makes a button
// of each setting, and Python names its argument.

/**
 * A setting to change.
 * @typedef {object} Advice
 * @property {string} field an option of the judge (angles, angularFirst, convention, frame,
 *   lengths), or "locked" (the number of a joint to lock), "arm" (the name of another arm),
 *   "values" (a symbol that needs a number), "ownJoints" (rows of a right table whose joints count
 *   otherwise, as text)
 * @property {string | number | boolean} value
 */

const adviseOtherUnit = (_, { angles }) => ({
  field: "angles",
  value: angles === "deg" ? "rad" : "deg",
});

/**
 * The advice that follows from a cause and its first field.
 * @type {Record<string, (field: string, options: Record<string, any>) => Advice>}
 */
const ADVICE_BY_CAUSE = {
  "J.halves": (_, { angularFirst }) => ({ field: "angularFirst", value: !angularFirst }),
  "J.frame": (frame) => ({ field: "frame", value: Number(frame) }),
  "J.millimetres": () => ({ field: "lengths", value: "mm" }),
  "J.degrees": adviseOtherUnit,
  "tau.degrees": adviseOtherUnit,
  "ik.degrees": adviseOtherUnit,
  "ik.radians": adviseOtherUnit,
  "trace.degrees": adviseOtherUnit,
  "trace.radians": adviseOtherUnit,
  "table.craig": () => ({ field: "convention", value: "craig" }),
};

/**
 * Return the settings that the causes of a verdict advise, without those that are set already.
 * @param {string[]} causes names; a pair of mistakes is "J.frame:3 + J.millimetres"
 * @param {Record<string, any>} options of the question
 * @returns {Advice[]}
 */
export function adviseOnCauses(causes, options) {
  const names = new Set(causes.flatMap((name) => name.split(" + ")));
  const advice = [...names].map((name) => {
    const [key, field] = name.split(":");
    return ADVICE_BY_CAUSE[key]?.(field, options);
  });
  return advice.filter((setting) => setting && options[setting.field] !== setting.value);
}
