"""Find which mistakes in a table the poses read off a drawing do not show.

All simple mistakes are made, one and two at a time, and those are kept that no pose shows.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from math import isclose, pi
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import require_type
from helpers.kinematics import forward_kinematics

__all__ = ["Census", "TableSlip", "census"]

_SAME = 1e-9  # m, or a difference of a rotation's entries


class TableSlip(NamedTuple):
    """A mistake in a table.

    Attributes:
        row: Number of the row, counted from 1.
        entry: "a", "alpha", "d" or "theta" for a wrong value of an entry, "q" for a wrong factor of
            the joint's variable.
        value: The wrong value or factor.
    """

    row: int
    entry: str
    value: float


@dataclass(frozen=True)
class Census:
    """Tables with one or two slips, and those that some configurations do not reveal.

    Attributes:
        single_slips: Number of tables with one slip.
        slip_pairs: Number of tables with two slips.
        unseen_by_tip: The slips of tables that give the right tip position in all configurations.
        unseen_by_pose: The slips of tables that give the right tip pose in all configurations.
    """

    single_slips: int
    slip_pairs: int
    unseen_by_tip: Sequence[tuple[TableSlip, ...]]
    unseen_by_pose: Sequence[tuple[TableSlip, ...]]


def list_slips(arm: Arm) -> Sequence[TableSlip]:
    """List every single slip of three kinds in an arm's table.

    An entry is left out, an entry has the other sign (except 180°, which stays the same angle), or
    a joint counts the other way.

    Example:
        >>> from helpers.robots import ELBOW
        >>> list_slips(ELBOW)[:2]
        [TableSlip(row=1, entry='q', value=-1.0), TableSlip(row=1, entry='alpha', value=0.0)]
    """
    require_type(arm, Arm, "arm")
    slips = []
    for i, row in enumerate(arm.rows, 1):
        if i in arm.joints:
            slips.append(TableSlip(i, "q", -1.0))
        for name, entry in zip(("a", "alpha", "d", "theta"), row.entries, strict=True):
            value = arm.number(entry)
            if value:
                slips.append(TableSlip(i, name, 0.0))
            if value and not (name in ("alpha", "theta") and isclose(abs(value), pi)):
                slips.append(TableSlip(i, name, -value))
    return slips


def census(arm: Arm, q: ArrayLike) -> Census:
    """Try every table with one slip or two in the given poses.

    Args:
        arm: The arm with the right table.
        q: Joint values, shape (k, dof), in rad or m.

    Example:
        >>> from helpers.robots import ELBOW
        >>> census(ELBOW, [[0.3, 0.5, -0.2]]).unseen_by_tip
        []
    """
    require_type(arm, Arm, "arm")
    q = arm.joint_vector(q)
    singles = [(slip,) for slip in list_slips(arm)]
    pairs = [a + b for a, b in combinations(singles, 2) if _in_different_entries(*a, *b)]
    right = forward_kinematics(arm, q)
    errors = [(slips, np.abs(_poses_with(arm, q, slips) - right)) for slips in singles + pairs]
    return Census(
        single_slips=len(singles),
        slip_pairs=len(pairs),
        unseen_by_tip=[slips for slips, error in errors if error[..., 3].max() < _SAME],
        unseen_by_pose=[slips for slips, error in errors if error.max() < _SAME],
    )


def _in_different_entries(first: TableSlip, second: TableSlip) -> bool:
    return (first.row, first.entry) != (second.row, second.entry)


def _poses_with(
    arm: Arm, q: NDArray[np.float64], slips: tuple[TableSlip, ...]
) -> NDArray[np.float64]:
    for slip in slips:
        arm, q = apply_slip(arm, q, slip)
    return forward_kinematics(arm, q)


def apply_slip(
    arm: Arm, q: NDArray[np.float64], slip: TableSlip
) -> tuple[Arm, NDArray[np.float64]]:
    """Return the arm and the joint values, shape (..., dof), of somebody who makes a slip."""
    if slip.entry == "q":
        return arm, q * np.where(np.array(arm.joints) == slip.row, slip.value, 1)
    return arm.with_row(slip.row, **{slip.entry: slip.value}), q
