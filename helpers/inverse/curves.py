"""Describe the curve on which a joint moves a point by invariants of the next joint.

Two numbers of a point stay the same when joint 2 moves it: for a revolute joint the height along
its axis, and the squared distance from a point of the axis. In the plane of these two numbers the
circle of a neighbouring joint is an ellipse, or a segment if the two axes meet or are parallel.
"""

from typing import NamedTuple

import numpy as np

from helpers.inverse.axes import (
    Array,
    JointAxis,
    cross,
    dot,
    perpendicular_part,
    unit_perpendicular,
)


class Curve(NamedTuple):
    """Points centre + X x + Y y to which a joint moves a point.

    (x, y) is (cos q, sin q) for a revolute joint and (q, q^2) for a prismatic joint.
    """

    centre: Array
    X: Array
    Y: Array
    turns: bool


def joint_curve(axis: JointAxis, x: Array) -> Curve:
    """Return the circle or line on which a joint moves the points x."""
    if not axis.turns:
        return Curve(x, axis.direction + 0 * x, 0 * x, False)
    radius = perpendicular_part(axis.direction, x - axis.point)
    return Curve(x - radius, radius, cross(axis.direction, radius), True)


def compute_invariants(second: JointAxis, curve: Curve, size: float) -> tuple[Array, Array]:
    """Return the two invariants of joint 2 along a curve as A (x, y) + b, in m.

    For a revolute joint 2 they are the height along its axis and the squared distance from a point
    of it, over twice the size; for a prismatic one, two coordinates across it.

    Returns:
        A of shape (2, 2, branches, batch), b of shape (2, branches, batch).
    """
    centre, X, Y, turns = curve
    if second.turns:
        h, r = second.direction, centre - second.point
        rows = [[dot(h, v) for v in (X, Y, r)]]
        linear = dot(r, Y) if turns else dot(X, X) / 2
        square = dot(r, r) + (dot(X, X) if turns else 0.0)
        rows += [[dot(r, X) / size, linear / size, square / (2 * size)]]
    else:
        e = unit_perpendicular(second.direction)
        rows = [[dot(f, v) for v in (X, Y, centre)] for f in (e, cross(second.direction, e))]
    A = np.stack([np.stack(np.broadcast_arrays(*row[:2])) for row in rows])
    return A, np.stack([np.broadcast_to(row[2], A.shape[2:]) for row in rows])


class Flatness(NamedTuple):
    """The principal directions of a curve in the plane of the two invariants, as columns (2, 2),
    and its width over its length: 0 where the ellipse is a segment."""

    directions: Array
    width: float


def find_flatness(axis: JointAxis, second: JointAxis, size: float) -> Flatness:
    """Return how flat the curve of a joint is, in the invariants of a second joint."""
    x = axis.point + size * np.array([0.3, -0.7, 0.5])[:, None, None]
    A, _ = compute_invariants(second, joint_curve(axis, x), size)
    U, sizes, _ = np.linalg.svd(A[:, :, 0, 0])
    # The names of roots depend on these signs, so the signs must not depend on the linear algebra
    # library.
    U = U * np.where(np.where(np.abs(U[0]) > 1e-6, U[0], U[1]) < 0, -1.0, 1.0)
    return Flatness(U, float(sizes[1] / sizes[0]) if sizes[0] > 0 else 0.0)
