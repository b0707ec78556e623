"""The reference as an arm of the student's own table, whose joints count otherwise."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm, Body, Joint, Row
from helpers.kinematics import link_frames

Array = NDArray[np.float64]


def in_own_joints(arm: Arm, found: Mapping[str, Any], name: str) -> Arm:
    """An arm of the student's rows with the limits, the home and the bodies of `arm` carried over.

    By `found`, the judge's map, joint k of `arm` is signs[k] times the student's plus offsets[k],
    and the student's base stands in the frame `base`.
    """
    signs, offsets = np.array(found["signs"], float), np.array(found["offsets"], float)
    limits = np.sort([signs * (end - offsets) for end in arm.limits], axis=0)
    joints = iter(zip(*limits, arm.speed_limits, arm.effort_limits, strict=True))
    rows = [_row(row, joints) for row in found["rows"]]
    mine = Arm(name, rows, home=tuple(signs * (np.array(arm.home) - offsets)), source=arm.source)
    if not arm.bodies:
        return mine
    base = np.eye(4)
    base[:3] = np.transpose([found["base"][axis] for axis in "xyzo"])
    ours = base @ link_frames(mine, np.zeros(mine.dof))
    return mine.with_bodies(_bodies(mine, ours, arm, link_frames(arm, offsets)))


def _row(row: Mapping[str, Any], joints: Iterator[tuple]) -> Row:
    fixed = row["kind"] == "fixed"
    joint = Joint("fixed") if fixed else Joint(row["kind"], *map(float, next(joints)))
    return Row(row["a"], row["alpha"], row["d"], row["theta"], joint)


def _bodies(mine: Arm, ours: Array, arm: Arm, theirs: Array) -> list[Body]:
    """Each link's mass in the frame of the last row that moves with it in the student's table."""
    totals = np.zeros((len(mine.rows), 4))  # mass, and mass times centre
    owners = _owners(mine)
    for body, frame, joint in zip(arm.bodies, theirs[1:], _owners(arm), strict=True):
        if joint not in owners:
            continue  # it stands on the base, of which the student has no row
        row = len(owners) - 1 - owners[::-1].index(joint)
        mass = arm.number(body.mass)
        centre = frame @ [*map(arm.number, body.com), 1.0]
        own = np.linalg.inv(ours[row + 1]) @ centre
        totals[row] += mass * np.r_[1.0, own[:3]]
    return [Body(m, tuple(c / m for c in s) if m else (0, 0, 0)) for m, *s in totals.tolist()]


def _owners(arm: Arm) -> list[int]:
    """The number of joints that move each row's link."""
    return np.cumsum([row.joint.kind != "fixed" for row in arm.rows]).tolist()
