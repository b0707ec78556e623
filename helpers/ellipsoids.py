"""What a Jacobian can and cannot do at one pose: its ellipsoids and its lost directions.

Source: Siciliano, Sciavicco, Villani and Oriolo, Robotics, section 3.9 (manipulability
    ellipsoids).
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.inputs import ArmError, number, numbers

__all__ = [
    "lost_directions",
    "velocity_ellipsoid",
]

Array = NDArray[np.float64]


def velocity_ellipsoid(J: ArrayLike) -> Array:
    """The semi-axes, as columns, of the velocities J q_dot that joint speeds of norm 1 can give.

    J is one block of a Jacobian, shape (3, n); the result has shape (3, 3), its columns falling in
    length. A column of zeros is a direction in which the tip cannot move. Raises ArmError for
    another shape.
    """
    block = _block(J)
    if block.shape[0] != 3:
        raise ArmError(
            f"J has shape {block.shape}; expected (3, n), the linear or the angular rows"
        )
    U, found, _ = np.linalg.svd(block)
    sizes = np.zeros(3)
    sizes[: len(found)] = np.where(found > 1e-12 * found.max(initial=0.0), found, 0.0)
    return _signed(U) * sizes


def lost_directions(J: ArrayLike, cutoff: float = 1e-9) -> Array:
    """The velocities that no joint motion can give, as orthonormal rows of shape (lost, rows of J).

    They are the left singular vectors whose singular value is not above `cutoff` times the largest.
    """
    cutoff = number(cutoff, "cutoff", "a number of 0 or more", least=0)
    U, sizes, _ = np.linalg.svd(_block(J), full_matrices=True)
    rank = int((sizes > cutoff * sizes.max(initial=0.0)).sum())
    return U.T[rank:]


def _signed(U: Array) -> Array:
    """The same axes, each pointing to its first large entry's positive side: LAPACK's own choice
    differs by machine."""
    first = np.argmax(np.abs(U) > 0.5 * np.abs(U).max(axis=0), axis=0)
    return U * np.sign(U[first, range(U.shape[1])])


def _block(J: ArrayLike) -> Array:
    return numbers(J, "J", "one matrix of finite numbers", (None, None))
