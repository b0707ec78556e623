"""Standard and modified Denavit-Hartenberg tables of the same arm.

Both conventions are the one sequence Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha), cut at
different places: the standard row i ends with a_i and alpha_i, the modified row i of Craig begins
with a_{i-1} and alpha_{i-1}. So a table is converted by moving its a and alpha columns by one row.
Source: Craig, Introduction to Robotics, section 3.4; Spong, Hutchinson and Vidyasagar, section 3.2.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm, Row, fixed
from helpers.inputs import ArmError, listed, must_be
from helpers.kinematics import link_frames

__all__ = [
    "modified_frames",
    "modified_from_standard",
    "standard_from_modified",
]


def standard_from_modified(rows: Sequence[Row]) -> tuple[Row, ...]:
    """Standard rows from modified ones, each of which holds (a_{i-1}, alpha_{i-1}, d_i, theta_i).

    Where the first row has an a_0 or alpha_0, a fixed row is put before it. Raises ArmError for an
    empty table.
    """
    rows = _rows(rows, "modified")
    following = [*rows[1:], Row()]
    shifted = [replace(row, a=n.a, alpha=n.alpha) for row, n in zip(rows, following, strict=True)]
    base = [] if rows[0].a == rows[0].alpha == 0 else [fixed(a=rows[0].a, alpha=rows[0].alpha)]
    return (*base, *shifted)


def modified_from_standard(rows: Sequence[Row]) -> tuple[Row, ...]:
    """Modified rows from standard ones; a last fixed row is added where a_n or alpha_n is not 0."""
    rows = _rows(rows, "standard")
    before = [Row(), *rows[:-1]]
    shifted = [replace(row, a=b.a, alpha=b.alpha) for row, b in zip(rows, before, strict=True)]
    tip = [] if rows[-1].a == rows[-1].alpha == 0 else [fixed(a=rows[-1].a, alpha=rows[-1].alpha)]
    return (*shifted, *tip)


def modified_frames(arm: Arm, q: ArrayLike) -> NDArray[np.float64]:
    """Craig's frames 1 .. n of an arm, shape (..., rows, 4, 4): each lies on its own joint's axis,
    not the next one's.

    They are the standard frames before their step along and turn about x. Papers on the Panda give
    centres of mass in them.
    """
    must_be(arm, Arm, "arm")
    steps = np.array([np.eye(4)] * len(arm.rows))
    for step, row in zip(steps, arm.numeric, strict=True):
        step[:3, 1:3] = [[0, 0], [row.cos_alpha, -row.sin_alpha], [row.sin_alpha, row.cos_alpha]]
        step[0, 3] = row.a
    return link_frames(arm, q)[..., 1:, :, :] @ np.linalg.inv(steps)


def _rows(rows: Sequence[Row], convention: str) -> tuple[Row, ...]:
    found = listed(rows, f"the rows of the {convention} table", "one Row or more")
    if not found:
        raise ArmError(f"the {convention} table has no rows; expected one or more")
    for row in found:
        must_be(row, Row, f"a row of the {convention} table")
    return found
