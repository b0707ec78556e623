"""Paths for the tip: where it should be, and how fast, at any time."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import ArmError, must_be, must_be_callable, number, numbers, plane_axes, whole
from helpers.kinematics import tip

Array = NDArray[np.floating]


@dataclass(frozen=True)
class Path:
    """A path of the tip at held orientation.

    Attributes:
        times: when the steps begin and the last one ends, shape (steps + 1,), in s.
        position, velocity: functions of times of shape (...,) to arrays of shape (..., 3), in m and
            m/s.
        normal: the unit normal of the wall that the path lies on.
    """

    times: Array
    position: Callable[[ArrayLike], Array]
    velocity: Callable[[ArrayLike], Array]
    normal: Array

    def __post_init__(self) -> None:
        times = numbers(self.times, "times", "finite times (steps + 1,) in s", (None,))
        if not (len(times) and (np.diff(times) > 0).all()):
            raise ArmError(f"times are {times}; expected each later than the one before")
        for name in ("position", "velocity"):
            must_be_callable(getattr(self, name), name, "a function of the time")
        normal = numbers(self.normal, "normal", "a vector of three finite numbers", (3,))
        object.__setattr__(self, "times", times.copy())
        object.__setattr__(self, "normal", normal.copy())

    @property
    def positions(self) -> Array:
        """Where the tip should be at each of `times`, shape (steps + 1, 3), in m."""
        return self.position(self.times.copy())

    @property
    def velocities(self) -> Array:
        """How fast the tip should be at each of `times`, shape (steps + 1, 3), in m/s."""
        return self.velocity(self.times.copy())


def circle(
    centre: ArrayLike, radius: float, plane: str, period: float, steps: int, *, phase: float = 0.0
) -> Path:
    """A circle at even speed: centre + radius (cos(phi) e_1 + sin(phi) e_2) with phi = phase + 2 pi
    t / period.

    `plane` names the base axes e_1 and e_2 in their order, as in "zy" for a circle that starts at
    the top and moves towards +y. Centre in m, shape (3,), radius in m, period in s, phase in rad.
    Raises ArmError for a value that makes no circle.
    """
    centre = numbers(centre, "the centre", "three finite coordinates in m", (3,)).copy()
    radius = number(radius, "radius", "a finite length > 0 in m", above=0)
    period = number(period, "period", "a finite time > 0 in s", above=0)
    phase = number(phase, "phase", "a finite angle in rad")
    steps = whole(steps, "steps", least=1)
    first, second = np.eye(3)[list(plane_axes(plane))]
    rate = 2 * np.pi / period

    def position(t: ArrayLike) -> Array:
        angle = phase + rate * np.asarray(t)[..., None]
        return centre + radius * (np.cos(angle) * first + np.sin(angle) * second)

    def velocity(t: ArrayLike) -> Array:
        angle = phase + rate * np.asarray(t)[..., None]
        return radius * rate * (np.cos(angle) * second - np.sin(angle) * first)

    return Path(np.linspace(0.0, period, steps + 1), position, velocity, np.cross(first, second))


def circle_below(
    arm: Arm, start: ArrayLike, radius: float, plane: str, period: float, steps: int
) -> Path:
    """The circle that begins at the tip of `arm` at `start`, shape (dof,), and hangs below it.

    With z first, as in the plane "zy", the tip sets out towards +y; with z last, as in "yz",
    towards -y. Radius in m, period in s. Raises ArmError for a plane without z, and as `circle`
    does.
    """
    must_be(arm, Arm, "arm")
    top = tip(arm, arm.joint_vector(start, "start", many=False))
    if 2 not in plane_axes(plane):
        raise ArmError(
            f"plane is {plane!r}; expected one with z, such as 'zy', to be below the tip"
        )
    centre = top - [0, 0, number(radius, "radius", "a finite length > 0 in m", above=0)]
    phase = 0.0 if plane[0] == "z" else np.pi / 2
    return circle(centre, radius, plane, period, steps, phase=phase)


def rest_to_rest(path: Path) -> Path:
    """The same path in the same time, begun and ended at rest: the tip is where `path` has it at
    the share s = 10 u^3 - 15 u^4 + 6 u^5 of its time, with u the share that has passed.

    Speed and acceleration are 0 at both ends; the largest speed is 15/8 of an even one's.
    Source: Lynch and Park, Modern Robotics, section 9.2 (quintic time scaling).
    """
    must_be(path, Path, "path")
    begin, period = path.times[0], path.times[-1] - path.times[0]

    def share(t: ArrayLike) -> Array:
        return (np.asarray(t) - begin) / period

    def there(u: Array) -> Array:
        return begin + period * u**3 * (10 + u * (6 * u - 15))

    def position(t: ArrayLike) -> Array:
        return path.position(there(share(t)))

    def velocity(t: ArrayLike) -> Array:
        u = share(t)
        return 30 * (u[..., None] * (1 - u[..., None])) ** 2 * path.velocity(there(u))

    return Path(path.times, position, velocity, path.normal)
