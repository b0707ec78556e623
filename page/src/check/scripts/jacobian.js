// The script that judges Jacobians and torques.

import { numbers } from "../../../../judge/reading/numbers.js";
import { compareJacobian } from "../../../../judge/topics/jacobian.js";
import { ownValues, valuesCall } from "../../../../judge/reading/values.js";
import { register } from "../checkers.js";
import { ArmError, quoted } from "../../../../judge/sentences.js";
import { compareTorques } from "../../../../judge/topics/torques.js";

const inDegrees = ({ unit }) => (unit === "deg" ? ['angles="deg"'] : []);

register("jacobian", {
  verdict({ answer, q, unit, frame, first, values }, arm) {
    if (Number(frame) > arm.rows.length) {
      throw new ArmError(`frame is ${frame}; expected a whole number from 0 to ${arm.rows.length}`);
    }
    const how = { angles: unit, frame: Number(frame), angularFirst: first === "omega" };
    return compareJacobian(answer, arm, q, { ...how, values: ownValues(values) });
  },
  call(question, name) {
    const given = ["mine", name, quoted(question.q.trim()), ...inDegrees(question)];
    if (question.first === "omega") given.push("angular_first=True");
    if (question.frame !== "0") given.push(`frame=${Number(question.frame)}`);
    return `checks.compare_jacobian(${[...given, ...valuesCall(question.values)].join(", ")})`;
  },
});

register("torques", {
  verdict: ({ answer, q, unit, wrench }, arm) =>
    compareTorques(answer, arm, q, { angles: unit, wrench: wrenchOf(wrench) }),
  call(question, name) {
    const wrench = wrenchOf(question.wrench);
    const given = ["mine", name, quoted(question.q.trim())];
    if (wrench) given.push(`wrench=(${wrench.join(", ")})`);
    return `checks.compare_torques(${[...given, ...inDegrees(question)].join(", ")})`;
  },
});

function wrenchOf(text) {
  if (!text.trim()) return undefined;
  const { values } = numbers(text, "the wrench");
  if (values.length !== 6) {
    throw new ArmError(
      `the wrench has ${values.length} numbers; expected six, three of force and three of moment`,
    );
  }
  return values;
}
