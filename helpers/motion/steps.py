"""Compute one step of a trace, or all steps in a batch: wanted twists, rules and tip errors."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from helpers.motion.paths import Path

Array = NDArray[np.floating]
# A function of the fraction of a step and the joint values there that returns joint rates.
Slope = Callable[[float, Array], Array]
# A function of the slope, the step's duration, q and the rates at its start; it returns the next q.
Rule = Callable[[Slope, Array, Array, Array], Array]


@dataclass(frozen=True)
class PathSamples:
    """The wanted motion of the tip in each step, at the fractions of a step that a method needs.

    Attributes:
        times: Times at which the steps begin and the last one ends, shape (steps + 1,), in s.
        h: Durations of the steps, shape (steps, 1), in s.
        twists: For each fraction (0.0 at a step's start, 1.0 at its end) the twists (steps, 6).
        positions: For each fraction the wanted positions of the tip, (steps, 3), in m.
        rotation: The constant orientation of the tip, shape (3, 3).
    """

    times: Array
    h: Array
    twists: dict[float, Array]
    positions: dict[float, Array]
    rotation: Array


FRACTIONS = {"euler": (0.0,), "rk4": (0.0, 0.5, 1.0), "exact": (0.0, 1.0)}
METHODS = tuple(FRACTIONS)


def sample_path(path: Path, method: str, rotation: Array) -> PathSamples:
    """Sample a path for all steps with a single call of its functions."""
    h = np.diff(path.times)
    at = {f: path.times[:-1] + f * h for f in FRACTIONS[method]}
    velocities = {f: _sample_at_times(path.velocity, times) for f, times in at.items()}
    return PathSamples(
        times=path.times,
        h=h[:, None],
        twists={f: np.hstack([v, np.zeros_like(v)]) for f, v in velocities.items()},
        positions={f: _sample_at_times(path.position, times) for f, times in at.items()},
        rotation=rotation,
    )


def _sample_at_times(function: Callable[[Array], Array], times: Array) -> Array:
    """Evaluate a function at all times, (steps, 3).

    They are taken in turn where the function takes no batch.
    """
    values = np.array(function(times.copy()), dtype=float)
    return values if values.shape == (len(times), 3) else np.array([function(t) for t in times])


def take_euler_step(slope: Slope, h: Array, q: Array, rate: Array) -> Array:
    """Take one step of Euler's rule from q.

    `rate` holds the joint rates there.
    """
    return q + h * rate


def take_rk4_step(slope: Slope, h: Array, q: Array, rate: Array) -> Array:
    """Take one step of the classical Runge-Kutta rule of fourth order from q."""
    k_2 = slope(0.5, q + h / 2 * rate)
    k_3 = slope(0.5, q + h / 2 * k_2)
    k_4 = slope(1.0, q + h * k_3)
    return q + h / 6 * (rate + 2 * k_2 + 2 * k_3 + k_4)


RULES = {"euler": take_euler_step, "rk4": take_rk4_step}


def tip_error(pose: Array, position: Array, rotation: Array) -> Array:
    """Compute the small twists that would carry poses to wanted ones.

    Args:
        pose: Poses, shape (..., 4, 4).
        position: Wanted positions, shape (..., 3), in m.
        rotation: Wanted orientation, shape (3, 3).

    Returns:
        Differences in position and rotation vectors to first order, shape (..., 6), in m and rad.
    """
    turn = rotation @ np.swapaxes(pose[..., :3, :3], -1, -2)
    error = np.empty((*pose.shape[:-2], 6))
    error[..., :3] = position - pose[..., :3, 3]
    error[..., 3] = 0.5 * (turn[..., 2, 1] - turn[..., 1, 2])
    error[..., 4] = 0.5 * (turn[..., 0, 2] - turn[..., 2, 0])
    error[..., 5] = 0.5 * (turn[..., 1, 0] - turn[..., 0, 1])
    return error
