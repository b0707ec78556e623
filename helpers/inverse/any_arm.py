"""Find all solutions of any arm whose structure has a closed form."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import require_type
from helpers.inverse.by_structure import find_candidates
from helpers.inverse.reach import distance_of_targets
from helpers.inverse.shoulder import elbow, has_rod, is_elbow_arm, rod
from helpers.inverse.solutions import (
    TILTED,
    BranchArrays,
    Solutions,
    check_poses,
    check_positions,
    each_branch,
)
from helpers.inverse.structure import (
    EXACT,
    PARALLEL,
    PLANAR_2R,
    PLANAR_3R,
    POSITION,
    SCARA,
    Structure,
    find_structure,
)
from helpers.inverse.ur import is_ur_arm, ur
from helpers.inverse.wrist import (
    is_elbow_arm_with_wrist,
    is_stanford_arm,
    spherical_wrist,
    stanford,
)
from helpers.kinematics import forward_kinematics, jacobian

Array = NDArray[np.float64]

# Largest error, in m and rad, with which a branch may miss its target.
VALID = 1e-9
# Newton's method improves branches whose error is below these bounds, in m and rad. The first
# bound is for arms with the exact structure, whose branches are inaccurate only close to a
# boundary. The second is for arms that have the structure only nearly.
FINISHED_FROM, NEARLY_FINISHED_FROM = 1e-6, 1e-2
# Values for a free joint, in rad, that are tried if its start value gives no solution.
TRIED = 0.55 * np.arange(1, 12)


def solutions(arm: Arm, targets: ArrayLike, start: ArrayLike | None = None) -> Solutions:
    """Return every joint vector that takes the tip to each target.

    Serves six joints with three axes that meet in a point (a spherical wrist, as KUKA, ABB, Fanuc
    or PUMA have) or with three parallel axes (as Universal Robots), SCARA and planar arms, and
    positions of arms of three joints. `Solutions.structure` says which it is; branches are named by
    the choices shoulder, elbow, rod and wrist, each with + and - for the two roots of its equation;
    arms with the table of a chapter have the chapter's names, such as front and elbow up. Where the
    axes meet a structure nearly (within 1e-4, as in calibrated arms), each branch is finished by
    Newton's method, and next to the boundary of the workspace a branch may be missing.

    Args:
        arm: the arm; its tool, base and fixed rows may be any.
        targets: poses (..., 4, 4) in m; positions (..., 3) for an arm of two or three joints that
            is not a planar three-link arm. Of a pose printed with 3 decimals
            or more the nearest rotation is taken, with a warning.
        start: values that free joints keep, (..., dof), zeros unless given.

    Returns:
        The solutions; `distance` is NaN at targets out of reach of an arm with three parallel axes
        among six, but for Universal Robots' arms.

    Raises:
        ArmError: the arm has no such structure, or the targets have another shape.

    Source: Pieper (1968); the axes as lines: Elias and Wen (2025).
    """
    require_type(arm, Arm, "arm")
    solver, structure = next((solver, name) for fits, solver, name in _SOLVERS if fits(arm))
    found = solver(arm, targets, start)
    return found if found.structure else replace(found, structure=structure)


def _solve_by_axes(arm: Arm, targets: ArrayLike, start: ArrayLike | None) -> Solutions:
    """Return all solutions by the axes that meet or are parallel."""
    structure = find_structure(arm)
    is_position = structure.kind in (POSITION, PLANAR_2R)
    columns = check_positions(arm, targets) if is_position else check_poses(arm, targets)
    # The names of the choices are the same for every target; this one is the tip at rest.
    target = structure.tip[:3, 3] if is_position else structure.tip
    at_rest = np.zeros((len(structure.axes), 1))
    names = find_candidates(structure, target[..., None], at_rest).choices
    choices = tuple((f"{name} +", f"{name} -") for name in names)

    def kernel(arm: Arm, columns: Array, start: Array) -> BranchArrays:
        if is_position:
            return _solve_by_structure(arm, structure, columns, start)
        return _solve_by_structure(arm, structure, columns.reshape(4, 4, -1), start)

    found = each_branch(arm, columns, start, choices, kernel)
    if structure.kind in (PLANAR_3R, SCARA):
        axis = structure.axes[-1].direction[:, 0, 0]
        rotations = columns.reshape(*columns.shape[:-1], 4, 4)[..., :3, :3]
        turned = rotations @ structure.tip[:3, :3].T @ axis
        tilt = np.arctan2(np.linalg.norm(np.cross(turned, axis), axis=-1), turned @ axis)
        tilt = np.broadcast_to(tilt, found.distance.shape)
        distance = np.where(tilt > TILTED, np.nan, found.distance)
        found = replace(found, tilt=tilt, distance=distance)
    return replace(found, structure=structure.description)


# Solvers in the order of trial. The closed forms of the chapters come first, since they are faster
# and also return distances and free joints; all other arms are solved by their axes.
_SOLVERS = (
    (is_elbow_arm, elbow, "elbow arm"),
    (has_rod, rod, "rod through the shoulder"),
    (is_ur_arm, ur, "parallel axes 2, 3 and 4"),
    (is_stanford_arm, stanford, "rod through the shoulder, spherical wrist"),
    (is_elbow_arm_with_wrist, spherical_wrist, "elbow arm with a spherical wrist"),
    (lambda arm: True, _solve_by_axes, ""),
)


def _solve_by_structure(
    arm: Arm, structure: Structure, targets: Array, start: Array
) -> BranchArrays:
    """Return all branches for poses (4, 4, batch) or positions (3, batch)."""
    found = _solve_once(arm, structure, targets, start)
    if structure.kind != PARALLEL:
        missed = np.flatnonzero(np.isnan(found.distance))
        if missed.size:
            found.distance[missed] = distance_of_targets(structure, targets[..., missed])
        return found
    for value in TRIED:
        valid = np.broadcast_to(found.valid, (*found.valid.shape[:-1], targets.shape[-1]))
        branches = tuple(range(valid.ndim - 1))
        has_free = np.zeros(found.distance.shape, bool)
        for where in found.free.values():
            has_free |= where.any(axis=branches)
        missed = np.flatnonzero(~valid.any(axis=branches) & has_free)
        if not missed.size:
            break
        again = _solve_once(arm, structure, targets[..., missed], start[:, missed] + value)
        for old, new in zip(found.q, again.q, strict=True):
            old[..., missed] = new
        found.valid[..., missed], found.distance[..., missed] = again.valid, again.distance
        for was_equal, is_equal in zip(found.merged, again.merged, strict=True):
            was_equal[..., missed] = is_equal
        for joint, is_free in again.free.items():
            found.free[joint][..., missed] = is_free
    return found


def _solve_once(arm: Arm, structure: Structure, targets: Array, start: Array) -> BranchArrays:
    """Return all branches, with free joints at `start`, (dof, batch)."""
    reference = structure.reference[:, None]
    tried = find_candidates(structure, targets, start - reference)
    count, batch = len(tried.choices), targets.shape[-1]
    branches = 2**count
    q = (
        np.stack([np.broadcast_to(x, (branches, batch)) for x in tried.motions])
        + reference[:, None]
    )
    q = np.where(np.isfinite(q), q, 0.0)
    turning = arm.turning[:, None, None]
    q = np.where(turning, q - 2 * np.pi * np.rint(q / (2 * np.pi)), q)
    q, valid = _refine_branches(arm, structure, np.moveaxis(targets, -1, 0), q.transpose(2, 1, 0))
    shape = (2,) * count
    equal = [
        np.broadcast_to(one, (2**k, batch)).reshape((2,) * k + (1,) * (count - k) + (batch,))
        for k, one in enumerate(tried.equal)
    ]
    free = {
        joint: np.broadcast_to(one, (branches, batch)).reshape(*shape, batch).copy()
        for joint, one in tried.free.items()
    }
    exists = valid.T.reshape(*shape, batch)
    return BranchArrays(
        tuple(column.T.reshape(*shape, batch).copy() for column in np.moveaxis(q, -1, 0)),
        free,
        exists.copy(),
        tuple(one.copy() for one in equal),
        np.where(valid.any(axis=1), 0.0, np.nan),
    )


def _refine_branches(
    arm: Arm, structure: Structure, targets: Array, q: Array
) -> tuple[Array, NDArray[np.bool_]]:
    """Improve branches q (batch, branches, dof) by Newton's method.

    Returns them and which are valid.

    A branch that is not near its target stays: its equations had no root.
    """
    error = _pose_error(arm, targets, q)
    near = FINISHED_FROM if structure.gap < EXACT else NEARLY_FINISHED_FROM
    for _ in range(4):
        worst = np.abs(error).max(axis=-1)
        at = (worst > VALID / 1000) & (worst < near)
        if not at.any():
            break
        J = jacobian(arm, q[at])[:, : error.shape[-1]]
        step = (np.linalg.pinv(J, rcond=1e-7) @ error[at][..., None])[..., 0]
        trial = q[at] + np.where(np.abs(step).max(axis=-1, keepdims=True) < 0.1, step, 0.0)
        wanted = np.broadcast_to(targets[:, None], (*q.shape[:2], *targets.shape[1:]))[at]
        after = _pose_error(arm, wanted, trial[:, None])[:, 0]
        better = np.abs(after).max(axis=-1) < worst[at]
        where = tuple(index[better] for index in np.nonzero(at))
        q[where], error[where] = trial[better], after[better]
    return q, np.abs(error).max(axis=-1) < VALID


def _pose_error(arm: Arm, targets: Array, q: Array) -> Array:
    """Return the errors of the tip's pose, (batch, branches, 3 or 6).

    Errors of the position in m stand over the sines of the turn. 1 is added to the sines if the
    turn exceeds 90 degrees, since the sine of half a turn is 0 too.
    """
    T = forward_kinematics(arm, q)
    if targets.shape[-1] == 3 and targets.ndim == 2:
        return targets[:, None] - T[..., :3, 3]
    R, wanted = T[..., :3, :3], targets[:, None, :3, :3]
    turn = sum(np.cross(R[..., i], wanted[..., i]) for i in range(3)) / 2
    turn = turn + ((R * wanted).sum(axis=(-1, -2)) < 0)[..., None]
    return np.concatenate([targets[:, None, :3, 3] - T[..., :3, 3], turn], axis=-1)
