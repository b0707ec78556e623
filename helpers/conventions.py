"""Convert Denavit-Hartenberg tables between the standard and the modified convention.

Both conventions multiply the same matrices Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha) and
divide the product differently: the standard row i ends with a_i and alpha_i, the modified row i of
Craig begins with a_{i-1} and alpha_{i-1}. Moving the columns a and alpha by one row converts a
table.
Source: Craig, Introduction to Robotics, section 3.4; Spong, Hutchinson and Vidyasagar, section 3.2.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm, Row, fixed
from helpers.inputs import ArmError, require_type, tuple_of_items
from helpers.kinematics import link_frames

__all__ = [
    "modified_frames",
    "modified_from_standard",
    "standard_from_modified",
]


def standard_from_modified(rows: Sequence[Row]) -> tuple[Row, ...]:
    """Convert modified rows to standard ones.

    Args:
        rows: Modified rows, each with (a_{i-1}, alpha_{i-1}, d_i, theta_i).

    Returns:
        Standard rows. Where a_0 or alpha_0 is not 0, a fixed row comes first.

    Raises:
        ArmError: The table is empty.

    Example:
        >>> [row.a for row in standard_from_modified([Row(), Row(a=0.4)])]
        [0.4, 0]
    """
    rows = _check_rows(rows, "modified")
    following = [*rows[1:], Row()]
    shifted = [replace(row, a=n.a, alpha=n.alpha) for row, n in zip(rows, following, strict=True)]
    base = [] if rows[0].a == rows[0].alpha == 0 else [fixed(a=rows[0].a, alpha=rows[0].alpha)]
    return (*base, *shifted)


def modified_from_standard(rows: Sequence[Row]) -> tuple[Row, ...]:
    """Convert standard rows to modified ones.

    Args:
        rows: Standard rows, each with (a_i, alpha_i, d_i, theta_i).

    Returns:
        Modified rows. Where a_n or alpha_n is not 0, a fixed row comes last.

    Example:
        >>> [row.a for row in modified_from_standard([Row(a=0.4), Row(a=0.3)])]
        [0, 0.4, 0.3]
    """
    rows = _check_rows(rows, "standard")
    before = [Row(), *rows[:-1]]
    shifted = [replace(row, a=b.a, alpha=b.alpha) for row, b in zip(rows, before, strict=True)]
    tip = [] if rows[-1].a == rows[-1].alpha == 0 else [fixed(a=rows[-1].a, alpha=rows[-1].alpha)]
    return (*shifted, *tip)


def modified_frames(arm: Arm, q: ArrayLike) -> NDArray[np.float64]:
    """Compute Craig's frames 1 .. n of an arm, each on its own joint's axis.

    They are the standard frames before the step along x and the turn about x. Papers on the Panda
    give centres of mass in them.

    Args:
        arm: The arm, in standard rows.
        q: Joint values, shape (..., dof).

    Returns:
        Frames, shape (..., rows, 4, 4).

    Example:
        >>> from helpers.robots import ELBOW
        >>> modified_frames(ELBOW, [0, 0, 0])[:, :3, 3]
        array([[0. , 0. , 0.5],
               [0. , 0. , 0.5],
               [0.4, 0. , 0.5]])
    """
    require_type(arm, Arm, "arm")
    steps = np.array([np.eye(4)] * len(arm.rows))
    for step, row in zip(steps, arm.numeric, strict=True):
        step[:3, 1:3] = [[0, 0], [row.cos_alpha, -row.sin_alpha], [row.sin_alpha, row.cos_alpha]]
        step[0, 3] = row.a
    return link_frames(arm, q)[..., 1:, :, :] @ np.linalg.inv(steps)


def _check_rows(rows: Sequence[Row], convention: str) -> tuple[Row, ...]:
    items = tuple_of_items(rows, f"the rows of the {convention} table", "one Row or more")
    if not items:
        raise ArmError(f"the {convention} table has no rows; expected one or more")
    for row in items:
        require_type(row, Row, f"a row of the {convention} table")
    return items
