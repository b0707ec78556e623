"""Place frames on joint axes row by row; a row's four numbers take frame i-1 to frame i."""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from helpers.arm import Arm, ArmError, Joint, Row
from helpers.derive.values import (
    POINT,
    Array,
    Axis,
    Case,
    Derivation,
    DerivationStep,
    Line,
    clean_length,
)
from helpers.expressions import Entry
from helpers.inputs import (
    finite_array,
    finite_number,
    float_array,
    require_type,
    tuple_of_items,
)
from helpers.poses import rigid_poses
from helpers.rows import cos_sin, quarter_turns

_POSE = "a rigid motion, 4x4, in m"
_NEARLY_PARALLEL = 1e-3  # largest sine of the angle between axes that a warning calls nearly so
_FAR = 10  # a normal this many times farther from the base than all else gives a warning


def derive(
    axes: Sequence[Axis],
    tip: ArrayLike,
    *,
    name: str = "arm",
    negative: bool = False,
    tolerance: float = 1e-9,
) -> Derivation:
    """Derive the table of an arm from its joint axes in a drawn pose, which becomes q = 0.

    A fixed row comes first where axis 1 is not the base's z axis, and last where the last common
    normal misses the tip. Lengths become symbols with values (``a_2``, ``d_4``), and so do angles
    that are no right angles (``alpha_2``, and ``phi_2`` in the column of theta).

    Rounded angles can make axes nearly parallel, with a common normal far from the arm. This gives
    a warning; with a larger tolerance such axes count as parallel.

    Args:
        axes: One `Axis` for each joint, from the base to the tip.
        tip: The tip's pose in the drawing, 4x4, or its point, shape (3,); z_n then runs along
            z_{n-1}.
        name: The arm's name.
        negative: Whether x_i may run from z_i to z_{i-1} where that turns less from x_{i-1}; a_i
            is then negative, as a_4 in the usual table of the Panda.
        tolerance: Lines closer than this (m) count as meeting, and lines with a smaller sine of
            their angle as parallel. An angle within a hundredth of it (rad) of a right angle
            counts as that right angle.

    Raises:
        ArmError: An argument is no axis or no pose, or is not finite.

    Example:
        >>> axes = [Axis((0, 0, 0), (0, 0, 1)), Axis((0, 0, 0.5), (0, -1, 0))]
        >>> derive(axes, tip=(0.4, 0, 0.5)).arm.rows[0].entries
        (0, 'pi/2', 'd_1', 0)
    """
    axes = _check_axes(axes)
    pose = _tip_pose(tip, axes[-1])
    tolerance = finite_number(tolerance, "tolerance", "a number above 0, as 1e-9", above=0)
    lines = _find_lines(axes, pose[:3, 3])
    goal = _Goal(pose, free=np.ndim(tip) == 1)
    choices = _Choices(bool(negative), tolerance)
    steps = _derive_steps([axis.joint for axis in axes], lines, goal, choices)
    arm = Arm(name, *_with_symbols(steps), source="derived from its joint axes")
    reach = max(np.linalg.norm(line.point) for line in [*lines, goal.line])
    for step in steps:
        tilt = abs(math.sin(step.alpha)) if step.case in ("skew", "intersecting") else 0.0
        if abs(step.d) > _FAR * reach and 0 < tilt <= _NEARLY_PARALLEL:
            warnings.warn(f"{name}: {_nearly_parallel_warning(step, tilt)}", stacklevel=2)
    return Derivation(arm, tuple(steps), tuple(lines))


def _nearly_parallel_warning(step: DerivationStep, tilt: float) -> str:
    return (
        f"z_{step.number - 1} and z_{step.number} are within {math.degrees(tilt):.2g}° of parallel,"
        f" so the last digits of that angle say where their common normal is (d_{step.number} ="
        f" {step.d:.6g} m); a tolerance above {tilt:.1g} takes them for parallel"
    )


class _Choices(NamedTuple):
    """The options `negative` and `tolerance` of `derive`."""

    negative: bool
    tolerance: float


# Input


