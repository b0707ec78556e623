"""From a wanted velocity of the tip to joint rates: the inverse and its stand-ins.

Each function returns one of type ``Rates``: from a Jacobian (6, n), a twist (6,) and the joint
vector (n,) to joint rates (n,).
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import ArmError, must_be, must_be_callable, number, numbers

Array = NDArray[np.floating]
Rates = Callable[[Array, Array, Array], Array]


class SingularError(ArmError):
    """A plain inverse was asked for where there is none."""


@dataclass(frozen=True)
class PlainInverse:
    """q_dot = J^-1 xi where the smallest singular value is above `cutoff` times the largest."""

    cutoff: float

    def __call__(self, J: Array, twist: Array, q: Array) -> Array:
        if J.shape[0] != J.shape[1]:
            raise SingularError(
                f"J is {J.shape[0]} x {J.shape[1]} and has no inverse; lock a joint or use"
                " pseudo_inverse()"
            )
        try:
            found = np.linalg.solve(J, twist)
        except np.linalg.LinAlgError:
            found = np.full(J.shape[1], np.inf)
        if not _proves_itself(found, twist):
            sizes = np.linalg.svd(J, compute_uv=False)
            if sizes[-1] <= self.cutoff * sizes[0]:
                raise SingularError(
                    "J has no inverse here: its smallest singular value is"
                    f" {magnitude(sizes[-1])}, its largest {sizes[0]:.3g}; use pseudo_inverse(),"
                    " damped() or another start"
                )
        return found

    def many(self, J: Array, twists: Array) -> Array:
        """The same of many at once, J (steps, 6, 6) and twists (steps, 6). Raises SingularError
        where one is in doubt."""
        found = np.linalg.solve(J, twists[..., None])[..., 0]
        if not _proves_itself(found, twists):
            raise SingularError(
                "a Jacobian is so nearly singular that its singular values must be seen"
            )
        return found


def _proves_itself(rates: Array, twist: Array) -> bool:
    """Whether rates are too small to come of a singular Jacobian; large ones cost a look at the
    singular values."""
    enough = 1e3 * (1e-9 + np.abs(twist).max(axis=-1, keepdims=True))
    return bool((np.abs(rates) < enough).all())


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


def adaptive(damping: float, below: float) -> Rates:
    """Damping only near a singular pose: damping^2 (1 - (s/below)^2) where the smallest singular
    value s < `below`."""
    _not_negative(damping=damping)
    number(below, "below", "a finite number > 0", above=0)

    def rates(J: Array, twist: Array, q: Array) -> Array:
        smallest = np.linalg.svd(J, compute_uv=False)[-1]
        return _damped(J, twist, damping**2 * max(0.0, 1 - (smallest / below) ** 2))

    return rates


def levenberg(scale: float = 0.1) -> Rates:
    """Damping that fades with what is left to do, damping^2 = scale times the size of xi: for
    method "exact", where xi is an error.

    Far away it is careful, close by it is Newton's method. Source: Nocedal and Wright, Numerical
    Optimization, 10.3.
    """
    _not_negative(scale=scale)
    return lambda J, twist, q: _damped(J, twist, scale * float(np.linalg.norm(twist)))


def with_null_space(rates: Rates, wish: Callable[[Array], Array]) -> Rates:
    """Add the part of `wish(q)`, rates of shape (n,), that does not move the tip: (I - J^+ J)
    wish(q)."""
    must_be_callable(rates, "rates", "a function of J, twist and q, as pseudo_inverse() makes")
    must_be_callable(wish, "wish", "a function of q, as towards() makes")

    def both(J: Array, twist: Array, q: Array) -> Array:
        wanted = wish(q.copy())
        own = rates(J.copy(), twist.copy(), q.copy())
        return own + wanted - _pseudo(J, J @ wanted, 1e-6)

    return both


def towards(goal: ArrayLike, gain: float) -> Callable[[Array], Array]:
    """A wish to be at the joint vector `goal`, shape (n,): gain (goal - q), gain in 1/s."""
    goal = numbers(goal, "goal", "finite joint values (n,)", (None,)).copy()
    _not_negative(gain=gain)

    def wish(q: Array) -> Array:
        if q.shape != goal.shape:
            raise ArmError(f"goal has {goal.size} joint values; expected {q.size}, as q has")
        return gain * (goal - q)

    return wish


def away_from_limits(arm: Arm, gain: float) -> Callable[[Array], Array]:
    """A wish to be in the middle of each joint's range, as strong as the range is narrow. Source:
    Siciliano, section 3.5."""
    must_be(arm, Arm, "arm")
    _not_negative(gain=gain)
    lower, upper = arm.limits
    if not np.isfinite([lower, upper]).all():
        raise ArmError(f"{arm.name} has joints without limits; give a goal with towards() instead")
    middle, half = (lower + upper) / 2, (upper - lower) / 2
    return lambda q: -gain * (q - middle) / half**2


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
