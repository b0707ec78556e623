"""Convert poses to rigid transforms."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.inputs import ArmError, finite_array, warn_caller

Array = NDArray[np.float64]

# Poses with larger errors of the rotation or the last row are corrected or refused. Poses with 6 or
# more decimals are within it. judge/geometry/inverse.js has the same bound (tests/test_poses.py).
_LARGEST_ROTATION_ERROR = 1e-6
# Decimals that a printed rotation may have; with fewer its direction is uncertain by a degree.
_DECIMALS = range(3, 8)
_NEARLY = 0.1  # up to this error the message explains how to get the nearest rotation
_CHUNK = 4096  # poses checked at a time, whose numbers fit into the cache


def rigid_poses(value: ArrayLike, name: str, expected: str, many: bool = False) -> Array:
    """Convert poses to rigid transforms.

    A rotation printed with few decimals is mended.

    If rounding to 3 or more decimals explains why a rotation is none, the nearest rotation takes
    its place, with a warning.

    Args:
        value: A pose, shape (4, 4); with `many` also poses (..., 4, 4).
        name: What messages call the poses.
        expected: What messages say was expected.
        many: Whether a batch is allowed.

    Raises:
        ArmError: `value` is no pose of finite numbers, or its rotation is none.
    """
    poses = finite_array(value, name, expected, (4, 4), many)
    flat = poses.reshape(-1, 16)
    errors = np.concatenate(
        [_rigid_errors(flat[i : i + _CHUNK]) for i in range(0, max(len(flat), 1), _CHUNK)]
    )
    bent = np.flatnonzero(errors > _LARGEST_ROTATION_ERROR)
    if not bent.size:
        return poses
    # 3 to 7 decimals to which a rotation was rounded, or 0.
    rotations = flat[bent].reshape(-1, 4, 4)[:, :3, :3]
    decimals = [
        next((n for n in _DECIMALS if np.abs(R - R.round(n)).max() < 1e-12), 0) for R in rotations
    ]
    # The nearest rotations, by singular values.
    left, _, right = np.linalg.svd(rotations)
    left[..., 2] *= np.where(np.linalg.det(left @ right) < 0, -1.0, 1.0)[..., None]
    mended = flat.reshape(-1, 4, 4).copy()
    mended[bent, :3, :3] = left @ right
    moved = np.linalg.norm((flat.reshape(-1, 4, 4) - mended)[bent, :3, :3], axis=(1, 2))
    # Rounding changes each of nine entries by at most half a unit, so by at most 1.5 units in
    # total. The nearest rotation is at most as far away as the rotation that was rounded.
    explained = moved <= [1.5 * 10.0**-n + 1e-9 if n else 0.0 for n in decimals]
    explained &= np.abs(flat[bent, 12:] - (0, 0, 0, 1)).max(axis=1) <= _LARGEST_ROTATION_ERROR
    if not explained.all():
        error = errors[bent][~explained].max()
        advice = "; U, _, V = np.linalg.svd(T[:3, :3]) gives the nearest rotation, U @ V"
        raise ArmError(
            f"{name} is no rigid transform, by {error:.2g}; expected {expected}: a rotation, its"
            " numbers rounded to three decimals or more, over (0, 0, 0, 1)"
            + (advice if error < _NEARLY else "")
        )
    warn_caller(
        f"{name} has only {min(filter(None, decimals))} decimals, so that its axes miss length 1 or"
        f" a right angle by {errors[bent].max():.2g}; the nearest rotation is taken"
    )
    return mended.reshape(poses.shape)


def _rigid_errors(flat: Array) -> Array:
    """Return the largest error of each pose (batch, 16) as a rigid transform."""
    columns = np.ascontiguousarray(flat.T)
    x, y, z = (columns[i:12:4] for i in range(3))
    square = columns[:12] * columns[:12]
    norms = square[0:3] + square[4:7] + square[8:11]
    normal = np.stack(
        [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]
    )
    gaps = (
        normal - z,
        norms - 1.0,
        (x * y).sum(axis=0)[None],
        columns[12:] - [[0.0], [0.0], [0.0], [1.0]],
    )
    return np.max([np.abs(gap).max(axis=0) for gap in gaps], axis=0)
