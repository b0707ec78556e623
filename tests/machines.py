"""Decide by numeric search whether two tables describe the same machine.

Two tables are the same machine if joint signs s, joint offsets delta, a base motion and a constant
tool rotation R exist, so that the poses of one at s q + delta equal the poses of the other at q,
for every q. Poses relative to the first pose do not depend on the base motion. The search knows
nothing of common normals, by which the judge decides the same question.
"""

from dataclasses import replace
from itertools import product

import numpy as np

from helpers.arm import Arm, Row, fixed, prismatic, revolute
from helpers.kinematics import forward_kinematics

_STARTS, _STEPS = 16, 40


def same_machine(mine: Arm, reference: Arm) -> bool:
    """Return whether signs, offsets and a tool rotation are found that map mine to reference."""
    rng = np.random.default_rng(0)
    q = rng.uniform(-1.5, 1.5, (10, reference.dof))
    expected = _relative_poses(forward_kinematics(reference, q))
    return any(
        _fits(mine, np.array(s) * q, expected, rng) for s in product((1, -1), repeat=mine.dof)
    )


def _fits(mine: Arm, q: np.ndarray, expected: np.ndarray, rng: np.random.Generator) -> bool:
    """Search for offsets and tool rotation by Levenberg-Marquardt from all random starts at once.

    A row of x holds the dof joint offsets and the rotation vector of the tool.
    """
    x = rng.uniform(-np.pi, np.pi, (_STARTS, mine.dof + 3))
    misfit, damping = _misfit(mine, q, expected, x), np.full((_STARTS, 1, 1), 1e-2)
    nudges = 1e-7 * np.eye(x.shape[1])[:, None]
    for _ in range(_STEPS):
        nudged = _misfit(mine, q, expected, (x + nudges).reshape(-1, x.shape[1]))
        rates = (nudged.reshape(-1, *misfit.shape) - misfit) / 1e-7
        J, JT = rates.transpose(1, 2, 0), rates.transpose(1, 0, 2)
        step = np.linalg.solve(JT @ J + damping * np.eye(x.shape[1]), JT @ misfit[..., None])
        trial = x - step[..., 0]
        trial_misfit = _misfit(mine, q, expected, trial)
        better = _cost(trial_misfit) < _cost(misfit)
        x[better], misfit[better] = trial[better], trial_misfit[better]
        damping = np.clip(damping * np.where(better, 0.2, 6)[:, None, None], 1e-14, 1e6)
        if _cost(misfit).min() < 1e-9:
            return True
    return False


def _cost(misfit: np.ndarray) -> np.ndarray:
    return (misfit**2).sum(axis=1)


def _misfit(mine: Arm, q: np.ndarray, expected: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Return one row of pose residuals per start, with joint offsets and tool rotation applied."""
    poses = _relative_poses(forward_kinematics(mine, q + x[:, None, : mine.dof]))
    R = _rotation_matrix(x[:, mine.dof :])[:, None]
    turned = R @ expected[:, :3, :3] - poses[..., :3, :3] @ R
    moved = R @ expected[:, :3, 3:] - poses[..., :3, 3:]
    return np.concatenate([turned.reshape(len(x), -1), moved.reshape(len(x), -1)], axis=1)


def _relative_poses(T: np.ndarray) -> np.ndarray:
    """Return all poses except the first, relative to the first."""
    return np.linalg.inv(T[..., :1, :, :]) @ T[..., 1:, :, :]


def _rotation_matrix(w: np.ndarray) -> np.ndarray:
    """Return rotation matrices of rotation vectors by Rodrigues' formula."""
    angle = np.linalg.norm(w, axis=-1)[:, None, None] + 1e-12
    K = np.zeros((len(w), 3, 3))
    K[:, 2, 1], K[:, 0, 2], K[:, 1, 0] = w.T
    K = (K - np.swapaxes(K, 1, 2)) / angle
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K


# Random pairs of tables

# `same_machine` needs a quarter of a second for a pair, so its results are stored here, and the
# tests repeat the search for a few seeds only. Seeds 124 and 197 are left out: fixed rows before
# joint 1 move the base, and relative poses do not depend on the base.
SEEDS = sorted({*range(300)} - {124, 197})
SAME_MACHINES = {
    2, 6, 7, 8, 10, 11, 12, 14, 15, 17, 18, 20, 21, 22, 25, 28, 29, 30, 31, 33, 34, 35, 37,
    39, 40, 41, 42, 43, 45, 47, 48, 49, 50, 51, 52, 53, 55, 58, 60, 61, 62, 65, 67, 68, 69,
    70, 71, 72, 76, 78, 80, 81, 82, 83, 85, 86, 87, 88, 90, 92, 93, 96, 98, 100, 101, 102,
    103, 105, 106, 110, 111, 112, 115, 117, 118, 121, 122, 123, 125, 126, 127, 128, 129, 130,
    133, 134, 136, 137, 138, 140, 142, 143, 146, 147, 148, 149, 150, 151, 152, 153, 156, 158,
    159, 161, 162, 164, 165, 167, 168, 169, 171, 173, 175, 178, 180, 181, 182, 185, 188, 190,
    191, 192, 193, 194, 195, 198, 200, 201, 205, 208, 210, 211, 212, 213, 215, 216, 217, 220,
    224, 228, 230, 232, 233, 234, 237, 238, 239, 240, 241, 242, 243, 245, 246, 248, 249, 250,
    251, 254, 257, 259, 261, 262, 263, 264, 265, 267, 268, 269, 270, 274, 278, 280, 281, 282,
    283, 286, 287, 289, 292, 293, 294, 295, 298, 299,
}  # fmt: skip

_LENGTHS = (0, 0, 0.3, -0.2, 0.5)
_TWISTS = (0, "pi/2", "-pi/2", "pi", 0.7, -1.1)
_ANGLES = (0, 0, "pi/2", 0.4)
_KINDS = (revolute, revolute, prismatic, fixed)


def random_pair(seed: int, rows: int = 3) -> tuple[Arm, Arm]:
    """Return a changed copy of a random table, and the table.

    The table has many special cases, such as right angles and zero lengths. One to three of the
    copy's entries are shifted or reversed.
    """
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


def _make_change(name: str, formula: str):
    """Return a function that puts a formula of the old entry into a row."""

    def change(row: Row) -> Row:
        return replace(row, **{name: formula.format(getattr(row, name))})

    return change


_CHANGES = [
    *(_make_change(name, "-({})") for name in ("a", "alpha", "d")),
    *(_make_change(name, "{} + 0.1") for name in ("a", "d")),
    *(_make_change(name, "{} + pi") for name in ("alpha", "theta")),
    _make_change("theta", "{} + 0.5"),
]
