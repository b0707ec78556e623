"""Define paths of the tip: its wanted position and velocity at any time."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import (
    ArmError,
    finite_array,
    finite_number,
    parse_plane,
    require_callable,
    require_type,
    whole_number,
)
from helpers.kinematics import tip

Array = NDArray[np.floating]


@dataclass(frozen=True)
class Path:
    """A path of the tip at constant orientation.

    Args:
        times: Times at which the steps begin and the last one ends, shape (steps + 1,), in s.
        position: Function from times (...,) to positions (..., 3), in m.
        velocity: Function from times (...,) to velocities (..., 3), in m/s.
        normal: Unit normal of the wall that the path lies on.
    """

    times: Array
    position: Callable[[ArrayLike], Array]
    velocity: Callable[[ArrayLike], Array]
    normal: Array

    def __post_init__(self) -> None:
        times = finite_array(self.times, "times", "finite times (steps + 1,) in s", (None,))
        if not (len(times) and (np.diff(times) > 0).all()):
            raise ArmError(f"times are {times}; expected each later than the one before")
        for name in ("position", "velocity"):
            require_callable(getattr(self, name), name, "a function of the time")
        normal = finite_array(self.normal, "normal", "a vector of three finite numbers", (3,))
        object.__setattr__(self, "times", times.copy())
        object.__setattr__(self, "normal", normal.copy())

    @property
    def positions(self) -> Array:
        """The wanted positions of the tip at `times`, shape (steps + 1, 3), in m."""
        return self.position(self.times.copy())

    @property
    def velocities(self) -> Array:
        """The wanted velocities of the tip at `times`, shape (steps + 1, 3), in m/s."""
        return self.velocity(self.times.copy())


def circle(
    centre: ArrayLike, radius: float, plane: str, period: float, steps: int, *, phase: float = 0.0
) -> Path:
    """Define a circle that is travelled at constant speed.

    The tip is at centre + radius (cos(phi) e_1 + sin(phi) e_2), phi being phase + 2 pi t / period.

    Args:
        centre: Centre in the base frame, shape (3,), in m.
        radius: Radius, in m.
        plane: The base axes e_1 and e_2, in their order; "zy" is a circle that starts at the top
            and moves towards +y.
        period: Time for one turn, in s.
        steps: Number of steps.
        phase: Angle at which the circle begins, in rad.

    Example:
        >>> path = circle([0.5, 0, 0.6], 0.1, "zy", period=4, steps=4)
        >>> path.positions.round(3) + 0.0
        array([[ 0.5,  0. ,  0.7],
               [ 0.5,  0.1,  0.6],
               [ 0.5,  0. ,  0.5],
               [ 0.5, -0.1,  0.6],
               [ 0.5,  0. ,  0.7]])
    """
    centre = finite_array(centre, "the centre", "three finite coordinates in m", (3,)).copy()
    radius = finite_number(radius, "radius", "a finite length > 0 in m", above=0)
    period = finite_number(period, "period", "a finite time > 0 in s", above=0)
    phase = finite_number(phase, "phase", "a finite angle in rad")
    steps = whole_number(steps, "steps", least=1)
    first, second = np.eye(3)[list(parse_plane(plane))]
    rate = 2 * np.pi / period

    def position(t: ArrayLike) -> Array:
        angle = phase + rate * np.asarray(t)[..., None]
        return centre + radius * (np.cos(angle) * first + np.sin(angle) * second)

    def velocity(t: ArrayLike) -> Array:
        angle = phase + rate * np.asarray(t)[..., None]
        return radius * rate * (np.cos(angle) * second - np.sin(angle) * first)

    return Path(np.linspace(0.0, period, steps + 1), position, velocity, np.cross(first, second))


def line(start: ArrayLike, end: ArrayLike, period: float, steps: int) -> Path:
    """Define a straight line that is travelled at constant speed.

    The path's `normal` is a direction at right angles to the line, so that the report's distance
    off the wall is a distance from the line. `rest_to_rest` makes it begin and end at rest.

    Args:
        start: First point in the base frame, shape (3,), in m.
        end: Last point in the base frame, shape (3,), in m.
        period: Time from the first to the last point, in s.
        steps: Number of steps.

    Raises:
        ArmError: The points are the same, or not three finite coordinates each.

    Example:
        >>> line([0.4, 0, 0.5], [0.4, 0.2, 0.5], period=2, steps=2).positions
        array([[0.4, 0. , 0.5],
               [0.4, 0.1, 0.5],
               [0.4, 0.2, 0.5]])
    """
    first = finite_array(start, "start", "three finite coordinates in m", (3,)).copy()
    last = finite_array(end, "end", "three finite coordinates in m", (3,)).copy()
    period = finite_number(period, "period", "a finite time > 0 in s", above=0)
    steps = whole_number(steps, "steps", least=1)
    step = last - first
    if not np.linalg.norm(step):
        raise ArmError(f"start and end are both {first}; expected two different points")
    # The normal is computed with the base axis that is closest to perpendicular to the line.
    normal = np.cross(step, np.eye(3)[np.abs(step).argmin()])

    def position(t: ArrayLike) -> Array:
        return first + np.asarray(t)[..., None] / period * step

    def velocity(t: ArrayLike) -> Array:
        return np.broadcast_to(step / period, (*np.shape(t), 3))

    times = np.linspace(0.0, period, steps + 1)
    return Path(times, position, velocity, normal / np.linalg.norm(normal))


def circle_below(
    arm: Arm, start: ArrayLike, radius: float, plane: str, period: float, steps: int
) -> Path:
    """Define the circle that begins at an arm's tip and hangs below it.

    The circle is upright. For a level one, as for a SCARA, use `circle` with the plane "xy".

    Args:
        arm: The arm.
        start: Joint values at the start, shape (dof,).
        radius: Radius, in m.
        plane: Two base axes, one of them z. In "zy" the tip starts towards +y, in "yz" towards -y.
        period: Time for one turn, in s.
        steps: Number of steps.

    Raises:
        ArmError: The plane has no z axis.

    Example:
        >>> from helpers.robots import UR10E
        >>> path = circle_below(UR10E, [0, -1, 1.2, -1, -1.5, 0], 0.1, "zy", period=5, steps=100)
        >>> bool(np.allclose(path.positions[0], tip(UR10E, [0, -1, 1.2, -1, -1.5, 0])))
        True
    """
    require_type(arm, Arm, "arm")
    top = tip(arm, arm.joint_vector(start, "start", many=False))
    if 2 not in parse_plane(plane):
        raise ArmError(
            f"plane is {plane!r}; expected one with z, such as 'zy', to be below the tip;"
            " for a level circle use motion.circle"
        )
    centre = top - [0, 0, finite_number(radius, "radius", "a finite length > 0 in m", above=0)]
    phase = 0.0 if plane[0] == "z" else np.pi / 2
    return circle(centre, radius, plane, period, steps, phase=phase)


def rest_to_rest(path: Path) -> Path:
    """Return the same path in the same time, beginning and ending at rest.

    At the fraction u of the time, the tip is where `path` has it at the fraction
    10 u^3 - 15 u^4 + 6 u^5. Speed and acceleration are 0 at both ends; the largest speed is 15/8 of
    the constant one.

    Example:
        >>> path = rest_to_rest(circle([0.5, 0, 0.6], 0.1, "zy", period=4, steps=4))
        >>> np.linalg.norm(path.velocities, axis=1).round(3)
        array([0.   , 0.166, 0.295, 0.166, 0.   ])

    Source: Lynch and Park, Modern Robotics, section 9.2 (quintic time scaling).
    """
    require_type(path, Path, "path")
    begin, period = path.times[0], path.times[-1] - path.times[0]

    def fraction(t: ArrayLike) -> Array:
        return (np.asarray(t) - begin) / period

    def time_on_path(u: Array) -> Array:
        return begin + period * u**3 * (10 + u * (6 * u - 15))

    def position(t: ArrayLike) -> Array:
        return path.position(time_on_path(fraction(t)))

    def velocity(t: ArrayLike) -> Array:
        u = fraction(t)
        return 30 * (u[..., None] * (1 - u[..., None])) ** 2 * path.velocity(time_on_path(u))

    return Path(path.times, position, velocity, path.normal)
