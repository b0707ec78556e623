"""Solve positions by geometry, for the elbow arm and the first three Stanford joints.

Both stand on a vertical axis and move in a plane beside it. Joint 1 turns the plane towards the
target, which leaves a problem in the plane's own coordinates. Source: Spong, Hutchinson and
Vidyasagar, section 5.3.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import ArmError, require_type
from helpers.inverse.geometry import REACH, Links, solve_two_links, turn_plane_to_target
from helpers.inverse.solutions import (
    BranchArrays,
    Solutions,
    check_positions,
    each_branch,
    subtract_offset,
)
from helpers.rows import NumericRow

Array = NDArray[np.float64]

ELBOW_BRANCHES = (("front", "back"), ("elbow up", "elbow down"))
ROD_BRANCHES = (("front", "back"), ("rod out", "rod through"))


def elbow(arm: Arm, targets: ArrayLike, start: ArrayLike | None = None) -> Solutions:
    """Return the four branches of an elbow arm for positions of its tip, in closed form.

    In "front" branches the arm's plane turns towards the target, in "back" branches away from it.
    "elbow up" means that the elbow is above the line from the shoulder to the tip.

    Args:
        arm: An arm with alpha = (+-90, 0 or 180, any) degrees and a_1 = 0, and any d. A fourth,
            fixed row may move the tip along z_3.
        targets: Positions of the tip, shape (..., 3), in m.
        start: Values of free joints, shape (..., 3); zeros by default. Joint 1 of an arm without
            offset is free straight above the shoulder.

    Raises:
        ArmError: The arm has another table, or the targets have another shape.
    """
    require_elbow_arm(arm)
    return each_branch(arm, check_positions(arm, targets), start, ELBOW_BRANCHES, elbow_kernel)


def rod(arm: Arm, targets: ArrayLike, start: ArrayLike | None = None) -> Solutions:
    """Return the four branches of an RRP arm for positions of its tip, in closed form.

    Its rod slides through the shoulder. "rod out" means that q_3 plus its offset is positive, "rod
    through" that it is negative, which few real rods can do. Otherwise as `elbow`.

    Raises:
        ArmError: The table is not alpha = (+-90, +-90, 0) degrees with a = 0, or the targets have
            another shape.
    """
    require_rod(arm)
    return each_branch(arm, check_positions(arm, targets), start, ROD_BRANCHES, rod_kernel)


def elbow_kernel(arm: Arm, p: Array, start: Array) -> BranchArrays:
    """Compute both shoulder branches with both elbow branches, for positions (3, batch)."""
    first, second, third, *tool = arm.numeric
    shape = _read_shape(second, third, tool[0].d if tool else 0.0)
    plane = turn_plane_to_target(first, shape.offset, p, start[0] + first.theta)
    up = first.sin_alpha * np.array([[[-1.0], [1.0]], [[1.0], [-1.0]]])
    end = plane.x[:, None], plane.y[:, None]
    bend = solve_two_links(shape.links, end, up, start[1] + second.theta)
    q = (
        subtract_offset(plane.phi[:, None], first.theta),
        subtract_offset(bend.phi_2, second.theta),
        subtract_offset(second.cos_alpha * bend.phi_3, shape.beta + third.theta),
    )
    valid = plane.exists & bend.exists
    free, merged = {0: plane.free, 1: bend.free}, (plane.is_double, bend.is_double)
    reached = valid.any(axis=(0, 1))
    distance = np.where(reached, 0.0, _elbow_distance(shape, first, p))
    return BranchArrays(q, free, valid, merged, distance)


def rod_kernel(arm: Arm, p: Array, start: Array) -> BranchArrays:
    """Compute both shoulder branches with the rod out and through, for positions (3, batch)."""
    first, second, third, *tool = arm.numeric
    plane = turn_plane_to_target(first, second.d, p, start[0] + first.theta)
    out = np.array([1.0, -1.0])[:, None]
    length = out * np.hypot(plane.x, plane.y)[:, None]
    side = second.sin_alpha * out
    phi_2 = np.arctan2(side * plane.x[:, None], -side * plane.y[:, None])
    central = np.abs(length) < REACH
    q = (
        subtract_offset(plane.phi[:, None], first.theta),
        np.where(central, start[1], subtract_offset(phi_2, second.theta)),
        length - third.d - (tool[0].d if tool else 0.0),
    )
    missing = np.where(plane.exists, 0.0, abs(second.d) - np.hypot(p[0], p[1]))
    free = {0: plane.free, 1: central}
    return BranchArrays(q, free, plane.exists, (plane.is_double, central), missing)


class Shape(NamedTuple):
    """An elbow arm in its plane: links, constant bend of the second, offset along z_1."""

    links: Links
    beta: float
    offset: float


def _read_shape(second, third, tool: float) -> Shape:
    across = -tool * third.sin_alpha
    fore, beta = float(np.hypot(third.a, across)), float(np.arctan2(across, third.a))
    offset = second.d + second.cos_alpha * (third.d + tool * third.cos_alpha)
    return Shape(Links(second.a, fore), beta, offset)


def _elbow_distance(shape: Shape, first: NumericRow, p: Array) -> Array:
    """Return the distance of positions (3, batch) from the nearest point within reach.

    Seen beside the axis at (rho, s), s up from the shoulder, the arm reaches what lies at least
    `offset` from the axis and has inner^2 <= rho^2 - offset^2 + s^2 <= outer^2: a ring, cut off
    near the axis. The nearest point is straight in or out on a circle of the ring, or on the cut.
    """
    beside, height = np.hypot(p[0], p[1]), np.abs(p[2] - first.d)
    cut, links = abs(shape.offset), shape.links
    far = np.hypot(beside, height)
    outwards = np.where(far > 0, beside / np.where(far > 0, far, 1.0), 1.0)
    found = np.hypot(beside - cut, height - np.clip(height, links.inner, links.outer))
    for radius in (np.hypot(links.inner, cut), np.hypot(links.outer, cut)):
        straight = np.where(radius * outwards >= cut, np.abs(far - radius), np.inf)
        found = np.minimum(found, straight)
    return found


def is_elbow_arm(arm: Arm) -> bool:
    """Return whether an arm has the table that `elbow` solves."""
    rows, kinds = arm.numeric, [row.kind for row in arm.numeric]
    return kinds in (["revolute"] * 3, ["revolute"] * 3 + ["fixed"]) and (
        rows[0].a == rows[0].cos_alpha == rows[1].sin_alpha == 0.0
        and rows[1].a != 0.0
        and _read_shape(rows[1], rows[2], 0.0 if len(rows) == 3 else rows[3].d).links.fore > 0.0
        and (len(rows) == 3 or rows[3].a == 0.0)
    )


def require_elbow_arm(arm: Arm) -> None:
    """Raise ArmError for an arm that `elbow` does not solve."""
    require_type(arm, Arm, "arm")
    if not is_elbow_arm(arm):
        raise ArmError(
            f"{arm.name} is no elbow arm; expected three revolute joints, alpha_1 = 90 or -90"
            " degrees, alpha_2 = 0 or 180, a_1 = 0 and two links with length; for other arms,"
            " with a_1 for instance, use helpers.inverse.solutions"
        )


def has_rod(arm: Arm) -> bool:
    """Return whether an arm has the table that `rod` solves."""
    rows, kinds = arm.numeric, [row.kind for row in arm.numeric]
    moving = ["revolute", "revolute", "prismatic"]
    return kinds in (moving, [*moving, "fixed"]) and (
        rows[0].cos_alpha == rows[1].cos_alpha == rows[2].sin_alpha == 0.0
        and rows[2].cos_alpha == 1.0
        and all(row.a == 0.0 for row in rows)
    )


def require_rod(arm: Arm) -> None:
    """Raise ArmError for an arm that `rod` does not solve."""
    require_type(arm, Arm, "arm")
    if not has_rod(arm):
        raise ArmError(
            f"{arm.name} has no rod through its shoulder; expected joints R, R, P with alpha ="
            " (+-90, +-90, 0) degrees and a = 0"
        )
