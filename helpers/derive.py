"""From the joint axes of an arm to its Denavit-Hartenberg table, row by row, as one does it by
hand.

Draw the arm in some pose, say where each joint's axis lies and where the base and the tip are, and
`derive` lays the frames: z_{i-1} on axis i, x_i along the common normal from z_{i-1} to z_i, o_i
where that normal meets z_i. The four numbers of a row take frame i-1 to frame i. Where the
convention leaves a choice it is always made the same way, and each row's `words` say how. The drawn
pose is q = 0. Source: Spong, Hutchinson and Vidyasagar, Robot Modeling and Control, section 3.2.2;
Craig, Introduction to Robotics, section 3.4, for the modified table, which has the same common
normals.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm, ArmError, Body, Joint, Row
from helpers.conventions import modified_from_standard
from helpers.expressions import Entry
from helpers.inputs import floats, listed, must_be, number, numbers, shown
from helpers.kinematics import link_frames
from helpers.rows import cos_sin, quarter_turns

__all__ = ["Axis", "Derivation", "Line", "Step", "derive"]

Array = NDArray[np.float64]
Case = Literal["skew", "intersecting", "parallel", "coincident"]

_POINT = "a point (x, y, z) in m"
_POSE = "a rigid motion, 4x4, in m"
_NEARLY = 1e-3  # axes whose angle's sine is below this are called nearly parallel


@dataclass(frozen=True)
class Axis:
    """A joint's axis in the drawn pose: a point on it (m), its direction, and what moves there.

    The direction is that of positive motion, by the right-hand rule where the joint turns; its
    length does not matter. `joint` is a `Joint`, or only its kind. An axis that slides has a
    direction but no place of its own: it is laid where it is drawn, or, without a `point`, through
    the next axis that turns (through the tip if none does).

    Raises:
        ArmError: no point or direction of three finite numbers, a direction of length 0, a kind
            that does not move, or an axis that turns without a point.
    """

    point: tuple[float, float, float] | None
    direction: tuple[float, float, float]
    joint: Joint = field(default_factory=Joint)

    def __post_init__(self) -> None:
        joint = Joint(self.joint) if isinstance(self.joint, str) else self.joint
        must_be(joint, Joint, "an axis's joint")
        if joint.kind == "fixed":
            raise ArmError("an axis's joint is fixed; expected revolute or prismatic")
        object.__setattr__(self, "joint", joint)
        object.__setattr__(self, "direction", _unit(self.direction))
        if self.point is not None:
            point = numbers(self.point, "an axis's point", _POINT, (3,))
            object.__setattr__(self, "point", tuple(map(float, point)))
        elif joint.kind == "revolute":
            raise ArmError(f"the point of an axis that turns is None; expected {_POINT}")


def _unit(direction: ArrayLike) -> tuple[float, ...]:
    wanted = "a vector of three finite numbers, not all 0"
    vector = numbers(direction, "an axis's direction", wanted, (3,))
    largest = np.abs(vector).max()
    if not largest:
        raise ArmError(f"an axis's direction is {direction!r}; expected {wanted}")
    vector = vector / largest
    return tuple(map(float, vector / np.linalg.norm(vector)))


class Line(NamedTuple):
    """A line in space, in base axes: a point on it and the unit vector along it."""

    point: Array
    z: Array


@dataclass(frozen=True, eq=False)
class Step:
    """How one row came about: from the line of z_{i-1} to the line of z_i, in base axes in the
    drawn pose.

    Attributes:
        number: the row i, from 1.
        joint: what moves the row; fixed for one that only places the base or the tip.
        case: how the two lines lie to each other.
        opposite: whether z_i points against z_{i-1}, where the lines are parallel or one.
        normal: the feet of the common normal on the two lines, shape (2, 3), equal where the lines
            meet.
        before, frame: frames i-1 and i, each 4x4.
        a, alpha, d, theta: the four numbers (m, rad); q_i, which is 0 in the drawing, is added to
            theta or to d.
        words: the row in words.
    """

    number: int
    joint: Joint
    case: Case
    opposite: bool
    normal: Array
    before: Array
    frame: Array
    a: float
    alpha: float
    d: float
    theta: float
    words: str = ""


@dataclass(frozen=True, eq=False)
class Derivation:
    """The table that `derive` found, and how.

    Attributes:
        arm: the arm, its table in the standard convention.
        steps: one `Step` for each row of that table.
        lines: the joint axes, in base axes in the drawn pose.
        base: the base frame's pose in the drawing, 4x4.
        tip: the tip's pose in base axes in the drawn pose, 4x4.
    """

    arm: Arm
    steps: tuple[Step, ...]
    lines: tuple[Line, ...]
    base: Array
    tip: Array

    @property
    def modified_rows(self) -> tuple[Row, ...]:
        """Craig's table of the same arm: row i holds (a_{i-1}, alpha_{i-1}, d_i, theta_i)."""
        rows = modified_from_standard(self.arm.rows)
        return rows[1:] if rows[0] == Row(joint=Joint("fixed")) else rows

    @property
    def frames(self) -> Array:
        """Frames 0 .. n in base axes in the drawn pose, shape (rows + 1, 4, 4)."""
        return np.array([self.steps[0].before, *(step.frame for step in self.steps)])

    @cached_property
    def deviation(self) -> float:
        """How far the table's axes and tip are from those drawn, the largest of all (m, or the sine
        of an angle).

        It is rounding only, unless lines that nearly met or nearly were parallel were taken to.
        """
        frames = link_frames(self.arm, np.zeros(self.arm.dof))
        found = [np.abs(frames[-1] - self.tip).max()]
        for i, line, turns in zip(self.arm.joints, self.lines, self.arm.turning, strict=True):
            _, _, z, o = frames[i - 1, :3].T
            apart = np.cross(line.z, o - line.point) * turns
            found += [np.abs(z - line.z).max(), np.abs(apart).max()]
        return float(max(found))

    def with_bodies(self, masses: ArrayLike, centres: ArrayLike) -> Arm:
        """The arm with its links' masses (kg), shape (dof,), and centres of mass (m), shape (dof,
        3).

        The centres are points of the drawing, given as the joint axes were; each is carried over
        into the frame that moves with its link. Rows that do not move get no mass. Raises ArmError
        for another shape or a negative mass.
        """
        n = self.arm.dof
        wanted = f"{n} masses in kg, none negative"
        kilograms = numbers(masses, "masses", wanted, (n,))
        if (kilograms < 0).any():
            raise ArmError(f"masses are {shown(masses)}; expected {wanted}")
        points = numbers(centres, "centres", f"points of shape ({n}, 3) in m", (n, 3))
        points = (points - self.base[:3, 3]) @ self.base[:3, :3]
        bodies = [Body(0, (0, 0, 0))] * len(self.arm.rows)
        for i, mass, point in zip(self.arm.joints, kilograms, points, strict=True):
            R, o = self.steps[i - 1].frame[:3, :3], self.steps[i - 1].frame[:3, 3]
            bodies[i - 1] = Body(float(mass), tuple(map(_length, R.T @ (point - o))))
        return replace(self.arm, bodies=bodies)


