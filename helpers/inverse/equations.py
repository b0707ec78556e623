"""Solve the three equations to which every structured arm is reduced.

1. a cos q + b sin q = c: two roots.
2. The turn about an axis that takes one point to another: one root.
3. A spherical triangle: two turns, which are mirror images.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from helpers.inverse.axes import Array, cross, dot, norm, perpendicular_part

# A target this close to the boundary of a joint's range of points (relative to the arm's size, or
# in rad) counts as on it: a thousand times the round-off of a pose.
BOUNDARY = 1e-12
# A point this close to an axis (relative to the arm's size) counts as on it, since turns about the
# axis move it by less than the round-off of a pose of the arm.
ON_AXIS = 1e-11

Mask = NDArray[np.bool_]


class Roots(NamedTuple):
    """The roots of one equation for every branch and target.

    Attributes:
        values: joint values, (2 * branches, batch); both roots of a branch are neighbours.
        equal: whether both roots are one, (branches, batch).
        free: whether every joint value is a root, (branches, batch).
    """

    values: Array
    equal: Mask
    free: Mask


def double(x: NDArray) -> NDArray:
    """Repeat each branch, (..., branches, batch), once for each of its two roots."""
    return np.repeat(x, 2, axis=-2)


def interleave(first: Array, second: Array) -> Array:
    """Put two roots for each branch in the order of `double`."""
    first, second = np.broadcast_arrays(first, second)
    shape = (*first.shape[:-2], 2 * first.shape[-2], first.shape[-1])
    return np.stack([first, second], axis=-2).reshape(shape)


def solve_cosine_sine(a: Array, b: Array, c: Array, scale: float, chosen: Array) -> Roots:
    """Solve a cos q + b sin q = c.

    Where c is out of reach both roots are the nearest angle, so the caller must check the pose.

    Args:
        a, b, c: coefficients, (branches, batch) or broadcastable to it, in m.
        scale: the size of the arm, in m.
        chosen: the value for a free joint, (batch,).
    """
    a, b, c = np.broadcast_arrays(a, b, c)
    amplitude = np.hypot(a, b)
    gap = amplitude - np.abs(c)
    gap = np.where(np.abs(gap) < BOUNDARY * scale, 0.0, gap)
    free = amplitude < ON_AXIS * scale
    # Half angles are accurate even if both roots coincide, while arccos would lose half the digits.
    half = np.arctan2(np.sqrt(np.maximum(gap, 0.0)), np.sqrt(amplitude + np.abs(c)))
    half = np.where(free, 0.0, 2 * np.where(c < 0, np.pi / 2 - half, half))
    middle = np.where(free, chosen, np.arctan2(b, a))
    return Roots(interleave(middle + half, middle - half), free | (gap <= 0.0), free)


def solve_quadratic(a: Array, b: Array, c: Array, scale: float) -> Roots:
    """Solve a q + b q^2 = c for a prismatic joint.

    The arguments are those of `solve_cosine_sine`.

    A joint that moves nothing along the equation has the root NaN.
    """
    a, b, c = np.broadcast_arrays(a, b, c)
    free = np.zeros(a.shape, bool)
    if np.abs(b).max() < BOUNDARY / scale:
        linear = np.where(np.abs(a) < ON_AXIS, np.nan, a)
        return Roots(double(c / linear), ~free, free)
    square = a * a + 4 * b * c
    square = np.where(np.abs(square) < 4 * np.abs(b) * BOUNDARY * scale, 0.0, square)
    root = np.sqrt(np.maximum(square, 0.0))
    return Roots(interleave((-a + root) / (2 * b), (-a - root) / (2 * b)), square <= 0.0, free)


def angle_between(
    direction: Array, x: Array, y: Array, scale: float, chosen: Array
) -> tuple[Array, Mask]:
    """Return the turn about a direction from x to y, and where the turn is arbitrary.

    Args:
        direction: unit vector, (3, 1, 1 or batch).
        x, y: vectors, (3, branches, batch).
        scale: the length that x and y are compared with.
        chosen: the angle where x or y lies along the direction, (batch,).
    """
    # Project first, because the product of long vectors would lose digits.
    x, y = perpendicular_part(direction, x), perpendicular_part(direction, y)
    free = np.minimum(dot(x, x), dot(y, y)) < (ON_AXIS * scale) ** 2
    return np.where(free, chosen, np.arctan2(dot(direction, cross(x, y)), dot(x, y))), free


def turns_to_angle(direction: Array, x: Array, y: Array, target: Array) -> Roots:
    """Return the two turns about a direction that bring x to a given angle with y.

    The direction, x and y are corners of a spherical triangle whose sides are known: the angles
    of x and y to the direction, and the angle of x to y, which must become that of `target` to y.
    The mirror image of the triangle is the second root.

    Args:
        direction, x, y, target: unit vectors, (3, branches, batch).
    """
    side_y, side_x, opposite = np.broadcast_arrays(
        _compute_angle(direction, y), _compute_angle(direction, x), _compute_angle(y, target)
    )
    half_sum = (side_y + side_x + opposite) / 2
    above = _compute_sine(half_sum - side_y) * _compute_sine(half_sum - side_x)
    below = _compute_sine(half_sum) * _compute_sine(half_sum - opposite)
    corner = 2 * np.arctan2(np.sqrt(np.maximum(above, 0.0)), np.sqrt(np.maximum(below, 0.0)))
    start, _ = angle_between(direction, x, y, 1.0, np.zeros(()))
    equal = (above <= 0.0) | (below <= 0.0)
    return Roots(interleave(start + corner, start - corner), equal, np.zeros(equal.shape, bool))


def _compute_angle(u: Array, v: Array) -> Array:
    """Return the angle between vectors, which is accurate near 0 and pi too."""
    return np.arctan2(norm(cross(u, v)), dot(u, v))


def _compute_sine(angle: Array) -> Array:
    """Return the sine of an angle, exactly 0 at the boundary."""
    off_boundary = np.abs(angle) > BOUNDARY
    return np.where(off_boundary & (np.abs(np.pi - angle) > BOUNDARY), np.sin(angle), 0.0)
