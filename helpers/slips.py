"""Do poses that were read off a drawing find the mistakes in a table? All simple ones are made, one
and two at a time, and those are kept that the poses do not see."""

from collections.abc import Sequence
from itertools import combinations
from math import isclose, pi
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import must_be
from helpers.kinematics import forward_kinematics

__all__ = ["Census", "Slip", "census", "slips"]

_SAME = 1e-9  # m, or the entries of a rotation


class Slip(NamedTuple):
    """One mistake: in a row, counted from 1, an entry (a, alpha, d or theta) that got another
    value, or a joint variable (q) that got the factor -1."""

    row: int
    entry: str
    value: float


class Census(NamedTuple):
    """How many tables have one slip, how many two, and the slips of those that poses do not tell
    from the right one: by the place of the tip, and by the whole pose of the tip's frame."""

    one: int
    two: int
    unseen_by_tip: Sequence[tuple[Slip, ...]]
    unseen_by_pose: Sequence[tuple[Slip, ...]]


def slips(arm: Arm) -> Sequence[Slip]:
    """Every single slip of three kinds: an entry forgotten, an entry with the other sign (but for
    180°, where that is none), a joint that counts the other way."""
    must_be(arm, Arm, "arm")
    found = []
    for i, row in enumerate(arm.rows, 1):
        if i in arm.joints:
            found.append(Slip(i, "q", -1.0))
        for name, entry in zip(("a", "alpha", "d", "theta"), row.entries, strict=True):
            value = arm.number(entry)
            if value:
                found.append(Slip(i, name, 0.0))
            if value and not (name in ("alpha", "theta") and isclose(abs(value), pi)):
                found.append(Slip(i, name, -value))
    return found


def census(arm: Arm, q: ArrayLike) -> Census:
    """Every table with one slip or two, tried in poses q of shape (k, dof) (rad or m)."""
    must_be(arm, Arm, "arm")
    q = arm.joint_vector(q)
    one = [(slip,) for slip in slips(arm)]
    two = [first + second for first, second in combinations(one, 2) if _both(*first, *second)]
    right = forward_kinematics(arm, q)
    tables = [(wrong, np.abs(_tried(arm, q, wrong) - right)) for wrong in one + two]
    by_tip = [wrong for wrong, off in tables if off[..., 3].max() < _SAME]
    return Census(len(one), len(two), by_tip, [wrong for wrong, off in tables if off.max() < _SAME])


def _both(first: Slip, second: Slip) -> bool:
    """Whether two slips can be made at once: not in one entry."""
    return first[:2] != second[:2]


def _tried(arm: Arm, q: NDArray[np.float64], wrong: tuple[Slip, ...]) -> NDArray[np.float64]:
    for slip in wrong:
        arm, q = slipped(arm, q, slip)
    return forward_kinematics(arm, q)


def slipped(arm: Arm, q: NDArray[np.float64], slip: Slip) -> tuple[Arm, NDArray[np.float64]]:
    """The arm and the joint values, shape (..., dof), of who makes a slip."""
    row, name, value = slip
    if name == "q":
        return arm, q * np.where(np.array(arm.joints) == row, value, 1)
    return arm.with_row(row, **{name: value}), q