def derive(
    axes: Sequence[Axis],
    tip: ArrayLike,
    base: ArrayLike | None = None,
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
        base: the base frame's pose in the drawing, 4x4; the drawing's own axes unless given.
        name: the arm's name.
        negative: whether x_i may run against the common normal, from z_i to z_{i-1}, where that
            turns less from x_{i-1}; a_i is negative then, as a_4 in the usual table of the Panda.
        tolerance: lines closer than this (m) are taken to meet, and to be parallel below this sine
            of their angle; an angle within a hundredth of it (rad) of a right one is taken for
            that.

    A fixed row is put first where axis 1 is not the base's z axis, and last where the last common
    normal leaves the tip elsewhere on its z axis or turned about it. Lengths become letters with
    values (``a_2``, ``d_4``), and so do angles that are no right angles (``alpha_2``, and ``phi_2``
    in the column of theta). Raises ArmError for anything that is no axis, no pose, or not finite.
    """
    axes = _axes(axes)
    pose = _tip_pose(tip, axes[-1])
    home = np.eye(4) if base is None else _pose(base, "base", _POSE)
    tolerance = number(tolerance, "tolerance", "a number above 0, as 1e-9", above=0)
    lines = [_in_base(axis, home) for axis in _placed(axes, pose[:3, 3])]
    goal = _Goal(np.linalg.inv(home) @ pose, free=np.ndim(tip) == 1)
    choices = _Choices(bool(negative), tolerance)
    steps = _steps([axis.joint for axis in axes], lines, goal, choices)
    arm = Arm(name, *_lettered(steps), source="derived from its joint axes")
    tip_pose = steps[-1].frame if goal.free else goal.pose
    return Derivation(arm, tuple(_told(steps, axes)), tuple(lines), home, tip_pose)


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
    wanted = f"{_POSE}, or {_POINT}"
    given = floats(tip, "tip", wanted)
    if given.ndim != 1:
        return _pose(given, "tip", wanted)
    pose = np.eye(4)
    pose[:3, 2], pose[:3, 3] = last.direction, numbers(given, "tip", wanted, (3,))
    return pose


def _placed(axes: tuple[Axis, ...], place: Array) -> list[Axis]:
    """The axes, each that slides and has no point laid through the next one that turns, or through
    the tip."""
    found = []
    for axis in reversed(axes):
        found.append(axis if axis.point is not None else replace(axis, point=tuple(place)))
        if axis.joint.kind == "revolute":
            place = np.array(axis.point)
    return found[::-1]


def _in_base(axis: Axis, base: Array) -> Line:
    R, o = base[:3, :3], base[:3, 3]
    return Line(R.T @ (np.array(axis.point) - o), R.T @ np.array(axis.direction))


# Row by row


def _steps(joints: list[Joint], lines: list[Line], goal: _Goal, choices: _Choices) -> list[Step]:
    """One step a joint, with a fixed one first or last where the base or the tip asks for it."""
    steps: list[Step] = []
    still, frame = Joint("fixed"), np.eye(4)
    ways = [(joint, line, None) for joint, line in zip(joints, lines[1:], strict=False)]
    if not _lies_on(frame, lines[0], choices.tolerance):
        ways.insert(0, (still, lines[0], None))
    for joint, line, end in [*ways, (joints[-1], goal.line, goal)]:
        steps.append(_step(len(steps) + 1, joint, frame, line, end, choices))
        frame = steps[-1].frame
    if goal.missed_by(frame) >= choices.tolerance:
        steps.append(_last_step(len(steps) + 1, frame, goal, choices))
    return steps


def _lies_on(frame: Array, line: Line, tolerance: float) -> bool:
    """Whether a line is the z axis of a frame, in the same direction."""
    _, _, z, o = frame[:3].T
    apart = np.linalg.norm(np.cross(z, line.point - o))
    return bool(np.linalg.norm(z - line.z) < tolerance and apart < tolerance)


def _step(
    i: int, joint: Joint, frame: Array, line: Line, goal: _Goal | None, choices: _Choices
) -> Step:
    """The row from a frame to the next, whose z axis is `line`; `goal` is where the last frame
    should lie."""
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
    a, d = _length(a * (case in ("skew", "parallel"))), _length(d, choices.tolerance)
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
        _length((goal.pose[:3, 3] - o) @ z),
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


def _length(value: float, tolerance: float = 1e-12) -> float:
    """A length freed from rounding: 0.1639 rather than 0.16390000000000005."""
    short = round(float(value), 7)
    near = 2e-11 if short else tolerance
    return (short if abs(short - value) < near else float(value)) + 0.0


def _angle(sine: float, cosine: float, choices: _Choices) -> float:
    """The angle with this sine and cosine, in (-pi, pi]; a multiple of a right angle is exact."""
    angle = math.atan2(sine, cosine)
    turns = round(angle / (math.pi / 2))
    if abs(angle - turns * math.pi / 2) >= choices.tolerance / 100:
        return angle
    return math.pi if abs(turns) == 2 else turns * math.pi / 2


# In letters


def _lettered(steps: Sequence[Step]) -> tuple[list[Row], dict[str, float]]:
    """The rows with letters for their lengths and odd angles, and the values of the letters."""
    rows: list[Row] = []
    values: dict[str, float] = {}
    for step in steps:
        entries = {
            "a": _lettered_length("a", step.number, step.a, values),
            "alpha": _lettered_angle("alpha", step.number, step.alpha, values),
            "d": _lettered_length("d", step.number, step.d, values),
            "theta": _lettered_angle("phi", step.number, step.theta, values),
        }
        rows.append(Row(**entries, joint=step.joint))
    return rows, values


def _lettered_length(letter: str, i: int, value: float, values: dict[str, float]) -> Entry:
    if not value:
        return 0
    values[f"{letter}_{i}"] = abs(value)
    return f"{letter}_{i}" if value > 0 else f"-{letter}_{i}"


def _lettered_angle(letter: str, i: int, value: float, values: dict[str, float]) -> Entry:
    turns = quarter_turns(value)
    if turns is None:
        return _lettered_length(letter, i, value, values)
    right: dict[int, Entry] = {0: 0, 1: "pi/2", -1: "-pi/2", 2: "pi"}
    return right[turns]


# In words


def _told(steps: Sequence[Step], axes: Sequence[Axis]) -> list[Step]:
    """The steps with their words."""
    told, count = [], 0
    for step in steps:
        moves = step.joint.kind != "fixed"
        count += moves
        here = axes[count - 1] if moves else None
        there = axes[count] if count < len(axes) else None
        words = [_what_moves(step, count, here), _where_next(step, count, there), _how(step, there)]
        told.append(replace(step, words=" ".join([*words, _numbers_of(step)])))
    return told


def _what_moves(step: Step, joint: int, axis: Axis | None) -> str:
    z = f"z_{step.number - 1}"
    if axis is not None:
        way = "turns about" if axis.joint.kind == "revolute" else "slides along"
        return f"Joint {joint} {way} {z}."
    start = "the base frame to the first axis" if not joint else "the last common normal to the tip"
    return f"Nothing moves in this row: it leads from {start}."


def _where_next(step: Step, joint: int, axis: Axis | None) -> str:
    z = f"z_{step.number}"
    if axis is None:
        return f"{z} is the tip's own."
    if axis.joint.kind == "revolute":
        return f"{z} is laid on the axis of joint {joint + 1}."
    laid = "as it is drawn" if axis.point is not None else "through what comes after it"
    return (
        f"{z} points the way joint {joint + 1} slides; a slide has no place of its own, and"
        f" this one is laid {laid}."
    )


def _how(step: Step, axis: Axis | None) -> str:
    i, before = step.number, step.number - 1
    at_rest = f"d_{i} = 0" if step.joint.kind != "prismatic" else f"d_{i} = 0 at q_{i} = 0"
    level = f"o_{before}, which makes {at_rest}" if axis is not None else "the tip"
    over = f" z_{i} points against z_{before}." if step.opposite else ""
    if step.case == "parallel":
        return (
            f"It is parallel to z_{before}, {abs(step.a):g} m away, so every common normal will"
            f" do: x_{i} runs along the"
            f" one that is level with {level}{_against(step)}.{over}"
        )
    if step.case == "coincident":
        kept = (
            f"x_{i} keeps the direction of x_{before}" if not step.theta else f"x_{i} is the tip's"
        )
        return (
            f"It is the same line as z_{before}: there is no common normal, {kept}, and o_{i}"
            f" lies in {level}.{over}"
        )
    nearly = _nearly_parallel(step)
    if step.case == "skew":
        return (
            f"It passes z_{before} at a distance: x_{i} runs along the common normal,"
            f" {abs(step.a):g} m long, from"
            f" z_{before} to z_{i}{_against(step)}, and o_{i} lies where the normal meets"
            f" z_{i}.{nearly}"
        )
    return (
        f"It meets z_{before} in o_{i}, so a_{i} = 0; x_{i} is perpendicular to both, the way that"
        f" turns less from x_{before} (z_{before} x z_{i} where both turn as much).{nearly}"
    )


def _against(step: Step) -> str:
    if step.a > 0:
        return ""
    return (
        f" but the other way round, since that turns less from x_{step.number - 1}:"
        f" a_{step.number} is negative"
    )


def _nearly_parallel(step: Step) -> str:
    tilt = abs(math.sin(step.alpha))
    if tilt > _NEARLY:
        return ""
    return (
        f" The two are within {math.degrees(tilt):.2g}° of parallel, so their common normal is far"
        " off; a tolerance"
        f" above {tilt:.1g} takes them for parallel."
    )


def _numbers_of(step: Step) -> str:
    i, q = step.number, f"q_{step.number}"
    theta = f"{math.degrees(step.theta):g}°"
    d = f"{step.d:g} m" if step.d else "0"
    if step.joint.kind == "revolute":
        theta = f"{q} + {theta}".replace("+ -", "- ") if step.theta else q
    if step.joint.kind == "prismatic":
        d = f"{q} + {d}".replace("+ -", "- ") if step.d else q
    a = f"{step.a:g} m" if step.a else "0"
    return (
        f"So a_{i} = {a}, alpha_{i} = {math.degrees(step.alpha):g}°, d_{i} = {d}, theta_{i} ="
        f" {theta}."
    )
