"""Compute self-motions, in which the joints move and the tip's pose stays fixed."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm, require_joints
from helpers.inputs import ArmError, finite_number
from helpers.kinematics import forward_kinematics, jacobian
from helpers.motion.paths import Path
from helpers.motion.steps import tip_error
from helpers.motion.tracing import Trace

Array = NDArray[np.floating]

_CUTOFF = 1e-6  # singular values up to this fraction of the largest count as 0


def self_motion(
    arm: Arm,
    start: ArrayLike,
    direction: ArrayLike,
    length: float,
    *,
    step: float = 0.01,
    speed: float = 0.5,
) -> Trace:
    """Follow a null direction of the Jacobian, keeping the tip's pose to 1e-13.

    Each step goes along the null direction nearest to the last one; Newton's method then brings the
    tip back. The motion ends early, with fewer rows, where a joint would leave its range; where
    there is no room for a step the arm stands still.

    Args:
        arm: The arm.
        start: Joint values at the start, shape (dof,).
        direction: Joint rates, shape (dof,); the part that moves the tip is left out.
        length: Length of the motion, along the curve in joint space, in rad (and m, for joints that
            slide).
        step: Length of one step, in the same unit.
        speed: Size of the joint rates, in rad/s (and m/s); it gives the times.

    Returns:
        A trace whose path is the tip's constant position.

    Raises:
        ArmError: `direction` only moves the tip, or a step is too long to follow the curve.

    Source: Siciliano, section 3.5; Allgower
    and Georg, Numerical Continuation Methods, chapter 2 (predictor and corrector).
    """
    require_joints(arm)
    start = arm.joint_vector(start, "start", many=False)
    direction = arm.joint_vector(direction, "direction", many=False)
    length = finite_number(length, "length", "a finite length > 0 in joint space", above=0)
    step = finite_number(step, "step", "a finite length > 0 in joint space", above=0)
    speed = finite_number(speed, "speed", "a finite joint speed > 0", above=0)
    pose, steps = forward_kinematics(arm, start), max(1, round(length / step))
    lower, upper = arm.limits
    ahead = _find_tangent(arm, start, direction)
    q: list[Array] = [start]
    for _ in range(steps):
        moved = q[-1] + length / steps * ahead
        for _ in range(20):
            error = tip_error(forward_kinematics(arm, moved), pose[:3, 3], pose[:3, :3])
            if np.abs(error).max() < 1e-13:
                break
            moved = moved + np.linalg.pinv(jacobian(arm, moved), rcond=_CUTOFF) @ error
        else:
            raise ArmError("step is too long: the tip was not brought back; expected a shorter one")
        if not np.linalg.norm(moved - q[-1]) < 2 * length / steps:
            raise ArmError(
                f"step is {step}, after which the tip is far off; expected a shorter one"
            )
        if (moved < lower).any() or (moved > upper).any():
            break
        ahead = _find_tangent(arm, moved, ahead)
        q.append(moved)
    if len(q) == 1:  # the limits leave no room for a motion
        q.append(start)

    seconds = length / steps / speed
    rates, poses = np.diff(q, axis=0) / seconds, forward_kinematics(arm, np.array(q))
    path = Path(
        seconds * np.arange(len(q)),
        lambda t: np.broadcast_to(poses[0, :3, 3], (*np.shape(t), 3)),
        lambda t: np.zeros((*np.shape(t), 3)),
        poses[0, :3, 2],
    )
    return Trace(arm, path, np.array(q), np.vstack([rates, rates[-1]]), poses)


def self_motion_directions(arm: Arm, q: ArrayLike) -> Array:
    """Find the directions in which self-motions leave q.

    With one null direction v of the Jacobian J the direction is v, unless the tip leaves in second
    order: while the joints move at the rates v, J must be able to undo the tip's acceleration
    (dJ/dt) v. Where J has lost rank and has two null directions, the same condition is a quadratic
    equation, which leaves two lines of their plane, or none.

    Args:
        arm: The arm.
        q: Joint values, shape (dof,).

    Returns:
        Unit vectors, shape (number, dof); their first moving joint moves forwards, and each stands
        for its opposite too. The one that moves joint 1 most comes first.

    Raises:
        ArmError: J has more null directions, or the second order leaves the answer open.

    Source: Allgower and Georg, Numerical Continuation Methods, section 8.1 (branching).
    """
    require_joints(arm)
    J = jacobian(arm, arm.joint_vector(q, "q", many=False))
    left, sizes, right = np.linalg.svd(J)
    rank = int((sizes > _CUTOFF * sizes[0]).sum())
    null, lost = right[rank:], left[:, rank:].T
    if len(null) > 2 or (len(null) == 2 and not len(lost)):
        raise ArmError(
            f"J has {len(null)} null directions and loses {len(lost)} at q = {np.asarray(q)}; "
            "expected one null direction, or two at a configuration of lost rank"
        )
    if len(null) == 2:
        # Find unit vectors x in the plane of both with x . F x = 0, where F is the largest form.
        forms = [
            [lost @ (_compute_acceleration(J, u + v) - _compute_acceleration(J, u - v)) / 4
             for u in null]
            for v in null
        ]  # fmt: skip
        largest = np.abs(forms).max(axis=(0, 1)).argmax()
        (low, high), axes = np.linalg.eigh(np.array(forms)[:, :, largest])
        if min(abs(low), abs(high)) < _CUTOFF:
            raise ArmError(
                f"second order does not tell the directions at q = {np.asarray(q)}; expected"
                " another configuration"
            )
        if low * high > 0:
            null = null[:0]
        else:
            null = np.sqrt([high, -low] / (high - low)) * [[1, 1], [1, -1]] @ axes.T @ null
    keeps_tip = [np.abs(lost @ _compute_acceleration(J, v)).max(initial=0) < _CUTOFF for v in null]
    directions = null[np.array(keeps_tip, dtype=bool)]
    directions = directions[np.lexsort(-np.abs(directions.T[::-1]))]
    forwards = [v * np.sign(v[np.abs(v) > 1e-6][0]) for v in directions]
    return np.array(forwards).reshape(directions.shape)


def _compute_acceleration(J: Array, rates: Array) -> Array:
    """Compute the tip's acceleration (dJ/dt) rates, shape (6,), from the columns of J alone."""
    v, w = (J * rates)[:3].T, (J * rates)[3:].T
    axis_rates = np.cumsum(w, axis=0) - w  # angular velocity of each joint's axis
    linear = np.cross(2 * axis_rates + w, v).sum(axis=0)
    return np.concatenate([linear, np.cross(axis_rates, w).sum(axis=0)])


def _find_tangent(arm: Arm, q: Array, ahead: Array) -> Array:
    """Return the part of `ahead` that does not move the tip, with length 1."""
    _, sizes, right = np.linalg.svd(jacobian(arm, q))
    null = right[int((sizes > _CUTOFF * sizes[0]).sum()) :]
    along = null.T @ (null @ ahead)
    if not np.linalg.norm(along) > 1e-3 * np.linalg.norm(ahead):
        raise ArmError(
            f"{ahead} only moves the tip at q = {np.asarray(q)}; expected a direction that leaves"
            " it alone"
        )
    return along / np.linalg.norm(along)
