// The frame of all topics: an answer is read, compared and reported. A topic holds what differs.

import { causeName, joinCauseMessages } from "../causes/ranking.js";
import { WRONG } from "../digits.js";
import { formatMessage, joinList, toClause } from "../sentences.js";
import { completeVerdicts, makeFinding, makeVerdict } from "../verdict.js";
import { judgeWholeOrBeginning } from "./beginning.js";
import { askAboutDegrees } from "./degrees.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */
/** @typedef {import("../verdict.js").Verdict} Verdict */
/**
 * A topic: how its answers are read and compared, and the sentences about them.
 * @typedef {object} Topic
 * @property {string} name
 * @property {Record<string, string>} sentences keys of the headlines, by grade; "wrong" has the
 *   field `cause`, and "places" is said of several wrong places
 * @property {Record<string, string>} otherUnit keys of the messages that the other unit of angles
 *   was typed, by the unit that was typed
 * @property {(arm: Arm, given: any, options: any) => any} ask makes the question from what is given
 * @property {(mine: any, question: any) => any} read throws a NoFitError if there are too few
 *   numbers; the answer has the numbers as `typed`
 * @property {(answer: any, question: any) => Outcome} compare
 * @property {(answer: any, question: any) => { values: number[], angles?: string }?} getAngles
 *   the joint values that may be in the other unit, and their unit if the text names it
 * @property {(question: any) => import("./beginning.js").Beginning[]} listBeginnings
 */
/**
 * The result of a comparison. The frame writes the headline, unless there is one.
 * @typedef {Partial<Omit<Verdict, "causes">> & { grade: string,
 *   causes?: import("../causes/ranking.js").Cause[], causeNames?: string[],
 *   fields?: Record<string, any> }} Outcome `causes` explain the whole answer, `causeNames` are
 *   further names, `fields` are those of the headline
 */

/**
 * Make the judge of a topic.
 * @param {Topic} topic
 * @returns {(mine: any, arm: Arm, given: any, options?: any) => Verdict}
 */
export function makeJudge(topic) {
  const judge = (mine, arm, given, options = {}) => {
    const question = topic.ask(arm, given, options);
    const judgeWhole = () => {
      const answer = topic.read(mine, question);
      const outcome = topic.compare(answer, question);
      const verdict = { ...reportOutcome(topic, arm, outcome), typed: answer.typed };
      const angles = topic.getAngles(answer, question);
      return angles
        ? askAboutDegrees(verdict, {
            arm,
            angles: options.angles,
            ...angles,
            keys: topic.otherUnit,
            judgeIn: (unit) => judge(mine, arm, given, { ...options, angles: unit }),
            makeHeadline: (cause) => formatWrong(topic, arm, outcome.fields, cause),
          })
        : verdict;
    };
    const listBeginnings = () => topic.listBeginnings(question);
    return judgeWholeOrBeginning(mine, judgeWhole, { topic: topic.name, arm, listBeginnings });
  };
  return completeVerdicts(judge);
}

const formatWrong = ({ sentences }, arm, fields, cause) =>
  formatMessage(sentences.wrong, { arm: arm.name, ...fields, cause: toClause(cause) });

/**
 * Make the verdict on an outcome. The headline of a wrong answer has the causes, or else the only
 * finding, or else the places of all findings.
 * @param {Pick<Topic, "name" | "sentences">} topic @param {Arm} arm @param {Outcome} outcome
 * @returns {Verdict}
 */
function reportOutcome(topic, arm, outcome) {
  const { causes = [], causeNames = [], findings = [], fields: _, ...others } = outcome;
  const cause = causes.length ? `${joinCauseMessages(causes)}.` : "";
  const headline = outcome.headline ?? writeHeadline(topic, arm, outcome, cause);
  return makeVerdict(topic.name, arm, outcome.grade, headline, {
    ...others,
    findings: cause ? [makeFinding("cause", cause), ...findings] : findings,
    causes: [...causes.map(causeName), ...causeNames],
  });
}

function writeHeadline(topic, arm, { grade, findings = [], fields = {} }, cause) {
  const { sentences } = topic;
  if (grade !== WRONG) return formatMessage(sentences[grade], { arm: arm.name, ...fields });
  const explanation = cause || (findings.length === 1 ? findings[0].words : "");
  if (explanation) return formatWrong(topic, arm, fields, explanation);
  const places = joinList(findings.map(({ where }) => where));
  return formatMessage(sentences.places, { arm: arm.name, places, ...fields });
}
