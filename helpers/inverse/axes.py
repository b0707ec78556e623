"""Represent joint axes as lines in space, and move points and directions by their joints.

Arrays of vectors have shape (3, branches, batch): component by component, one column for each
target. A constant vector has shape (3, 1, 1).
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class JointAxis(NamedTuple):
    """The axis of one joint at a reference configuration.

    Attributes:
        direction: unit vector along the axis, (3, 1, 1) or (3, 1, batch).
        point: a point on the axis, in m, of the same shape.
        turns: whether the joint is revolute; a prismatic one slides along `direction`.
    """

    direction: Array
    point: Array
    turns: bool


def dot(u: Array, v: Array) -> Array:
    """Return the inner products of columns."""
    return np.einsum("i...,i...->...", u, v)


def cross(u: Array, v: Array) -> Array:
    """Return the cross products of columns."""
    w = np.empty(np.broadcast_shapes(u.shape, v.shape))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        np.subtract(u[j] * v[k], u[k] * v[j], out=w[i, ...])
    return w


def norm(u: Array) -> Array:
    """Return the lengths of columns."""
    return np.sqrt(dot(u, u))


def perpendicular_part(direction: Array, x: Array) -> Array:
    """Return the component of x perpendicular to a unit direction."""
    return x - dot(direction, x) * direction


def unit_perpendicular(direction: Array) -> Array:
    """Return a unit vector perpendicular to a constant direction (3, 1, 1)."""
    least = np.eye(3)[np.abs(direction[:, 0, 0]).argmin()][:, None, None]
    e = cross(direction, least)
    return e / norm(e)


def rotate(direction: Array, q: Array, x: Array) -> Array:
    """Turn vectors x by q about a direction (Rodrigues' formula)."""
    c, s = np.cos(q), np.sin(q)
    return c * x + s * cross(direction, x) + (1 - c) * dot(direction, x) * direction


def move_point(axis: JointAxis, q: Array, x: Array) -> Array:
    """Return points x after the joint has moved by q."""
    if axis.turns:
        return axis.point + rotate(axis.direction, q, x - axis.point)
    return x + q * axis.direction


def move_direction(axis: JointAxis, q: Array, x: Array) -> Array:
    """Return directions x after the joint has moved by q."""
    return rotate(axis.direction, q, x) if axis.turns else x + 0 * q


def transform_point(T: Array, x: Array) -> Array:
    """Apply transforms T (4, 4, batch) to points x (3, branches, 1 or batch)."""
    return transform_direction(T, x) + T[:3, 3][:, None]


def transform_direction(T: Array, x: Array) -> Array:
    """Apply the rotations of T (4, 4, batch) to directions x (3, branches, 1 or batch)."""
    return np.einsum("ijn,jbn->ibn", T[:3, :3], np.broadcast_to(x, (*x.shape[:2], T.shape[2])))


def invert_transform(T: Array) -> Array:
    """Return the inverses of rigid transforms (4, 4, batch)."""
    R = T[:3, :3].transpose(1, 0, 2)
    inverse = np.zeros_like(T)
    inverse[:3, :3], inverse[3, 3] = R, 1.0
    inverse[:3, 3] = -np.einsum("ijn,jn->in", R, T[:3, 3])
    return inverse
