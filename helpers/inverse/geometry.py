"""Geometry that the closed forms share: a plane turned to its target, two links in it, a tool's own
axes."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.rows import NumericRow

Array = NDArray[np.float64]

REACH = 1e-12  # m: a target this far beyond the boundary counts as on it
SINGULAR = (
    1e-11  # a sine this small counts as 0, which moves the tool by no more than as many radians
)


class Plane(NamedTuple):
    """Joint 1's two angles and the target in the plane's axes x_1, y_1, (2, batch), and what is
    known of it, (batch,)."""

    phi: Array
    x: Array
    y: Array
    exists: NDArray[np.bool_]
    free: NDArray[np.bool_]


def facing(first: NumericRow, offset: float, p: Array, chosen: Array) -> Plane:
    """Turn the plane, which lies `offset` along z_1 beside the axis, to the target: p . z_1 =
    offset, twice."""
    x, y, z = p[0], p[1], p[2]
    delta = first.sin_alpha * offset
    square = x * x + y * y - delta * delta
    reach = np.sqrt(np.maximum(square, 0.0))
    both = np.stack([reach, -reach])
    phi = np.arctan2(y * both + x * delta, x * both - y * delta)
    free = x * x + y * y < REACH**2
    if not delta and free.any():
        phi = np.where(free, np.stack([chosen, chosen + np.pi]), phi)
    exists = square >= -2 * abs(delta) * REACH
    height = np.broadcast_to(first.sin_alpha * (z - first.d), both.shape)
    return Plane(phi, both, height, exists, free & (delta == 0.0))


class Bend(NamedTuple):
    """The two angles of a planar pair of links, each (branches, batch)."""

    phi_2: Array
    phi_3: Array
    exists: NDArray[np.bool_]
    free: NDArray[np.bool_]


def two_links(upper: float, fore: float, px: Array, py: Array, sign: Array, chosen: Array) -> Bend:
    """Angles of two links from the origin to (px, py), by the law of cosines; `sign` is that of
    sin(phi_3)."""
    cosine = (px * px + py * py - (upper**2 + fore**2)) * (0.5 / (upper * fore))
    exists = np.abs(cosine) <= 1.0 + REACH * (abs(upper) + abs(fore)) / abs(upper * fore)
    cosine = np.minimum(np.maximum(cosine, -1.0), 1.0)
    sine = np.sqrt(1.0 - cosine * cosine)
    along, across = upper + fore * cosine, sign * (fore * sine)
    phi_2 = np.arctan2(py * along - px * across, px * along + py * across)
    free = np.maximum(np.abs(px), np.abs(py)) < REACH
    if free.any():
        phi_2 = np.where(free, chosen, phi_2)
    return Bend(phi_2, sign * np.arctan2(sine, cosine), exists, free)


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
