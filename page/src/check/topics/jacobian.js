// Check Jacobians and joint torques.

import { numbers } from "../../../../judge/reading/numbers.js";
import { compareJacobian } from "../../../../judge/topics/jacobian.js";
import { readSymbolValues } from "../../../../judge/reading/values.js";
import { ArmError } from "../../../../judge/sentences.js";
import { compareTorques } from "../../../../judge/topics/torques.js";

/** @type {import("../question.js").Checker} */
export function checkJacobian({ answer, q, unit, frame, first, lengths, values }, arm, page) {
  if (Number(frame) > arm.rows.length) {
    throw new ArmError(`frame is ${frame}; expected a whole number from 0 to ${arm.rows.length}`);
  }
  const how = {
    angles: unit,
    frame: Number(frame),
    angularFirst: first === "omega",
    lengths,
    ...page,
  };
  return compareJacobian(answer, arm, q, { ...how, values: readSymbolValues(values) });
}

/** @type {import("../question.js").Checker} */
export const checkTorques = ({ answer, q, unit, wrench }, arm) =>
  compareTorques(answer, arm, q, { angles: unit, wrench: parseWrench(wrench) });

function parseWrench(text) {
  if (!text.trim()) return undefined;
  const { values } = numbers(text, "the wrench");
  if (values.length !== 6) {
    throw new ArmError(
      `the wrench has ${values.length} numbers; expected six, three of force and three of moment`,
    );
  }
  return values;
}
