"""Geometry that the closed forms share: a plane turned to its target, two links in it, a tool's own
axes."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.rows import NumericRow

Array = NDArray[np.float64]

# Branches meet where a target lies on the boundary of what they reach: the two shoulders, the two
# elbows. There the root of a distance tells them apart, so that rounding a pose in its last digit
# moves them by 1e-8 rad. A target this close to the boundary, in m, on either side, therefore
# counts as on it, and the two as one: a thousand times what rounding does, and less than anybody
# can measure.
REACH = 1e-12
# A sine this small counts as 0, which moves the tool by no more than as many radians.
SINGULAR = 1e-11
# Largest effect of rounding on an axis that is computed from a pose.
NOISE = 4e-15


class Plane(NamedTuple):
    """Joint 1's two angles and the target in the plane's axes x_1, y_1, (2, batch), and what is
    known of it, (batch,): whether it exists, whether both are one, and whether joint 1 is free."""

    phi: Array
    x: Array
    y: Array
    exists: NDArray[np.bool_]
    one: NDArray[np.bool_]
    free: NDArray[np.bool_]


def facing(first: NumericRow, offset: float, p: Array, chosen: Array) -> Plane:
    """Turn the plane, which lies `offset` along z_1 beside the axis, to the target: p . z_1 =
    offset, twice."""
    x, y, z = p[0], p[1], p[2]
    delta = first.sin_alpha * offset
    square, edge = x * x + y * y - delta * delta, max(2 * abs(delta) * REACH, REACH**2)
    one = np.abs(square) <= edge
    reach = np.sqrt(np.where(square > edge, square, 0.0))
    both = np.stack([reach, -reach])
    phi = np.arctan2(y * both + x * delta, x * both - y * delta)
    free = one & (delta == 0.0)
    if free.any():
        phi = np.where(free, np.stack([chosen, chosen + np.pi]), phi)
    height = np.broadcast_to(first.sin_alpha * (z - first.d), both.shape)
    return Plane(phi, both, height, square >= -edge, one, free)


class Links(NamedTuple):
    """Two links in a plane, by their lengths; a sign turns the axis that they count from."""

    upper: float
    fore: float

    @property
    def outer(self) -> float:
        """How far they reach, stretched."""
        return abs(self.upper) + abs(self.fore)

    @property
    def inner(self) -> float:
        """How near they reach, folded."""
        return abs(abs(self.upper) - abs(self.fore))


class Bend(NamedTuple):
    """The two angles of a planar pair of links, each (branches, batch), whether they exist, whether
    both bends are one, and whether the first angle is free."""

    phi_2: Array
    phi_3: Array
    exists: NDArray[np.bool_]
    one: NDArray[np.bool_]
    free: NDArray[np.bool_]


def two_links(
    links: Links,
    end: tuple[Array, Array],
    sign: Array,
    chosen: Array,
    blur: Array | float = 0.0,
) -> Bend:
    """Angles of two links from the origin to a point, by the law of cosines; `sign` is that of
    sin(phi_3). Both bends are one, too, where rounding moves the point by `blur`, in m, across the
    boundary; their values stay what they are."""
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
    """The frame before the last row's twist, whose z axis joint 6 turns about, and the tip, in
    columns.

    `axes` has shape (3, 3, batch): component by component, x, y and z.
    """

    axes: Array
    tip: Array


def unwound(arm: Arm, columns: Array) -> Tool:
    """The last row's twist taken back from poses in columns (16, batch)."""
    frame = columns[:12].reshape(3, 4, -1)
    axes, tip = frame[:, :3], frame[:, 3]
    c, s = arm.numeric[-1].cos_alpha, arm.numeric[-1].sin_alpha
    if (c, s) != (1.0, 0.0):
        x, y, z = axes.transpose(1, 0, 2)
        axes = np.stack([x, c * y - s * z, s * y + c * z], axis=1)
    return Tool(axes, tip)


def wrist_centre(arm: Arm, tool: Tool) -> Array:
    """The origin before the last row's lengths, (3, batch)."""
    centre = tool.tip - arm.numeric[-1].d * tool.axes[:, 2]
    return centre - arm.numeric[-1].a * tool.axes[:, 0] if arm.numeric[-1].a else centre
