"""Following a path by integrating joint rates, and what came of it."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers import kinematics
from helpers.arm import Arm
from helpers.inputs import ArmError, must_be, must_be_callable, number, one_of, shown
from helpers.kinematics import forward_kinematics
from helpers.motion.at_once import all_steps
from helpers.motion.paths import Path
from helpers.motion.rates import PlainInverse, Rates, SingularError, plain_inverse
from helpers.motion.report import Report, run_report
from helpers.motion.steps import METHODS, RULES, Course, Rule, charted, tip_error

Array = NDArray[np.floating]


_ITERATIONS = 30
_ARRIVED = 1e-9  # m and rad
_WHY = "the path leads out of reach or through a singular pose, or its steps are too long"


class UnreachableError(ArmError):
    """The tip was asked to be on a path that the arm cannot follow."""


@dataclass(frozen=True, repr=False)
class Trace:
    """A run along a path: times (steps + 1,), q and q_dot (steps + 1, dof), tip poses (steps + 1,
    4, 4)."""

    arm: Arm
    path: Path
    q: Array
    q_dot: Array
    poses: Array

    @property
    def t(self) -> Array:
        """The times of the path, in s."""
        return self.path.times

    @cached_property
    def report(self) -> Report:
        """What went well and what did not."""
        return run_report(self.arm, self.path, self.q, self.q_dot, self.poses)

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
    """Follow a path from `start`, joints of shape (dof,), at the orientation that the tip has
    there.

    Args:
        method: "euler" as in the homework, "rk4" (fourth-order Runge-Kutta), or "exact": at each
            step Newton's method moves the tip onto the path itself.
        rates: how joint rates follow from a twist; ``plain_inverse()`` unless given.
        gain: feedback in 1/s: the twist gains `gain` times the errors of position and orientation.
        jacobian: the Jacobian to steer by; a wrong one shows what a mistake does.

    Raises ArmError for an unknown method or a start that does not fit, SingularError, with the step
    it happened at, where the plain inverse does not exist. Source: Whitney (1969); feedback:
    Siciliano, section 3.7.
    """
    must_be(arm, Arm, "arm")
    must_be(path, Path, "path")
    one_of(method, "method", METHODS)
    number(gain, "gain", "a finite number of 0 or more", least=0)
    must_be_callable(jacobian, "jacobian", "a function of an arm and q")
    start = arm.joint_vector(start, "start", many=False)
    rates = plain_inverse() if rates is None else rates
    must_be_callable(rates, "rates", "a function of J, twist and q, as plain_inverse() makes")
    if method == "exact" and gain:
        raise ArmError(
            f'gain is {shown(gain)}; expected 0 with method "exact", which leaves no error to feed'
            " back"
        )
    course = charted(path, method, forward_kinematics(arm, start)[:3, :3])
    run = None
    if isinstance(rates, PlainInverse) and jacobian is kinematics.jacobian and not gain:
        run = all_steps(arm, start, course, method, rates)
    if run is None:
        run = _one_by_one(arm, start, course, Steering(rates, gain, jacobian, RULES.get(method)))
    q, q_dot = run
    q_dot = np.concatenate([q_dot, q_dot[-1:]])
    return Trace(arm, path, q, q_dot, forward_kinematics(arm, q))


@dataclass(frozen=True)
class Steering:
    """How joint rates follow from a twist, and joints from rates; no rule is Newton's method. Its
    functions may be a student's: they get copies, never the run itself."""

    rates: Rates
    gain: float
    jacobian: Callable[[Arm, Array], Array]
    rule: Rule | None

    def along(self, arm: Arm, q: Array, twist: Array) -> Array:
        """Joint rates (dof,) for a twist (6,) at q (dof,)."""
        return self.rates(self.jacobian(arm, q.copy()), twist.copy(), q.copy())


def _one_by_one(arm: Arm, start: Array, course: Course, steering: Steering) -> tuple[Array, Array]:
    """Each step from the one before; joints (steps + 1, dof) and their rates (steps, dof)."""
    step = _by_rule if steering.rule else _to_the_path
    steps = len(course.h)
    q, q_dot = np.empty((steps + 1, arm.dof)), np.empty((steps, arm.dof))
    q[0] = start
    for k in range(steps):
        try:
            q_dot[k], q[k + 1] = step(arm, q[k], course, k, steering)
        except (SingularError, UnreachableError) as error:
            raise type(error)(f"{arm.name}, step {k} of {steps}: {error}") from None
    return q, q_dot


def _by_rule(arm: Arm, q: Array, course: Course, k: int, steering: Steering) -> tuple[Array, Array]:
    assert steering.rule  # or Newton's method would be asked

    def slope(share: float, q: Array) -> Array:
        twist = course.twists[share][k]
        if steering.gain:
            pose, position = forward_kinematics(arm, q), course.positions[share][k]
            twist = twist + steering.gain * tip_error(pose, position, course.rotation)
        return steering.along(arm, q, twist)

    rate = slope(0.0, q)
    return rate, steering.rule(slope, course.h[k], q, rate)


def _to_the_path(
    arm: Arm, q: Array, course: Course, k: int, steering: Steering
) -> tuple[Array, Array]:
    """Newton's method for the joint vector at the end of the step, from the one at its start."""
    found, position = q, course.positions[1.0][k]
    for _ in range(_ITERATIONS):
        error = tip_error(forward_kinematics(arm, found), position, course.rotation)
        if np.abs(error).max() < 1e-13:
            break
        found = found + steering.along(arm, found, error)
    _must_have_arrived(error)
    _must_not_leap(arm, found - q)
    return (found - q) / course.h[k], found


def _must_have_arrived(error: Array) -> None:
    """Where rates that damp come within the last digits only, that is enough."""
    metres, radians = np.linalg.norm(error.reshape(2, 3), axis=1)
    if not max(metres, radians) < _ARRIVED:
        raise UnreachableError(
            f"after {_ITERATIONS} iterations of Newton's method the tip is {1e3 * metres:.3g} mm"
            f" and {np.degrees(radians):.3g}° off the path: {_WHY}"
        )


def _must_not_leap(arm: Arm, step: Array) -> None:
    leaps = np.where(arm.turning, np.abs(step), 0.0)
    if leaps.max() > np.pi:
        joint, leap = arm.joints[leaps.argmax()], leaps.max()
        raise UnreachableError(
            f"joint {joint} would turn by {leap:.3g} rad at once; expected half a turn at most:"
            f" {_WHY}"
        )
