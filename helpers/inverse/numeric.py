"""Numeric inverse kinematics for any arm: Levenberg and Marquardt's damped least squares, in batches."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm, ArmError
from helpers.inverse.solutions import must_be_rigid, poses, positions
from helpers.kinematics import cross, forward_kinematics, jacobian

Array = NDArray[np.float64]


@dataclass(frozen=True)
class NumericSolution:
    """One joint vector for each target, and how well it does.

    Attributes:
        q: shape (..., dof), the best found, reached or not.
        reached: whether both errors are within the tolerance, shape (...).
        position_error: distance from tip to target, shape (...), in m.
        orientation_error: angle of the turn that is missing, shape (...), in rad; 0 where only positions were asked for.
        iterations: steps taken from the start that gave q, shape (...).
        starts: how many starts were tried, shape (...).
    """

    q: Array
    reached: NDArray[np.bool_]
    position_error: Array
    orientation_error: Array
    iterations: NDArray[np.int_]
    starts: NDArray[np.int_]

    def __repr__(self) -> str:
        missed = self.reached.size - self.reached.sum()
        return f"<NumericSolution: {self.reached.sum()} of {self.reached.size} targets reached, {missed} missed>"


def solve(
    arm: Arm,
    target: ArrayLike,
    q0: ArrayLike | None = None,
    *,
    limits: bool = True,
    tolerance: float = 1e-10,
    iterations: int = 100,
    restarts: int = 0,
    seed: int = 0,
) -> NumericSolution:
    """A joint vector near q0 that takes the tip to each target: poses (..., 4, 4), or positions (..., 3) in m.

    The step J^T (J J^T + lambda I)^-1 e has a damping lambda in proportion to |e|^2, which grows while steps fail: far from
    the target it is cautious, close to it Newton's. Metres and radians count alike. With `limits` joints stay within
    theirs. Targets not reached within `tolerance` (m and rad) after `iterations` steps are tried again from up to
    `restarts` random starts. q0 has shape (..., dof); home unless given. Raises ArmError for bad shapes or numbers.
    Source: Levenberg (1944), Marquardt (1963); damping by the error: Sugihara (2011).
    """
    goal, shape = _goal(arm, target)
    start = arm.joint_vector(arm.home if q0 is None else q0)
    shape = np.broadcast_shapes(shape, start.shape[:-1])
    goal = np.broadcast_to(goal, (*shape, *goal.shape[-2:])).reshape(-1, *goal.shape[-2:])
    start = np.broadcast_to(start, (*shape, arm.dof)).reshape(-1, arm.dof)
    _must_count(iterations=iterations, restarts=restarts)
    if not (np.isfinite(tolerance) and tolerance > 0):
        raise ArmError(f"tolerance is {tolerance!r}; expected a positive number of m and rad")

    bounds = arm.limits if limits else (np.full(arm.dof, -np.inf), np.full(arm.dof, np.inf))
    best = _descend(arm, goal, start, bounds, tolerance, iterations)
    starts, random = np.ones(len(goal), int), np.random.default_rng(seed)
    for _ in range(restarts):
        missed = np.flatnonzero(best.cost > tolerance)
        if not missed.size:
            break
        again = random.uniform(*_range(arm), (missed.size, arm.dof))
        found = _descend(arm, goal[missed], again, bounds, tolerance, iterations)
        starts[missed] += 1
        better = found.cost < best.cost[missed]
        for old, new in zip(best.arrays, found.arrays, strict=True):
            old[missed[better]] = new[better]
    errors = (best.position, best.orientation)
    results = (best.q, best.cost <= tolerance, *errors, best.steps, starts)
    return NumericSolution(*(x.reshape(*shape, *x.shape[1:]) for x in results))


@dataclass
class _Descent:
    """The state of a batch of descents, changed in place as they go on."""

    q: Array
    error: Array
    steps: NDArray[np.int_]

    @property
    def arrays(self) -> tuple[Array, ...]:
        return self.q, self.error, self.steps

    @property
    def position(self) -> Array:
        return np.linalg.norm(self.error[:, :3], axis=1)

    @property
    def orientation(self) -> Array:
        return np.linalg.norm(self.error[:, 3:], axis=1)

    @property
    def cost(self) -> Array:
        """The larger of both errors."""
        return np.maximum(self.position, self.orientation)


def _descend(arm: Arm, goal: Array, start: Array, bounds, tolerance: float, most: int) -> _Descent:
    q = np.clip(start, *bounds)
    state = _Descent(q, residual(arm, q, goal), np.zeros(len(q), int))
    caution = np.full(len(q), 0.1)
    for _ in range(most):
        going = np.flatnonzero((state.cost > tolerance) & (caution < 1e9))
        if not going.size:
            break
        q, error = state.q[going], state.error[going]
        tried = np.clip(q + _step(arm, q, error, caution[going], bounds), *bounds)
        left = residual(arm, tried, goal[going])
        better = _square(left) < _square(error)
        caution[going] *= np.where(better, 0.1, 10.0)
        state.q[going[better]], state.error[going[better]] = tried[better], left[better]
        state.steps[going] += 1
    return state


def _step(arm: Arm, q: Array, error: Array, caution: Array, bounds) -> Array:
    """The damped step; where it would leave the limits, those joints go to theirs and the others make up for it."""
    J = jacobian(arm, q)[:, : error.shape[1]]
    damping = caution * _square(error) + 1e-14
    step = _damped(J, error, damping)
    kept = np.clip(step, bounds[0] - q, bounds[1] - q)
    cut = np.flatnonzero((kept != step).any(axis=1))
    if cut.size:
        stopped = (kept != step)[cut]
        part = np.where(stopped, kept[cut], 0.0)
        left = error[cut] - (J[cut] @ part[..., None])[..., 0]
        others = np.where(stopped[:, None], 0.0, J[cut])
        step[cut] = part + _damped(others, left, damping[cut])
    return step


def _damped(J: Array, error: Array, damping: Array) -> Array:
    A = J @ J.swapaxes(1, 2)
    rows = range(A.shape[1])
    A[:, rows, rows] += damping[:, None]
    return (np.linalg.solve(A, error[..., None]).swapaxes(1, 2) @ J)[:, 0]


def residual(arm: Arm, q: Array, goal: Array) -> Array:
    """What is missing to the goal: metres (batch, 3) for positions (batch, 1, 3), and radians too (batch, 6) for poses."""
    T = forward_kinematics(arm, q)
    if goal.shape[-2] == 1:
        return goal[:, 0] - T[:, :3, 3]
    return np.concatenate([goal[:, :3, 3] - T[:, :3, 3], turn_between(T, goal)], axis=1)


def turn_between(T: Array, goal: Array) -> Array:
    """Rotation vectors (batch, 3), in rad and base axes, that turn the poses T into the goals."""
    have, want = (np.moveaxis(x[:, :3, :3], 0, -1) for x in (T, goal))
    axis = 0.5 * sum(cross(have[:, i], want[:, i]) for i in range(3))
    sine = np.sqrt((axis * axis).sum(axis=0))
    angle = np.arctan2(sine, 0.5 * ((have * want).sum(axis=(0, 1)) - 1.0))
    scale = angle / np.where(sine > 1e-8, sine, np.maximum(angle, 1e-300))
    vector = (axis * scale).T
    for k in np.flatnonzero((sine <= 1e-8) & (angle > 1.0)):
        vector[k] = _half_turn(goal[k, :3, :3] @ T[k, :3, :3].T)
    return vector


def _half_turn(R: Array) -> Array:
    """The rotation vector of a half turn, from its largest column of R + I = 2 n n^T."""
    columns = R + np.eye(3)
    largest = columns[:, np.argmax(np.diag(columns))]
    return np.pi * largest / np.linalg.norm(largest)


def _square(error: Array) -> Array:
    return (error * error).sum(axis=1)


def _goal(arm: Arm, target: ArrayLike) -> tuple[Array, tuple[int, ...]]:
    if np.shape(target)[-2:] == (4, 4):
        flat = poses(arm, target)
        must_be_rigid(arm, flat.reshape(-1, 16).T)
        return flat.reshape(*flat.shape[:-1], 4, 4), flat.shape[:-1]
    points = positions(arm, target)
    return points[..., None, :], points.shape[:-1]


def _range(arm: Arm) -> tuple[Array, Array]:
    """Where random starts lie: the joint limits, or half a turn and a metre either way where there are none."""
    kinds = [arm.rows[i - 1].joint.kind for i in arm.joints]
    far = np.array([np.pi if kind == "revolute" else 1.0 for kind in kinds])
    lower, upper = arm.limits
    return np.where(np.isfinite(lower), lower, -far), np.where(np.isfinite(upper), upper, far)


def _must_count(**counts: int) -> None:
    for name, value in counts.items():
        if not isinstance(value, int | np.integer) or value < 0:
            raise ArmError(f"{name} is {value!r}; expected a whole number of 0 or more")
