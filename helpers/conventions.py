"""Standard and modified Denavit-Hartenberg tables of the same arm.

Both conventions are the one sequence Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha), cut at different places:
the standard row i ends with a_i and alpha_i, the modified row i of Craig begins with a_{i-1} and alpha_{i-1}.
So a table is converted by moving its a and alpha columns by one row.
Source: Craig, Introduction to Robotics, section 3.4; Spong, Hutchinson and Vidyasagar, section 3.2.
"""

from collections.abc import Sequence
from dataclasses import replace

from helpers.arm import ArmError, Row, fixed


def standard_from_modified(rows: Sequence[Row]) -> tuple[Row, ...]:
    """Standard rows from modified ones, each of which holds (a_{i-1}, alpha_{i-1}, d_i, theta_i).

    Where the first row has an a_0 or alpha_0, a fixed row is put before it. Raises ArmError for an empty table.
    """
    if not rows:
        raise ArmError("the modified table has no rows; expected one or more")
    following = [*rows[1:], Row()]
    shifted = [replace(row, a=n.a, alpha=n.alpha) for row, n in zip(rows, following, strict=True)]
    base = [] if rows[0].a == rows[0].alpha == 0 else [fixed(a=rows[0].a, alpha=rows[0].alpha)]
    return (*base, *shifted)


def modified_from_standard(rows: Sequence[Row]) -> tuple[Row, ...]:
    """Modified rows from standard ones; a last fixed row is added where a_n or alpha_n is not 0."""
    if not rows:
        raise ArmError("the standard table has no rows; expected one or more")
    before = [Row(), *rows[:-1]]
    shifted = [replace(row, a=b.a, alpha=b.alpha) for row, b in zip(rows, before, strict=True)]
    tip = [] if rows[-1].a == rows[-1].alpha == 0 else [fixed(a=rows[-1].a, alpha=rows[-1].alpha)]
    return (*shifted, *tip)