@dataclass(frozen=True, eq=False)
class _Goal:
    """The wanted last frame.

    Attributes:
        pose: The frame in base axes, 4x4.
        free: Whether its rotation about z is free.
    """

    pose: Array
    free: bool

    @property
    def line(self) -> Line:
        return Line(self.pose[:3, 3], self.pose[:3, 2])

    def missed_by(self, frame: Array) -> float:
        """Return the largest difference in origin (m) and, unless free, in the x axis."""
        columns = [3] if self.free else [0, 3]
        return float(np.abs(frame - self.pose)[:, columns].max())


def _check_axes(axes: Sequence[Axis]) -> tuple[Axis, ...]:
    items = tuple_of_items(axes, "axes", "one Axis or more, base to tip")
    if not items:
        raise ArmError("axes are []; expected one Axis or more, base to tip")
    for axis in items:
        require_type(axis, Axis, "an item of axes")
    return items


def _tip_pose(tip: ArrayLike, last: Axis) -> Array:
    """Return the tip's pose.

    Without its orientation, z runs along the last axis.
    """
    expected = f"{_POSE}, or {POINT}"
    tip_array = float_array(tip, "tip", expected)
    if tip_array.ndim != 1:
        return rigid_poses(tip_array, "tip", expected)
    pose = np.eye(4)
    pose[:3, 2], pose[:3, 3] = last.direction, finite_array(tip_array, "tip", expected, (3,))
    return pose


def _find_lines(axes: tuple[Axis, ...], tip: Array) -> list[Line]:
    """Return the axes' lines.

    A slide without a point runs through the next turning axis or tip.
    """
    lines, next_point = [], tip
    for axis in reversed(axes):
        point = next_point if axis.point is None else np.array(axis.point)
        lines.append(Line(point, np.array(axis.direction)))
        if axis.joint.kind == "revolute":
            next_point = point
    return lines[::-1]


# Row by row


def _derive_steps(
    joints: list[Joint], lines: list[Line], goal: _Goal, choices: _Choices
) -> list[DerivationStep]:
    """Derive one row for each joint, and a fixed row first or last where base or tip need it."""
    steps: list[DerivationStep] = []
    frame = np.eye(4)
    targets = [_Target(joint, line) for joint, line in zip(joints, lines[1:], strict=False)]
    if not _lies_on(frame, lines[0], choices.tolerance):
        targets.insert(0, _Target(Joint("fixed"), lines[0]))
    for i, target in enumerate([*targets, _Target(joints[-1], goal.line, goal)], 1):
        steps.append(_derive_step(i, frame, target, choices))
        frame = steps[-1].frame
    if goal.missed_by(frame) >= choices.tolerance:
        steps.append(_last_step(len(steps) + 1, frame, goal, choices))
    return steps


def _lies_on(frame: Array, line: Line, tolerance: float) -> bool:
    """Return whether a line is the z axis of a frame, in the same direction."""
    _, _, z, o = frame[:3].T
    apart = np.linalg.norm(np.cross(z, line.point - o))
    return bool(np.linalg.norm(z - line.z) < tolerance and apart < tolerance)


class _Target(NamedTuple):
    """A row's joint, the line of the next z axis, and for the last row the wanted frame."""

    joint: Joint
    line: Line
    goal: _Goal | None = None


def _derive_step(i: int, frame: Array, target: _Target, choices: _Choices) -> DerivationStep:
    """Derive the row that takes a frame to the next z axis."""
    joint, line, goal = target
    x, _, z, o = frame[:3].T
    wish = x if goal is None or goal.free else goal.pose[:3, 0]
    crossed = np.linalg.norm(np.cross(z, line.z)) >= choices.tolerance
    case, along = (_nonparallel_case if crossed else _parallel_case)(frame, line, wish, choices)
    theta = _compute_angle(float(np.cross(x, along) @ z), float(x @ along), choices)
    alpha = math.pi if z @ line.z < 0 else 0.0
    if crossed:
        alpha = _compute_angle(float(np.cross(z, line.z) @ along), float(z @ line.z), choices)
    # a and d are measured in the axes that the rounded angles give, so that they make up for the
    # rounding.
    x_i, y_i, z_i, _ = (frame @ _make_link_transform(0, alpha, 0, theta))[:3].T
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
    reached = frame @ _make_link_transform(a, alpha, d, theta)
    feet = np.array([start, start + a * x_i])
    return DerivationStep(i, joint, case, opposite, feet, frame, reached, a, alpha, d, theta)


