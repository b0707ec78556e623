"""Whether two tables are the same machine, found out by trying: nothing here knows what a common
normal is.

They are if, for some signs s, shifts delta, base motion and constant turn R of the tool, the poses
of the one at s q + delta are those of the other at q, whatever q. The base motion drops out of
poses taken relative to the first.
"""

from dataclasses import replace
from itertools import product

import numpy as np

from helpers.arm import Arm, Row, fixed, prismatic, revolute
from helpers.kinematics import forward_kinematics

_TRIES, _STEPS = 16, 40


def same_machine(mine: Arm, reference: Arm) -> bool:
    """Searches for signs, shifts and turn by Levenberg and Marquardt's method from many starts at
    once."""
    rng = np.random.default_rng(0)
    q = rng.uniform(-1.5, 1.5, (10, reference.dof))
    wanted = _relative(forward_kinematics(reference, q))
    return any(_fits(mine, np.array(s) * q, wanted, rng) for s in product((1, -1), repeat=mine.dof))


def _fits(mine: Arm, q: np.ndarray, wanted: np.ndarray, rng: np.random.Generator) -> bool:
    x = rng.uniform(-np.pi, np.pi, (_TRIES, mine.dof + 3))
    misfit, damping = _misfit(mine, q, wanted, x), np.full((_TRIES, 1, 1), 1e-2)
    nudges = 1e-7 * np.eye(x.shape[1])[:, None]
    for _ in range(_STEPS):
        nudged = _misfit(mine, q, wanted, (x + nudges).reshape(-1, x.shape[1]))
        rates = (nudged.reshape(-1, *misfit.shape) - misfit) / 1e-7
        J, JT = rates.transpose(1, 2, 0), rates.transpose(1, 0, 2)
        step = np.linalg.solve(JT @ J + damping * np.eye(x.shape[1]), JT @ misfit[..., None])
        trial = x - step[..., 0]
        tried = _misfit(mine, q, wanted, trial)
        better = _cost(tried) < _cost(misfit)
        x[better], misfit[better] = trial[better], tried[better]
        damping = np.clip(damping * np.where(better, 0.2, 6)[:, None, None], 1e-14, 1e6)
        if _cost(misfit).min() < 1e-9:
            return True
    return False


def _cost(misfit: np.ndarray) -> np.ndarray:
    return (misfit**2).sum(axis=1)


def _misfit(mine: Arm, q: np.ndarray, wanted: np.ndarray, x: np.ndarray) -> np.ndarray:
    """One row per start: how far the poses at q + delta, the tool turned by R, are from those
    wanted."""
    poses = _relative(forward_kinematics(mine, q + x[:, None, : mine.dof]))
    R = _rotation(x[:, mine.dof :])[:, None]
    turned = R @ wanted[:, :3, :3] - poses[..., :3, :3] @ R
    moved = R @ wanted[:, :3, 3:] - poses[..., :3, 3:]
    return np.concatenate([turned.reshape(len(x), -1), moved.reshape(len(x), -1)], axis=1)


def _relative(T: np.ndarray) -> np.ndarray:
    return np.linalg.inv(T[..., :1, :, :]) @ T[..., 1:, :, :]


def _rotation(w: np.ndarray) -> np.ndarray:
    """Rodrigues' formula."""
    angle = np.linalg.norm(w, axis=-1)[:, None, None] + 1e-12
    K = np.zeros((len(w), 3, 3))
    K[:, 2, 1], K[:, 0, 2], K[:, 1, 0] = w.T
    K = (K - np.swapaxes(K, 1, 2)) / angle
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K


# Pairs of tables to try it on

_LENGTHS = (0, 0, 0.3, -0.2, 0.5)
_TWISTS = (0, "pi/2", "-pi/2", "pi", 0.7, -1.1)
_ANGLES = (0, 0, "pi/2", 0.4)
_KINDS = (revolute, revolute, prismatic, fixed)


def random_pair(seed: int, rows: int = 3) -> tuple[Arm, Arm]:
    """A table full of special cases, and the same one with up to three entries changed or
    reversed."""
    rng = np.random.default_rng(seed)
    pick = lambda values: values[rng.integers(len(values))]  # noqa: E731
    table = [
        pick(_KINDS)(pick(_LENGTHS), pick(_TWISTS), pick(_LENGTHS), pick(_ANGLES))
        for _ in range(rows)
    ]
    table[rng.integers(rows)] = revolute(pick(_LENGTHS), pick(_TWISTS), pick(_LENGTHS))
    changed = list(table)
    for _ in range(rng.integers(1, 4)):
        i = rng.integers(rows)
        changed[i] = pick(_CHANGES)(changed[i])
    return Arm("mine", changed), Arm("reference", table)


def _changed(name: str, formula: str):
    def change(row: Row) -> Row:
        return replace(row, **{name: formula.format(getattr(row, name))})

    return change


_CHANGES = [
    *(_changed(name, "-({})") for name in ("a", "alpha", "d")),
    *(_changed(name, "{} + 0.1") for name in ("a", "d")),
    *(_changed(name, "{} + pi") for name in ("alpha", "theta")),
    _changed("theta", "{} + 0.5"),
]
