"""Define rules for joint rates that give the tip a wanted velocity.

Each public function returns a rule of type ``Rates``: a function of a Jacobian (6, n), a twist (6,)
and the joint values (n,) that returns joint rates (n,).
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from helpers.inputs import ArmError, finite_number

Array = NDArray[np.floating]
Rates = Callable[[Array, Array, Array], Array]


class SingularError(ArmError):
    """The Jacobian has no inverse."""


@dataclass(frozen=True)
class PlainInverse:
    """The rule q_dot = J^-1 xi.

    It is refused where the smallest singular value is not above `cutoff` times the largest. The
    inverse bounds the singular values from below by 1/|J^-1| and from above by |J| (Frobenius
    norms). They cost several times what the inverse does, so they are computed only where these
    bounds leave it open whether they are above twice the cutoff.

    Args:
        cutoff: Smallest ratio of the singular values that is accepted.
    """

    cutoff: float

    def __call__(self, J: Array, twist: Array, q: Array) -> Array:
        _require_square(J)
        try:
            solutions = np.linalg.solve(J, np.concatenate([twist[:, None], np.eye(len(J))], axis=1))
        except np.linalg.LinAlgError:
            raise _singular_error(np.linalg.svd(J, compute_uv=False)) from None
        if not self._is_regular(J, solutions[:, 1:]):
            sizes = np.linalg.svd(J, compute_uv=False)
            if sizes[-1] <= self.cutoff * sizes[0]:
                raise _singular_error(sizes)
        return solutions[:, 0]

    def inverses(self, J: Array) -> Array:
        """Invert many Jacobians, (steps, 6, 6).

        Raises:
            SingularError: A Jacobian may be singular.
        """
        X = np.linalg.inv(J)
        if not self._is_regular(J, X):
            raise SingularError(_DOUBT)
        return X

    def require_regular_near(self, J: Array, inverted: Array, inverse: Array) -> None:
        """Raise SingularError unless inverses of nearby Jacobians prove that J is regular.

        No singular value of J is further from that of `inverted` than the norm of their difference.

        Args:
            J: The Jacobians, shape (steps, 6, 6).
            inverted: A Jacobian near each, of the same shape.
            inverse: The inverses of `inverted`.

        Raises:
            SingularError: A Jacobian may be singular.
        """
        smallest = 1 / np.sqrt(_squared_norm(inverse)) - np.sqrt(_squared_norm(J - inverted))
        if not (smallest > self._least_ratio * np.sqrt(_squared_norm(J))).all():
            raise SingularError(_DOUBT)

    @property
    def _least_ratio(self) -> float:
        """The ratio of singular values that the norms must exceed."""
        return 2 * max(self.cutoff, _TRUSTED)

    def _is_regular(self, J: Array, inverse: Array) -> bool:
        """Return whether the norms prove that no J is singular."""
        return bool((self._least_ratio**2 * _squared_norm(J) * _squared_norm(inverse) < 1.0).all())


_TRUSTED = 1e-12  # below this ratio of singular values, round-off makes the inverse's norm useless
_DOUBT = "a Jacobian is so nearly singular that its singular values must be seen"


def _squared_norm(J: Array) -> Array:
    """Compute the squared Frobenius norm of each matrix."""
    return np.einsum("...ij,...ij->...", J, J)


def _require_square(J: Array) -> None:
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


def _singular_error(sizes: Array) -> SingularError:
    return SingularError(
        f"J has no inverse here: its smallest singular value is {format_size(sizes[-1])}, its"
        f" largest {sizes[0]:.3g}; use pseudo_inverse(), damped() or another start"
    )


def plain_inverse(cutoff: float = 1e-9) -> Rates:
    """Return the rule q_dot = J^-1 xi.

    It raises SingularError where J has no inverse.

    Args:
        cutoff: Smallest ratio of the smallest to the largest singular value that is accepted.

    Example:
        >>> rates = plain_inverse()
        >>> rates(2 * np.eye(6), np.ones(6), np.zeros(6))
        array([0.5, 0.5, 0.5, 0.5, 0.5, 0.5])
    """
    _require_nonnegative(cutoff=cutoff)
    return PlainInverse(cutoff)


def pseudo_inverse(cutoff: float = 1e-9) -> Rates:
    """Return the rule q_dot = J^+ xi, with the pseudo-inverse.

    Args:
        cutoff: Share of the largest singular value up to which a singular value counts as 0.

    Source: Whitney (1969).
    """
    _require_nonnegative(cutoff=cutoff)

    def rates(J: Array, twist: Array, q: Array) -> Array:
        # Apply J^+ by the singular values, without computing the matrix.
        U, sizes, V = np.linalg.svd(J, full_matrices=False)
        is_nonzero = sizes > cutoff * sizes[0]
        return (np.divide(twist @ U, sizes, out=np.zeros_like(sizes), where=is_nonzero)) @ V

    return rates


def damped(damping: float) -> Rates:
    """Return the rule q_dot = J^T (J J^T + damping^2 I)^-1 xi, with limited joint rates.

    Args:
        damping: The larger it is, the smaller the joint rates and the larger the tip's error.

    Example:
        >>> rates = damped(1.0)
        >>> rates(np.eye(6), np.ones(6), np.zeros(6))
        array([0.5, 0.5, 0.5, 0.5, 0.5, 0.5])

    Source: Nakamura and Hanafusa (1986).
    """
    _require_nonnegative(damping=damping)
    return lambda J, twist, q: _apply_damped_inverse(J, twist, damping**2)


def levenberg(scale: float = 0.1) -> Rates:
    """Return the damped rule with damping^2 = scale * norm(xi).

    It is meant for the method "exact", whose xi is an error: far from the target its steps are
    short, near the target they are those of Newton's method.

    Args:
        scale: Factor of the damping.

    Source: Nocedal and Wright, Numerical Optimization, 10.3.
    """
    _require_nonnegative(scale=scale)
    return lambda J, twist, q: _apply_damped_inverse(J, twist, scale * float(np.linalg.norm(twist)))


def format_size(value: float) -> str:
    """Write a singular value with three digits.

    Below 1e-12 it is round-off.
    """
    return f"{value:.3g}" if value >= 1e-12 else "below 1e-12"


def _require_nonnegative(**numbers: float) -> None:
    for name, value in numbers.items():
        finite_number(value, name, "a finite number of 0 or more", least=0)


def _apply_damped_inverse(J: Array, twist: Array, squared: float) -> Array:
    try:
        return J.T @ np.linalg.solve(J @ J.T + squared * np.eye(len(J)), twist)
    except np.linalg.LinAlgError:
        raise SingularError("J has no inverse here and the damping is 0; expected more") from None
