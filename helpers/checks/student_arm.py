"""Express an arm in the joints of a student's table, which counts them otherwise."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm, Body, Joint, Row
from helpers.kinematics import link_frames

Array = NDArray[np.float64]


def express_in_student_joints(arm: Arm, joint_map: Mapping[str, Any], name: str) -> Arm:
    """Return an arm with the student's rows and the limits, home and bodies of `arm`.

    Args:
        arm: the reference.
        joint_map: the judge's map. Joint k of `arm` is signs[k] times the student's plus
            offsets[k]; `base` is the frame of the student's base.
        name: name of the new arm.
    """
    signs, offsets = np.array(joint_map["signs"], float), np.array(joint_map["offsets"], float)
    limits = np.sort([signs * (end - offsets) for end in arm.limits], axis=0)
    joints = iter(zip(*limits, arm.speed_limits, arm.effort_limits, strict=True))
    rows = [_row(row, joints) for row in joint_map["rows"]]
    mine = Arm(name, rows, home=tuple(signs * (np.array(arm.home) - offsets)), source=arm.source)
    if not arm.bodies:
        return mine
    base = np.eye(4)
    base[:3] = np.transpose([joint_map["base"][axis] for axis in "xyzo"])
    student_frames = base @ link_frames(mine, np.zeros(mine.dof))
    return mine.with_bodies(_bodies(mine, student_frames, arm, link_frames(arm, offsets)))


def _row(row: Mapping[str, Any], joints: Iterator[tuple]) -> Row:
    fixed = row["kind"] == "fixed"
    joint = Joint("fixed") if fixed else Joint(row["kind"], *map(float, next(joints)))
    return Row(row["a"], row["alpha"], row["d"], row["theta"], joint)


def _bodies(mine: Arm, student_frames: Array, arm: Arm, arm_frames: Array) -> list[Body]:
    """Return each link's mass in the frame of the last row of the student's that moves with it."""
    totals = np.zeros((len(mine.rows), 4))  # mass, and mass times centre
    moving_joints = _count_moving_joints(mine)
    for body, frame, joint in zip(
        arm.bodies, arm_frames[1:], _count_moving_joints(arm), strict=True
    ):
        if joint not in moving_joints:
            continue  # the body is fixed to the base, for which the student has no row
        row = len(moving_joints) - 1 - moving_joints[::-1].index(joint)
        mass = arm.number(body.mass)
        centre = frame @ [*map(arm.number, body.com), 1.0]
        centre_in_link = np.linalg.inv(student_frames[row + 1]) @ centre
        totals[row] += mass * np.r_[1.0, centre_in_link[:3]]
    return [Body(m, tuple(c / m for c in s) if m else (0, 0, 0)) for m, *s in totals.tolist()]


def _count_moving_joints(arm: Arm) -> list[int]:
    """Return for each row the number of joints that move its link."""
    return np.cumsum([row.joint.kind != "fixed" for row in arm.rows]).tolist()
