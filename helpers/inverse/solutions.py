"""Store all solution branches of a batch of targets, and choose branches by name or distance."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import product
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import (
    ArmError,
    broadcast_shape,
    finite_array,
    float_array,
    require_callable,
    require_type,
    warn_caller,
)
from helpers.poses import rigid_poses

Array = NDArray[np.float64]

# Targets solved at a time: enough that NumPy does most of the work, few enough for the cache.
_CHUNK = 4096


# rad: a planar arm cannot reach a target tilted by more. Typed poses have six decimals.
TILTED = 1e-6


@dataclass(frozen=True, repr=False)
class Solutions:
    """Every configuration that takes the tip to a target, for one target or a batch.

    For one target it is a sequence of the configurations that exist, in the order of `names`. For a
    batch it is a sequence of the `Solutions` of each target along the first axis.

    Attributes:
        arm: the arm.
        branches: a name for each branch, in the order of the arrays.
        q: shape (..., branches, dof), angles in (-pi, pi]; NaN where a branch does not exist.
        valid: whether the branch exists, shape (..., branches). Joint limits do not enter; see
            `within_limits`. Branches that are one at this target, or of one family, exist once,
            under the first of their names.
        merged: whether a choice, such as that of an elbow, makes no difference to the branch,
            shape (..., branches, choices), in the order in which the names have them.
        free: whether a joint's value was chosen, because any would do if the others follow, shape
            (..., branches, dof).
        distance: how far the target (for a wrist: its centre) is from the nearest point within
            reach, shape (...), in m; 0 where it is reached. For `ur` the way that is sure to be
            enough: across the arm's plane, and in it until the links reach, orientation kept.
            NaN where a target is out of reach of an arm with three parallel axes that is solved
            by its structure alone, and where `tilt` is not 0.
        structure: the structure that gave the closed form, as "spherical wrist (axes 4, 5 and 6
            meet)"; empty where a closed form was called by its name.
        tilt: for a planar or SCARA arm the angle between its last axis and where a target wants it,
            shape (...), in rad: such an arm only turns its tool about its parallel axes. None for
            other arms.
    """

    arm: Arm
    branches: tuple[str, ...]
    q: Array
    valid: NDArray[np.bool_]
    merged: NDArray[np.bool_]
    free: NDArray[np.bool_]
    distance: Array
    structure: str = ""
    tilt: Array | None = None

    @property
    def times(self) -> NDArray[np.int_]:
        """Multiplicity of each branch, shape (..., branches).

        It is 1, or 2, 4 or 8 for a multiple solution, and 0 where the branch does not exist.
        """
        return np.where(self.valid, 2 ** self.merged.sum(axis=-1), 0)

    def __len__(self) -> int:
        return int(self.valid.sum()) if self.q.ndim == 2 else len(self.q)

    def __getitem__(self, index: int) -> Any:
        if self.q.ndim == 2:
            return self.q[self.valid][index]
        arrays = {name: getattr(self, name)[index] for name in _BATCHED}
        tilt = None if self.tilt is None else self.tilt[index]
        return replace(self, **arrays, tilt=tilt)

    def __iter__(self) -> Iterator[Any]:
        return (self[k] for k in range(len(self)))

    @property
    def names(self) -> list[str]:
        """The names of the branches that exist for one target, in the order of the sequence."""
        return list(self.by_name)

    @property
    def by_name(self) -> dict[str, Array]:
        """Branches that exist for one target, by their names.

        A name leaves out a choice that makes no difference: it is "back" if both elbows coincide.

        Raises:
            ArmError: If there are several targets.
        """
        if self.q.ndim != 2:
            raise ArmError(
                f"{self.arm.name}: the targets are {self.q.shape[:-2]}; expected one target"
            )
        found = {}
        for name, q, valid, merged in zip(
            self.branches, self.q, self.valid, self.merged, strict=True
        ):
            kept = [choice for choice, one in zip(name.split(", "), merged, strict=True) if not one]
            if valid:
                found[", ".join(kept) or "the only one"] = q
        return found

    def __repr__(self) -> str:
        if self.q.ndim != 2:
            reached = self.valid.any(axis=-1)
            return f"{self.arm.name}: {reached.sum()} of {reached.size} targets within reach"
        if not self.by_name:
            reason = f"the target is {self.distance:.4g} m out of reach"
            if np.isnan(self.distance):
                reason = "the target is out of reach"
            if self.tilt is not None and self.tilt > TILTED:
                reason = (
                    f"the target tilts the tool by {np.degrees(self.tilt):.4g}°, and the arm cannot"
                    " tilt it: it turns its tool about its parallel axes alone"
                )
            return f"{self.arm.name}: no solution, {reason}"
        lines = [f"  {', '.join(cells)}" for cells in self._list_cells()]
        return "\n".join(
            [f"{self.arm.name}, {', '.join(('solution', *self.arm.variables))}:", *lines]
        )

    def _repr_markdown_(self) -> str:
        if self.q.ndim != 2 or not self.by_name:
            return repr(self)
        heads = ("solution", *(f"${name}$" for name in self.arm.variables))
        rows = [heads, (":--", *["--:"] * self.arm.dof), *self._list_cells()]
        return "\n".join(f"| {' | '.join(row)} |" for row in rows)

    def _list_cells(self) -> list[tuple[str, ...]]:
        """Return a table row for each branch: name, and joint values or "any" for a free joint."""
        shown = [[f"{x:.4f}" for x in q.round(4) + 0.0] for q in self.by_name.values()]
        loose = self.free[self.valid]
        rows = zip(self.by_name, loose, shown, strict=True)
        return [(way, *np.where(any_, "any", row)) for way, any_, row in rows]

    @property
    def within_limits(self) -> NDArray[np.bool_]:
        """True where a branch exists and is within the joint limits, shape (..., branches).

        Revolute joints may differ by whole turns.
        """
        return _is_within_limits(self.arm, _turn_towards(self.arm, self.q, np.zeros(self.arm.dof)))

    def nearest(self, q: ArrayLike) -> Array:
        """Return the branch whose largest joint change from q is the smallest.

        Args:
            q: Joint values, shape (..., dof), rad or m. Each revolute joint is counted in the turn
                nearest to its value here.

        Returns:
            Joint values within the limits, shape (..., dof); NaN where no branch is within them.

        Raises:
            ArmError: q has another shape.
        """
        start = self.arm.joint_vector(q)
        broadcast_shape("q and the targets", start.shape[:-1], self.distance.shape)
        start = start[..., None, :]
        found = _turn_towards(self.arm, self.q, start)
        change = np.abs(found - start).max(axis=-1)
        allowed = _is_within_limits(self.arm, found)
        best = np.where(allowed, change, np.inf).argmin(axis=-1)[..., None]
        chosen = np.take_along_axis(found, best[..., None], axis=-2)[..., 0, :]
        return np.where(np.take_along_axis(allowed, best, axis=-1), chosen, np.nan)


_BATCHED = ("q", "valid", "merged", "free", "distance")


def follow(solver: Callable[..., Solutions], targets: ArrayLike, start: ArrayLike) -> Array:
    """Solve a path of targets, each by the branch nearest to the solution before.

    Args:
        solver: A closed form with its arm, as `partial(ur, UR10E)`; called as
            `solver(target, start=q)`.
        targets: Positions (n, 3) in m or poses (n, 4, 4).
        start: Joint values before the path, shape (dof,), rad or m. A free joint keeps its value.

    Returns:
        Joint values, shape (n, dof).

    Raises:
        ArmError: No branch reaches a target within the joint limits.
    """
    require_callable(solver, "solver", "a closed form with its arm put in, as partial(ur, UR10E)")
    path, q = [], float_array(start, "start", "joint values (dof,)")
    expected = "positions (n, 3) or poses (n, 4, 4)"
    wanted = float_array(targets, "targets", expected)
    if wanted.ndim not in (2, 3):
        raise ArmError(f"targets have shape {wanted.shape}; expected (n, 3) or (n, 4, 4)")
    shape: tuple[int | None, ...] = (None, 4, 4) if wanted.ndim == 3 else (None, 3)
    wanted = finite_array(wanted, "targets", expected, shape)
    for step, target in enumerate(wanted):
        found = solver(target.copy(), start=q.copy())
        require_type(found, Solutions, "what solver gives")
        q = found.nearest(q)
        if np.isnan(q).any():
            raise ArmError(
                f"{found.arm.name}: no branch reaches target {step} of {len(wanted)} within the"
                " joint limits"
            )
        path.append(q)
    return np.array(path)


class BranchArrays(NamedTuple):
    """Branches of a batch, in arrays that broadcast to (*branches, batch).

    Attributes:
        q: Values of each joint, rad or m.
        free: For the index of a joint, where its value was chosen freely.
        valid: Where the branch exists.
        merged: For each choice, where it makes no difference.
        distance: Distance of the target from the workspace, shape (batch,), m.
    """

    q: tuple[Array, ...]
    free: Mapping[int, NDArray[Any]]
    valid: NDArray[np.bool_]
    merged: tuple[NDArray[np.bool_], ...]
    distance: Array


def each_branch(
    arm: Arm,
    targets: Array,
    start: ArrayLike | None,
    branches: tuple[tuple[str, ...], ...],
    kernel: Callable[[Arm, Array, Array], BranchArrays],
) -> Solutions:
    """Run `kernel` on targets of shape (..., k), in chunks of columns (k, batch), and put its
    branches together.

    `branches` names the choices that a branch is made of, first to last; the kernel's arrays have
    one axis for each. `free` holds an array for each joint, by its index, that was ever chosen.
    """
    start = np.zeros(arm.dof) if start is None else arm.joint_vector(start, "start")
    shape = broadcast_shape("targets and start", targets.shape[:-1], start.shape[:-1])
    choices = tuple(map(len, branches))
    count, many, dof = math.prod(shape), math.prod(choices), arm.dof
    targets, start = _arrange_columns(targets, shape), _arrange_columns(start, shape)
    q, free = np.empty((*choices, dof, count)), np.zeros((*choices, dof, count), bool)
    valid, distance = np.empty((*choices, count), bool), np.empty(count)
    merged = np.empty((*choices, len(choices), count), bool)
    for first in range(0, count, _CHUNK):
        part = np.s_[..., first : first + _CHUNK]
        found = kernel(arm, np.ascontiguousarray(targets[part]), start[part])
        merged[part] = np.stack([np.broadcast_to(x, valid[part].shape) for x in found.merged], -2)
        valid[part] = found.valid
        for choice, is_one in enumerate(found.merged):
            if is_one.any():  # list the first of coinciding branches
                second = (slice(None),) * choice + (1,)
                valid[part][second] &= ~merged[part][..., choice, :][second]
        distance[part] = found.distance
        missing = np.where(valid[part], 0.0, np.nan)
        for joint, values in enumerate(found.q):
            np.add(values, missing, out=q[..., joint, :][part])
        for joint, values in found.free.items():
            free[..., joint, :][part] = values & valid[part]
    return Solutions(
        arm,
        tuple(map(", ".join, product(*branches))),
        _by_target(q, shape, many, dof),
        _by_target(valid, shape, many),
        _by_target(merged, shape, many, len(choices)),
        _by_target(free, shape, many, dof),
        _by_target(distance, shape),
    )


def _arrange_columns(values: Array, shape: tuple[int, ...]) -> Array:
    """Arrange vectors (..., k) as columns (k, batch), repeated to the shape of the batch."""
    if values.ndim == 1:
        return np.broadcast_to(values[:, None], (len(values), math.prod(shape)))
    return np.broadcast_to(values, (*shape, values.shape[-1])).reshape(-1, values.shape[-1]).T


def _by_target(columns: NDArray, shape: tuple[int, ...], *axes: int) -> NDArray:
    """Return a view of an array (..., batch) with the batch's shape first, then `axes`."""
    return columns.reshape(math.prod(axes), -1).T.reshape((*shape, *axes))


