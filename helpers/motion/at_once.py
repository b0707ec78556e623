"""All steps of a trace at once, where joint rates are the plain inverse of the arm's own Jacobian.

One step after the other, a run takes a thousand small computations; all at once, a few of whole
batches. A first guess, from few long steps, breaks the method's rule by a misfit at each step. To
the plain inverse a misfit is a displacement of the tip that stays what it is along the rest of the
path: so the misfits are summed up as displacements, and each joint vector is moved back by its sum.
A handful of such sweeps leaves rounding. They are Newton's method for all steps together, which is
multiple shooting for an initial value; source: Bellen and Zennaro (1989), Journal of Computational
and Applied Mathematics 25, for difference equations in general.

Whatever is in doubt, such as a pose that is nearly singular, is left to the loop, which knows how
to tell it.
"""

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.inputs import ArmError
from helpers.kinematics import forward_kinematics, jacobian
from helpers.motion.rates import PlainInverse
from helpers.motion.steps import RULES, Course, tip_error

Array = NDArray[np.floating]

_LONG_STEPS = 20
_SWEEPS = 20
_BRANCH = 0.25  # the share of a step by which it may miss what the Jacobian before it predicts


def all_steps(
    arm: Arm, start: Array, course: Course, method: str, rates: PlainInverse
) -> tuple[Array, Array] | None:
    """Joints and rates of the whole run, (steps + 1, dof) and (steps, dof), or None where the loop
    must decide."""
    if arm.dof != 6 or len(course.h) <= _LONG_STEPS:
        return None
    sweep = _exact if method == "exact" else _by_rule
    try:
        return sweep(arm, _guess(arm, start, course, rates), course, method, rates)
    except (np.linalg.LinAlgError, ArmError):
        return None


def _guess(arm: Arm, start: Array, course: Course, rates: PlainInverse) -> Array:
    """Joints (steps + 1, dof) by few long steps of the rule of Adams and Bashforth of second
    order, and straight lines between them."""
    marks = np.linspace(0, len(course.h), _LONG_STEPS + 1).round().astype(int)
    times, twists = course.times[marks], course.twists[0.0][marks[:-1]]
    q, steps, before = np.empty((len(marks), arm.dof)), np.diff(times), None
    q[0] = start
    for k, (step, twist) in enumerate(zip(steps, twists, strict=True)):
        rate = rates(jacobian(arm, q[k]), twist, q[k])
        bend = 0.0 if before is None else (rate - before) / steps[k - 1]
        q[k + 1] = q[k] + step * (rate + step / 2 * bend)
        before = rate
    return np.stack([np.interp(course.times, times, joint) for joint in q.T], axis=1)


def _by_rule(
    arm: Arm, q: Array, course: Course, method: str, rates: PlainInverse
) -> tuple[Array, Array] | None:
    """Sweeps until every step obeys the rule of "euler" or "rk4" to rounding."""

    def slope(share: float, q: Array) -> Array:
        return _each(rates.inverses(jacobian(arm, q)), course.twists[share])

    rounding, before = 1e-15 * max(1.0, np.abs(q).max()), np.inf
    for sweep in range(_SWEEPS):
        J = jacobian(arm, q[:-1])
        inverse = rates.inverses(J)
        rate = _each(inverse, course.twists[0.0])
        off = RULES[method](slope, course.h, q[:-1], rate) - q[1:]
        size = np.abs(off).max()
        if _goes_astray(sweep, size, before):
            return None
        q[1:] += _each(inverse, np.cumsum(_each(J, off), axis=0))
        left = size * size / before  # if this sweep takes what the last one took
        if sweep and min(size, 10 * left) < rounding:
            return q, rate
        before = size
    return None


def _exact(
    arm: Arm, q: Array, course: Course, method: str, rates: PlainInverse
) -> tuple[Array, Array] | None:
    """Newton's method at every step, on the branch that the steps lead to."""
    before = np.inf
    for sweep in range(_SWEEPS):
        error = tip_error(forward_kinematics(arm, q[1:]), course.positions[1.0], course.rotation)
        size = np.abs(error).max()
        if size < 1e-13:
            return (q, np.diff(q, axis=0) / course.h) if _on_branch(arm, q, course, rates) else None
        if _goes_astray(sweep, size, before):
            return None
        before = size
        q[1:] += _each(rates.inverses(jacobian(arm, q[1:])), error)
    return None


def _each(matrices: Array, vectors: Array) -> Array:
    """Each matrix (steps, 6, 6) times its vector (steps, 6)."""
    return np.einsum("nij,nj->ni", matrices, vectors)


def _goes_astray(sweep: int, size: float, before: float) -> bool:
    """Whether a sweep brought less than Newton's method should; the first, from a rough guess, may
    overshoot."""
    return not (sweep == 1 or size < 0.9 * before)


def _on_branch(arm: Arm, q: Array, course: Course, rates: PlainInverse) -> bool:
    """Whether each step is what Newton's method begins with at the step before, so that the loop
    would take it too."""
    poses = forward_kinematics(arm, q[:-1])
    error = tip_error(poses, course.positions[1.0], course.rotation)
    step, expected = np.diff(q, axis=0), _each(rates.inverses(jacobian(arm, q[:-1])), error)
    off = np.abs(step - expected).max(axis=1)
    return bool((off <= _BRANCH * np.abs(expected).max(axis=1) + 1e-9).all())
