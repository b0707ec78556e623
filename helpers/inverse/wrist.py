"""Solve spherical wrists, first for the wrist's centre, then for its three angles.

Source: Pieper (1968); Spong, Hutchinson and Vidyasagar, section 5.3 (kinematic decoupling).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm, fixed
from helpers.inputs import ArmError, require_type
from helpers.inverse.axes import dot
from helpers.inverse.geometry import SINGULAR, remove_last_twist, wrist_centre
from helpers.inverse.shoulder import (
    ELBOW_BRANCHES,
    ROD_BRANCHES,
    elbow_kernel,
    has_rod,
    is_elbow_arm,
    require_elbow_arm,
    require_rod,
    rod_kernel,
)
from helpers.inverse.solutions import (
    BranchArrays,
    Solutions,
    check_poses,
    each_branch,
    wrap_angle,
)
from helpers.kinematics import tip_entries
from helpers.program import cosines_and_sines, get_program, run_batch

Array = NDArray[np.float64]


def stanford(arm: Arm, targets: ArrayLike, start: ArrayLike | None = None) -> Solutions:
    """Return the eight branches of a Stanford arm (RRP and a spherical wrist) in closed form.

    Each branch of `rod` for the wrist's centre is combined with q_5 > 0 and with q_5 < 0. The
    result's `within_limits` tells which branches are within the range of the rod.

    Args:
        arm: The arm.
        targets: Poses of the tip, shape (..., 4, 4).
        start: Values of free joints, shape (..., 6); zeros by default. If q_5 = 0, axes 4 and 6
            coincide: joint 4 keeps this value, and joint 6 is computed from it.

    Raises:
        ArmError: The arm has another table, or the targets are no poses.
    """
    return _solve_decoupled(arm, targets, start, Shoulder(rod_kernel, require_rod, ROD_BRANCHES))


def spherical_wrist(arm: Arm, targets: ArrayLike, start: ArrayLike | None = None) -> Solutions:
    """Return the eight branches of an elbow arm with a spherical wrist in closed form.

    Each branch of `elbow` for the wrist's centre is combined with q_5 > 0 and with q_5 < 0. Free
    joints are those of `stanford` and `elbow`.

    Args:
        arm: An arm whose rows 4 to 6 have alpha = (+-90, +-90, any) degrees and
            a_4 = a_5 = d_5 = 0, so that their axes meet in a point.
        targets: Poses of the tip, shape (..., 4, 4).
        start: Values of free joints, shape (..., 6); zeros by default.

    Raises:
        ArmError: The arm has another table, or the targets are no poses.
    """
    return _solve_decoupled(
        arm, targets, start, Shoulder(elbow_kernel, require_elbow_arm, ELBOW_BRANCHES)
    )


class Shoulder(NamedTuple):
    """A closed form of joints 1 to 3, the check that an arm fits it, and its branch names."""

    place: Callable[[Arm, Array, Array], BranchArrays]
    must_fit: Callable[[Arm], None]
    choices: tuple[tuple[str, ...], ...]


def _solve_decoupled(
    arm: Arm, targets: ArrayLike, start: ArrayLike | None, by: Shoulder
) -> Solutions:
    require_type(arm, Arm, "arm")
    if not has_right_angled_wrist(arm):
        raise ArmError(
            f"{arm.name} has no spherical wrist; expected six rows, the last three revolute with"
            " alpha = (+-90, +-90, any) degrees and a_4 = a_5 = d_5 = 0"
        )
    shoulder = _arm_to_wrist_centre(arm)
    by.must_fit(shoulder)

    def kernel(arm: Arm, columns: Array, start: Array) -> BranchArrays:
        tool = remove_last_twist(arm, columns)
        placed = by.place(shoulder, wrist_centre(arm, tool), start[:3])
        first = np.stack(np.broadcast_arrays(*placed.q))
        tool_axes = _express_in_frame_3(shoulder, first, tool.axes[:, 0], tool.axes[:, 2])
        wrist, singular = _solve_wrist(arm, tool_axes, start)
        free = {joint: _repeat_for_both_wrists(loose) for joint, loose in placed.free.items()}
        q = (*(_repeat_for_both_wrists(joint) for joint in placed.q), *wrist)
        merged = (
            *(_repeat_for_both_wrists(one) for one in placed.merged),
            _repeat_for_both_wrists(singular),
        )
        return BranchArrays(
            q,
            {**free, 3: _repeat_for_both_wrists(singular)},
            _repeat_for_both_wrists(placed.valid),
            merged,
            placed.distance,
        )

    choices = (*by.choices, ("q_5 > 0", "q_5 < 0"))
    return each_branch(arm, check_poses(arm, targets), start, choices, kernel)


def _repeat_for_both_wrists(values: NDArray[Any]) -> NDArray[Any]:
    """Insert an axis of length 2 before the last, for both wrist branches."""
    return values[..., None, :]


@lru_cache(maxsize=32)
def _arm_to_wrist_centre(arm: Arm) -> Arm:
    """Return the arm of the first three joints, with its tip at the wrist's centre."""
    rows = (*arm.rows[:3], fixed(d=arm.rows[3].d))
    return replace(arm, rows=rows, bodies=(), home=())


