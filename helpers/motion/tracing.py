"""Follow a path by integrating joint rates."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers import kinematics
from helpers.arm import Arm, require_joints
from helpers.inputs import (
    ArmError,
    finite_number,
    require_callable,
    require_choice,
    require_type,
    shorten,
)
from helpers.kinematics import forward_kinematics
from helpers.motion.at_once import all_steps
from helpers.motion.paths import Path
from helpers.motion.rates import PlainInverse, Rates, SingularError, plain_inverse
from helpers.motion.report import TraceReport, report_trace
from helpers.motion.steps import METHODS, RULES, PathSamples, Rule, sample_path, tip_error

Array = NDArray[np.floating]


_ITERATIONS = 30
_TOLERANCE = 1e-9  # in m and rad; damped rates do not converge further
_REASONS = (
    "the path leads out of reach or through a singular configuration, or its steps are too long"
)


class UnreachableError(ArmError):
    """The arm cannot follow the path."""


@dataclass(frozen=True, repr=False)
class Trace:
    """A motion of an arm along a path.

    Attributes:
        arm: The arm.
        path: The path.
        q: Joint values, shape (steps + 1, dof).
        q_dot: Joint rates, shape (steps + 1, dof).
        poses: Poses of the tip, shape (steps + 1, 4, 4).
    """

    arm: Arm
    path: Path
    q: Array
    q_dot: Array
    poses: Array

    @property
    def t(self) -> Array:
        """The times of the path, shape (steps + 1,), in s."""
        return self.path.times

    @cached_property
    def report(self) -> TraceReport:
        """The report of errors, speeds and limits."""
        return report_trace(self.arm, self.path, self.q, self.q_dot, self.poses)

    def __repr__(self) -> str:
        steps = f"{len(self.t) - 1} steps in {self.t[-1] - self.t[0]:g} s"
        return f"{self.arm.name}, {steps}\n{self.report}"

    def _repr_markdown_(self) -> str:
        return self.report._repr_markdown_()


def trace(
    arm: Arm,
    start: ArrayLike,
    path: Path,
    *,
    method: str = "euler",
    rates: Rates | None = None,
    gain: float = 0.0,
    jacobian: Callable[[Arm, Array], Array] = kinematics.jacobian,
) -> Trace:
    """Follow a path with the tip at the orientation that it has at the start.

    Args:
        arm: The arm.
        start: Joint values at the start, shape (dof,).
        path: The path.
        method: "euler" as in the homework, "rk4" (fourth-order Runge-Kutta), or "exact", which
            moves the tip onto the path by Newton's method at each step.
        rates: Rule for joint rates; ``plain_inverse()`` by default.
        gain: Feedback gain, in 1/s: `gain` times the errors of position and orientation is added
            to the twist.
        jacobian: Function of the arm and q that returns J; a wrong one shows the effect of a
            mistake.

    Raises:
        ArmError: The method is unknown, or the start does not fit.
        SingularError: The plain inverse does not exist; the message names the step.
        UnreachableError: The method "exact" cannot bring the tip onto the path.

    Example:
        >>> from helpers.motion.paths import circle_below
        >>> from helpers.robots import UR10E
        >>> start = [0, -1, 1.2, -1, -1.5, 0]
        >>> path = circle_below(UR10E, start, radius=0.1, plane="zy", period=5, steps=1000)
        >>> run = trace(UR10E, start, path, method="rk4")
        >>> run.q.shape, bool(run.report.position_error < 1e-9)
        ((1001, 6), True)

    Source: Whitney (1969); feedback: Siciliano, section 3.7.
    """
    require_joints(arm)
    require_type(path, Path, "path")
    require_choice(method, "method", METHODS)
    finite_number(gain, "gain", "a finite number of 0 or more", least=0)
    require_callable(jacobian, "jacobian", "a function of an arm and q")
    start = arm.joint_vector(start, "start", many=False)
    rates = plain_inverse() if rates is None else rates
    require_callable(rates, "rates", "a function of J, twist and q, as plain_inverse() makes")
    if method == "exact" and gain:
        raise ArmError(
            f'gain is {shorten(gain)}; expected 0 with method "exact", which leaves no error to'
            " feed back"
        )
    samples = sample_path(path, method, forward_kinematics(arm, start)[:3, :3])
    result = None
    if isinstance(rates, PlainInverse) and jacobian is kinematics.jacobian and not gain:
        result = all_steps(arm, start, samples, method, rates)
    if result is None:
        steering = Steering(rates, gain, jacobian, RULES.get(method))
        result = _steps_in_turn(arm, start, samples, steering)
    q, q_dot = result
    q_dot = np.concatenate([q_dot, q_dot[-1:]])
    return Trace(arm, path, q, q_dot, forward_kinematics(arm, q))


@dataclass(frozen=True)
class Steering:
    """Rules that compute joint rates from a twist, and joint values from rates.

    Functions passed in by the caller receive copies of arrays.

    Attributes:
        rates: Rule for joint rates.
        gain: Feedback gain, in 1/s.
        jacobian: Function of the arm and q.
        rule: Integration rule; None for Newton's method.
    """

    rates: Rates
    gain: float
    jacobian: Callable[[Arm, Array], Array]
    rule: Rule | None

    def joint_rates(self, arm: Arm, q: Array, twist: Array) -> Array:
        """Compute joint rates (dof,) for a twist (6,) at q (dof,)."""
        return self.rates(self.jacobian(arm, q.copy()), twist.copy(), q.copy())


def _steps_in_turn(
    arm: Arm, start: Array, samples: PathSamples, steering: Steering
) -> tuple[Array, Array]:
    """Take all steps in turn.

    Returns q, shape (steps + 1, dof), and rates, shape (steps, dof).
    """
    step = _rule_step if steering.rule else _newton_step
    steps = len(samples.h)
    q, q_dot = np.empty((steps + 1, arm.dof)), np.empty((steps, arm.dof))
    q[0] = start
    for k in range(steps):
        try:
            q_dot[k], q[k + 1] = step(arm, q[k], samples, k, steering)
        except (SingularError, UnreachableError) as error:
            raise type(error)(f"{arm.name}, step {k} of {steps}: {error}") from None
    return q, q_dot


def _rule_step(
    arm: Arm, q: Array, samples: PathSamples, k: int, steering: Steering
) -> tuple[Array, Array]:
    """Take step k from q by the rule.

    Returns the rates at its start and the next q.
    """
    assert steering.rule  # the exact method, without a rule, uses _newton_step

    def slope(fraction: float, q: Array) -> Array:
        twist = samples.twists[fraction][k]
        if steering.gain:
            pose, position = forward_kinematics(arm, q), samples.positions[fraction][k]
            twist = twist + steering.gain * tip_error(pose, position, samples.rotation)
        return steering.joint_rates(arm, q, twist)

    rate = slope(0.0, q)
    return rate, steering.rule(slope, samples.h[k], q, rate)


def _newton_step(
    arm: Arm, q: Array, samples: PathSamples, k: int, steering: Steering
) -> tuple[Array, Array]:
    """Find the joint values at the end of step k by Newton's method, from those at its start."""
    end, position = q, samples.positions[1.0][k]
    for _ in range(_ITERATIONS):
        error = tip_error(forward_kinematics(arm, end), position, samples.rotation)
        if np.abs(error).max() < 1e-13:
            break
        end = end + steering.joint_rates(arm, end, error)
    metres, radians = np.linalg.norm(error.reshape(2, 3), axis=1)
    if not max(metres, radians) < _TOLERANCE:
        raise UnreachableError(
            f"after {_ITERATIONS} iterations of Newton's method the tip is {1e3 * metres:.3g} mm"
            f" and {np.degrees(radians):.3g}° off the path: {_REASONS}"
        )
    leaps = np.where(arm.turning, np.abs(end - q), 0.0)
    if leaps.max() > np.pi:
        joint, leap = arm.joints[leaps.argmax()], leaps.max()
        raise UnreachableError(
            f"joint {joint} would turn by {leap:.3g} rad at once; expected half a turn at most:"
            f" {_REASONS}"
        )
    return (end - q) / samples.h[k], end
