"""Compute the torques of a moving arm by the recursive Newton-Euler algorithm.

The motion is carried from the base to the tip, the forces from the tip to the base, all in base
axes. Gravity enters as an upward acceleration of the base.
Source: Spong, Hutchinson and Vidyasagar, Robot Modeling and Control, section 6.6.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import broadcast_shape, finite_array
from helpers.kinematics import link_frames
from helpers.rows import check_tensors
from helpers.statics import GRAVITY, require_bodies

__all__ = ["inverse_dynamics", "mass_matrix"]

Array = NDArray[np.float64]


def inverse_dynamics(
    arm: Arm,
    q: ArrayLike,
    q_dot: ArrayLike,
    q_ddot: ArrayLike,
    *,
    inertias: ArrayLike | None = None,
    gravity: ArrayLike = GRAVITY,
) -> Array:
    """Compute the torques M q_ddot + C q_dot + g(q) of a moving arm without friction.

    Args:
        arm: The arm, with its bodies.
        q: Joint values, shape (..., dof), in rad or m.
        q_dot: Joint rates, shape (..., dof), in rad/s or m/s.
        q_ddot: Joint accelerations, shape (..., dof), in rad/s^2 or m/s^2.
        inertias: Inertia tensors in place of those of the bodies: about the links' centres of mass,
            in the axes of the link frames, shape (rows, 3, 3), in kg m^2.
        gravity: Gravity in base axes, shape (3,), in m/s^2.

    Returns:
        Torques, shape (..., dof), in N m; in N for a joint that slides.

    Raises:
        ArmError: The arm has no masses, a tensor is not symmetric, or shapes do not fit.

    Example:
        >>> from helpers.robots import UR10E
        >>> rest = [0, 0, 0, 0, 0, 0]
        >>> inverse_dynamics(UR10E, rest, rest, [0, 1, 0, 0, 0, 0])[1:3].round(2)
        array([-110.4 ,  -34.84])
    """
    require_bodies(arm)
    q, q_dot, q_ddot = (
        arm.joint_vector(x, name) for x, name in ((q, "q"), (q_dot, "q_dot"), (q_ddot, "q_ddot"))
    )
    broadcast_shape("q and q_dot", q.shape[:-1], q_dot.shape[:-1])
    broadcast_shape("q and q_ddot", q.shape[:-1], q_ddot.shape[:-1])
    up = -finite_array(gravity, "gravity", "a vector of three finite numbers in m/s^2", (3,))
    if inertias is None:
        tensors = np.array([body.inertia for body in arm.bodies])
    else:
        tensors = check_tensors(inertias, (len(arm.rows), 3, 3), "inertias")
    q, q_dot, q_ddot = np.broadcast_arrays(q, q_dot, q_ddot)
    frames = np.moveaxis(link_frames(arm, q), -3, 0)

    # From the base to the tip, compute for each link its angular velocity omega and acceleration
    # alpha, the acceleration a of its origin, and the force and moment (about the base's origin)
    # that its motion requires.
    zero = np.zeros((*q.shape[:-1], 3))
    omega, alpha, a, wrenches, joint = zero, zero, zero + up, [], 0
    for k, (row, body) in enumerate(zip(arm.numeric, arm.bodies, strict=True)):
        z, step = frames[k][..., :3, 2], frames[k + 1][..., :3, 3] - frames[k][..., :3, 3]
        slide = zero
        if row.kind != "fixed":
            rate, acceleration = (x[..., joint, None] * z for x in (q_dot, q_ddot))
            joint += 1
        if row.kind == "revolute":
            alpha = alpha + acceleration + np.cross(omega, rate)
            omega = omega + rate
        elif row.kind == "prismatic":
            slide = acceleration + 2 * np.cross(omega, rate)
        a = a + slide + _relative_acceleration(omega, alpha, step)
        R, origin = frames[k + 1][..., :3, :3], frames[k + 1][..., :3, 3]
        lever = R @ np.array([arm.number(c) for c in body.com])
        force = arm.number(body.mass) * (a + _relative_acceleration(omega, alpha, lever))
        moment = np.cross(origin + lever, force)
        if tensors[k].any():  # not a point mass
            tensor = R @ tensors[k] @ np.swapaxes(R, -1, -2)
            momentum, change = (_apply_tensors(tensor, vector) for vector in (omega, alpha))
            moment += change + np.cross(omega, momentum)
        wrenches.append((force, moment))

    # From the tip to the base, sum the wrenches; each joint carries the sum of all links beyond it.
    force = moment = zero
    torques = np.empty(q.shape)
    for k in range(len(arm.rows) - 1, -1, -1):
        force, moment = force + wrenches[k][0], moment + wrenches[k][1]
        z, origin, kind = frames[k][..., :3, 2], frames[k][..., :3, 3], arm.numeric[k].kind
        joint -= kind != "fixed"
        if kind == "revolute":
            torques[..., joint] = np.sum(z * (moment - np.cross(origin, force)), axis=-1)
        elif kind == "prismatic":
            torques[..., joint] = np.sum(z * force, axis=-1)
    return torques


def mass_matrix(arm: Arm, q: ArrayLike, *, inertias: ArrayLike | None = None) -> Array:
    """Compute the mass matrix M of M q_ddot + C q_dot + g(q) = tau.

    Column i holds the torques of a unit acceleration of joint i, at rest and without gravity.

    Args:
        arm: The arm, with its bodies.
        q: Configurations, shape (..., dof), in rad or m.
        inertias: Inertia tensors as for `inverse_dynamics`.

    Returns:
        Symmetric matrices, shape (..., dof, dof), in kg m^2; in kg for two joints that slide.

    Example:
        >>> from helpers.robots import UR10E
        >>> mass_matrix(UR10E, [0, 0, 0, 0, 0, 0])[1, 1:3].round(3)
        array([10.883,  4.461])
    """
    require_bodies(arm)
    q = arm.joint_vector(q)
    columns = [
        inverse_dynamics(arm, q, np.zeros(arm.dof), unit, inertias=inertias, gravity=(0, 0, 0))
        for unit in np.eye(arm.dof)
    ]
    return np.stack(columns, axis=-1)


def _relative_acceleration(omega: Array, alpha: Array, r: Array) -> Array:
    """Compute the acceleration of a point of a rigid body relative to its origin, at offset r."""
    return np.cross(alpha, r) + np.cross(omega, np.cross(omega, r))


def _apply_tensors(tensor: Array, vector: Array) -> Array:
    return np.einsum("...ij,...j->...i", tensor, vector)