def _express_in_frame_3(shoulder: Arm, q: Array, *vectors: Array) -> list[Array]:
    """Express vectors (3, batch) in frame 3 of each branch.

    `q` and the results have shape (3, 2, 2, batch).
    """
    pose = run_batch(get_program(shoulder, tip_entries), q.reshape(3, -1))
    pose = pose.reshape(4, 4, *q.shape[1:])
    axes = [pose[:3, i] for i in range(3)]
    return [np.stack([dot(axis, v[:, None, None]) for axis in axes]) for v in vectors]


def _solve_wrist(arm: Arm, tool_axes: list[Array], start: Array) -> tuple[tuple[Array, ...], Array]:
    """Return joints 4 to 6 of both wrists, each (2, 2, 2, batch), and where joint 4 is free.

    Joint 6 follows from x_6 after joint 4's rotation is removed. Near a straight wrist each angle
    alone is uncertain, but both together turn the tool correctly.
    """
    x, z = tool_axes
    s4, s5 = arm.numeric[3].sin_alpha, arm.numeric[4].sin_alpha
    sine, cosine = np.hypot(z[0], z[1]), -s4 * s5 * z[2]
    singular = sine < SINGULAR
    sine = np.where(singular, 0.0, sine)
    chosen = start[3] + arm.numeric[3].theta
    phi_4 = np.where(singular, chosen, np.arctan2(s5 * z[1], s5 * z[0]))
    c, s = cosines_and_sines(phi_4)
    ahead, aside = c * x[0] + s * x[1], c * x[1] - s * x[0]
    phi_5 = np.arctan2(sine, cosine)
    phi_6 = np.arctan2(-s4 * s5 * aside, cosine * ahead + s4 * sine * x[2])
    flip = np.where(singular, 0.0, np.pi)
    pairs = (phi_4, phi_4 + flip), (phi_5, -phi_5), (phi_6, phi_6 + flip)
    wrist = (
        wrap_angle(np.stack(pair, axis=2) - row.theta)
        for pair, row in zip(pairs, arm.numeric[3:], strict=True)
    )
    return tuple(wrist), singular


def has_right_angled_wrist(arm: Arm) -> bool:
    """Return whether rows 4 to 6 of an arm are a spherical wrist with exact right angles."""
    rows = arm.numeric
    return (
        len(rows) == 6
        and all(row.kind == "revolute" for row in rows[3:])
        and rows[3].a == rows[4].a == rows[4].d == rows[3].cos_alpha == rows[4].cos_alpha == 0.0
    )


def is_elbow_arm_with_wrist(arm: Arm) -> bool:
    """Return whether an arm has the table that `spherical_wrist` solves."""
    return has_right_angled_wrist(arm) and is_elbow_arm(_arm_to_wrist_centre(arm))


def is_stanford_arm(arm: Arm) -> bool:
    """Return whether an arm has the table that `stanford` solves."""
    return has_right_angled_wrist(arm) and has_rod(_arm_to_wrist_centre(arm))
