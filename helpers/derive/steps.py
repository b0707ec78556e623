"""Frames laid on joint axes row by row: each row's four numbers take frame i-1 to frame i."""

import math
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from helpers.arm import Arm, ArmError, Joint, Row
from helpers.derive.values import POINT, Array, Axis, Case, Derivation, Line, Step, clean_length
from helpers.expressions import Entry
from helpers.inputs import floats, listed, must_be, number, numbers
from helpers.rows import cos_sin, quarter_turns

_POSE = "a rigid motion, 4x4, in m"
_NEARLY = 1e-3  # axes whose angle's sine is below this are called nearly parallel
_FAR = 10  # a common normal so many times as far off as anything drawn is no part of the arm


def derive(
    axes: Sequence[Axis],
    tip: ArrayLike,
    *,
    name: str = "arm",
    negative: bool = False,
    tolerance: float = 1e-9,
) -> Derivation:
    """The table of an arm from its joint axes, base to tip, in the drawn pose, which becomes q = 0.

    Args:
        axes: one `Axis` for each joint.
        tip: the tip's pose in the drawing, 4x4, or only its point (3,): then z_n runs along
            z_{n-1}.
        name: the arm's name.
        negative: whether x_i may run against the common normal, from z_i to z_{i-1}, where that
            turns less from x_{i-1}; a_i is negative then, as a_4 in the usual table of the Panda.
        tolerance: lines closer than this (m) are taken to meet, and to be parallel below this sine
            of their angle; an angle within a hundredth of it (rad) of a right one is taken for
            that.

    A fixed row is put first where axis 1 is not the base's z axis, and last where the last common
    normal leaves the tip elsewhere on its z axis or turned about it. Lengths become letters with
    values (``a_2``, ``d_4``), and so do angles that are no right angles (``alpha_2``, and ``phi_2``
    in the column of theta). Warns where axes that are nearly parallel, as rounded angles make them,
    have their common normal far off the arm: a larger tolerance takes them for parallel. Raises
    ArmError for anything that is no axis, no pose, or not finite.
    """
    axes = _axes(axes)
    pose = _tip_pose(tip, axes[-1])
    tolerance = number(tolerance, "tolerance", "a number above 0, as 1e-9", above=0)
    lines = _lines(axes, pose[:3, 3])
    goal = _Goal(pose, free=np.ndim(tip) == 1)
    choices = _Choices(bool(negative), tolerance)
    steps = _steps([axis.joint for axis in axes], lines, goal, choices)
    arm = Arm(name, *_lettered(steps), source="derived from its joint axes")
    reach = max(np.linalg.norm(line.point) for line in [*lines, goal.line])
    for step in steps:
        tilt = abs(math.sin(step.alpha)) if step.case in ("skew", "intersecting") else 0.0
        if abs(step.d) > _FAR * reach and 0 < tilt <= _NEARLY:
            warnings.warn(f"{name}: {_nearly_parallel(step, tilt)}", stacklevel=2)
    return Derivation(arm, tuple(steps), tuple(lines))


def _nearly_parallel(step: Step, tilt: float) -> str:
    return (
        f"z_{step.number - 1} and z_{step.number} are within {math.degrees(tilt):.2g}° of parallel,"
        f" so the last digits of that angle say where their common normal is (d_{step.number} ="
        f" {step.d:.6g} m); a tolerance above {tilt:.1g} takes them for parallel"
    )


class _Choices(NamedTuple):
    """What `derive` was told: may x_i run against the common normal, and what is near enough to
    0."""

    negative: bool
    tolerance: float


# What is given


@dataclass(frozen=True, eq=False)
class _Goal:
    """Where the last frame should come to lie, 4x4 in base axes; how it is turned about z is `free`
    or counts."""

    pose: Array
    free: bool

    @property
    def line(self) -> Line:
        return Line(self.pose[:3, 3], self.pose[:3, 2])

    def missed_by(self, frame: Array) -> float:
        """The largest difference between a frame's x axis and origin and those wanted (m, or a
        sine)."""
        columns = [3] if self.free else [0, 3]
        return float(np.abs(frame - self.pose)[:, columns].max())