def check_positions(arm: Arm, targets: ArrayLike) -> Array:
    """Return targets as positions (..., 3).

    Raises ArmError for anything else.
    """
    name, expected = f"{arm.name}: a target", "(..., 3), finite positions in m"
    points = finite_array(targets, name, expected, (3,), many=True)
    _warn_of_millimetres(arm, points)
    return points


def check_poses(arm: Arm, targets: ArrayLike) -> Array:
    """Return target poses flattened to (..., 16).

    Raises ArmError for anything else.

    `helpers.poses.rigid_poses` mends a rotation that was printed with few decimals.
    """
    expected = "(..., 4, 4), poses of finite numbers"
    poses = rigid_poses(targets, f"{arm.name}: a target", expected, many=True)
    _warn_of_millimetres(arm, poses[..., :3, 3])
    return poses.reshape(*poses.shape[:-2], 16)


def _warn_of_millimetres(arm: Arm, points: Array) -> None:
    """Warn if a target is farther from the base than ten times the arm's reach."""
    ends = np.abs(arm.limits).max(axis=0)[~arm.turning]
    slides = np.where(np.isfinite(ends), ends, 1.0).sum()  # a slide without limits counts as 1 m
    reach = sum(math.hypot(row.a, row.d) for row in arm.numeric) + float(slides)
    far = float(np.linalg.norm(points, axis=-1).max(initial=0.0))
    if far > 10 * reach:
        warn_caller(
            f"{arm.name}: a target is {far:.4g} m from the base, more than ten times as far as the"
            " arm reaches; write metres"
        )


