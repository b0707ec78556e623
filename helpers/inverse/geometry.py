"""Solve the geometry that closed forms share: the arm's plane, two links in it, the last twist."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.rows import NumericRow

Array = NDArray[np.float64]

# m: targets this close to the workspace boundary are treated as on it (1000 x round-off). On the
# boundary two branches coincide; next to it they differ by the square root of the distance, so
# that a pose rounded in its last digit would otherwise move them by 1e-8 rad.
REACH = 1e-12
# A sine this small counts as 0, which turns the tool by at most this angle in rad.
SINGULAR = 1e-11
# Largest round-off of an axis that is computed from a pose.
NOISE = 4e-15


class Plane(NamedTuple):
    """The arm's plane in its two directions, front and back.

    Attributes:
        phi: Joint 1's angle with its offset, shape (2, batch), rad.
        x: Target along x_1, shape (2, batch), m.
        y: Target along y_1, shape (2, batch), m.
        exists: Where the plane can reach the target, shape (batch,).
        is_double: Where both positions are the same, shape (batch,).
        free: Where joint 1 may have any value, shape (batch,).
    """

    phi: Array
    x: Array
    y: Array
    exists: NDArray[np.bool_]
    is_double: NDArray[np.bool_]
    free: NDArray[np.bool_]


def turn_plane_to_target(first: NumericRow, offset: float, p: Array, chosen: Array) -> Plane:
    """Turn the arm's plane to a target in both directions, so that p . z_1 = offset.

    Args:
        first: Row 1 of the table.
        offset: Distance of the plane from joint 1's axis, along z_1, m.
        p: Targets, shape (3, batch), m.
        chosen: Joint 1's angle where it is free, shape (batch,), rad.
    """
    x, y, z = p[0], p[1], p[2]
    delta = first.sin_alpha * offset
    square, edge = x * x + y * y - delta * delta, max(2 * abs(delta) * REACH, REACH**2)
    is_double = np.abs(square) <= edge
    reach = np.sqrt(np.where(square > edge, square, 0.0))
    both = np.stack([reach, -reach])
    phi = np.arctan2(y * both + x * delta, x * both - y * delta)
    free = is_double & (delta == 0.0)
    if free.any():
        phi = np.where(free, np.stack([chosen, chosen + np.pi]), phi)
    height = np.broadcast_to(first.sin_alpha * (z - first.d), both.shape)
    return Plane(phi, both, height, square >= -edge, is_double, free)


class Links(NamedTuple):
    """Signed lengths of two links in a plane, m."""

    upper: float
    fore: float

    @property
    def outer(self) -> float:
        """Reach of the stretched links, m."""
        return abs(self.upper) + abs(self.fore)

    @property
    def inner(self) -> float:
        """Reach of the folded links, m."""
        return abs(abs(self.upper) - abs(self.fore))


class Bend(NamedTuple):
    """Angles of two links in a plane, in arrays (branches, batch).

    Attributes:
        phi_2: Angle of the first link, rad.
        phi_3: Angle of the second link against the first, rad.
        exists: Where the links reach the point.
        is_double: Where both bends are the same.
        free: Where the first angle may have any value.
    """

    phi_2: Array
    phi_3: Array
    exists: NDArray[np.bool_]
    is_double: NDArray[np.bool_]
    free: NDArray[np.bool_]


def solve_two_links(
    links: Links,
    end: tuple[Array, Array],
    sign: Array,
    chosen: Array,
    blur: Array | float = 0.0,
) -> Bend:
    """Compute the angles of two links from the origin to a point by the law of cosines.

    Args:
        links: Lengths of the links.
        end: Coordinates (x, y) of the point, m.
        sign: Sign of sin(phi_3) for each branch.
        chosen: First angle where it is free, rad.
        blur: How far rounding may move the point, m. Bends this close to the boundary count as
            double too.
    """
    upper, fore, (px, py) = *links, end
    square = px * px + py * py
    far = np.sqrt(square)
    cosine = (square - (upper**2 + fore**2)) * (0.5 / (upper * fore))
    cosine = np.minimum(np.maximum(cosine, -1.0), 1.0)
    off = np.minimum(np.abs(far - links.outer), np.abs(far - links.inner))
    at = off <= REACH
    if at.any():
        cosine = np.where(at, np.rint(cosine), cosine)
    sine = np.sqrt(1.0 - cosine * cosine)
    along, across = upper + fore * cosine, sign * (fore * sine)
    phi_2 = np.arctan2(py * along - px * across, px * along + py * across)
    free = at & (far <= REACH)
    if free.any():
        phi_2 = np.where(free, chosen, phi_2)
    exists = at | ((far < links.outer) & (far > links.inner))
    return Bend(phi_2, sign * np.arctan2(sine, cosine), exists, off <= REACH + blur, free)


class Tool(NamedTuple):
    """The frame before the last row's twist, whose z axis is joint 6's.

    Attributes:
        axes: Components of x, y and z, shape (3, 3, batch), component first.
        tip: Position of the tip, shape (3, batch), m.
    """

    axes: Array
    tip: Array


def remove_last_twist(arm: Arm, columns: Array) -> Tool:
    """Remove the last row's twist from poses in columns (16, batch)."""
    frame = columns[:12].reshape(3, 4, -1)
    axes, tip = frame[:, :3], frame[:, 3]
    c, s = arm.numeric[-1].cos_alpha, arm.numeric[-1].sin_alpha
    if (c, s) != (1.0, 0.0):
        x, y, z = axes.transpose(1, 0, 2)
        axes = np.stack([x, c * y - s * z, s * y + c * z], axis=1)
    return Tool(axes, tip)


def wrist_centre(arm: Arm, tool: Tool) -> Array:
    """Return the origin before the last row's lengths, shape (3, batch), m."""
    centre = tool.tip - arm.numeric[-1].d * tool.axes[:, 2]
    return centre - arm.numeric[-1].a * tool.axes[:, 0] if arm.numeric[-1].a else centre
