// The kinds of questions: what each is called, the fields it has besides arm and answer, and the
// script of its checker.

/**
 * `longest` is how many characters of an answer are judged, where they may be more than usual.
 * @type {Record<string, { title: string, fields: string[], script: string, longest?: number }>}
 */
export const ASKED = {
  jacobian: {
    title: "Jacobian at a pose",
    fields: ["q", "unit", "frame", "first", "values"],
    script: "jacobian",
  },
  torques: {
    title: "Joint torques at a pose",
    fields: ["q", "unit", "wrench"],
    script: "jacobian",
  },
  table: {
    title: "Denavit-Hartenberg table",
    fields: ["columns", "lengths", "angles", "convention", "values"],
    script: "table",
  },
  branches: {
    title: "All joint angles for a target",
    fields: ["target", "unit"],
    script: "motion",
  },
  pose: { title: "Joint angles for one pose", fields: ["target", "unit"], script: "motion" },
  trace: {
    title: "Joints along a circle",
    fields: ["q", "unit", "radius", "plane", "period", "steps", "pace"],
    script: "motion",
    longest: 5_000_000,
  },
};
