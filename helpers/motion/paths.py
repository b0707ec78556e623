"""Paths for the tip: where it should be, and how fast, at any time."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import ArmError

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Path:
    """A path of the tip at held orientation.

    Attributes:
        times: when the steps begin and the last one ends, shape (steps + 1,), in s.
        position, velocity: functions of times of shape (...,) to arrays of shape (..., 3), in m and m/s.
        normal: the unit normal of the wall that the path lies on.
    """

    times: Array
    position: Callable[[ArrayLike], Array]
    velocity: Callable[[ArrayLike], Array]
    normal: Array

    @property
    def positions(self) -> Array:
        """Where the tip should be at each of `times`, shape (steps + 1, 3), in m."""
        return self.position(self.times)

    @property
    def velocities(self) -> Array:
        """How fast the tip should be at each of `times`, shape (steps + 1, 3), in m/s."""
        return self.velocity(self.times)


def circle(
    centre: ArrayLike, radius: float, plane: str, period: float, steps: int, phase: float = 0.0
) -> Path:
    """A circle at even speed: centre + radius (cos(phi) e_1 + sin(phi) e_2) with phi = phase + 2 pi t / period.

    `plane` names the base axes e_1 and e_2 in their order, as in "zy" for a circle that starts at the top and moves towards
    +y. Centre in m, shape (3,), radius in m, period in s, phase in rad. Raises ArmError for a value that makes no circle.
    """
    centre = np.asarray(centre, dtype=float)
    if centre.shape != (3,) or not np.isfinite(centre).all():
        raise ArmError(f"the centre is {centre}; expected three finite coordinates")
    if not (np.isfinite(radius) and radius > 0 and np.isfinite(period) and period > 0):
        raise ArmError(f"radius and period are {radius}, {period}; expected both > 0 and finite")
    if not (isinstance(steps, int | np.integer) and steps >= 1):
        raise ArmError(f"steps is {steps!r}; expected a whole number of 1 or more")
    if len(plane) != 2 or plane[0] == plane[1] or not set(plane) <= set("xyz"):
        raise ArmError(
            f"plane is {plane!r}; expected two different letters of x, y, z, such as 'yz'"
        )
    first, second = (np.eye(3)["xyz".index(letter)] for letter in plane)
    rate = 2 * np.pi / period

    def position(t: ArrayLike) -> Array:
        angle = phase + rate * np.asarray(t, dtype=float)[..., None]
        return centre + radius * (np.cos(angle) * first + np.sin(angle) * second)

    def velocity(t: ArrayLike) -> Array:
        angle = phase + rate * np.asarray(t, dtype=float)[..., None]
        return radius * rate * (np.cos(angle) * second - np.sin(angle) * first)

    return Path(np.linspace(0.0, period, steps + 1), position, velocity, np.cross(first, second))
