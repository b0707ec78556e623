"""Following a path by integrating joint rates, and what came of it."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import must_be, must_be_callable, number, one_of
from helpers.kinematics import forward_kinematics, jacobian
from helpers.motion.paths import Path
from helpers.motion.rates import Rates, SingularError, plain_inverse
from helpers.motion.report import Report, run_report

Array = NDArray[np.float64]

METHODS = ("euler", "rk4", "exact")


@dataclass(frozen=True)
class Trace:
    """A run along a path: times (steps + 1,), q and q_dot (steps + 1, dof), tip poses (steps + 1, 4, 4)."""

    arm: Arm
    path: Path
    q: Array
    q_dot: Array
    poses: Array

    @property
    def t(self) -> Array:
        """The times of the path, in s."""
        return self.path.times

    @property
    def report(self) -> Report:
        """What went well and what did not."""
        return run_report(self.arm, self.path, self.q, self.q_dot, self.poses)


def trace(
    arm: Arm,
    start: ArrayLike,
    path: Path,
    *,
    method: str = "euler",
    rates: Rates | None = None,
    gain: float = 0.0,
    jacobian: Callable[[Arm, Array], Array] = jacobian,
) -> Trace:
    """Follow a path from `start`, joints of shape (dof,), at the orientation that the tip has there.

    Args:
        method: "euler" as in the homework, "rk4" (fourth-order Runge-Kutta), or "exact": at each step Newton's method
            moves the tip onto the path itself.
        rates: how joint rates follow from a twist; ``plain_inverse()`` unless given.
        gain: feedback in 1/s: the twist gains `gain` times the errors of position and orientation.
        jacobian: the Jacobian to steer by; a wrong one shows what a mistake does.

    Raises ArmError for an unknown method or a start that does not fit, SingularError, with the step it happened at, where
    the plain inverse does not exist. Source: Whitney (1969); feedback: Siciliano, section 3.7.
    """
    must_be(arm, Arm, "arm")
    must_be(path, Path, "path")
    one_of(method, "method", METHODS)
    number(gain, "gain", "a finite number of 0 or more", least=0)
    must_be_callable(jacobian, "jacobian", "a function of an arm and q")
    start = arm.joint_vector(start, "start", many=False)
    rates = plain_inverse() if rates is None else rates
    must_be_callable(rates, "rates", "a function of J, twist and q, as plain_inverse() makes")
    held = forward_kinematics(arm, start)[:3, :3]

    def slope(t: float, q: Array) -> Array:
        twist = np.concatenate([path.velocity(t), np.zeros(3)])
        if gain:
            twist = twist + gain * _error(forward_kinematics(arm, q), path.position(t), held)
        return rates(jacobian(arm, q), twist, q)

    step = {"euler": _euler, "rk4": _rk4, "exact": _exact(arm, path, held, rates)}[method]
    q = np.empty((len(path.times), arm.dof))
    q_dot = np.empty_like(q)
    q[0] = start
    for k in _progress(len(path.times) - 1):
        t, h = path.times[k], path.times[k + 1] - path.times[k]
        try:
            q_dot[k], q[k + 1] = step(slope, t, h, q[k])
        except SingularError as error:
            raise SingularError(f"{arm.name}, step {k} of {len(q) - 1}: {error}") from None
    q_dot[-1] = q_dot[-2]
    return Trace(arm, path, q, q_dot, forward_kinematics(arm, q))


def _euler(slope, t: float, h: float, q: Array) -> tuple[Array, Array]:
    rate = slope(t, q)
    return rate, q + h * rate


def _rk4(slope, t: float, h: float, q: Array) -> tuple[Array, Array]:
    k_1 = slope(t, q)
    k_2 = slope(t + h / 2, q + h / 2 * k_1)
    k_3 = slope(t + h / 2, q + h / 2 * k_2)
    k_4 = slope(t + h, q + h * k_3)
    return k_1, q + h / 6 * (k_1 + 2 * k_2 + 2 * k_3 + k_4)


def _exact(arm: Arm, path: Path, held: Array, rates: Rates):
    """Newton's method for the joint vector at the end of the step, from the one at its start."""

    def step(slope, t: float, h: float, q: Array) -> tuple[Array, Array]:
        found, wanted = q, path.position(t + h)
        for _ in range(30):
            error = _error(forward_kinematics(arm, found), wanted, held)
            if np.abs(error).max() < 1e-13:
                break
            found = found + rates(jacobian(arm, found), error, found)
        return (found - q) / h, found

    return step


def _error(pose: Array, position: Array, rotation: Array) -> Array:
    """The small twist (6,) that would carry a pose to a position and a rotation."""
    turn = 0.5 * np.cross(pose[:3, :3], rotation, axis=0).sum(axis=1)
    return np.concatenate([position - pose[:3, 3], turn])


def _progress(steps: int):
    """Count steps; a bar appears only in runs of more than ten seconds, and leaves nothing behind."""
    from tqdm import tqdm  # the one for notebooks leaves a bar behind where a run fails

    return tqdm(range(steps), delay=10, leave=False)
