"""One step of a trace, or all of its steps in a batch: what the path asks, the rules, and what is
missing to the path."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from helpers.motion.paths import Path

Array = NDArray[np.floating]
Slope = Callable[
    [float, Array], Array
]  # from the share of a step, and the joints there, to joint rates
Rule = Callable[[Slope, Array, Array, Array], Array]


@dataclass(frozen=True)
class Course:
    """What a path asks of the tip in each step: at the share 0.0 of it where it begins, 1.0 where
    it ends.

    Attributes:
        times: when the steps begin and the last one ends, shape (steps + 1,), in s.
        h: how long each takes, shape (steps, 1), in s.
        twists: for each share that the method looks at, the twists (steps, 6).
        positions: for each of them, where the tip should be, (steps, 3), in m.
        rotation: the orientation that the tip keeps, shape (3, 3).
    """

    times: Array
    h: Array
    twists: dict[float, Array]
    positions: dict[float, Array]
    rotation: Array


SHARES = {"euler": (0.0,), "rk4": (0.0, 0.5, 1.0), "exact": (0.0, 1.0)}
METHODS = tuple(SHARES)


def charted(path: Path, method: str, rotation: Array) -> Course:
    """The path in tables, so that its functions are called once and not at every step."""
    h = np.diff(path.times)
    at = {share: path.times[:-1] + share * h for share in SHARES[method]}
    velocities = {share: _table(path.velocity, times) for share, times in at.items()}
    return Course(
        times=path.times,
        h=h[:, None],
        twists={share: np.hstack([v, np.zeros_like(v)]) for share, v in velocities.items()},
        positions={share: _table(path.position, times) for share, times in at.items()},
        rotation=rotation,
    )


def _table(function: Callable[[Array], Array], times: Array) -> Array:
    """The function at all times, (steps, 3); one by one where it takes no batch."""
    values = np.array(function(times.copy()), dtype=float)
    return values if values.shape == (len(times), 3) else np.array([function(t) for t in times])


def euler(slope: Slope, h: Array, q: Array, rate: Array) -> Array:
    """The joints at the end of a step that begins at q with these rates."""
    return q + h * rate


def rk4(slope: Slope, h: Array, q: Array, rate: Array) -> Array:
    """The same by the classical rule of fourth order."""
    k_2 = slope(0.5, q + h / 2 * rate)
    k_3 = slope(0.5, q + h / 2 * k_2)
    k_4 = slope(1.0, q + h * k_3)
    return q + h / 6 * (rate + 2 * k_2 + 2 * k_3 + k_4)


RULES = {"euler": euler, "rk4": rk4}


def tip_error(pose: Array, position: Array, rotation: Array) -> Array:
    """The small twists (..., 6) that would carry poses (..., 4, 4) to positions (..., 3) and a
    rotation (3, 3)."""
    turn = rotation @ np.swapaxes(pose[..., :3, :3], -1, -2)
    error = np.empty((*pose.shape[:-2], 6))
    error[..., :3] = position - pose[..., :3, 3]
    error[..., 3] = 0.5 * (turn[..., 2, 1] - turn[..., 1, 2])
    error[..., 4] = 0.5 * (turn[..., 0, 2] - turn[..., 2, 0])
    error[..., 5] = 0.5 * (turn[..., 1, 0] - turn[..., 0, 1])
    return error
