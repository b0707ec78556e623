// The kinds of questions: what each is called, the fields it has besides arm and answer, and the script of its checker.

/** @type {Record<string, { title: string, fields: string[], script: string }>} */
export const ASKED = {
  jacobian: { title: "Jacobian at a pose", fields: ["q", "unit", "frame", "first"], script: "jacobian" },
  torques: { title: "Joint torques at a pose", fields: ["q", "unit", "wrench"], script: "jacobian" },
};