def _axes(axes: Sequence[Axis]) -> tuple[Axis, ...]:
    found = listed(axes, "axes", "one Axis or more, base to tip")
    if not found:
        raise ArmError("axes are []; expected one Axis or more, base to tip")
    for axis in found:
        must_be(axis, Axis, "an item of axes")
    return found


def _pose(pose: ArrayLike, what: str, wanted: str) -> Array:
    T = numbers(pose, what, wanted, (4, 4))
    R = T[:3, :3]
    error = max(np.abs(R @ R.T - np.eye(3)).max(), np.abs(T[3] - (0, 0, 0, 1)).max())
    if error > 1e-6 or np.linalg.det(R) < 0:
        raise ArmError(f"{what} is no rigid transform, by {error:.2g}; expected {wanted}")
    return T


def _tip_pose(tip: ArrayLike, last: Axis) -> Array:
    """The tip's pose; where only its point is given, z runs along the last axis."""
    wanted = f"{_POSE}, or {POINT}"
    given = floats(tip, "tip", wanted)
    if given.ndim != 1:
        return _pose(given, "tip", wanted)
    pose = np.eye(4)
    pose[:3, 2], pose[:3, 3] = last.direction, numbers(given, "tip", wanted, (3,))
    return pose


def _lines(axes: tuple[Axis, ...], place: Array) -> list[Line]:
    """The axes' lines, that of a slide without a point laid through the next axis that turns, or
    through the tip."""
    found = []
    for axis in reversed(axes):
        point = place if axis.point is None else np.array(axis.point)
        found.append(Line(point, np.array(axis.direction)))
        if axis.joint.kind == "revolute":
            place = point
    return found[::-1]


# Row by row


def _steps(joints: list[Joint], lines: list[Line], goal: _Goal, choices: _Choices) -> list[Step]:
    """One step a joint, with a fixed one first or last where the base or the tip asks for it."""
    steps: list[Step] = []
    frame = np.eye(4)
    ways = [_Way(joint, line) for joint, line in zip(joints, lines[1:], strict=False)]
    if not _lies_on(frame, lines[0], choices.tolerance):
        ways.insert(0, _Way(Joint("fixed"), lines[0]))
    for i, way in enumerate([*ways, _Way(joints[-1], goal.line, goal)], 1):
        steps.append(_step(i, frame, way, choices))
        frame = steps[-1].frame
    if goal.missed_by(frame) >= choices.tolerance:
        steps.append(_last_step(len(steps) + 1, frame, goal, choices))
    return steps


def _lies_on(frame: Array, line: Line, tolerance: float) -> bool:
    """Whether a line is the z axis of a frame, in the same direction."""
    _, _, z, o = frame[:3].T
    apart = np.linalg.norm(np.cross(z, line.point - o))
    return bool(np.linalg.norm(z - line.z) < tolerance and apart < tolerance)


class _Way(NamedTuple):
    """What moves a row, the line of the next z axis, and where the last frame should come to
    lie."""

    joint: Joint
    line: Line
    goal: _Goal | None = None


def _step(i: int, frame: Array, way: _Way, choices: _Choices) -> Step:
    """The row from a frame to the next."""
    joint, line, goal = way
    x, _, z, o = frame[:3].T
    wish = x if goal is None or goal.free else goal.pose[:3, 0]
    crossed = np.linalg.norm(np.cross(z, line.z)) >= choices.tolerance
    case, along = (_crossed if crossed else _side_by_side)(frame, line, wish, choices)
    theta = _angle(float(np.cross(x, along) @ z), float(x @ along), choices)
    alpha = math.pi if z @ line.z < 0 else 0.0
    if crossed:
        alpha = _angle(float(np.cross(z, line.z) @ along), float(z @ line.z), choices)
    # From here on in the axes of the row's own angles, so that a rounded angle is made up for by a
    # and d.
    x_i, y_i, z_i, _ = (frame @ _link(0, alpha, 0, theta))[:3].T
    if crossed:
        out = line.point - o
        a, d = out @ x_i, out @ y_i / math.sin(alpha)
    else:
        level = o if goal is None else goal.pose[:3, 3]
        out = line.point + ((level - line.point) @ z_i) * z_i - o
        a, d = out @ x_i, out @ z
    a, d = clean_length(a * (case in ("skew", "parallel"))), clean_length(d, choices.tolerance)
    start = o + d * z
    opposite = not crossed and alpha != 0
    reached = frame @ _link(a, alpha, d, theta)
    feet = np.array([start, start + a * x_i])
    return Step(i, joint, case, opposite, feet, frame, reached, a, alpha, d, theta)


