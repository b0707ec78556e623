"""Compute how far a target is out of reach of three joints that move a point."""

import numpy as np

from helpers.inverse.axes import (
    Array,
    JointAxis,
    cross,
    dot,
    invert_transform,
    move_point,
    norm,
    perpendicular_part,
    rotate,
    transform_point,
)
from helpers.inverse.structure import (
    FIRST_THREE_MEET,
    PARALLEL,
    PLANAR_2R,
    POSITION,
    SCARA,
    WRIST,
    Structure,
)

# Start values of each joint (rad, or fractions of the arm's size) and steps of each search.
# tests/test_any_arm.py compares the result with a search from ten times as many starts.
_STARTS = np.array([-1.6, 1.6])
_STEPS = 25


def distance_to_reach(axes: tuple[JointAxis, ...], w: Array, p: Array, size: float) -> Array:
    """Return the least distance between E_1 E_2 E_3 w and p, over all motions of three joints.

    Args:
        axes: The three joint axes.
        w: The point that they move, (3, 1, 1) or (3, 1, batch), in m.
        p: Where it should be, (3, 1, batch), in m.
        size: Length of the arm, in m.

    Returns:
        Distances (batch,), in m, found by damped Newton steps from eight starts.
    """
    scales = [1.0 if axis.turns else size / 2 for axis in axes]
    grid = np.stack(np.meshgrid(*(_STARTS * scale for scale in scales), indexing="ij"))
    q = np.repeat(grid.reshape(3, -1, 1), p.shape[-1], axis=-1)
    damping = np.full(q.shape[1:], 1e-2)
    gap, step = _gap_and_step(axes, q, w, p, damping)
    for _ in range(_STEPS):
        trial = q + step
        trial_gap, _ = _gap_and_step(axes, trial, w, p, damping)
        better = norm(trial_gap) < norm(gap)
        damping = np.where(better, damping / 5, damping * 10)
        q, gap = np.where(better, trial, q), np.where(better, trial_gap, gap)
        _, step = _gap_and_step(axes, q, w, p, damping)
    return norm(gap).min(axis=0)


def distance_of_targets(structure: Structure, targets: Array) -> Array:
    """Return how far targets are out of reach of an arm, (batch,), in m.

    It is the distance of the point that the structure's three joints place: the tip of a
    three-joint or two-link arm, the centre of a wrist (counted from the tip where the first three
    axes meet), the axis of the last turning joint of a planar or SCARA arm. NaN for three parallel
    axes among six, whose loop has no such point.

    Args:
        structure: The arm's structure.
        targets: Poses (4, 4, batch), or positions (3, batch) for POSITION and PLANAR_2R.
    """
    axes, size, tip = structure.axes, structure.size, structure.tip[:3, 3][:, None, None]
    if structure.kind == PARALLEL:
        return np.full(targets.shape[-1], np.nan)
    if structure.kind == POSITION:
        return distance_to_reach(axes, tip, targets[:, None], size)
    if structure.kind == PLANAR_2R:
        return _distance_to_ring(axes[0], axes[1], tip, targets[:, None])
    G = np.einsum("ijn,jk->ikn", targets, np.linalg.inv(structure.tip))
    if structure.kind == WRIST:
        assert structure.centre is not None
        point = structure.centre
        return distance_to_reach(axes[:3], point, transform_point(G, point), size)
    if structure.kind == FIRST_THREE_MEET:
        assert structure.centre is not None
        point = structure.centre
        wanted = transform_point(invert_transform(G), point)
        return distance_to_reach(axes[:2:-1], point, wanted, size)
    first, second, third = (axis for axis in axes if axis.turns)
    wanted = transform_point(G, third.point)
    return _distance_to_ring(first, second, third.point, wanted, structure.kind == SCARA)


def _distance_to_ring(
    first: JointAxis, second: JointAxis, w: Array, p: Array, is_lifted: bool = False
) -> Array:
    """Return the distance of p from the ring of points to which two parallel joints can move w.

    `is_lifted` says whether a sliding joint brings w to any height. NaN where p is in reach: then
    the target asks for an orientation that the arm does not have.
    """
    z = first.direction
    near, far = (
        norm(perpendicular_part(z, v)) for v in (second.point - first.point, w - second.point)
    )
    away = norm(perpendicular_part(z, p - first.point))
    gap = np.maximum(0, np.maximum(away - (near + far), np.abs(near - far) - away))
    height = 0.0 if is_lifted else dot(z, p - w)
    distance = np.hypot(gap, height)[0]
    return np.where(distance > 1e-12, distance, np.nan)


def _gap_and_step(
    axes: tuple[JointAxis, ...], q: Array, w: Array, p: Array, damping: Array
) -> tuple[Array, Array]:
    """Return the gap p - E_1 E_2 E_3 w and the damped Newton step that reduces it.

    The second derivatives of the point count, since the gap stays large at the nearest one:
    d2x / dq_i dq_j = z_i x (dx / dq_j) for i <= j, where joint i turns about z_i.
    """
    point = w + 0 * p
    velocities: list[Array] = []
    directions: list[Array] = []
    for axis, motion in zip(axes[::-1], q[::-1], strict=True):
        point = move_point(axis, motion, point)
        if axis.turns:
            velocities = [rotate(axis.direction, motion, v) for v in velocities]
            directions = [rotate(axis.direction, motion, z) for z in directions]
        z = axis.direction + 0 * point
        velocities.insert(0, cross(z, point - axis.point) if axis.turns else z)
        directions.insert(0, z)
    gap = p - point
    hessian = np.empty((*gap.shape[1:], 3, 3))
    gradient = np.stack([dot(v, gap) for v in velocities], axis=-1)
    for i, j in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)):
        curvature = dot(gap, cross(directions[i], velocities[j])) if axes[i].turns else 0.0
        hessian[..., i, j] = hessian[..., j, i] = dot(velocities[i], velocities[j]) - curvature
    # Use absolute values of the Hessian's eigenvalues, so that the step reduces the distance.
    values, vectors = np.linalg.eigh(hessian)
    along = (vectors.swapaxes(-1, -2) @ gradient[..., None])[..., 0]
    step = (vectors @ (along / (np.abs(values) + damping[..., None]))[..., None])[..., 0]
    return gap, np.moveaxis(np.clip(step, -0.7, 0.7), -1, 0)
