"""From a wanted velocity of the tip to joint rates: the inverse and its stand-ins.

Each function returns one of type ``Rates``: from a Jacobian (6, n), a twist (6,) and the joint
vector (n,) to joint rates (n,).
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from helpers.inputs import ArmError, number

Array = NDArray[np.floating]
Rates = Callable[[Array, Array, Array], Array]


class SingularError(ArmError):
    """A plain inverse was asked for where there is none."""


@dataclass(frozen=True)
class PlainInverse:
    """q_dot = J^-1 xi where the smallest singular value is above `cutoff` times the largest.

    The singular values cost several times what the solution does. The inverse bounds them: no
    singular value is below 1/|J^-1|, none above |J| (Frobenius norms). So 1/(|J| |J^-1|), which
    comes with the solution, is a share that the smallest has at least; only where it does not
    clear the cutoff twice over are they computed.
    """

    cutoff: float

    def __call__(self, J: Array, twist: Array, q: Array) -> Array:
        _must_be_square(J)
        try:
            both = np.linalg.solve(J, np.concatenate([twist[:, None], np.eye(len(J))], axis=1))
        except np.linalg.LinAlgError:
            raise _no_inverse(np.linalg.svd(J, compute_uv=False)) from None
        if not self._proved(J, both[:, 1:]):
            sizes = np.linalg.svd(J, compute_uv=False)
            if sizes[-1] <= self.cutoff * sizes[0]:
                raise _no_inverse(sizes)
        return both[:, 0]

    def inverses(self, J: Array) -> Array:
        """The inverses of many Jacobians, (steps, 6, 6). Raises SingularError where one is in
        doubt."""
        X = np.linalg.inv(J)
        if not self._proved(J, X):
            raise SingularError(
                "a Jacobian is so nearly singular that its singular values must be seen"
            )
        return X

    def _proved(self, J: Array, inverse: Array) -> bool:
        least = 2 * max(self.cutoff, _TRUSTED)
        return bool((least**2 * _square(J) * _square(inverse) < 1.0).all())


_TRUSTED = 1e-12  # rounding makes an inverse's norm worthless where the share is not well above it


def _square(J: Array) -> Array:
    """The square of the Frobenius norm."""
    return np.einsum("...ij,...ij->...", J, J)


def _must_be_square(J: Array) -> None:
    rows, joints = J.shape
    if joints < rows:
        raise SingularError(
            f"J is {rows} x {joints} and has no inverse: {joints} joints cannot give a tip any"
            " velocity; use pseudo_inverse(), which comes nearest"
        )
    if joints > rows:
        raise SingularError(
            f"J is {rows} x {joints} and has no inverse; lock a joint or use pseudo_inverse()"
        )


def _no_inverse(sizes: Array) -> SingularError:
    return SingularError(
        f"J has no inverse here: its smallest singular value is {magnitude(sizes[-1])}, its"
        f" largest {sizes[0]:.3g}; use pseudo_inverse(), damped() or another start"
    )


def plain_inverse(cutoff: float = 1e-9) -> Rates:
    """q_dot = J^-1 xi. Raises SingularError where the smallest singular value is below `cutoff`
    times the largest."""
    _not_negative(cutoff=cutoff)
    return PlainInverse(cutoff)


def pseudo_inverse(cutoff: float = 1e-9) -> Rates:
    """q_dot = J^+ xi, singular values below `cutoff` times the largest being taken as 0. Source:
    Whitney (1969)."""
    _not_negative(cutoff=cutoff)
    return lambda J, twist, q: _pseudo(J, twist, cutoff)


def damped(damping: float) -> Rates:
    """q_dot = J^T (J J^T + damping^2 I)^-1 xi, which trades error for speed. Source: Nakamura and
    Hanafusa (1986)."""
    _not_negative(damping=damping)
    return lambda J, twist, q: _damped(J, twist, damping**2)


def levenberg(scale: float = 0.1) -> Rates:
    """Damping that fades with what is left to do, damping^2 = scale times the size of xi: for
    method "exact", where xi is an error.

    Far away it is careful, close by it is Newton's method. Source: Nocedal and Wright, Numerical
    Optimization, 10.3.
    """
    _not_negative(scale=scale)
    return lambda J, twist, q: _damped(J, twist, scale * float(np.linalg.norm(twist)))


def magnitude(value: float) -> str:
    """A singular value with three digits; below 1e-12 it is rounding."""
    return f"{value:.3g}" if value >= 1e-12 else "below 1e-12"


def _not_negative(**numbers: float) -> None:
    for name, value in numbers.items():
        number(value, name, "a finite number of 0 or more", least=0)


def _pseudo(J: Array, twist: Array, cutoff: float) -> Array:
    """J^+ xi by the singular values, without the matrix J^+ itself."""
    U, sizes, V = np.linalg.svd(J, full_matrices=False)
    kept = sizes > cutoff * sizes[0]
    return (np.divide(twist @ U, sizes, out=np.zeros_like(sizes), where=kept)) @ V


def _damped(J: Array, twist: Array, squared: float) -> Array:
    try:
        return J.T @ np.linalg.solve(J @ J.T + squared * np.eye(len(J)), twist)
    except np.linalg.LinAlgError:
        raise SingularError("J has no inverse here and the damping is 0; expected more") from None
