"""Self-motions: the joints move, and the tip stands still."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import ArmError, must_be, number
from helpers.kinematics import forward_kinematics, jacobian
from helpers.motion.paths import Path
from helpers.motion.steps import tip_error
from helpers.motion.tracing import Trace

Array = NDArray[np.floating]

_CUTOFF = 1e-6  # singular values below this share of the largest count as 0


def self_motion(
    arm: Arm,
    start: ArrayLike,
    direction: ArrayLike,
    length: float,
    *,
    step: float = 0.01,
    speed: float = 0.5,
) -> Trace:
    """Follow a null direction of the Jacobian from `start`, the tip's pose held to 1e-13 at every
    step.

    Each step goes along the null direction nearest to the last one; Newton's method then brings the
    tip back. The motion ends early, with fewer rows, where a joint would leave its range; where
    there is no room for a step the arm stands still.

    Args:
        start, direction: joints and joint rates, shape (dof,); the part of `direction` that moves
            the tip is left out.
        length: how far to go, measured along the curve in joint space, in rad (and m, for joints
            that slide).
        step: the length of one step, in the same unit.
        speed: the size of the joints' rates, in rad/s (and m/s), from which the times of the run
            follow.

    Returns a Trace whose path stays where the tip is. Raises ArmError for a direction that only
    moves the tip, and a step too long to follow the curve. Source: Siciliano, section 3.5; Allgower
    and Georg, Numerical Continuation Methods, chapter 2 (predictor and corrector).
    """
    must_be(arm, Arm, "arm")
    start = arm.joint_vector(start, "start", many=False)
    direction = arm.joint_vector(direction, "direction", many=False)
    length = number(length, "length", "a finite length > 0 in joint space", above=0)
    step = number(step, "step", "a finite length > 0 in joint space", above=0)
    speed = number(speed, "speed", "a finite joint speed > 0", above=0)
    pose, steps = forward_kinematics(arm, start), max(1, round(length / step))
    ahead = _tangent(arm, start, direction)
    q: list[Array] = [start]
    for _ in range(steps):
        moved = _brought_back(arm, q[-1] + length / steps * ahead, pose)
        if not np.linalg.norm(moved - q[-1]) < 2 * length / steps:
            raise ArmError(
                f"step is {step}, after which the tip is far off; expected a shorter one"
            )
        if not _within_limits(arm, moved):
            break
        ahead = _tangent(arm, moved, ahead)
        q.append(moved)
    if len(q) == 1:  # no room: it stands still
        q.append(start)
    return _at_rest(arm, np.array(q), length / steps / speed)


def self_motion_directions(arm: Arm, q: ArrayLike) -> Array:
    """The directions in which self-motions leave q, shape (number, dof): of size 1, the first joint
    that moves forwards.

    Each stands for its reverse, too; the one that moves joint 1 most comes first. With one null
    direction v of the Jacobian J it is v, unless the tip leaves in second order: while the joints
    move at the rates v, the tip's acceleration (dJ/dt) v must be one that J can undo. Where J has
    lost rank and has two null directions, the same condition is a quadratic equation, which leaves
    two lines of their plane, or none.

    Raises ArmError with more null directions than that, and where second order does not tell.
    Source: Allgower and Georg, Numerical Continuation Methods, section 8.1 (branching).
    """
    must_be(arm, Arm, "arm")
    J = jacobian(arm, arm.joint_vector(q, "q", many=False))
    left, sizes, right = np.linalg.svd(J)
    rank = int((sizes > _CUTOFF * sizes[0]).sum())
    still, lost = right[rank:], left[:, rank:].T
    if len(still) > 2 or (len(still) == 2 and not len(lost)):
        raise ArmError(
            f"J has {len(still)} null directions and loses {len(lost)} at q = {np.asarray(q)}; "
            "expected one null direction, or two at a pose of lost rank"
        )
    if len(still) == 2:
        forms = np.array([[lost @ _bilinear(J, u, v) for u in still] for v in still])
        still = _zeros(forms, f"q = {np.asarray(q)}") @ still
    stays = [np.abs(lost @ _acceleration(J, v)).max(initial=0) < _CUTOFF for v in still]
    found = still[np.array(stays, dtype=bool)]
    found = found[np.lexsort(-np.abs(found.T[::-1]))]
    return np.array([v * np.sign(v[np.abs(v) > 1e-6][0]) for v in found]).reshape(found.shape)


def _zeros(forms: Array, where: str) -> Array:
    """The unit vectors x, shape (2 or 0, 2), with x . F x = 0 for the largest of the forms F, shape
    (2, 2, number)."""
    largest = np.abs(forms).max(axis=(0, 1)).argmax()
    (low, high), axes = np.linalg.eigh(forms[:, :, largest])
    if min(abs(low), abs(high)) < _CUTOFF:
        raise ArmError(
            f"second order does not tell the directions at {where}; expected another pose"
        )
    if low * high > 0:
        return np.empty((0, 2))
    return np.sqrt([high, -low] / (high - low)) * [[1, 1], [1, -1]] @ axes.T


def _bilinear(J: Array, u: Array, v: Array) -> Array:
    return (_acceleration(J, u + v) - _acceleration(J, u - v)) / 4


def _acceleration(J: Array, rates: Array) -> Array:
    """The tip's acceleration (6,) while the joints keep `rates`, (dJ/dt) rates, from the columns of
    J alone."""
    v, w = (J * rates)[:3].T, (J * rates)[3:].T
    before = np.cumsum(w, axis=0) - w  # how the axis of each joint turns
    linear = np.cross(2 * before + w, v).sum(axis=0)
    return np.concatenate([linear, np.cross(before, w).sum(axis=0)])


def _tangent(arm: Arm, q: Array, ahead: Array) -> Array:
    """The part of `ahead` that leaves the tip alone, of size 1."""
    _, sizes, right = np.linalg.svd(jacobian(arm, q))
    still = right[int((sizes > _CUTOFF * sizes[0]).sum()) :]
    along = still.T @ (still @ ahead)
    if not np.linalg.norm(along) > 1e-3 * np.linalg.norm(ahead):
        raise ArmError(
            f"{ahead} only moves the tip at q = {np.asarray(q)}; expected a direction that leaves"
            " it alone"
        )
    return along / np.linalg.norm(along)


def _brought_back(arm: Arm, q: Array, pose: Array) -> Array:
    """The joints near q at which the tip has its pose, by Newton's method with the smallest
    steps."""
    for _ in range(20):
        error = tip_error(forward_kinematics(arm, q), pose[:3, 3], pose[:3, :3])
        if np.abs(error).max() < 1e-13:
            break
        q = q + np.linalg.pinv(jacobian(arm, q), rcond=_CUTOFF) @ error
    else:
        raise ArmError("step is too long: the tip was not brought back; expected a shorter one")
    return q


def _within_limits(arm: Arm, q: Array) -> bool:
    lower, upper = arm.limits
    return bool(((lower <= q) & (q <= upper)).all())


def _at_rest(arm: Arm, q: Array, seconds: float) -> Trace:
    """The run (steps + 1, dof), a step every `seconds`, along a path that stays where the tip
    is."""
    poses = forward_kinematics(arm, q)
    still, times = poses[0, :3, 3], seconds * np.arange(len(q))

    def position(t: ArrayLike) -> Array:
        return np.broadcast_to(still, (*np.shape(t), 3))

    def velocity(t: ArrayLike) -> Array:
        return np.zeros((*np.shape(t), 3))

    rates = np.diff(q, axis=0) / seconds
    path = Path(times, position, velocity, poses[0, :3, 2])
    return Trace(arm, path, q, np.vstack([rates, rates[-1]]), poses)