def subtract_offset(angle: Array, offset: float) -> Array:
    """Subtract a row's offset from an angle and wrap the result to (-pi, pi]."""
    return wrap_angle(angle - offset) if offset else angle


def wrap_angle(angle: Array) -> Array:
    """Wrap an angle to (-pi, pi], up to rounding."""
    turns = angle * (0.5 / np.pi)
    np.rint(turns, out=turns)
    turns *= -2 * np.pi
    turns += angle
    return turns


def _turn_towards(arm: Arm, q: Array, start: Array) -> Array:
    """Add whole turns to revolute joints: nearest to `start`, then into the limits if possible."""
    turn = np.where(arm.turning, 2 * np.pi, np.inf)
    whole = np.where(arm.turning, 2 * np.pi, 0.0)
    q = q + whole * np.rint((start - q) / turn)
    lower, upper = arm.limits
    q = q - whole * np.ceil(np.maximum(q - upper - _SLACK, 0) / turn)
    return q + whole * np.ceil(np.maximum(lower - q - _SLACK, 0) / turn)


_SLACK = 1e-9  # rad or m: a joint this little beyond its limit is within it


def _is_within_limits(arm: Arm, q: Array) -> NDArray[np.bool_]:
    lower, upper = arm.limits
    return np.asarray(((q >= lower - _SLACK) & (q <= upper + _SLACK)).all(axis=-1))