def _last_step(i: int, frame: Array, goal: _Goal, choices: _Choices) -> DerivationStep:
    """Derive the fixed row that shifts and turns a frame along the tip's z axis into the tip."""
    x, _, z, o = frame[:3].T
    wish = x if goal.free else goal.pose[:3, 0]
    d, theta = (
        clean_length((goal.pose[:3, 3] - o) @ z),
        _compute_angle(np.cross(x, wish) @ z, x @ wish, choices),
    )
    reached = frame @ _make_link_transform(0, 0, d, theta)
    feet = np.array([reached[:3, 3]] * 2)
    return DerivationStep(
        i, Joint("fixed"), "coincident", False, feet, frame, reached, 0.0, 0.0, d, theta
    )


def _parallel_case(frame: Array, line: Line, wish: Array, choices: _Choices) -> tuple[Case, Array]:
    """Return whether parallel lines coincide, and x_i."""
    _, _, z, o = frame[:3].T
    out = line.point - o
    across = out - (out @ z) * z
    away = np.linalg.norm(across)
    if away < choices.tolerance:
        along = wish - (wish @ z) * z
        return "coincident", along / np.linalg.norm(along)
    along = across / away
    return "parallel", _choose_nearer(along, wish, choices) if choices.negative else along


def _nonparallel_case(
    frame: Array, line: Line, wish: Array, choices: _Choices
) -> tuple[Case, Array]:
    """Return whether lines that are not parallel meet, and x_i."""
    _, _, z, o = frame[:3].T
    along = np.cross(z, line.z)
    along = along - (along @ z) * z  # removes round-off, which is large for nearly parallel lines
    along = along / np.linalg.norm(along)
    gap = (line.point - o) @ along
    if abs(gap) < choices.tolerance:
        return "intersecting", _choose_nearer(along, wish, choices)
    out = math.copysign(1, gap) * along
    return "skew", _choose_nearer(out, wish, choices) if choices.negative else out


def _choose_nearer(along: Array, wish: Array, choices: _Choices) -> Array:
    """Return the direction or its opposite, whichever turns less from `wish`."""
    return -along if along @ wish < -choices.tolerance else along


def _make_link_transform(a: float, alpha: float, d: float, theta: float) -> Array:
    """Compute A_i at q_i = 0."""
    (ca, sa), (c, s) = cos_sin(alpha), cos_sin(theta)
    return np.array(
        [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]]
    )


def _compute_angle(sine: float, cosine: float, choices: _Choices) -> float:
    """Return the angle in (-pi, pi].

    An angle near a multiple of a right angle becomes that multiple.
    """
    angle = math.atan2(sine, cosine)
    turns = round(angle / (math.pi / 2))
    if abs(angle - turns * math.pi / 2) >= choices.tolerance / 100:
        return angle
    return math.pi if abs(turns) == 2 else turns * math.pi / 2


# Symbols


_RIGHT_ANGLES: dict[int, Entry] = {0: 0, 1: "pi/2", -1: "-pi/2", 2: "pi"}


def _with_symbols(steps: Sequence[DerivationStep]) -> tuple[list[Row], dict[str, float]]:
    """Return rows with symbols for lengths and odd angles, and the values of the symbols."""
    values: dict[str, float] = {}

    def length(prefix: str, i: int, value: float) -> Entry:
        if not value:
            return 0
        values[f"{prefix}_{i}"] = abs(value)
        return f"{prefix}_{i}" if value > 0 else f"-{prefix}_{i}"

    def angle(prefix: str, i: int, value: float) -> Entry:
        turns = quarter_turns(value)
        return length(prefix, i, value) if turns is None else _RIGHT_ANGLES[turns]

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
