"""Compute all steps of a trace at once, for joint rates by the plain inverse of J.

One step after the other, a trace takes a thousand small computations; all at once it takes a few on
whole batches. A first guess from few long steps violates the method's rule at each step by a
residual. With the plain inverse, a residual displaces the tip by the same amount for the rest of
the path. So the residuals are summed up as displacements of the tip, and each joint vector is moved
back by its sum. A handful of such sweeps leaves only round-off. They are Newton's method for all
steps together, which is multiple shooting for an initial value; source: Bellen and Zennaro (1989),
Journal of Computational and Applied Mathematics 25, for difference equations in general. The later
sweeps move the joints so little that they keep the inverse Jacobians of an earlier one.

Doubtful cases, such as a nearly singular configuration, are left to the loop in `tracing`, which
has the messages for them.
"""

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.inputs import ArmError
from helpers.kinematics import forward_kinematics, jacobian
from helpers.motion.rates import PlainInverse
from helpers.motion.steps import RULES, PathSamples, tip_error

Array = NDArray[np.floating]

_LONG_STEPS = 20
_SWEEPS = 20
_SMALL_MOVE = 1e-3  # in rad or m: after so small a move the inverse of J is reused
_BRANCH_TOLERANCE = 0.25  # largest error of the Jacobian's prediction, relative to the step


def all_steps(
    arm: Arm, start: Array, samples: PathSamples, method: str, rates: PlainInverse
) -> tuple[Array, Array] | None:
    """Compute q (steps + 1, dof) and rates (steps, dof), or None if only the loop can decide."""
    if arm.dof != 6 or len(samples.h) <= _LONG_STEPS:
        return None
    solve = _solve_exact if method == "exact" else _solve_rule
    try:
        return solve(arm, _first_guess(arm, start, samples), samples, method, rates)
    except (np.linalg.LinAlgError, ArmError):
        return None


def _first_guess(arm: Arm, start: Array, samples: PathSamples) -> Array:
    """Guess q (steps + 1, dof) by a few long Adams-Bashforth steps, with straight lines between."""
    marks = np.linspace(0, len(samples.h), _LONG_STEPS + 1).round().astype(int)
    times, twists = samples.times[marks], samples.twists[0.0][marks[:-1]]
    q, steps, before = np.empty((len(marks), arm.dof)), np.diff(times), None
    q[0] = start
    for k, (step, twist) in enumerate(zip(steps, twists, strict=True)):
        rate = np.linalg.solve(jacobian(arm, q[k]), twist)
        rate_change = 0.0 if before is None else (rate - before) / steps[k - 1]
        q[k + 1] = q[k] + step * (rate + step / 2 * rate_change)
        before = rate
    return np.stack([np.interp(samples.times, times, joint) for joint in q.T], axis=1)


def _solve_rule(
    arm: Arm, q: Array, samples: PathSamples, method: str, rates: PlainInverse
) -> tuple[Array, Array] | None:
    """Sweep until every step obeys the rule of "euler" or "rk4" to round-off."""
    twists = samples.twists[0.0]

    def slope(fraction: float, q: Array) -> Array:
        return _multiply_each(rates.inverses(jacobian(arm, q)), samples.twists[fraction])

    round_off, before, moved = 1e-15 * max(1.0, np.abs(q).max()), np.inf, np.inf
    rate = np.zeros_like(twists)
    for sweep in range(_SWEEPS):
        J = jacobian(arm, q[:-1])
        if moved > _SMALL_MOVE:
            inverted, inverse = J, rates.inverses(J)
        for _ in range(2):  # with a reused inverse, a pass reduces the rates' error but leaves some
            rate = rate + _multiply_each(inverse, twists - _multiply_each(J, rate))
        residual = RULES[method](slope, samples.h, q[:-1], rate) - q[1:]
        size = np.abs(residual).max()
        if _diverges(sweep, size, before):
            return None
        correction = _multiply_each(inverse, np.cumsum(_multiply_each(J, residual), axis=0))
        q[1:] += correction
        # Expect that the next sweep reduces the residual by the same factor as the last sweep.
        expected = size * size / before
        if sweep and min(size, 10 * expected) < round_off:
            rates.require_regular_near(J, inverted, inverse)
            return q, rate
        before, moved = size, np.abs(correction).max()
    return None


def _solve_exact(
    arm: Arm, q: Array, samples: PathSamples, method: str, rates: PlainInverse
) -> tuple[Array, Array] | None:
    """Apply Newton's method at every step, and check that the solution branch is the loop's."""
    before = np.inf
    for sweep in range(_SWEEPS):
        error = tip_error(forward_kinematics(arm, q[1:]), samples.positions[1.0], samples.rotation)
        size = np.abs(error).max()
        if size < 1e-13:
            if not _is_on_branch(arm, q, samples, rates):
                return None
            return q, np.diff(q, axis=0) / samples.h
        if _diverges(sweep, size, before):
            return None
        before = size
        q[1:] += _multiply_each(rates.inverses(jacobian(arm, q[1:])), error)
    return None


def _multiply_each(matrices: Array, vectors: Array) -> Array:
    """Multiply each matrix (steps, 6, 6) by its vector (steps, 6)."""
    return np.einsum("nij,nj->ni", matrices, vectors)


def _diverges(sweep: int, size: float, before: float) -> bool:
    """Return whether a sweep reduced the error too little.

    The first sweep may overshoot.
    """
    return not (sweep == 1 or size < 0.9 * before)


def _is_on_branch(arm: Arm, q: Array, samples: PathSamples, rates: PlainInverse) -> bool:
    """Return whether Newton's method, begun at the step before, leads to each step."""
    poses = forward_kinematics(arm, q[:-1])
    error = tip_error(poses, samples.positions[1.0], samples.rotation)
    step, expected = (
        np.diff(q, axis=0),
        _multiply_each(rates.inverses(jacobian(arm, q[:-1])), error),
    )
    off = np.abs(step - expected).max(axis=1)
    return bool((off <= _BRANCH_TOLERANCE * np.abs(expected).max(axis=1) + 1e-9).all())