def _last_step(i: int, frame: Array, goal: _Goal, choices: _Choices) -> Step:
    """The fixed row that brings a frame on the tip's z axis into the tip: a turn about it and a
    shift along it."""
    x, _, z, o = frame[:3].T
    wish = x if goal.free else goal.pose[:3, 0]
    d, theta = (
        clean_length((goal.pose[:3, 3] - o) @ z),
        _angle(np.cross(x, wish) @ z, x @ wish, choices),
    )
    reached = frame @ _link(0, 0, d, theta)
    feet = np.array([reached[:3, 3]] * 2)
    return Step(i, Joint("fixed"), "coincident", False, feet, frame, reached, 0.0, 0.0, d, theta)


def _side_by_side(frame: Array, line: Line, wish: Array, choices: _Choices) -> tuple[Case, Array]:
    """Parallel lines, or one line: which of the two, and x_i."""
    _, _, z, o = frame[:3].T
    out = line.point - o
    across = out - (out @ z) * z
    away = np.linalg.norm(across)
    if away < choices.tolerance:
        along = wish - (wish @ z) * z
        return "coincident", along / np.linalg.norm(along)
    along = across / away
    return "parallel", _nearer(along, wish, choices) if choices.negative else along


def _crossed(frame: Array, line: Line, wish: Array, choices: _Choices) -> tuple[Case, Array]:
    """Lines that meet or pass each other: which of the two, and x_i."""
    _, _, z, o = frame[:3].T
    along = np.cross(z, line.z)
    along = along - (along @ z) * z  # rounding leaves some of it where they are nearly parallel
    along = along / np.linalg.norm(along)
    gap = (line.point - o) @ along
    if abs(gap) < choices.tolerance:
        return "intersecting", _nearer(along, wish, choices)
    out = math.copysign(1, gap) * along
    return "skew", _nearer(out, wish, choices) if choices.negative else out


def _nearer(along: Array, wish: Array, choices: _Choices) -> Array:
    """A direction or its opposite, whichever turns less from `wish`; the direction where both turn
    as much."""
    return -along if along @ wish < -choices.tolerance else along


def _link(a: float, alpha: float, d: float, theta: float) -> Array:
    """A_i at q_i = 0."""
    (ca, sa), (c, s) = cos_sin(alpha), cos_sin(theta)
    return np.array(
        [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]]
    )


def _angle(sine: float, cosine: float, choices: _Choices) -> float:
    """The angle with this sine and cosine, in (-pi, pi]; a multiple of a right angle is exact."""
    angle = math.atan2(sine, cosine)
    turns = round(angle / (math.pi / 2))
    if abs(angle - turns * math.pi / 2) >= choices.tolerance / 100:
        return angle
    return math.pi if abs(turns) == 2 else turns * math.pi / 2


# In letters


_RIGHT: dict[int, Entry] = {0: 0, 1: "pi/2", -1: "-pi/2", 2: "pi"}


def _lettered(steps: Sequence[Step]) -> tuple[list[Row], dict[str, float]]:
    """The rows with letters for their lengths and odd angles, and the values of the letters."""
    values: dict[str, float] = {}

    def length(letter: str, i: int, value: float) -> Entry:
        if not value:
            return 0
        values[f"{letter}_{i}"] = abs(value)
        return f"{letter}_{i}" if value > 0 else f"-{letter}_{i}"

    def angle(letter: str, i: int, value: float) -> Entry:
        turns = quarter_turns(value)
        return length(letter, i, value) if turns is None else _RIGHT[turns]

    rows = [
        Row(
            length("a", step.number, step.a),
            angle("alpha", step.number, step.alpha),
            length("d", step.number, step.d),
            angle("phi", step.number, step.theta),
            step.joint,
        )
        for step in steps
    ]
    return rows, values
