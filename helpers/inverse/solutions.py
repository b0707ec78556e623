"""What every closed form returns: all branches of a batch of targets, and ways to choose among them."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm, ArmError
from helpers.kinematics import cross

Array = NDArray[np.float64]

_CHUNK = 4096  # so many targets at a time keep all branches inside a level-2 cache
REACH = 1e-12  # m: a target this far beyond the boundary counts as on it


@dataclass(frozen=True)
class Solutions:
    """Every joint vector that takes the tip to a target, for a batch of targets.

    Attributes:
        arm: the arm.
        branches: a name for each branch, in the order of the arrays.
        q: shape (..., branches, dof), angles in (-pi, pi]; NaN where a branch does not exist. Branches that merge at a
            singular pose are all listed.
        valid: whether the branch exists, shape (..., branches). Joint limits do not enter; see `within_limits`.
        free: whether a joint's value was chosen, because any would do if the others follow, shape (..., branches, dof).
        distance: how far the target (for a wrist: its centre) is from the nearest point within reach, shape (...), in m;
            0 where it is reached, NaN where no short formula tells.
    """

    arm: Arm
    branches: tuple[str, ...]
    q: Array
    valid: NDArray[np.bool_]
    free: NDArray[np.bool_]
    distance: Array

    @property
    def within_limits(self) -> NDArray[np.bool_]:
        """Whether a branch exists and lies within the joint limits, whole turns allowed, shape (..., branches)."""
        return _inside(self.arm, _turned_towards(self.arm, self.q, np.zeros(self.arm.dof)))

    def nearest(self, q: ArrayLike, limits: bool = True) -> Array:
        """The branch with the least largest joint change from q, shape (..., dof); NaN where there is none.

        Revolute joints may have made whole turns: each is taken by the turn nearest to q. With `limits` only what lies within
        the joint limits counts. q has shape (..., dof). Raises ArmError for another shape.
        """
        start = self.arm.joint_vector(q)[..., None, :]
        found = _turned_towards(self.arm, self.q, start, limits)
        change = np.abs(found - start).max(axis=-1)
        allowed = _inside(self.arm, found) if limits else self.valid
        best = np.where(allowed, change, np.inf).argmin(axis=-1)[..., None]
        chosen = np.take_along_axis(found, best[..., None], axis=-2)[..., 0, :]
        return np.where(np.take_along_axis(allowed, best, axis=-1), chosen, np.nan)


def follow(solver: Callable[..., Solutions], targets: ArrayLike, q0: ArrayLike) -> Array:
    """Joint vectors along a path of targets, shape (len(targets), dof), each on the branch nearest to the one before.

    `solver(target, near)` is a closed form with its arm put in, as `partial(ur, UR10E)`. A free joint keeps its value. Raises
    ArmError at the first target that no branch reaches within the joint limits.
    """
    path, q = [], np.asarray(q0, dtype=float)
    for step, target in enumerate(np.asarray(targets, dtype=float)):
        found = solver(target, near=q)
        q = found.nearest(q)
        if np.isnan(q).any():
            raise ArmError(
                f"{found.arm.name}: no branch reaches target {step} of {len(targets)} within the joint limits"
            )
        path.append(q)
    return np.array(path)


def each_branch(
    arm: Arm,
    targets: Array,
    near: ArrayLike | None,
    branches: tuple[str, ...],
    kernel: Callable[..., tuple[Array, Array, Array, Array]],
) -> Solutions:
    """Run `kernel` on targets of shape (..., k), in chunks of columns, and put its branches together.

    The kernel gets columns (k, batch) and nearby joint values (dof, batch), and gives q (dof, branches, batch), free
    likewise, valid (branches, batch) and distance (batch,).
    """
    near = arm.joint_vector(np.zeros(arm.dof) if near is None else near)
    shape = np.broadcast_shapes(targets.shape[:-1], near.shape[:-1])
    count, many = math.prod(shape), len(branches)
    columns = _columns(targets, shape)
    chosen = _columns(near, shape)
    q, free = np.empty((count, many, arm.dof)), np.zeros((count, many, arm.dof), bool)
    valid, distance = np.empty((count, many), bool), np.empty(count)
    for start in range(0, count, _CHUNK):
        part = slice(start, start + _CHUNK)
        found, loose, exists, distance[part] = kernel(arm, columns[:, part], chosen[:, part])
        q[part], valid[part] = found.T, exists.T
        if loose is not None:
            free[part] = loose.T
    if not valid.all():
        q[~valid] = np.nan
    return Solutions(
        arm,
        branches,
        q.reshape(*shape, many, arm.dof),
        valid.reshape(*shape, many),
        free.reshape(*shape, many, arm.dof),
        distance.reshape(shape),
    )


def _columns(values: Array, shape: tuple[int, ...]) -> Array:
    flat = np.broadcast_to(values, (*shape, values.shape[-1])).reshape(-1, values.shape[-1])
    return np.ascontiguousarray(flat.T)


def positions(arm: Arm, p: ArrayLike) -> Array:
    """`p` as positions of shape (..., 3); raises ArmError for anything else."""
    points = np.asarray(p, dtype=float)
    if points.shape[-1:] != (3,):
        raise ArmError(f"{arm.name}: p has shape {points.shape}; expected (..., 3), positions in m")
    if not np.isfinite(points).all():
        raise ArmError(f"{arm.name}: p holds NaN or infinity; expected finite positions in m")
    return points


def poses(arm: Arm, T: ArrayLike) -> Array:
    """`T` as rigid transforms of shape (..., 4, 4); raises ArmError for anything else."""
    transforms = np.asarray(T, dtype=float)
    if transforms.shape[-2:] != (4, 4):
        raise ArmError(f"{arm.name}: T has shape {transforms.shape}; expected (..., 4, 4), poses")
    if not np.isfinite(transforms).all():
        raise ArmError(f"{arm.name}: T holds NaN or infinity; expected poses")
    x, y, z, _ = np.moveaxis(transforms, (-1, -2), (0, 1))[:, :3]
    error = max(np.abs((x * x).sum(axis=0) - 1).max(initial=0.0), np.abs(cross(y, z) - x).max(initial=0.0),
                np.abs(cross(z, x) - y).max(initial=0.0), np.abs(cross(x, y) - z).max(initial=0.0))  # fmt: skip
    if error > 1e-6:
        raise ArmError(f"{arm.name}: T holds no rotation (off by {error:.2g}); expected poses")
    return transforms


def wrapped(angle: Array) -> Array:
    """The same angle in (-pi, pi], up to rounding."""
    return angle - 2 * np.pi * np.rint(angle * (0.5 / np.pi))


def _turns(arm: Arm) -> Array:
    kinds = [arm.rows[i - 1].joint.kind for i in arm.joints]
    return np.array([2 * np.pi if kind == "revolute" else np.inf for kind in kinds])


def _turned_towards(arm: Arm, q: Array, start: Array, limits: bool = True) -> Array:
    """Each revolute joint by the turn nearest to `start`, or the nearest to it that is within the limits."""
    turn = _turns(arm)
    whole = np.where(np.isfinite(turn), turn, 0.0)
    q = q + whole * np.rint((start - q) / turn)
    if not limits:
        return q
    lower, upper = arm.limits
    q = q - whole * np.ceil(np.maximum(q - upper - _SLACK, 0) / turn)
    return q + whole * np.ceil(np.maximum(lower - q - _SLACK, 0) / turn)


_SLACK = 1e-9  # rad or m: a joint this far beyond its limit counts as at it


def _inside(arm: Arm, q: Array) -> NDArray[np.bool_]:
    lower, upper = arm.limits
    return ((q >= lower - _SLACK) & (q <= upper + _SLACK)).all(axis=-1)
