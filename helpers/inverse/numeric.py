"""Solve inverse kinematics of any arm numerically, by damped least squares in batches."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm, require_joints
from helpers.inputs import (
    ArmError,
    broadcast_shape,
    finite_number,
    float_array,
    shorten,
    whole_number,
)
from helpers.inverse.axes import cross, dot
from helpers.inverse.solutions import check_poses, check_positions
from helpers.kinematics import jacobian_entries, tip_entries
from helpers.program import RowMotion, Value, get_program, run_batch

Array = NDArray[np.float64]

_CHUNK = 4096  # number of descents at a time whose data fit into the processor's caches


@dataclass(frozen=True, repr=False)
class NumericSolution:
    """The best configuration found for each target, and its errors.

    Attributes:
        q: Configurations, shape (..., dof), reached or not.
        reached: Whether both errors are within the tolerance, shape (...).
        position_error: Distances from tip to target, shape (...), in m.
        orientation_error: Angles of the missing rotations, shape (...), in rad; 0 where only
            positions were asked for.
        iterations: Steps taken from the start that gave q, shape (...).
        starts: Number of starts that were tried, shape (...).
        limits: Whether the joints were kept within limits.
    """

    q: Array
    reached: NDArray[np.bool_]
    position_error: Array
    orientation_error: Array
    iterations: NDArray[np.int_]
    starts: NDArray[np.int_]
    limits: bool

    def __repr__(self) -> str:
        off = (
            f"{np.max(self.position_error):.3g} m and {np.max(self.orientation_error):.3g} rad off"
        )
        most = int(np.max(self.starts, initial=0))
        tried = f"from {'1 start' if most == 1 else f'{most} starts'}"
        tried += " within the limits" if self.limits else ""
        advice = f"try restarts={5 * max(most, 4)}" + ", or limits=False" * self.limits
        if self.reached.ndim:
            text = f"{self.reached.sum()} of {self.reached.size} targets reached, at worst {off}"
            return text if self.reached.all() else f"{text}, {tried}; {advice}"
        text = f"reached in {self.iterations} steps"
        text = text if self.reached else f"not reached {tried}, {off}; {advice}"
        return f"{text}: q = {np.array2string(self.q.round(6) + 0.0, separator=', ')}"

    def _repr_markdown_(self) -> str:
        if self.reached.ndim:
            return repr(self)
        how, _, _ = repr(self).partition(": q = ")
        heads = "".join(f" $q_{i}$ |" for i in range(1, self.q.size + 1))
        joints = "".join(f" {x:.4f} |" for x in self.q.round(4) + 0.0)
        return f"| result |{heads}\n| :-- |{' --: |' * self.q.size}\n| {how} |{joints}"


def solve(
    arm: Arm,
    targets: ArrayLike,
    start: ArrayLike | None = None,
    *,
    limits: bool = True,
    tolerance: float = 1e-10,
    iterations: int = 100,
    restarts: int = 20,
) -> NumericSolution:
    """Find a configuration that takes the tip to each target.

    It lies near `start` if the descent from there reaches the target. Otherwise random starts are
    tried, always the same ones. The step J^T (J J^T + lambda^2 I)^-1 e has a damping lambda that is
    proportional to the error e and grows while steps fail: far from the target it is cautious,
    close to it Newton's. Metres and radians count alike.

    Args:
        arm: The arm.
        targets: Poses (..., 4, 4), or positions (..., 3) in m. A pose printed with few decimals is
            taken as by `solutions`.
        start: Configurations (..., dof) from which the first descent begins; home by default.
        limits: Whether the joints stay within their limits.
        tolerance: Largest distance (m) and angle (rad) from a target that is reached.
        iterations: Largest number of steps of a descent.
        restarts: Largest number of random starts for a target that was not reached.

    Raises:
        ArmError: An argument has a wrong shape or value.

    Example:
        >>> from helpers.kinematics import forward_kinematics
        >>> from helpers.robots import PANDA
        >>> target = forward_kinematics(PANDA, PANDA.home)
        >>> bool(solve(PANDA, target, start=[0] * 7).reached)
        True

    Source: Levenberg (1944), Marquardt (1963); damping by the error: Sugihara (2011).
    """
    require_joints(arm)
    if not isinstance(limits, bool | np.bool_):
        raise ArmError(
            f"limits is {shorten(limits)}; expected True or False. Other limits belong to the arm,"
            " as in arm.with_row(1, limits=(-1, 1))"
        )
    name, expected = f"{arm.name}: a target", "poses (..., 4, 4) or positions (..., 3) in m"
    goal = float_array(targets, name, expected)
    if goal.shape[-2:] == (4, 4):
        goal = check_poses(arm, goal).reshape(goal.shape)
    else:
        goal = check_positions(arm, goal)[..., None, :]
    shape = goal.shape[:-2]
    start = arm.joint_vector(arm.home if start is None else start, "start")
    shape = broadcast_shape("targets and start", shape, start.shape[:-1])
    goal = np.broadcast_to(goal, (*shape, *goal.shape[-2:])).reshape(-1, *goal.shape[-2:])
    start = np.broadcast_to(start, (*shape, arm.dof)).reshape(-1, arm.dof)
    whole_number(iterations, "iterations")
    whole_number(restarts, "restarts")
    finite_number(tolerance, "tolerance", "a positive number of m and rad", above=0)

    unbounded = _Rule((np.full(arm.dof, -np.inf), np.full(arm.dof, np.inf)), tolerance, iterations)
    rule = _Rule(arm.limits, tolerance, iterations) if limits else unbounded
    best = _descend(arm, goal, start, rule)
    starts, random = np.ones(len(goal), int), np.random.default_rng(0)
    lower, upper = arm.limits
    far = np.where(arm.turning, np.pi, 1.0)  # range of random starts without limits, rad or m
    ends = np.where(np.isfinite(lower), lower, -far), np.where(np.isfinite(upper), upper, far)
    for _ in range(restarts):
        missed = np.flatnonzero(best.worst > tolerance)
        if not missed.size:
            break
        begin = random.uniform(*ends, (missed.size, arm.dof))
        if limits:
            # A descent often ends at a joint limit. So ignore the limits first, then add whole
            # turns that bring the joints within their limits, and descend again.
            passed = _descend(arm, goal[missed], begin, unbounded).q
            outside = arm.turning & ((passed < lower) | (passed > upper))
            turns = np.ceil((np.where(outside, lower, passed) - passed) / (2 * np.pi))
            begin = passed + 2 * np.pi * turns
        descent = _descend(arm, goal[missed], begin, rule)
        starts[missed] += 1
        better = descent.worst < best.worst[missed]
        for old, new in zip(best, descent, strict=True):
            old[missed[better]] = new[better]
    has_limits = bool(limits and np.isfinite(arm.limits).any())
    return NumericSolution(
        best.q.reshape(*shape, arm.dof),
        (best.worst <= tolerance).reshape(shape),
        best.position.reshape(shape),
        best.orientation.reshape(shape),
        best.steps.reshape(shape),
        starts.reshape(shape),
        has_limits,
    )


class _Descent(NamedTuple):
    """Joint values, remaining errors and step counts of a batch of descents."""

    q: Array
    error: Array
    steps: NDArray[np.int_]

    @property
    def position(self) -> Array:
        return np.linalg.norm(self.error[:, :3], axis=1)

    @property
    def orientation(self) -> Array:
        return np.linalg.norm(self.error[:, 3:], axis=1)

    @property
    def worst(self) -> Array:
        return _largest_error(self.error)


class _Rule(NamedTuple):
    """Settings of a descent: joint bounds, tolerance (m and rad) and largest number of steps."""

    bounds: tuple[Array, Array]
    tolerance: float
    max_steps: int


def _descend(arm: Arm, goal: Array, start: Array, rule: _Rule) -> _Descent:
    ends = [
        _descend_batch(arm, goal[i : i + _CHUNK], start[i : i + _CHUNK], rule)
        for i in range(0, max(1, len(goal)), _CHUNK)
    ]
    return _Descent(*map(np.concatenate, zip(*ends, strict=True)))


def _descend_batch(arm: Arm, goal: Array, start: Array, rule: _Rule) -> _Descent:
    """Step a batch of descents until each has converged or used up its steps.

    Vectors that have arrived or cannot improve any more leave it.
    """
    bounds, tolerance, max_steps = rule
    q = np.clip(start, *bounds)
    J, error = _jacobian_and_error(arm, q, goal)
    end = _Descent(q.copy(), error.copy(), np.zeros(len(q), int))
    index, caution = np.arange(len(q)), np.full(len(q), 0.1)
    for count in range(max_steps + 1):
        moving = (_largest_error(error) > tolerance) & (caution < 1e9) & (count < max_steps)
        if not moving.all():
            done = index[~moving]
            end.q[done], end.error[done], end.steps[done] = q[~moving], error[~moving], count
            index, q, error, J = index[moving], q[moving], error[moving], J[moving]
            goal, caution = goal[moving], caution[moving]
        if not index.size:
            break
        tried = np.clip(q + _compute_step(J, q, error, caution, bounds), *bounds)
        there, left = _jacobian_and_error(arm, tried, goal)
        better = _squared_norms(left) < _squared_norms(error)
        # The damping factor is reduced after a step that removed 90 % of the squared error, kept
        # after any other improvement, and raised after a failure, more so after a long step.
        strides = _squared_norms(tried - q)
        failed = np.maximum(10.0 * caution, 0.3 / np.maximum(strides, 1e-18))
        is_large = _squared_norms(left) < 0.1 * _squared_norms(error)
        caution = np.where(better, np.where(is_large, 0.1, 1.0) * caution, failed)
        q, error = np.where(better[:, None], tried, q), np.where(better[:, None], left, error)
        J = there if better.all() else np.where(better[:, None, None], there, J)
    return end


def _compute_step(J: Array, q: Array, error: Array, caution: Array, bounds) -> Array:
    """Return the damped step.

    Joints stop at their limits, and the remaining joints compensate.
    """
    damping = caution * _squared_norms(error) + 1e-14
    step = _solve_damped(J, error, damping)
    kept = np.clip(step, bounds[0] - q, bounds[1] - q)
    cut = np.flatnonzero((kept != step).any(axis=1))
    if cut.size:
        stopped = (kept != step)[cut]
        part = np.where(stopped, kept[cut], 0.0)
        left = error[cut] - (J[cut] @ part[..., None])[..., 0]
        others = np.where(stopped[:, None], 0.0, J[cut])
        step[cut] = part + _solve_damped(others, left, damping[cut])
    return step


def _solve_damped(J: Array, error: Array, damping: Array) -> Array:
    A = J @ J.swapaxes(1, 2)
    rows = range(A.shape[1])
    A[:, rows, rows] += damping[:, None]
    return (np.linalg.solve(A, error[..., None]).swapaxes(1, 2) @ J)[:, 0]


def _jacobian_and_error(arm: Arm, q: Array, goal: Array) -> tuple[Array, Array]:
    """Return Jacobians (batch, rows, dof) and errors to the goal (batch, rows), m and then rad."""
    rows = run_batch(get_program(arm, _tip_and_jacobian), q.T)
    # Copy J, because the program overwrites its rows, and a failed step is repeated with this J.
    pose, J = rows[:16].reshape(4, 4, -1), rows[16:].T.copy().reshape(-1, 6, arm.dof)
    tip = pose[:3, 3]
    if goal.shape[-2] == 1:
        return J[:, :3], goal[:, 0] - tip.T
    want = np.ascontiguousarray(goal[:, :3].transpose(2, 1, 0))
    turn = rotation_vectors(list(pose[:3, :3].swapaxes(0, 1)), list(want[:3]))
    return J, np.concatenate([want[3] - tip, turn]).T


def _tip_and_jacobian(arm: Arm, steps: Sequence[RowMotion]) -> Sequence[Value]:
    return [*tip_entries(arm, steps), *jacobian_entries(arm, steps)]


def rotation_vectors(frames: Sequence[Array], target_frames: Sequence[Array]) -> Array:
    """Return the rotation vectors that turn frames into target frames.

    Args:
        frames, target_frames: Three axes each, every axis of shape (3, batch).

    Returns:
        Rotation vectors in base axes, shape (3, batch), rad.
    """
    pairs = list(zip(frames, target_frames, strict=True))
    axis = 0.5 * np.sum([cross(u, v) for u, v in pairs], axis=0)
    sine = np.sqrt(dot(axis, axis))
    cosine = 0.5 * (np.sum([dot(u, v) for u, v in pairs], axis=0) - 1.0)
    angle = np.arctan2(sine, cosine)
    vector = axis * np.where(sine > 1e-8, angle / np.maximum(sine, 1e-300), 1.0)
    for k in np.flatnonzero((sine <= 1e-8) & (cosine < 0)):
        # For a half turn R + I = 2 n n^T, so its largest column gives the axis n.
        columns = np.sum([np.outer(v[:, k], u[:, k]) for u, v in pairs], axis=0) + np.eye(3)
        largest = columns[:, np.argmax(np.diag(columns))]
        vector[:, k] = np.pi * largest / np.linalg.norm(largest)
    return vector


def _squared_norms(error: Array) -> Array:
    return np.einsum("ij,ij->i", error, error)


def _largest_error(error: Array) -> Array:
    return np.sqrt(np.maximum(_squared_norms(error[:, :3]), _squared_norms(error[:, 3:])))
