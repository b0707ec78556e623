"""Spherical wrists: the position of the wrist's centre first, its three angles after.

Source: Pieper (1968); Spong, Hutchinson and Vidyasagar, section 5.3 (kinematic decoupling).
"""

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm, ArmError, fixed
from helpers.inverse.geometry import SINGULAR, unwound, wrist_centre
from helpers.inverse.shoulder import (
    ELBOW_BRANCHES,
    STANFORD_BRANCHES,
    elbow_kernel,
    must_be_elbow,
    must_have_rod,
    rod_kernel,
)
from helpers.inverse.solutions import Solutions, each_branch, poses, wrapped
from helpers.kinematics import frame_columns

Array = NDArray[np.float64]


def stanford(arm: Arm, T: ArrayLike, near: ArrayLike | None = None) -> Solutions:
    """All joint vectors of a Stanford arm (RRP and a spherical wrist) for poses T, shape (..., 4, 4): eight branches.

    Four place the wrist's centre, as `rod` names them, each with the wrist as it is and flipped (q_5 > 0, q_5 < 0). A rod has
    its limits, so ask `within_limits` which are real. Where q_5 = 0, joints 4 and 6 turn about one axis: joint 4 keeps its
    value of `near`, shape (..., 6), and joint 6 follows. Raises ArmError for another table or a T that is no pose.
    """
    return _decoupled(arm, T, near, rod_kernel, must_have_rod, STANFORD_BRANCHES)


def spherical_wrist(arm: Arm, T: ArrayLike, near: ArrayLike | None = None) -> Solutions:
    """All joint vectors of an elbow arm with a spherical wrist for poses T, shape (..., 4, 4): eight branches.

    Four place the wrist's centre, as `elbow` names them, each with q_5 > 0 and with q_5 < 0. Rows 4 to 6 have alpha = (+-90,
    +-90, any) degrees, a_4 = a_5 = d_5 = 0: their axes meet in one point. Free joints as in `stanford` and `elbow`. Raises
    ArmError for another table or a T that is no pose.
    """
    return _decoupled(arm, T, near, elbow_kernel, must_be_elbow, ELBOW_BRANCHES)


def _decoupled(arm: Arm, T: ArrayLike, near, place, must_fit, names: tuple[str, ...]) -> Solutions:
    _must_have_wrist(arm)
    shoulder = _to_centre(arm)
    must_fit(shoulder)

    def kernel(arm: Arm, columns: Array, near: Array) -> tuple[Array, Array, Array, Array]:
        tool = unwound(arm, columns)
        q, free, valid, distance = place(shoulder, wrist_centre(arm, tool), near[:3])
        turned, loose = _wrist(arm, _seen_from(shoulder, q, tool.x, tool.z), near)
        q = np.concatenate([np.repeat(q, 2, axis=1), turned])
        free = np.concatenate([np.repeat(free, 2, axis=1), loose])
        return q, free, np.repeat(valid, 2, axis=0), distance

    branches = tuple(f"{name}, q_5 {sign} 0" for name in names for sign in "><")
    T = poses(arm, T)
    return each_branch(arm, T.reshape(*T.shape[:-2], 16), near, branches, kernel)


def _to_centre(arm: Arm) -> Arm:
    """The first three joints, their tip at the wrist's centre."""
    rows = (*arm.rows[:3], fixed(d=arm.rows[3].d))
    return replace(arm, rows=rows, bodies=(), home=())


def _seen_from(shoulder: Arm, q: Array, x: Array, z: Array) -> tuple[Array, Array]:
    """The axes x_6 and z_5 in frame 3 of each branch, each (3, branches, batch)."""
    frame = list(frame_columns(shoulder, q.reshape(3, -1)))[3][:3]
    axes = [axis.reshape(3, q.shape[1], -1) for axis in frame]
    return tuple(np.stack([(axis * v[:, None]).sum(axis=0) for axis in axes]) for v in (x, z))


def _wrist(arm: Arm, seen: tuple[Array, Array], near: Array) -> tuple[Array, Array]:
    """Joints 4 to 6 of both wrist branches, interleaved (3, 2 branches, batch), and which of them is free."""
    x, z = seen
    fourth, fifth, sixth = arm.numeric[3:]
    s4, s5 = fourth.sin_alpha, fifth.sin_alpha
    across = np.hypot(z[0], z[1])
    singular = across < SINGULAR
    phi_4 = np.arctan2(s5 * z[1], s5 * z[0])
    phi_4 = np.where(singular, near[3] + fourth.theta, phi_4)
    phi_5 = np.arctan2(across, -s4 * s5 * z[2])
    phi_6 = np.arctan2(-s4 * (z[0] * x[1] - z[1] * x[0]), s4 * x[2])
    if singular.any():
        phi_6 = np.where(singular, _following(s4 * s5, x, z, phi_4), phi_6)
    flip = np.where(singular, 0.0, np.pi)
    q = [
        wrapped(_interleaved(phi_4, phi_4 + flip) - fourth.theta),
        wrapped(_interleaved(phi_5, -phi_5) - fifth.theta),
        wrapped(_interleaved(phi_6, phi_6 + flip) - sixth.theta),
    ]
    free = np.zeros((3, *q[0].shape), bool)
    free[0] = _interleaved(singular, singular)
    return np.stack(q), free


def _following(signs: float, x: Array, z: Array, phi_4: Array) -> Array:
    """Joint 6 where joints 4 and 6 share an axis and joint 4 is given."""
    c, s = np.cos(phi_4), np.sin(phi_4)
    straight = np.sign(-signs * z[2])
    return np.arctan2(-signs * (c * x[1] - s * x[0]), straight * (c * x[0] + s * x[1]))


def _interleaved(one: Array, other: Array) -> Array:
    return np.stack([one, other], axis=1).reshape(2 * len(one), *one.shape[1:])


def _must_have_wrist(arm: Arm) -> None:
    rows = arm.numeric
    fits = (
        len(rows) == 6
        and all(row.kind == "revolute" for row in rows[3:])
        and rows[3].a == rows[4].a == rows[4].d == rows[3].cos_alpha == rows[4].cos_alpha == 0.0
    )
    if not fits:
        raise ArmError(
            f"{arm.name} has no spherical wrist; expected six rows, the last three revolute with alpha = (+-90, +-90, any)"
            " degrees and a_4 = a_5 = d_5 = 0"
        )
