// What the explorer claims in words: rank, ways, same arm or not. The tests hold each against
// Python.

import { isOutsideLimits } from "../../judge/geometry/arm.js";
import { isSameMachine } from "../../judge/geometry/axes.js";
import { dot, movingRows, linkFrames, minus, norm } from "../../judge/geometry/kinematics.js";
import { fixed, motionText } from "./text.js";
import { joinList, capitalize } from "../../judge/sentences.js";

const RANK = 1e-6; // singular values below this share of the largest count as zero

// How many rows of the Jacobian the arm is for: an arm with fewer than six joints is asked for the
// place only.
export const asked = (arm) => (movingRows(arm).length < 6 ? 3 : 6);

// What its joints are found for.
export const aim = (arm) => (asked(arm) < 6 ? "place" : "pose");

export const rankOf = (values) => values.filter((value) => value > RANK * values[0]).length;

// The rank that the arm has where it is not singular, as far as its joints can give it.
export const fullRank = (arm) => Math.min(asked(arm), movingRows(arm).length);

/**
 * @param {{ arm: Arm, rank: number, lost: number[][] }} derived
 */
export function rankVerdict({ arm, rank, lost }) {
  const [full, rows] = [fullRank(arm), asked(arm)];
  const singular = rank < full;
  if (!singular) return { singular, text: reachOf(rank, full, movingRows(arm).length) };
  return { singular, text: `Singular: rank ${rank} of ${full}. ${cannot(lost, full < rows)}` };
}

// Where a tip of this rank can go.
function reachOf(rank, full, dof) {
  if (!dof) return "No joint moves this arm.";
  if (full === 6) return "Rank 6: the tip can move along and turn about every direction.";
  if (full < 3)
    return `Rank ${rank}, the most that ${dof > 1 ? `${dof} joints` : "one joint"} can have.`;
  const turns = "with fewer than six joints it cannot be turned at will as well";
  return `Rank 3: the tip can move along every direction; ${turns}.`;
}

const strong = (direction) => direction.filter((v) => Math.abs(v) > 0.02).length;

function cannot(lost, never) {
  if (!lost.length || never) return "";
  const single = lost.filter((d) => strong(d) === 1).map(motionText);
  const blends = lost.filter((d) => strong(d) > 1).map((d) => `make the motion ${motionText(d)}`);
  return `Here the tip cannot ${joinList([...single, ...blends], "nor")}.`;
}

const COUNTS = "No One Two Three Four Five Six Seven Eight".split(" ");
const counted = (n) => `${COUNTS[n] ?? n} ${n === 1 ? "way" : "ways"}`;
const named = (arm, moving) => joinList(moving.map((k) => `joint ${movingRows(arm)[k] + 1}`));

/**
 * How many ways there are, or that there are infinitely many and which joints are free.
 * @param {import("../../judge/geometry/arm.js").Arm} arm
 * @param {{ list: object[], families: { moving: number[] }[], held: number, whole: boolean }} ways
 */
export function waysVerdict(arm, { list, families = [], held = -1, whole = true }) {
  const pose = whole ? "pose" : "place, whatever the tool’s direction";
  const few = list.length - families.length;
  const fixedJoint =
    held < 0
      ? ""
      : ` with joint ${movingRows(arm)[held] + 1} held where it is; ` +
        "free, it makes them infinitely many";
  if (!families.length) return `${counted(list.length)} to this ${pose}${fixedJoint}.`;
  const free = families[0].moving;
  const how =
    free.length === 1
      ? `${named(arm, free)} is free`
      : `${named(arm, free)} are free to move together`;
  const kinds = families.length > 1 ? `, in ${families.length} families` : "";
  const rest = few ? ` and ${counted(few).toLowerCase()} more` : "";
  const still = held < 0 ? "" : `, joint ${movingRows(arm)[held] + 1} held`;
  const shown = `one of each is shown${rest}${still}`;
  return `Infinitely many ways to this ${pose}: ${how}${kinds}; ${shown}.`;
}

// The joints of which something holds, by their rows in the table.
export const jointNames = (arm, holds) =>
  movingRows(arm).flatMap((row, k) => (holds(row, k) ? [`joint ${row + 1}`] : []));

// The joints that pass a limit on a path.
export const pastLimits = (arm, path) =>
  jointNames(arm, (row, k) => path.some((q) => isOutsideLimits(arm.rows[row], q[k])));

// Why a dragged tip stops short of the pointer.
export function stopVerdict({ stops = [], short = 0 }) {
  if (short < 0.002) return "";
  const reason = stops.length ? joinList(stops) : "out of reach";
  return `${capitalize(reason)}: ${fixed(1000 * short, 0)} mm short.`;
}

// What a dragged tip has to say: why it stops, or that it is about to.
export function holdVerdict(hold) {
  if (!hold?.target) return "";
  const stopped = hold.moving ? "" : stopVerdict(hold);
  if (stopped || !hold.fading?.length) return stopped;
  const arrows = hold.fading.length > 1 ? "the arrows" : "the arrow";
  const gone = hold.fading.every(({ share }) => share < 1e-3);
  return gone
    ? `Singular: the tip cannot move along ${arrows}.`
    : `Nearly singular along ${arrows}.`;
}

const HOW_TO =
  "Type into any entry: 0.333, −90°, pi/2, or paste a whole table. " +
  "The arm follows, and the first one stays as a ghost.";

/**
 * Whether a typed table is the arm behind it, and how far the tips are apart.
 * @typedef {import("../../judge/geometry/arm.js").Arm} Arm
 * @param {{ arm: Arm, reference: Arm, q: number[] }} state
 * @param {{ frames: any[] }} derived
 */
export function tableVerdict({ arm, reference, q }, { frames }) {
  if (arm === reference) return HOW_TO;
  const counts = [arm, reference].map((one) => movingRows(one).length);
  if (counts[0] !== counts[1])
    return `Yours has ${counts[0]} joints, the ${reference.name} ${counts[1]}.`;
  const [mine, first] = [frames.at(-1), linkFrames(reference, q).at(-1)];
  const cosine = (dot(mine.x, first.x) + dot(mine.y, first.y) + dot(mine.z, first.z) - 1) / 2;
  const turn = (Math.acos(Math.max(-1, Math.min(1, cosine))) * 180) / Math.PI;
  const far = 1000 * norm(minus(mine.o, first.o));
  const apart = `${fixed(far, 1)} mm and ${fixed(turn, 1)}°`;
  const here = `at these joint values its tip is ${apart} away from the ghost’s`;
  if (!same(arm, reference)) return `Another arm than the ${reference.name}: ${here}.`;
  if (far < 0.05 && turn < 0.05) return `The same arm as the ${reference.name}: ${here}.`;
  return (
    `The same arm as the ${reference.name}, ` +
    `with another zero, direction or frame that is free to choose: ` +
    `${here}, but other joint values bring it there.`
  );
}

// Compared once for each pair of tables, not for each pose.
let last = { arm: null, reference: null, is: false };
function same(arm, reference) {
  if (last.arm !== arm || last.reference !== reference)
    last = { arm, reference, is: isSameMachine(arm.rows, reference.rows) };
  return last.is;
}
