"""Turn the pose of a base or of a tool into rows of a Denavit-Hartenberg table.

A pose has six numbers and a row four. So every pose is one row and a rotation about z with a shift
along z: Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha) Rot_z(theta') Trans_z(d').
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from helpers.expressions import Entry, check_entry, evaluate_entry
from helpers.inputs import ArmError, finite_array, shorten
from helpers.poses import rigid_poses
from helpers.rows import angle_entry, cos_sin, rotation_from_angles

_EXPECTED = "a 4x4 pose, or (x, y, z, roll, pitch, yaw) in m and rad"
# Lengths (m) and sines up to this count as 0: 1000 times the round-off of a pose.
_ROUND_OFF = 1e-12


class PoseRows(NamedTuple):
    """The entries of a pose as a row and a last rotation and shift.

    Attributes:
        a, alpha, d, theta: Entries of the row, in m and rad.
        last_d: Shift along z behind the row, in m.
        last_theta: Rotation about z behind the row, in rad.
    """

    a: Entry
    alpha: Entry
    d: Entry
    theta: Entry
    last_d: Entry
    last_theta: Entry


def split_pose(pose: ArrayLike, name: str) -> PoseRows:
    """Split a pose into the entries of a row and a last rotation and shift.

    Args:
        pose: A transform (4, 4), or (x, y, z, roll, pitch, yaw) in m and rad, with formulas such as
            "pi/2" allowed; R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll).
        name: What messages call the pose.

    Raises:
        ArmError: The pose is neither, or its rotation is none.
    """
    try:
        entries = np.asarray(pose, dtype=object)
    except ValueError:
        raise ArmError(f"{name} is {shorten(pose)}; expected {_EXPECTED}") from None
    if entries.shape == (6,):
        numbers = [evaluate_entry(check_entry(entry, name), {}) for entry in entries]
        T = np.eye(4)
        T[:3, 3], angles = np.split(finite_array(numbers, name, _EXPECTED, (6,)), 2)
        T[:3, :3] = rotation_from_angles(angles)
    else:
        T = rigid_poses(pose, name, _EXPECTED)
    z, p = T[:3, 2], T[:3, 3]
    sine = float(np.hypot(z[0], z[1]))
    if sine < _ROUND_OFF:
        theta, last_d = np.arctan2(p[1], p[0]), 0.0
        theta = theta if np.hypot(p[0], p[1]) > _ROUND_OFF else 0.0
    else:
        theta = np.arctan2(z[0], -z[1])  # x of the row is z_0 x z
    if abs(theta) > np.pi / 2 + _ROUND_OFF:
        theta -= np.copysign(np.pi, theta)  # x and -x are both allowed: choose the smaller turn
    c, s = cos_sin(float(theta))
    x, y = np.array([c, s, 0.0]), np.array([-s, c, 0.0])
    alpha = np.arctan2(-(y @ z), z[2])
    if sine >= _ROUND_OFF:
        last_d = (p @ y) / (z @ y)
    d = p[2] - last_d * z[2]
    row_y = np.cross(z, x)
    last_theta = np.arctan2(T[:3, 0] @ row_y, T[:3, 0] @ x)
    return PoseRows(
        _clean_length(p @ x), _clean_angle(alpha), _clean_length(d), _clean_angle(theta),
        _clean_length(last_d), _clean_angle(last_theta),
    )  # fmt: skip


def _clean_length(x: float) -> Entry:
    return 0 if abs(x) < _ROUND_OFF else float(x)


def _clean_angle(angle: float) -> Entry:
    entry = angle_entry(angle)
    return "pi" if entry == "-pi" else entry
