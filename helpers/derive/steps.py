"""Place frames on joint axes row by row; a row's four numbers move frame i-1 to frame i."""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence
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
from helpers.rows import angle_entry, cos_sin

_POSE = "a rigid motion, 4x4, in m"
_NEARLY_PARALLEL = 1e-3  # below this sine of their angle, axes give a warning
_FAR = 10  # a common normal this many times farther away than the arm gives a warning


def derive(
    axes: Sequence[Axis],
    tip: ArrayLike,
    *,
    name: str = "arm",
    negative: bool = False,
    tolerance: float = 1e-9,
) -> Derivation:
    """Derive the table of an arm from its joint axes in a drawn configuration, which becomes
    q = 0.

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
    items = tuple_of_items(axes, "axes", "one Axis or more, base to tip")
    if not items:
        raise ArmError("axes are []; expected one Axis or more, base to tip")
    for axis in items:
        require_type(axis, Axis, "an item of axes")
    expected = f"{_POSE}, or {POINT}"
    tip_array = float_array(tip, "tip", expected)
    x_is_free = tip_array.ndim == 1  # the tip is a point, so its frame may turn about z
    if x_is_free:
        pose = np.eye(4)
        pose[:3, 2] = items[-1].direction
        pose[:3, 3] = finite_array(tip_array, "tip", expected, (3,))
    else:
        pose = rigid_poses(tip_array, "tip", expected)
    tolerance = finite_number(tolerance, "tolerance", "a number above 0, as 1e-9", above=0)
    choices = _Choices(bool(negative), tolerance)

    # The axis of a prismatic joint has no position of its own, so without a point it is placed
    # through the next revolute axis or the tip.
    lines, next_point = [Line(pose[:3, 3], pose[:3, 2])], pose[:3, 3]
    for axis in reversed(items):
        point = next_point if axis.point is None else np.array(axis.point)
        lines.insert(0, Line(point, np.array(axis.direction)))
        if axis.joint.kind == "revolute":
            next_point = point
    targets = [(axis.joint, line) for axis, line in zip(items, lines[1:], strict=True)]
    frame, first = np.eye(4), lines[0]
    z = frame[:3, 2]
    apart = np.linalg.norm(np.cross(z, first.point))
    if not (np.linalg.norm(z - first.z) < tolerance and apart < tolerance):
        targets.insert(0, (Joint("fixed"), first))

    steps: list[DerivationStep] = []
    for i, (joint, line) in enumerate(targets, 1):
        is_last = i == len(targets)
        wish = pose[:3, 0] if is_last and not x_is_free else frame[:3, 0]
        level = pose[:3, 3] if is_last else frame[:3, 3]
        steps.append(_derive_step(i, frame, joint, line, wish=wish, level=level, choices=choices))
        frame = steps[-1].frame
    if np.abs(frame - pose)[:, [3] if x_is_free else [0, 3]].max() >= tolerance:
        # The tip may be shifted and turned along its z axis; a fixed row adds this motion.
        x, _, z, o = frame[:3].T
        wish = x if x_is_free else pose[:3, 0]
        d = clean_length((pose[:3, 3] - o) @ z)
        theta = _compute_angle(np.cross(x, wish) @ z, x @ wish, choices)
        end = frame @ _make_link_transform(0, 0, d, theta)
        feet = np.array([end[:3, 3]] * 2)
        number, joint = len(steps) + 1, Joint("fixed")
        steps.append(
            DerivationStep(number, joint, "coincident", False, feet, frame, end, 0.0, 0.0, d, theta)
        )

    reach = max(np.linalg.norm(line.point) for line in lines)
    for step in steps:
        tilt = abs(math.sin(step.alpha)) if step.case in ("skew", "intersecting") else 0.0
        if abs(step.d) > _FAR * reach and 0 < tilt <= _NEARLY_PARALLEL:
            i = step.number
            warnings.warn(
                f"{name}: z_{i - 1} and z_{i} are within {math.degrees(tilt):.2g}° of parallel, so"
                " the last digits of that angle say where their common normal is"
                f" (d_{i} = {step.d:.6g} m); a tolerance above {tilt:.1g} takes them for parallel",
                stacklevel=2,
            )
    arm = Arm(name, *_with_symbols(steps), source="derived from its joint axes")
    return Derivation(arm, tuple(steps), tuple(lines[:-1]))


class _Choices(NamedTuple):
    """The options `negative` and `tolerance` of `derive`."""

    negative: bool
    tolerance: float


def _derive_step(
    i: int, frame: Array, joint: Joint, line: Line, *, wish: Array, level: Array, choices: _Choices
) -> DerivationStep:
    """Derive the row that takes a frame to the line of the next z axis.

    Args:
        i: Number of the row.
        frame: Frame i-1, 4x4.
        joint: Joint of the row.
        line: Line of z_i.
        wish: Direction from which x_i turns as little as possible where it may be chosen.
        level: Point at whose height o_i stands on z_i where z_i is parallel to z_{i-1}.
        choices: The options of `derive`.
    """
    x, _, z, o = frame[:3].T
    out = line.point - o
    case: Case
    if crossed := bool(np.linalg.norm(np.cross(z, line.z)) >= choices.tolerance):
        along = np.cross(z, line.z)
        along = along - (along @ z) * z  # removes round-off of nearly parallel lines
        along = along / np.linalg.norm(along)
        gap = out @ along
        case = "intersecting" if abs(gap) < choices.tolerance else "skew"
        if case == "skew":
            along = math.copysign(1, gap) * along
    else:
        across = out - (out @ z) * z
        case = "coincident" if np.linalg.norm(across) < choices.tolerance else "parallel"
        if case == "coincident":
            across = wish - (wish @ z) * z
        along = across / np.linalg.norm(across)
    may_turn_back = case == "intersecting" or (choices.negative and case != "coincident")
    if may_turn_back and along @ wish < -choices.tolerance:
        along = -along

    theta = _compute_angle(float(np.cross(x, along) @ z), float(x @ along), choices)
    alpha = math.pi if z @ line.z < 0 else 0.0
    if crossed:
        alpha = _compute_angle(float(np.cross(z, line.z) @ along), float(z @ line.z), choices)
    # Measure a and d in the axes given by the rounded angles, so that the frame reaches the line
    # in spite of the rounding.
    x_i, y_i, z_i, _ = (frame @ _make_link_transform(0, alpha, 0, theta))[:3].T
    if crossed:
        a, d = out @ x_i, out @ y_i / math.sin(alpha)
    else:
        out = line.point + ((level - line.point) @ z_i) * z_i - o
        a, d = out @ x_i, out @ z
    a, d = clean_length(a * (case in ("skew", "parallel"))), clean_length(d, choices.tolerance)
    start = o + d * z
    opposite = not crossed and alpha != 0
    reached = frame @ _make_link_transform(a, alpha, d, theta)
    feet = np.array([start, start + a * x_i])
    return DerivationStep(i, joint, case, opposite, feet, frame, reached, a, alpha, d, theta)


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


def _with_symbols(steps: Sequence[DerivationStep]) -> tuple[list[Row], dict[str, float]]:
    """Return rows with symbols for lengths and odd angles, and the values of the symbols."""
    values: dict[str, float] = {}

    def length(prefix: str, i: int, value: float) -> Entry:
        if not value:
            return 0
        values[f"{prefix}_{i}"] = abs(value)
        return f"{prefix}_{i}" if value > 0 else f"-{prefix}_{i}"

    def angle(prefix: str, i: int, value: float) -> Entry:
        entry = angle_entry(value)
        return entry if isinstance(entry, str) or not value else length(prefix, i, value)

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
