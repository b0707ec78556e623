"""The torques of an arm that moves: the recursive Newton-Euler algorithm.

Motion is carried outwards from the base, forces inwards from the tip, everything in base axes.
Gravity enters as an upward acceleration of the base.
Source: Spong, Hutchinson and Vidyasagar, Robot Modeling and Control, section 6.6.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import ArmError, common_shape, numbers
from helpers.kinematics import link_frames
from helpers.statics import GRAVITY, must_have_bodies

__all__ = ["inverse_dynamics"]

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
    """M q_ddot + C q_dot + g(q), the torques (N m; N where a joint slides) of a moving arm without
    friction, shape (..., dof), for q, q_dot and q_ddot of shape (..., dof).

    `inertias` are the links' inertia tensors about their centres of mass, in the axes of the link
    frames, shape (rows, 3, 3), in kg m^2. Without them every link is a point mass at its centre.
    Raises ArmError where the arm has no masses, for tensors that are not symmetric, and for shapes
    that do not fit.
    """
    must_have_bodies(arm)
    q, q_dot, q_ddot = (
        arm.joint_vector(x, name) for x, name in ((q, "q"), (q_dot, "q_dot"), (q_ddot, "q_ddot"))
    )
    common_shape("q and q_dot", q.shape[:-1], q_dot.shape[:-1])
    common_shape("q and q_ddot", q.shape[:-1], q_ddot.shape[:-1])
    up = -numbers(gravity, "gravity", "a vector of three finite numbers in m/s^2", (3,))
    tensors = _tensors(arm, inertias)
    q, q_dot, q_ddot = np.broadcast_arrays(q, q_dot, q_ddot)
    frames = np.moveaxis(link_frames(arm, q), -3, 0)
    return _inwards(arm, frames, _outwards(arm, frames, (q_dot, q_ddot), up, tensors))


def _tensors(arm: Arm, inertias: ArrayLike | None) -> Array:
    shape = (len(arm.rows), 3, 3)
    if inertias is None:
        return np.zeros(shape)
    tensors = numbers(inertias, "inertias", f"tensors {shape} in kg m^2", shape)
    if not np.allclose(tensors, np.swapaxes(tensors, 1, 2), rtol=0, atol=1e-12):
        raise ArmError("inertias are not symmetric; expected xy = yx, xz = zx and yz = zy")
    return tensors


def _outwards(
    arm: Arm, frames: Array, motion: tuple[Array, Array], up: Array, tensors: Array
) -> list[tuple[Array, Array]]:
    """The force that each link's motion, (q_dot, q_ddot), takes, and its moment about the base's
    origin."""
    still = np.zeros((*motion[0].shape[:-1], 3))
    omega, alpha, a, wrenches, joint = still, still, still + up, [], 0
    for k, (row, body) in enumerate(zip(arm.numeric, arm.bodies, strict=True)):
        z, step = frames[k][..., :3, 2], frames[k + 1][..., :3, 3] - frames[k][..., :3, 3]
        slide = still
        if row.kind != "fixed":
            rate, spurt = (x[..., joint, None] * z for x in motion)
            joint += 1
        if row.kind == "revolute":
            alpha = alpha + spurt + np.cross(omega, rate)
            omega = omega + rate
        elif row.kind == "prismatic":
            slide = spurt + 2 * np.cross(omega, rate)
        a = a + slide + _swung(omega, alpha, step)
        R, origin = frames[k + 1][..., :3, :3], frames[k + 1][..., :3, 3]
        lever = R @ np.array([arm.number(c) for c in body.com])
        force = arm.number(body.mass) * (a + _swung(omega, alpha, lever))
        tensor = R @ tensors[k] @ np.swapaxes(R, -1, -2)
        spin = _times(tensor, alpha) + np.cross(omega, _times(tensor, omega))
        wrenches.append((force, np.cross(origin + lever, force) + spin))
    return wrenches


def _inwards(arm: Arm, frames: Array, wrenches: list[tuple[Array, Array]]) -> Array:
    """What each joint has to give of the force and the moment of all links beyond it."""
    force = moment = np.zeros((*frames.shape[1:-2], 3))
    torques, joint = np.empty((*frames.shape[1:-2], arm.dof)), arm.dof
    for k in range(len(arm.rows) - 1, -1, -1):
        force, moment = force + wrenches[k][0], moment + wrenches[k][1]
        z, origin, kind = frames[k][..., :3, 2], frames[k][..., :3, 3], arm.numeric[k].kind
        joint -= kind != "fixed"
        if kind == "revolute":
            torques[..., joint] = np.sum(z * (moment - np.cross(origin, force)), axis=-1)
        elif kind == "prismatic":
            torques[..., joint] = np.sum(z * force, axis=-1)
    return torques


def _swung(omega: Array, alpha: Array, r: Array) -> Array:
    """The acceleration of a point at r from another one of the same rigid body."""
    return np.cross(alpha, r) + np.cross(omega, np.cross(omega, r))


def _times(tensor: Array, vector: Array) -> Array:
    return np.einsum("...ij,...j->...i", tensor, vector)
