"""Are my joint torques wrong, and how? One torque vector or a whole run of them."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm, Body
from helpers.checks.verdict import Verdict
from helpers.inputs import ArmError, floats, must_be, number
from helpers.kinematics import link_frames
from helpers.statics import GRAVITY, gravity_torque, static_torque

Array = NDArray[np.float64]

_NO_WRENCH = (0.0,) * 6


@dataclass(frozen=True, repr=False)
class TorqueReport(Verdict):
    """What `compare_torques` found; `worst` is the largest difference (N m, or N where a joint
    slides)."""

    arm: str
    worst: float
    findings: tuple[str, ...]

    def __str__(self) -> str:
        verdict = "are right" if self.agrees else "are not right"
        return "\n".join(
            [f"The torques of {self.arm} {verdict}.", *(f"- {f}" for f in self.findings)]
        )


def compare_torques(
    mine: ArrayLike,
    arm: Arm,
    q: ArrayLike,
    wrench: ArrayLike = _NO_WRENCH,
    gravity: ArrayLike = GRAVITY,
    tolerance: float = 1e-3,
) -> TorqueReport:
    """Compare your torques, shape (..., dof), at q, shape (..., dof), with g(q) - J^T F, and name
    the mistake.

    `wrench` is on the tool, by the world, shape (6,) or (..., 6); `tolerance` is in N m. One pose
    can hide a mistake that a whole path shows. Raises ArmError where `mine` is not numbers or the
    arm has no masses.
    """
    must_be(arm, Arm, "arm")
    number(tolerance, "tolerance", "a number of N m, 0 or more", least=0)
    tau = _numbers(mine, arm)
    right = static_torque(arm, q, wrench, gravity)
    if tau.shape != right.shape:
        return TorqueReport(arm.name, np.inf, (_shape_finding(tau, right, arm),))
    worst = float(np.abs(tau - right).max(initial=0.0))
    agrees = worst <= tolerance
    findings = () if agrees else _diagnosis(tau, right, arm, q, wrench, gravity, tolerance)
    return TorqueReport(arm.name, worst, findings)


def _numbers(mine: ArrayLike, arm: Arm) -> Array:
    tau = floats(mine, f"{arm.name}: what you give for your torques", "numbers")
    if not np.isfinite(tau).all():
        raise ArmError(f"{arm.name}: your torques hold NaN or infinity; expected finite numbers")
    return tau


def _shape_finding(tau: Array, right: Array, arm: Arm) -> str:
    if tau.shape == right.shape[:-1]:
        return (
            "One number for a pose is the potential energy; torques are its derivatives, one"
            " per joint."
        )
    if tau.ndim == 2 and tau.T.shape == right.shape:
        return "It is transposed: one row per pose, one column per joint."
    return (
        f"Its shape is {tau.shape}; expected {right.shape}, one torque for each of {arm.dof}"
        " joints."
    )


def _diagnosis(
    tau: Array,
    right: Array,
    arm: Arm,
    q: ArrayLike,
    wrench: ArrayLike,
    gravity: ArrayLike,
    tolerance: float,
) -> tuple[str, ...]:
    wrongs = (*_signs(arm, q, wrench, gravity), *_models(arm, q, wrench, gravity))
    for sentence, wrong in wrongs:
        # A cause that makes no difference here explains nothing.
        if np.abs(tau - wrong).max() <= tolerance < np.abs(wrong - right).max():
            return (sentence,)
    return tuple(_joints(tau, right, arm, tolerance))


def _signs(
    arm: Arm, q: ArrayLike, wrench: ArrayLike, gravity: ArrayLike
) -> Iterator[tuple[str, Array]]:
    weight = gravity_torque(arm, q, gravity)
    force = static_torque(arm, q, wrench, gravity) - weight
    yield (
        "The force has the wrong sign: F is on the tool, by the world, and tau = g - J^T F.",
        weight - force,
    )
    yield "The force is missing: tau = g - J^T F.", weight + 0 * force
    yield "The weight is missing: tau = g - J^T F.", force + 0 * weight
    yield "Every sign is reversed.", -weight - force
    yield (
        "The weight has the wrong sign: g(q) = dP/dq, and P grows with height.",
        force - weight,
    )
    for g in (9.8, 10.0):
        size = np.linalg.norm(np.asarray(gravity, dtype=float))
        yield f"The acceleration of gravity is {g:g} m/s^2.", weight * g / size + force


def _models(
    arm: Arm, q: ArrayLike, wrench: ArrayLike, gravity: ArrayLike
) -> Iterator[tuple[str, Array]]:
    F = np.asarray(wrench, dtype=float)
    degrees = "q is taken in degrees: sines and cosines here take radians."
    yield degrees, static_torque(arm, np.radians(q), F, gravity)
    yield degrees, static_torque(arm, np.degrees(q), F, gravity)
    yield "Force and moment are exchanged.", static_torque(arm, q, np.roll(F, 3, -1), gravity)
    yield (
        "The force is in the tool's axes: turn it into the base's first.",
        static_torque(arm, q, _turned(arm, q, F), gravity),
    )
    middle = "The centres of mass are at the frames' origins: (0, 0, 0) in the table's frames."
    origins = [Body(body.mass, (0, 0, 0)) for body in arm.bodies]
    yield middle, static_torque(replace(arm, bodies=origins), q, F, gravity)
    for i in range(len(arm.bodies)):
        bodies = (*arm.bodies[:i], Body(0, (0, 0, 0)), *arm.bodies[i + 1 :])
        yield (
            f"The mass of link {i + 1} is missing.",
            static_torque(replace(arm, bodies=bodies), q, F, gravity),
        )


def _turned(arm: Arm, q: ArrayLike, F: Array) -> Array:
    """What a wrench becomes if its numbers are meant in the tool's axes."""
    R = link_frames(arm, q)[..., -1, :3, :3]
    halves = [np.einsum("...ij,...j->...i", R, half) for half in (F[..., :3], F[..., 3:])]
    return np.concatenate(halves, axis=-1)


def _joints(tau: Array, right: Array, arm: Arm, tolerance: float) -> Iterator[str]:
    axes = tuple(range(tau.ndim - 1))
    off, flipped = np.abs(tau - right).max(axis=axes), np.abs(tau + right).max(axis=axes)
    for joint, difference, other in zip(arm.joints, off, flipped, strict=True):
        if difference > tolerance:
            other_way = "its sign is reversed, as if the joint counted the other way"
            by = f"it is off by up to {difference:.3g} N m"
            yield f"Joint {joint}: {other_way if other <= tolerance else by}."
